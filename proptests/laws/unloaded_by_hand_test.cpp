// Chunks that are unloaded, by hand: what is refused, and what bytes are taken.
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "twins.h"
#include "unloaded.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

std::size_t segmentsOf(const World& world) { return world.segments().size(); }

/// The bytes of a chunk with one of them changed, and with the checksum that fits.
std::vector<std::byte> spoilt(std::vector<std::byte> bytes, std::size_t at, std::byte by) {
  bytes[at] ^= by;
  seal(bytes);
  return bytes;
}

TEST(UnloadedByHand, NoWallAppearsWhereTheLoadedWorldEnds) {
  World world = rowOfChunks(3);
  EXPECT_EQ(segmentsOf(world), 2U * 96 + 2U * 32);
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(1, 0), shelf.sink()), 1U);
  EXPECT_EQ(segmentsOf(world), 2U * 96 + 2U * 32) << "as of the last commit";
  const Changes& gone = world.commit();
  EXPECT_EQ(gone.removed.size(), 64U);
  EXPECT_TRUE(gone.added.empty() && gone.relinked.empty());
  EXPECT_EQ(segmentsOf(world), 2U * 64 + 2U * 32);
  EXPECT_EQ(world.stats().polygons, 2U * 1024);
  EXPECT_EQ(world.firstUnloaded({{0, 0}, {95, 31}}), (Cell{32, 0}));
  EXPECT_EQ(world.firstUnloaded({{0, 0}, {31, 31}}), std::nullopt);
  // The last segment on top of the first chunk goes on into what is unloaded.
  for (const SegmentId id : world.segments({{31, 31}, {31, 31}})) {
    const Segment s = *world.segment(id);
    EXPECT_EQ(s.ghost1, (Point{33 * U, 32 * U}));
    EXPECT_EQ(world.segment(s.predecessor).error().code, ErrorCode::unloaded);
    EXPECT_EQ(world.segment(s.predecessor).error().cell, (Cell{32, 31}));
    Segment out;
    EXPECT_EQ(world.segments({&s.predecessor, 1}, {&out, 1}).error().code, ErrorCode::unloaded);
  }
  EXPECT_EQ(world.commit().removed.size(), 0U);
  EXPECT_TRUE(shelf.reload(world, {32, 0}));
  const Changes& back = world.commit();
  EXPECT_EQ(back.added.size(), 64U);
  EXPECT_TRUE(back.removed.empty() && back.relinked.empty());
}

TEST(UnloadedByHand, WithoutACommitBetweenNothingHasHappened) {
  World world = rowOfChunks(2);
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  const Changes& changes = world.commit();
  EXPECT_TRUE(changes.removed.empty() && changes.added.empty() && changes.relinked.empty());
}

TEST(UnloadedByHand, OnlyChunksWithinTheRectangleGo) {
  World world = rowOfChunks(2);
  EXPECT_EQ(world.unload({{0, 0}, {31, 30}}, {}), 0U);
  EXPECT_EQ(world.unload({{1, 0}, {63, 31}}, {}), 1U);
  EXPECT_EQ(world.unload({{0, 0}, {63, 31}}, {}), 1U) << "the other one is unloaded already";
  EXPECT_EQ(world.unload({{0, 0}, {-1, 31}}, {}), 0U);
  EXPECT_EQ(world.unload({{0, 0}, {kMaxCell + 1, 31}}, {}).error().code, ErrorCode::cellOutOfRange);
  EXPECT_EQ(world.reloadEmpty({{kMaxCell + 1, 0}, {kMaxCell + 1, 31}}).error().code, ErrorCode::cellOutOfRange);
  EXPECT_EQ(world.firstUnloaded({{0, 0}, {-1, 0}}), std::nullopt);
}

TEST(UnloadedByHand, TheFirstUnloadedCellIsTheFirstByRows) {
  World world;
  for (const Cell cell : {Cell{0, 0}, Cell{64, 0}, Cell{0, 32}, Cell{32, 32}}) place(world, cell, unitSquare());
  world.commit();
  EXPECT_EQ(world.unload({{32, 0}, {95, 31}}, {}), 1U);
  EXPECT_EQ(world.unload({{0, 32}, {95, 63}}, {}), 2U);
  EXPECT_EQ(world.firstUnloaded(kEverywhere), (Cell{64, 0}));
  EXPECT_EQ(world.firstUnloaded({{0, 0}, {63, 63}}), (Cell{0, 32}));
  EXPECT_EQ(world.firstUnloaded({{5, 40}, {95, 63}}), (Cell{5, 40}));
}

TEST(UnloadedByHand, HandlesAreRefusedAndValidAgain) {
  World world;
  const PolygonHandle gone = place(world, {3, 4}, unitSquare()), stale = place(world, {5, 5}, unitSquare());
  EXPECT_TRUE(world.remove(stale));
  world.commit();
  Shelf shelf;
  EXPECT_EQ(world.unload(kEverywhere, shelf.sink()), 1U);
  for (int commits = 0; commits < 2; ++commits) {
    EXPECT_EQ(world.polygon(gone).error().code, ErrorCode::unloaded);
    EXPECT_EQ(world.polygon(gone).error().cell, (Cell{3, 4}));
    EXPECT_EQ(world.cellOf(gone).error().code, ErrorCode::unloaded);
    EXPECT_EQ(world.remove(gone).error().code, ErrorCode::unloaded);
    world.commit();
  }
  EXPECT_EQ(world.save({}).error().code, ErrorCode::unloaded);
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  EXPECT_EQ(world.cellOf(gone), (Cell{3, 4}));
  EXPECT_EQ(world.polygon(stale).error().code, ErrorCode::staleHandle);
  EXPECT_EQ(place(world, {5, 5}, unitSquare()).serial, stale.serial + 1) << "none is given out twice";
}

TEST(UnloadedByHand, AChunkThatComesBackEmptyGivesNoHandleTwice) {
  for (const int edits : {1, 300}) {  // more than a word counts
    World world;
    PolygonHandle old;
    for (int k = 0; k < edits; ++k) {
      EXPECT_TRUE(!old || world.remove(old));
      old = place(world, {3, 4}, unitSquare());
    }
    place(world, {40, 4}, unitSquare());
    world.commit();
    EXPECT_EQ(world.unload(chunkAt(0, 0), {}), 1U);
    world.commit();
    EXPECT_EQ(world.reloadEmpty(kEverywhere), 1U);
    EXPECT_EQ(world.reloadEmpty(kEverywhere), 0U);
    EXPECT_EQ(world.polygon(old).error().code, ErrorCode::staleHandle);
    for (const Cell cell : {Cell{3, 4}, Cell{9, 9}}) EXPECT_GT(place(world, cell, unitSquare()).serial, old.serial);
    EXPECT_EQ(world.commit().added.size(), 8U);
  }
}

TEST(UnloadedByHand, BytesAreThoseOfTheChunkOrRefused) {
  World world = rowOfChunks(2);
  Shelf shelf;
  const auto refusal = [&](std::span<const std::byte> bytes) { return world.reload(bytes).error().what; };
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  const std::vector<std::byte> first = shelf.newest({0, 0});
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  EXPECT_EQ(refusal(first), SnapshotError::What::loaded);
  removeAll(world, {0, 0});
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  world.commit();
  EXPECT_EQ(refusal(first), SnapshotError::What::otherBytes);
  EXPECT_EQ(refusal({}), SnapshotError::What::cut);
  const std::vector<std::byte> bytes = shelf.newest({0, 0});
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(world.reload(std::span(bytes).first(size)));
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    std::vector<std::byte> damaged = bytes;
    damaged[k] ^= std::byte{0x10};
    EXPECT_FALSE(world.reload(damaged));
  }
  EXPECT_EQ(world.firstUnloaded(kEverywhere), (Cell{0, 0}));
  EXPECT_EQ(refusal(saved(rowOfChunks(1))), SnapshotError::What::notASnapshot);
  EXPECT_TRUE(world.reload(bytes));
  World other([](Block, Block) { return true; });
  EXPECT_EQ(other.reload(bytes).error().what, SnapshotError::What::relation);
  World empty;
  EXPECT_EQ(empty.reload(bytes), (Cell{0, 0})) << "where there is no chunk any bytes will do";
  EXPECT_EQ(empty.stats().polygons, 1023U);
  // Nor may bytes that somebody made up do harm.
  for (std::size_t k = 8; k + 4 < bytes.size(); ++k) {
    for (const int bit : {0, 1, 3, 7}) {
      World victim = rowOfChunks(1);
      EXPECT_EQ(victim.unload(kEverywhere, {}), 1U);
      victim.commit();
      EXPECT_EQ(victim.forgetChunks(kEverywhere), 1U);
      static_cast<void>(victim.reload(spoilt(bytes, k, std::byte{1} << bit)));
      victim.commit();
      EXPECT_EQ(victim.unload(kEverywhere, {}).has_value(), true);
      victim.commit();
    }
  }
}

TEST(UnloadedByHand, ForgottenPlacesGiveTheirNumbersAndBordersBack) {
  World world = rowOfChunks(3);
  Shelf shelf;
  EXPECT_EQ(world.unload({{0, 0}, {63, 31}}, shelf.sink()), 2U);
  EXPECT_EQ(world.forgetChunks(kEverywhere).error().code, ErrorCode::uncommitted);
  world.commit();
  EXPECT_EQ(world.stats().chunks, 3U);
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U) << "the second one is beside one that is loaded";
  EXPECT_EQ(world.firstUnloaded(kEverywhere), (Cell{32, 0}));
  EXPECT_EQ(world.forgetChunks({{0, 0}, {63, 31}}), 0U);
  // It comes back where it was, under a number that is free.
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  EXPECT_TRUE(shelf.reload(world, {32, 0}));
  world.commit();
  EXPECT_EQ(segmentsOf(world), 2U * 96 + 2U * 32);
  // A loaded chunk that is forgotten is one that needs nothing any more.
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  EXPECT_TRUE(world.clear(CellRect{{32, 0}, {95, 31}}));
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 2U);
  EXPECT_EQ(world.forgetChunks(kEverywhere), 0U) << "what the empty ones needed goes with a commit";
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U);
  EXPECT_EQ(world.stats().chunks, 0U);
  EXPECT_TRUE(world.save({}));
}

TEST(UnloadedByHand, WhatNobodyNeedsCanBeForgottenAfterGoingBackToo) {
  World world = rowOfChunks(2);
  EXPECT_EQ(world.unload(chunkAt(0, 0), {}), 1U);
  EXPECT_TRUE(world.clear(CellRect{{32, 0}, {63, 31}}));
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U) << "the empty one";
  const Mark mark = world.checkpoint();
  world.commit();
  EXPECT_TRUE(world.rollBack(mark));
  EXPECT_TRUE(world.forget(mark));
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U);
}

TEST(UnloadedByHand, TheFirstChunkBesideWakesTheBorder) {
  World world = rowOfChunks(1);
  EXPECT_EQ(world.unload(kEverywhere, {}), 1U);
  world.commit();
  EXPECT_EQ(segmentsOf(world), 0U);
  const ShapeId square = shapeOf(world, {unitSquare()});
  const std::vector<Placement> placed{{{32, 31}, square, 1}, {{-1, 32}, square, 1}};
  EXPECT_TRUE(world.addMany(placed));
  EXPECT_EQ(world.commit().added.size(), 7U) << "the side towards what is unloaded does not show";
  for (const SegmentId id : world.segments())
    if (const Segment s = *world.segment(id); s.start == Point{0, 32 * U}) {
      EXPECT_EQ(s.ghost1, (Point{U, 32 * U})) << "where two solids touch the outline turns";
    }
}

TEST(UnloadedByHand, AGroupThatIsNotKeptUndoesWhatItEditedInAChunkThatLeft) {
  World world = rowOfChunks(2);
  const PolygonHandle atRim = world.polygons({3, 31})[0].handle, within = world.polygons({3, 3})[0].handle;
  const PolygonHandle stays = world.polygons({4, 4})[0].handle;
  Shelf shelf;
  {
    const auto group = world.edit();
    EXPECT_TRUE(world.remove(atRim));
    EXPECT_TRUE(world.remove(within));
    EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  }
  EXPECT_EQ(world.polygon(within).error().code, ErrorCode::unloaded) << "being in memory is no edit";
  world.commit();
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  for (const PolygonHandle handle : {atRim, within, stays}) EXPECT_TRUE(world.polygon(handle));
  EXPECT_EQ(world.commit().added.size(), 96U) << "all that it shows";
}

/// A game digs, walks away and undoes: what is far away is undone, too, and its disk has the newest bytes alone.
TEST(UnloadedByHand, WhatIsUndoneInAChunkThatIsAwayIsUndone) {
  for (const bool isFollowed : {false, true}) {
    World world = rowOfChunks(3);
    EXPECT_TRUE(world.followCells(isFollowed));
    const Mark start = world.checkpoint();
    removeAll(world, {3, 3});
    removeAll(world, {31, 7});
    EXPECT_EQ(world.commit().added.size(), 8U);
    const Mark dug = world.checkpoint();
    Shelf shelf;
    EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
    world.commit();
    const std::vector<std::byte> bytes = shelf.newest({0, 0});

    EXPECT_TRUE(world.rollBack(start, Undone::keep));
    EXPECT_EQ(world.firstUnloaded(kEverywhere), (Cell{0, 0})) << "it loads nothing";
    EXPECT_EQ(world.changesOfRollBack().removed.size(), 1U) << "beside the hole at the rim";
    EXPECT_EQ(world.unload(chunkAt(2, 0), shelf.sink()), 1U);
    world.commit();
    EXPECT_TRUE(world.rollForward(dug)) << "redo survives streaming";
    EXPECT_EQ(world.changesOfRollBack().added.size(), 1U);
    EXPECT_TRUE(world.rollBack(start, Undone::keep));
    EXPECT_TRUE(world.reload(bytes)) << "the newest bytes are good";
    EXPECT_FALSE(world.isEmpty({3, 3}));
    EXPECT_FALSE(world.isEmpty({31, 7}));
    world.commit();

    EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
    EXPECT_TRUE(world.rollForward(dug));
    EXPECT_TRUE(shelf.reload(world, {0, 0}));
    EXPECT_TRUE(world.isEmpty({3, 3}));
    EXPECT_TRUE(world.isEmpty({31, 7}));
    EXPECT_TRUE(world.rollBack(start));
    EXPECT_FALSE(world.isEmpty({3, 3}));
  }
}

TEST(UnloadedByHand, WhatIsOwedOutlivesTheMarks) {
  World world = rowOfChunks(2);
  Mark mark = world.checkpoint();
  removeAll(world, {3, 3});
  removeAll(world, {0, 0});
  world.commit();
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  world.commit();
  EXPECT_TRUE(world.rollBack(mark));
  EXPECT_TRUE(world.forget(mark));
  EXPECT_TRUE(world.clear(chunkAt(1, 0)));
  world.commit();
  world = World(world);
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  EXPECT_EQ(world.commit().added.size(), 4U * 32) << "as before it was dug";
}

TEST(UnloadedByHand, AChunkWhoseBytesAreOutOfDateIsNotForgotten) {
  World world = rowOfChunks(2);
  const Mark mark = world.checkpoint();
  EXPECT_TRUE(world.clear(Cell{5, 5}));
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  EXPECT_TRUE(world.clear(CellRect{{32, 0}, {63, 31}}));
  EXPECT_TRUE(world.rollBack(mark));
  EXPECT_TRUE(world.forget(mark));
  EXPECT_EQ(world.unload(chunkAt(1, 0), shelf.sink()), 1U);
  world.commit();
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U) << "of the first one the bytes lack what came back";
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  EXPECT_FALSE(world.isEmpty({5, 5}));
}

TEST(UnloadedByHand, AChunkMadeAfterTheMarkIsEmptyAndStaysAway) {
  World world = rowOfChunks(1);
  const Mark start = world.checkpoint();
  place(world, {40, 4}, unitSquare());
  world.commit();
  const Mark built = world.checkpoint();
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(1, 0), shelf.sink()), 1U);
  world.commit();
  EXPECT_TRUE(world.rollBack(start, Undone::keep));
  EXPECT_EQ(world.firstUnloaded(kEverywhere), (Cell{32, 0}));
  EXPECT_TRUE(world.rollForward(built));
  EXPECT_TRUE(world.rollBack(start, Undone::keep));
  EXPECT_TRUE(shelf.reload(world, {32, 0}));
  EXPECT_TRUE(world.isEmpty({40, 4}));
  EXPECT_TRUE(world.rollForward(built));
  EXPECT_FALSE(world.isEmpty({40, 4}));
}

TEST(UnloadedByHand, AChunkThatComesBackEmptyIsEmptyAtAllMarks) {
  World world = rowOfChunks(2);
  const Mark start = world.checkpoint();
  removeAll(world, {31, 7});
  world.commit();
  EXPECT_EQ(world.unload(chunkAt(0, 0), {}), 1U);
  EXPECT_EQ(world.reloadEmpty(chunkAt(0, 0)), 1U);
  const PolygonHandle made = place(world, {3, 3}, unitSquare());
  EXPECT_GT(made.serial, 1U);
  world.commit();
  EXPECT_TRUE(world.rollBack(start));
  EXPECT_EQ(world.stats().polygons, 1024U);
  EXPECT_EQ(world.segments().size(), 4U * 32) << "the outline is that of then, and the chunk is empty";
}

TEST(UnloadedByHand, WhatAChunkGaveUpIsReportedAfterGoingBackToWhereTheWorldIs) {
  World world;
  ASSERT_TRUE(world.followCells(true));
  place(world, {5, 5}, unitSquare());
  world.commit();
  removeAll(world, {5, 5});
  EXPECT_EQ(world.unload(chunkAt(0, 0), {}), 1U);
  EXPECT_EQ(world.reloadEmpty(chunkAt(0, 0)), 1U);
  ASSERT_TRUE(world.rollBack(world.checkpoint()));
  ASSERT_EQ(world.cellChanges().size(), 1U);
  EXPECT_EQ(world.cellChanges()[0].before.size(), 1U);
  EXPECT_TRUE(world.cellChanges()[0].now.empty());
}

TEST(UnloadedByHand, ChunksAtTheEndsOfTheWorldGoToo) {
  World world;
  for (const Cell cell : {Cell{kMaxCell, kMaxCell}, Cell{-kMaxCell, -kMaxCell}}) place(world, cell, unitSquare());
  world.commit();
  Shelf shelf;
  EXPECT_EQ(world.unload(kEverywhere, shelf.sink()), 2U);
  world.commit();
  EXPECT_EQ(world.at(toWorld({kMaxCell, kMaxCell}, {U, U})).where, Spot::Where::unloaded);
  for (const Cell corner : {Cell{kMaxCell, kMaxCell}, Cell{-kMaxCell, -kMaxCell}})
    EXPECT_TRUE(shelf.reload(world, corner));
  EXPECT_EQ(world.commit().added.size(), 8U);
}

TEST(UnloadedByHand, ThreadsSeeNoDifference) {
  World world = rowOfChunks(3);
  EXPECT_EQ(world.unload({{0, 0}, {95, 31}}, {}), 3U);
  world.commit();
  EXPECT_EQ(world.reloadEmpty(chunkAt(0, 0)), 1U);
  fill(world, chunkAt(0, 0));
  const Executor inLine = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t k = 0; k < count; ++k) job(k);
  };
  EXPECT_EQ(world.commit(inLine).added.size(), 96U) << "no wall towards the second chunk";
}

TEST(UnloadedByHand, APlaceNeverSeenIsEmptyOrUnknownAsTheGameSays) {
  World world = rowOfChunks(1);
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_EQ(world.at({40 * U, U}).where, Spot::Where::outside);
  for (const Cell cell : {Cell{40, 1}, Cell{-40, 1}}) {  // on the right it is unknown what is there
    ASSERT_TRUE(world.add(cell, square, 1));
    ASSERT_TRUE(world.clear(cell));
  }
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(1, 0), shelf.sink()), 1U);
  EXPECT_TRUE(world.commit().removed.empty()) << "to the ground beside it, it is empty";
  EXPECT_EQ(world.at({40 * U, U}).where, Spot::Where::unloaded);
  EXPECT_EQ(world.add({40, 1}, square, 1).error().code, ErrorCode::unloaded);
  EXPECT_EQ(world.at({-40 * U, U}).where, Spot::Where::outside);
  EXPECT_EQ(world.reloadEmpty(chunkAt(1, 0)), 1U) << "now the game makes it";
  EXPECT_TRUE(world.add({40, 1}, square, 1));
}

}  // namespace
}  // namespace lgs::test
