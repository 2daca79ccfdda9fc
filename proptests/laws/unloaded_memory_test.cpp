// Chunks that are unloaded, by hand: what memory they cost, and what is given back.
#include "unloaded.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

TEST(UnloadedByHand, MemoryGoesDownAndStaysDown) {
  World world = rowOfChunks(1);
  fill(world, {{0, 32}, {32 * 200 - 1, 63}});
  world.commit();
  const std::uint64_t full = world.stats().bytes;
  Shelf shelf;
  EXPECT_EQ(world.unload({{64, 32}, {32 * 200 - 1, 63}}, shelf.sink()), 198U);
  world.commit();
  const std::uint64_t empty = world.stats().bytes;
  EXPECT_LT(empty + 195U * 5'000, full) << "each chunk had its cells alone 5,120 bytes";
  std::uint64_t after = 0;
  for (int k = 0; k < 1'000; ++k) {
    EXPECT_TRUE(shelf.reload(world, {64, 32}));
    world.commit();
    EXPECT_EQ(world.unload(chunkAt(2, 1), {}), 1U);
    world.commit();
    if (k == 2) after = world.stats().bytes;
  }
  EXPECT_EQ(world.stats().bytes, after) << "a thousand goings and comings leave nothing";
  EXPECT_EQ(world.forgetChunks(kEverywhere), 197U);
  EXPECT_LT(world.stats().bytes, after - 197U * 60);
}

TEST(UnloadedByHand, AWalkLeavesLittleBehind) {
  World world;
  const ShapeId diamond = shapeOf(world, shapeNamed("diamond"));
  std::uint64_t before = 0;
  for (std::int32_t k = 0; k < 201; ++k) {
    EXPECT_TRUE(world.fill(chunkAt(k, 0), diamond, 1));
    world.commit();
    EXPECT_EQ(world.unload(chunkAt(k - 1, 0), {}), k == 0 ? 0U : 1U);
    world.commit();
    if (k == 100) before = world.stats().bytes;
  }
  EXPECT_LT(world.stats().bytes, before + 100U * 1'500) << "a chunk's lists of segments alone take 4,096";
}

TEST(UnloadedByHand, SegmentsThatWentGiveTheirMemoryBack) {
  World world;
  const ShapeId diamond = shapeOf(world, shapeNamed("diamond"));
  constexpr std::uint64_t kSegments = 64 * 1'024 * 4;
  EXPECT_TRUE(world.fill({{0, 0}, {255, 255}}, diamond, 1));
  EXPECT_EQ(world.commit().added.size(), kSegments);
  const World copy = world;
  std::uint64_t full = 0, left = 0;
  for (int k = 0; k < 10; ++k) {
    Shelf shelf;
    EXPECT_EQ(world.unload({{0, 32}, {255, 255}}, shelf.sink()), 56U);
    world.commit();
    if (k == 1) left = world.stats().bytes;
    EXPECT_LT(world.stats().bytes, k == 0 ? UINT64_MAX : full - 28 * kSegments / 2) << "a segment takes 28 bytes";
    const World part = world;
    EXPECT_EQ(part.segments().size(), 8U * 1'024 * 4);
    for (std::int32_t j = 1; j < 8; ++j)
      for (std::int32_t i = 0; i < 8; ++i) EXPECT_TRUE(shelf.reload(world, chunkAt(i, j).min));
    EXPECT_EQ(world.commit().added.size(), 7U * 8 * 1'024 * 4);
    full = world.stats().bytes;  // with the lists of changes, which are as long as they ever were
  }
  EXPECT_EQ(world.unload({{0, 32}, {255, 255}}, {}), 56U);
  world.commit();
  EXPECT_EQ(world.stats().bytes, left) << "goings and comings leave nothing";
  EXPECT_EQ(copy.segments().size(), kSegments);
}

// Its border is made of what its cells held then, and not of what the notes between two commits have left of that.
TEST(UnloadedByHand, AChunkThatGoesBackToBeingUnloadedHasTheBorderOfThen) {
  World world;
  Shelf shelf;
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_TRUE(world.add({32, 5}, square, 1));
  EXPECT_EQ(world.unload(chunkAt(1, 0), shelf.sink()), 1U);
  world.commit();
  const Mark mark = world.mark();
  EXPECT_TRUE(world.add({31, 5}, square, 1));  // it wakes the border
  EXPECT_EQ(world.commit().added.size(), 3U);
  EXPECT_TRUE(shelf.reload(world, {32, 0}));
  EXPECT_TRUE(world.clear(Cell{32, 5}));
  EXPECT_EQ(world.commit().added.size(), 1U);
  EXPECT_TRUE(world.rollBack(mark));
  EXPECT_TRUE(world.add({31, 5}, square, 1));
  EXPECT_EQ(world.commit().added.size(), 3U);
}

// The border of the unloaded chunk is to be settled anew, since the chunk beside it was forgotten. While a mark is held
// each commit does that again.
TEST(UnloadedByHand, CommitsUnderAMarkDoNotAddUp) {
  World world = rowOfChunks(3);
  ASSERT_TRUE(world.unload({{0, 0}, {31, 31}}, {}));
  world.commit();
  ASSERT_TRUE(world.clear(CellRect{{32, 0}, {63, 31}}));
  world.commit();
  ASSERT_EQ(world.forgetChunks(CellRect{{32, 0}, {63, 31}}), 1U);
  const Mark mark = world.mark();
  for (int k = 0; k < 100; ++k) world.commit();
  const std::uint64_t before = world.stats().bytes;
  for (int k = 0; k < 1'000; ++k) world.commit();
  EXPECT_EQ(world.stats().bytes, before);
  EXPECT_TRUE(world.forget(mark));
}

}  // namespace
}  // namespace lgs::test
