// World::forgetChunks(): empty chunks go, and nobody notices but by handles that are void and by memory.
#include "twins.h"
#include "unloaded.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

std::uint32_t chunkOf(PolygonHandle handle) { return handle.cellRef / 1024; }

TEST(LeavingByHand, VoidsTheHandlesOfThesePlaces) {
  World world;
  const PolygonHandle gone = place(world, {3, 4}, unitSquare()), stays = place(world, {40, 4}, unitSquare());
  EXPECT_TRUE(world.remove(gone));
  EXPECT_EQ(world.forgetChunks(kEverywhere).error().code, ErrorCode::uncommitted);
  EXPECT_EQ(world.followCells(true).error().code, ErrorCode::uncommitted);
  world.commit();
  const Mark mark = world.mark();
  EXPECT_EQ(world.forgetChunks(kEverywhere).error().code, ErrorCode::uncommitted);
  EXPECT_EQ(world.followCells(true).error().code, ErrorCode::uncommitted);
  EXPECT_TRUE(world.forget(mark));
  EXPECT_EQ(world.forgetChunks(kEverywhere), 1U);
  EXPECT_EQ(world.remove(gone).error().code, ErrorCode::staleHandle);
  EXPECT_EQ(world.cellOf(stays), (Cell{40, 4}));
  // The numbers of chunks that went are given out again, the least first: so nothing else has to be saved.
  const PolygonHandle far = place(world, {1'000, 4}, unitSquare());
  EXPECT_EQ(chunkOf(far), chunkOf(gone));
  EXPECT_EQ(chunkOf(place(world, {3, 4}, unitSquare())), 3U);
}

// With a thousand chunks they lie in slabs, several in each, which do not go with one of them.
TEST(LeavingByHand, AChunkThatComesTakesThePlaceOfOneThatWent) {
  World world;
  const ShapeId square = must(world.shape(kUnitSquare));
  std::vector<PolygonHandle> handles;
  for (std::int32_t k = 0; k < 1'000; ++k) handles.push_back(must(world.add({32 * k, 0}, square, 1)));
  world.commit();
  std::uint64_t bytes = 0;
  for (std::int32_t k = 0; k < 2'000; ++k) {
    PolygonHandle& one = handles[static_cast<std::size_t>(k) * 7 % 1'000];  // so that no slab is left by all
    EXPECT_TRUE(world.remove(one));
    world.commit();
    EXPECT_EQ(world.forgetChunks(kEverywhere), 1U);
    one = must(world.add({32 * k, 64}, square, 1));
    world.commit();
    if (k == 0) bytes = world.stats().bytes;
  }
  EXPECT_LT(world.stats().bytes, bytes + 100'000) << "a chunk takes 10,000, and the first ones have no slab";
}

}  // namespace
}  // namespace lgs::test
