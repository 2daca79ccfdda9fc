// World::forgetChunks(): empty chunks go, and nobody notices but by handles that are void and by memory.
#include "twins.h"
#include "unloaded.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

std::uint32_t chunkOf(PolygonHandle handle) { return handle.cellRef / 1024; }

TEST(LeavingByHand, TakesWhatLiesInTheRectangleAndIsEmpty) {
  World world;
  for (const Cell cell : {Cell{0, 0}, Cell{32, 0}, Cell{64, 0}}) place(world, cell, unitSquare());
  world.commit();
  removeAll(world, {0, 0});
  removeAll(world, {32, 0});
  world.commit();
  EXPECT_EQ(world.forgetChunks(CellRect{{0, 0}, {31, 30}}), 0U) << "a row of its cells is not in the rectangle";
  EXPECT_EQ(world.forgetChunks(CellRect{{1, 0}, {31, 31}}), 0U);
  EXPECT_EQ(world.forgetChunks(CellRect{{0, 1}, {31, 31}}), 0U);
  EXPECT_EQ(world.forgetChunks(CellRect{{0, 0}, {30, 31}}), 0U);
  EXPECT_EQ(world.forgetChunks(chunkAt(0, 0)), 1U);
  EXPECT_EQ(world.forgetChunks(chunkAt(0, 0)), 0U) << "it is gone";
  EXPECT_EQ(world.stats().chunks, 2U);
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U) << "the third one holds a polygon";
  EXPECT_EQ(world.stats().chunks, 1U);
  EXPECT_EQ(world.forgetChunks(CellRect{{0, 0}, {-1, 31}}), 0U) << "an empty rectangle";
}

TEST(LeavingByHand, IsRefusedWhileSomebodyMayNeedTheChunks) {
  World world;
  place(world, {}, unitSquare());
  EXPECT_EQ(world.forgetChunks(kEverywhere).error().code, ErrorCode::uncommitted);
  world.commit();
  const Mark mark = world.checkpoint();
  removeAll(world, {});
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere).error().code, ErrorCode::uncommitted);
  EXPECT_TRUE(world.rollBack(mark));
  EXPECT_FALSE(world.isEmpty({}));
  removeAll(world, {});
  world.commit();
  EXPECT_TRUE(world.forget(mark));
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U);
  const CellRect beyond{{0, 0}, {kMaxCell + 1, 0}};
  EXPECT_EQ(world.forgetChunks(beyond).error().code, ErrorCode::cellOutOfRange);
  EXPECT_EQ(world.forgetChunks(beyond).error().cell, beyond.max);
}

TEST(LeavingByHand, ChunksAtTheEndsOfTheWorldNeedNoCellsBeyond) {
  World world;
  for (const Cell cell : {Cell{kMaxCell, kMaxCell}, Cell{-kMaxCell, -kMaxCell}, Cell{kMaxCell, 0}}) {
    const PolygonHandle handle = place(world, cell, unitSquare());
    world.commit();
    EXPECT_TRUE(world.remove(handle));
    world.commit();
  }
  EXPECT_EQ(world.forgetChunks(CellRect{{kMaxCell, kMaxCell}, {kMaxCell, kMaxCell}}), 1U);
  EXPECT_EQ(world.forgetChunks(CellRect{{-kMaxCell, -kMaxCell}, {-kMaxCell + 30, -kMaxCell + 31}}), 0U);
  EXPECT_EQ(world.forgetChunks(CellRect{{-kMaxCell, -kMaxCell}, {-kMaxCell + 31, -kMaxCell + 31}}), 1U);
  EXPECT_EQ(world.forgetChunks(CellRect{{kMaxCell, 0}, {kMaxCell, 31}}), 1U);
}

TEST(LeavingByHand, VoidsTheHandlesOfThesePlaces) {
  World world;
  const PolygonHandle gone = place(world, {3, 4}, unitSquare()), stays = place(world, {40, 4}, unitSquare());
  EXPECT_TRUE(world.remove(gone));
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U);
  EXPECT_EQ(world.remove(gone).error().code, ErrorCode::staleHandle);
  EXPECT_EQ(world.cellOf(stays), (Cell{40, 4}));
  // The numbers of chunks that went are given out again, the least first: so nothing else has to be saved.
  const PolygonHandle far = place(world, {1'000, 4}, unitSquare());
  EXPECT_EQ(chunkOf(far), chunkOf(gone));
  EXPECT_EQ(chunkOf(place(world, {3, 4}, unitSquare())), 3U);
}

TEST(LeavingByHand, AWorldWithoutThemIsSavedAndGoesOn) {
  World world;
  for (std::int32_t k = 0; k < 6; ++k) place(world, {32 * k, 0}, unitSquare());
  for (const std::int32_t k : {0, 2, 3}) removeAll(world, {32 * k, 0});
  world.commit();
  EXPECT_EQ(std::to_integer<int>(saved(world)[7]), 1) << "the version of a world that has all numbers";
  EXPECT_EQ(world.forgetChunks(kEverywhere), 3U);
  const std::vector<std::byte> bytes = saved(world);
  EXPECT_EQ(std::to_integer<int>(bytes[7]), 2);
  World loaded = std::move(*World::load(bytes));
  EXPECT_EQ(saved(loaded), bytes);
  EXPECT_TRUE(samePolygons(world, loaded));
  for (const std::uint32_t number : {1U, 3U, 4U, 7U, 8U}) {
    const Cell cell{-32 * static_cast<std::int32_t>(number), 0};
    const PolygonHandle here = place(world, cell, unitSquare());
    EXPECT_EQ(chunkOf(here), number);
    EXPECT_EQ(place(loaded, cell, unitSquare()), here);
  }
  EXPECT_EQ(copyOf(world.commit()), copyOf(loaded.commit()));
  EXPECT_EQ(std::to_integer<int>(saved(world)[7]), 1) << "all numbers are in use again";
}

TEST(LeavingByHand, GoingBackGivesChunksTheirNumbersAgain) {
  World world;
  for (std::int32_t k = 0; k < 5; ++k) place(world, {32 * k, 0}, unitSquare());
  for (const std::int32_t k : {1, 3}) removeAll(world, {32 * k, 0});
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 2U);
  const std::vector<std::byte> before = saved(world);
  const Mark mark = world.checkpoint();
  std::vector<PolygonHandle> handles;
  for (std::int32_t k = 0; k < 4; ++k) handles.push_back(place(world, {32 * k, 500}, unitSquare()));
  world.commit();
  const Mark later = world.checkpoint();
  for (int rounds = 0; rounds < 2; ++rounds) {
    EXPECT_TRUE(world.rollBack(mark, Undone::keep));
    EXPECT_EQ(saved(world), before);
    EXPECT_EQ(world.stats().chunks, 3U);
    EXPECT_TRUE(world.rollForward(later));
    for (std::int32_t k = 0; k < 4; ++k)
      EXPECT_EQ(world.cellOf(handles[static_cast<std::size_t>(k)]), (Cell{32 * k, 500}));
  }
  EXPECT_EQ(chunkOf(handles[0]), 2U);
  EXPECT_EQ(chunkOf(handles[1]), 4U);
  EXPECT_EQ(chunkOf(handles[2]), 6U);
}

TEST(LeavingByHand, ARefusedCallOfManyLeavesTheNumbersAsTheyWere) {
  World world;
  for (std::int32_t k = 0; k < 4; ++k) place(world, {32 * k, 0}, unitSquare());
  for (const std::int32_t k : {0, 2}) removeAll(world, {32 * k, 0});
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 2U);
  const ShapeId square = shapeOf(world, {unitSquare()});
  const std::vector<std::byte> before = saved(world);
  const std::vector<Placement> refused{
      {{0, 99}, square, 1}, {{64, 99}, square, 1}, {{999, 99}, square, 1}, {{0, 99}, square, 1}};
  EXPECT_FALSE(world.addMany(refused));
  EXPECT_EQ(saved(world), before);
}

TEST(LeavingByHand, FollowersKeepWhatTheyWereTold) {
  World world;
  ASSERT_TRUE(world.followCells(true));
  const PolygonHandle handle = place(world, {5, 5}, unitSquare());
  world.commit();
  removeAll(world, {5, 5});
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U);
  ASSERT_EQ(world.cellChanges().size(), 1U);
  EXPECT_EQ(world.cellChanges()[0].before[0].handle, handle);
  place(world, {500, 5}, unitSquare());
  world.commit();
  EXPECT_EQ(world.cellChanges()[0].cell, (Cell{500, 5}));
  EXPECT_TRUE(world.cellChanges()[0].before.empty());
}

TEST(LeavingByHand, TakesWhatCellsRememberOfManyPolygons) {
  World world;
  for (const LocalPolygon& half : shapeNamed("two halves")) place(world, {}, half);
  removeAll(world, {});
  for (int k = 0; k < 300; ++k) {  // more than a word counts
    place(world, {1, 0}, unitSquare());
    removeAll(world, {1, 0});
  }
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U);
  EXPECT_EQ(place(world, {1, 0}, unitSquare()).serial, 1U) << "as if no edit had ever been there";
}

}  // namespace
}  // namespace lgs::test
