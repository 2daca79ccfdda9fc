// A view of the ground is told, at each commit and roll-back, which cells changed: by hand. That these are right is a law,
// oracle/check/laws/cells.cpp.
#include "proptests/support/law.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

TEST(ViewsByHand, NothingIsFollowedUnlessItIsAskedFor) {
  World world;
  place(world, {}, unitSquare());
  world.commit();
  EXPECT_TRUE(world.cellChanges().empty());
  ASSERT_TRUE(world.followCells(true));
  EXPECT_TRUE(world.cellChanges().empty());
  place(world, {1, 0}, unitSquare());
  world.commit();
  EXPECT_EQ(world.cellChanges().size(), 1U);
  ASSERT_TRUE(world.followCells(true));
  EXPECT_EQ(world.cellChanges().size(), 1U) << "it followed already";
  ASSERT_TRUE(world.followCells(false));
  EXPECT_TRUE(world.cellChanges().empty());
  place(world, {2, 0}, unitSquare());
  world.commit();
  EXPECT_TRUE(world.cellChanges().empty());
}

TEST(ViewsByHand, FollowingBeginsAndEndsBetweenCommitsWithoutMarks) {
  World world;
  place(world, {}, unitSquare());
  for (const bool follow : {true, false}) EXPECT_EQ(refusal(world.followCells(follow)).code, ErrorCode::uncommitted);
  world.commit();
  const Mark mark = world.mark();
  EXPECT_FALSE(world.followCells(true));
  ASSERT_TRUE(world.forget(mark));
  EXPECT_TRUE(world.followCells(true));
}

TEST(ViewsByHand, FollowingBeginsBehindNotesThatAreGone) {
  World world;
  {
    Transaction group = world.edit();
    place(world, {}, unitSquare());
    group.keep();
  }
  world.commit();
  ASSERT_TRUE(world.followCells(true));
  place(world, {1, 0}, unitSquare());
  world.commit();
  ASSERT_EQ(world.cellChanges().size(), 1U);
  EXPECT_EQ(world.cellChanges()[0].cell, (Cell{1, 0}));
}

TEST(ViewsByHand, WhatCellsHeldOutlivesIt) {
  World world;
  ASSERT_TRUE(world.followCells(true));
  for (std::int32_t k = 1; k <= 3'000; ++k) place(world, {k, 0}, {{0, 0}, {k, 0}, {0, k}});
  world.commit();
  ASSERT_TRUE(world.clear({{1, 0}, {3'000, 0}}));
  world.commit();  // forgets the contents that no cell has
  EXPECT_EQ(world.stats().contents, 0U);
  const World copy = world;
  fill(world, {{1, 0}, {3'000, 0}});
  world.commit();  // what it told before is overwritten
  world = World();
  ASSERT_EQ(copy.cellChanges().size(), 3'000U);
  for (const CellChange& change : copy.cellChanges()) {
    ASSERT_EQ(change.before.size(), 1U);
    EXPECT_EQ(change.before[0].vertices[1].x, change.cell.i);
    EXPECT_TRUE(change.now.empty());
  }
}

TEST(ViewsByHand, NothingIsKeptBeyondTheLastCommit) {
  World world;
  ASSERT_TRUE(world.followCells(true));
  const auto work = [&] {
    for (int k = 0; k < 100; ++k) {
      fill(world, {{0, 0}, {20, 20}});
      world.commit();
      ASSERT_TRUE(world.clear(CellRect{{0, 0}, {20, 20}}));
      world.commit();
    }
  };
  for (int k = 0; k < 3; ++k) work();
  const std::uint64_t bytes = world.stats().bytes;
  work();
  EXPECT_EQ(world.stats().bytes, bytes);
}

}  // namespace
}  // namespace lgs::test
