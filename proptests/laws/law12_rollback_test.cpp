// Law 12, marks, groups and copies, by hand: that to roll back is never having left the checker sees.
#include "proptests/support/must.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

TEST(RollBackByHand, MarksThatAreNoneAreRefused) {
  World world;
  EXPECT_EQ(world.rollBack({}).error().code, ErrorCode::unknownMark);
  EXPECT_EQ(world.forget(Mark{7}).error().code, ErrorCode::unknownMark);
  const Mark mark = world.mark();
  EXPECT_TRUE(world.forget(mark));
  const auto refused = refusal(world.rollBack(mark));
  EXPECT_EQ(refused.code, ErrorCode::unknownMark);
  EXPECT_EQ(message(refused),
            "this world has no such mark; it was forgotten, or the world rolled back to a moment before it");
  EXPECT_NE(world.mark(), mark);
}

TEST(RollBackByHand, MarksAreForOneWorldAndItsCopies) {
  World world;
  const Mark before = world.mark();
  place(world, {}, unitSquare());
  world.commit();
  World copy = world;
  World loaded = *World::load(saved(world), {});
  const Mark ofWorld = world.mark(), ofCopy = copy.mark(), ofLoaded = loaded.mark();
  for (const Mark mark : {before, ofWorld, ofCopy}) EXPECT_FALSE(loaded.rollBack(mark));
  for (const Mark mark : {ofCopy, ofLoaded}) EXPECT_FALSE(world.rollBack(mark));
  for (const Mark mark : {ofWorld, ofLoaded}) EXPECT_FALSE(copy.rollBack(mark));
  EXPECT_TRUE(copy.rollBack(before));
  EXPECT_TRUE(copy.isEmpty({}));
  EXPECT_FALSE(world.isEmpty({}));
}

TEST(RollBackByHand, ACopyHasNoGroup) {
  World world;
  const Mark mark = world.mark();
  std::optional<World> during;
  {
    Transaction group = world.edit();
    place(world, {}, unitSquare());
    Transaction inner = world.edit();
    place(world, {1, 0}, unitSquare());
    during = world;
    inner.keep();
    group.keep();
  }
  World after = world;
  EXPECT_TRUE(samePolygons(*during, after)) << "it has the edits that were made";
  for (World* copy : {&*during, &after}) {
    ASSERT_TRUE(copy->forget(mark));
    for (const Cell cell : cellsOf({{0, 2}, {31, 31}})) place(*copy, cell, ramp());
    copy->commit();
  }
  // It had room for two marks. To undo 960 edits would take more.
  EXPECT_LT(during->stats().bytes, after.stats().bytes + 1'000) << "it keeps what is needed to undo the group";
}

TEST(RollBackByHand, AFailedGroupLeavesWhatARollBackReported) {
  World world;
  const Mark mark = world.mark();
  place(world, {0, 0}, unitSquare(), 1);
  world.commit();
  ASSERT_TRUE(world.rollBack(mark));
  const Changes reported = world.changesOfRollBack();
  EXPECT_EQ(reported.removed.size(), 4U);
  {
    const Transaction group = world.edit();
    place(world, {0, 0}, unitSquare(), 1);
  }
  EXPECT_EQ(copyOf(world.changesOfRollBack()), copyOf(reported));
}

TEST(RollBackByHand, ATransactionThatWasCommittedInStays) {
  World world;
  {
    const Transaction group = world.edit();
    place(world, {}, unitSquare());
    world.commit();
    place(world, {1, 0}, unitSquare());
  }
  EXPECT_FALSE(world.isEmpty({}));
  EXPECT_FALSE(world.isEmpty({1, 0}));
}

TEST(RollBackByHand, ATransactionThatWasGoneBackBeyondEnds) {
  World world;
  const Mark mark = world.mark();
  {
    const Transaction group = world.edit();
    place(world, {}, unitSquare());
    ASSERT_TRUE(world.rollBack(mark));
    place(world, {1, 0}, unitSquare());
  }
  EXPECT_TRUE(world.isEmpty({}));
  EXPECT_FALSE(world.isEmpty({1, 0}));
}

TEST(RollBackByHand, NothingIsKeptWithoutMarks) {
  World world;
  std::vector<Mark> marks;
  const auto work = [&](bool isMarked = false) {
    for (int k = 0; k < 100; ++k) {
      if (isMarked) marks.push_back(world.mark());
      fill(world, {{0, 0}, {20, 20}});
      world.commit();
      ASSERT_TRUE(world.clear(CellRect{{0, 0}, {20, 20}}));
      world.commit();
    }
  };
  for (int k = 0; k < 3; ++k) work();  // the cells have been placed in more often than their words can count
  const std::uint64_t bytes = world.stats().bytes;
  work(true);
  EXPECT_GT(world.stats().bytes, bytes + 1'000'000);
  for (const Mark mark : marks) EXPECT_TRUE(world.forget(mark));
  work();
  EXPECT_LT(world.stats().bytes, bytes + 10'000);
}

TEST(RollBackByHand, WhatCellsHeldIsForgottenWithTheMark) {
  World world;
  std::vector<Mark> marks{world.mark()};
  const auto work = [&] {
    for (std::int32_t k = 1; k <= 3'000; ++k) {
      place(world, {}, {{0, 0}, {k, 0}, {0, k}});
      world.commit();
      marks.push_back(world.mark());
      removeAll(world, {});
      world.commit();
    }
  };
  work();
  EXPECT_GE(world.stats().contents, 3'000U);
  ASSERT_TRUE(world.rollBack(marks.front()));
  marks.resize(1);
  work();
  for (const Mark mark : marks) ASSERT_TRUE(world.forget(mark));
  world.commit();
  EXPECT_EQ(world.stats().contents, 0U);
}

TEST(RollBackByHand, NothingIsKeptOfCommitsThatFindNothing) {
  World world;
  const Mark mark = world.mark();
  place(world, {}, unitSquare());
  world.commit();
  world.commit();
  const std::uint64_t bytes = world.stats().bytes;
  for (int k = 0; k < 1'000; ++k) world.commit();
  EXPECT_EQ(world.stats().bytes, bytes);
  ASSERT_TRUE(world.rollBack(mark));
  EXPECT_EQ(world.changesOfRollBack().removed.size(), 4U);
}

// After some commits each side of the square has the id that it had.
TEST(RollBackByHand, AnIdThatNamesAnotherSegmentAtTheSamePlaceIsToldAsGoneAndCome) {
  World world;
  const PolygonHandle square = place(world, {0, 0}, unitSquare());
  const std::vector<SegmentId> ids = world.commit().added;
  const Mark mark = world.mark();
  const auto starts = [&] {
    std::vector<std::optional<Point>> all;
    for (const SegmentId id : ids) {
      const auto s = world.segment(id);
      all.push_back(s ? std::optional(s->start) : std::nullopt);
    }
    return all;
  };
  const auto first = starts();
  Block block = 1;
  do {
    ASSERT_TRUE(world.setBlock(square, ++block));
    world.commit();
  } while (starts() != first && block < 100);
  ASSERT_EQ(starts(), first);
  ASSERT_TRUE(world.rollBack(mark));
  EXPECT_EQ(world.changesOfRollBack().removed, ids);
  EXPECT_EQ(world.changesOfRollBack().added, ids);
  EXPECT_TRUE(world.changesOfRollBack().relinked.empty());
}

TEST(RollBackByHand, FollowersAreToldWhatWasCommittedAndNotWhatIsPending) {
  World world;
  ASSERT_TRUE(world.followCells(true));
  const Mark mark = world.mark();
  place(world, {1, 0}, unitSquare());
  world.commit();
  ASSERT_TRUE(world.clear(Cell{1, 0}));
  ASSERT_TRUE(world.rollBack(mark));
  const auto changes = world.cellChanges();
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].before.size(), 1U);
  EXPECT_TRUE(changes[0].now.empty());
}

}  // namespace
}  // namespace lgs::test
