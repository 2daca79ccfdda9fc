// What a commit that finds nothing does to groups and redo; what marks cost a game that streams; and the ends of the world.
#include "proptests/laws/unloaded.h"
#include "proptests/support/must.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

// Whatever the commit before the group did.
TEST(Groups, ACommitThatFindsNothingEndsNone) {
  for (const bool isRemovedBefore : {false, true}) {
    for (const bool isFollowed : {false, true}) {
      World world;
      EXPECT_TRUE(world.followCells(isFollowed));
      place(world, {0, 0}, unitSquare());
      world.commit();
      if (isRemovedBefore) removeAll(world, {0, 0});
      world.commit();
      {
        const Transaction group = world.edit();
        EXPECT_TRUE(world.commit().added.empty());
        place(world, {5, 5}, unitSquare());
      }
      EXPECT_TRUE(world.isEmpty({5, 5})) << isRemovedBefore << isFollowed;
      {
        const Transaction group = world.edit();
        place(world, {5, 5}, unitSquare());
        world.commit();
        place(world, {6, 5}, unitSquare());
      }
      EXPECT_FALSE(world.isEmpty({6, 5})) << isRemovedBefore << isFollowed;
    }
  }
}

// A chunk that left is something to find, and a roll-back that shows it finds it, too.
TEST(Groups, WhatShowsThatAChunkLeftEndsThem) {
  for (const bool isRolledBack : {false, true}) {
    World world;
    place(world, {40, 0}, unitSquare());
    world.commit();
    {
      const Transaction group = world.edit();
      const Mark within = world.mark();
      ASSERT_TRUE(world.unload({{32, 0}, {63, 31}}, {}));
      if (isRolledBack)
        ASSERT_TRUE(world.rollBack(within));
      else
        world.commit();
      EXPECT_EQ(world.segments().size(), 0U);
      place(world, {5, 5}, unitSquare());
    }
    EXPECT_FALSE(world.isEmpty({5, 5})) << isRolledBack;
    world.commit();
    EXPECT_EQ(world.segments().size(), 4U);
  }
}

TEST(Groups, ACommitThatFindsNothingEndsNoRedo) {
  for (const bool isFollowed : {false, true}) {
    World world;
    EXPECT_TRUE(world.followCells(isFollowed));
    const Mark before = world.mark();
    place(world, {0, 0}, unitSquare());
    world.commit();
    const Mark after = world.mark();
    ASSERT_TRUE(world.rollBack(before, Undone::keep));
    world.commit();
    const Mark since = world.mark();
    world.commit();
    ASSERT_TRUE(world.redo(after));
    EXPECT_EQ(world.changesOfRollBack().added.size(), 4U);
    EXPECT_EQ(world.cellChanges().size(), isFollowed ? 1U : 0U);
    EXPECT_FALSE(world.forget(since)) << "it is void";
    EXPECT_TRUE(world.rollBack(before));
    EXPECT_EQ(world.segments().size(), 0U);
  }
}

// A game that always has a mark streams chunks in and out.
TEST(UnloadedByHand, AWalkWithMarksLeavesNothingBehind) {
  World world;
  for (std::int32_t k = 0; k < 8; ++k) place(world, {32 * k, 0}, unitSquare());
  world.commit();
  Shelf shelf;
  Mark mark = world.mark();
  std::uint64_t bytes = 0;
  for (std::int32_t k = 0; k < 2'000; ++k) {
    const CellRect there{{32 * (k % 8), 0}, {32 * (k % 8) + 31, 31}};
    ASSERT_EQ(world.unload(there, shelf.sink()), 1U);
    if (k % 3 != 0) world.commit();
    ASSERT_TRUE(shelf.reload(world, there.min));
    world.commit();
    const Mark next = world.mark();
    ASSERT_TRUE(world.forget(mark));
    mark = next;
    if (k == 200) bytes = world.stats().bytes;
  }
  EXPECT_EQ(world.stats().bytes, bytes);
}

}  // namespace
}  // namespace lgs::test
