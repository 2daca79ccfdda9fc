// Law 12, going forward again: edits that were undone come back as if they had never been undone.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

class GoingForwardByHand : public testing::Test {
 protected:
  GoingForwardByHand() {
    marks.push_back(world.checkpoint());
    for (std::int32_t i = 0; i < 3; ++i) {
      handles.push_back(place(world, {40 * i, 0}, unitSquare()));  // each in a chunk of its own
      world.commit();
      marks.push_back(world.checkpoint());
    }
  }
  bool isForward(Mark mark) {
    const auto done = world.rollForward(mark);
    if (!done) {
      EXPECT_EQ(done.error().code, ErrorCode::unknownMark);
    }
    return done.has_value();
  }

  World world;
  std::vector<Mark> marks;
  std::vector<PolygonHandle> handles;
};

TEST_F(GoingForwardByHand, HandlesAndMarksComeBackStepByStep) {
  EXPECT_FALSE(isForward(marks[3])) << "it is not ahead";
  for (const std::size_t k : {2U, 1U, 0U}) {
    ASSERT_TRUE(world.rollBack(marks[k], Undone::keep));
    EXPECT_FALSE(world.polygon(handles[k]));
  }
  for (const std::size_t k : {1U, 2U, 3U}) {
    EXPECT_FALSE(world.rollBack(marks[k])) << "it is ahead";
    ASSERT_TRUE(isForward(marks[k]));
    EXPECT_TRUE(world.polygon(handles[k - 1]));
    EXPECT_EQ(world.changesOfRollBack().added.size(), 4U);
  }
  EXPECT_FALSE(isForward(marks[3]));
  ASSERT_TRUE(world.rollBack(marks[0], Undone::keep)) << "all at once";
  ASSERT_TRUE(isForward(marks[2]));
  EXPECT_FALSE(isForward(marks[1])) << "it is behind";
  ASSERT_TRUE(world.rollBack(marks[1]));
}

TEST_F(GoingForwardByHand, IsRefusedAfterAnEdit) {
  ASSERT_TRUE(world.rollBack(marks[1], Undone::keep));
  place(world, {5, 5}, unitSquare());
  EXPECT_FALSE(isForward(marks[2]));
  world.commit();
  EXPECT_FALSE(isForward(marks[2]));
}

TEST_F(GoingForwardByHand, IsRefusedAfterANewShapeAndAfterAMarkOfBeforeIsGone) {
  ASSERT_TRUE(world.rollBack(marks[1], Undone::keep));
  shapeOf(world, {ramp()});
  EXPECT_FALSE(isForward(marks[2]));
  ASSERT_TRUE(world.rollBack(marks[1]));
  EXPECT_TRUE(isForward(marks[2]));
  ASSERT_TRUE(world.rollBack(marks[1], Undone::keep));
  const Mark late = world.checkpoint();
  ASSERT_TRUE(world.forget(marks[0]));
  ASSERT_TRUE(world.forget(marks[1]));
  ASSERT_TRUE(world.forget(late));
  EXPECT_FALSE(isForward(marks[2]));
}

TEST_F(GoingForwardByHand, GoingBackFurtherWithoutKeepingDropsWhatIsAhead) {
  ASSERT_TRUE(world.rollBack(marks[2], Undone::keep));
  ASSERT_TRUE(world.rollBack(marks[1]));
  EXPECT_FALSE(isForward(marks[3]));
  place(world, {80, 0}, unitSquare(), 9);  // as many edits as there were
  world.commit();
  EXPECT_FALSE(isForward(marks[3]));
}

TEST_F(GoingForwardByHand, AGroupThatBeganBeforeAndIsNotKeptDropsWhatIsAhead) {
  {
    const Transaction group = world.edit();
    place(world, {7, 7}, unitSquare());
    const Mark inner = world.checkpoint();
    place(world, {8, 8}, unitSquare());
    const Mark end = world.checkpoint();
    ASSERT_TRUE(world.rollBack(inner, Undone::keep));
    marks.push_back(end);
  }
  place(world, {7, 7}, unitSquare(), 5);
  EXPECT_FALSE(isForward(marks.back()));
  EXPECT_TRUE(world.isEmpty({8, 8}));
}

TEST_F(GoingForwardByHand, MarksMadeSinceAreVoid) {
  ASSERT_TRUE(world.rollBack(marks[1], Undone::keep));
  const Mark since = world.checkpoint();
  ASSERT_TRUE(world.rollBack(since));
  ASSERT_TRUE(isForward(marks[2]));
  EXPECT_FALSE(world.rollBack(since));
  EXPECT_TRUE(world.rollBack(marks[1]));
}

// A game that makes a mark after each edit can redo also what came to nothing.
TEST_F(GoingForwardByHand, AMarkMadeSinceThatTheWorldGoesBackBeyondIsAhead) {
  ASSERT_TRUE(world.rollBack(marks[2], Undone::keep));
  EXPECT_EQ(world.clear(Cell{9, 9}).value(), 0U);
  world.commit();
  const Mark since = world.checkpoint();
  ASSERT_TRUE(world.rollBack(marks[1], Undone::keep));
  EXPECT_FALSE(isForward(marks[3]));
  ASSERT_TRUE(isForward(since));
  EXPECT_TRUE(world.polygon(handles[1]));
  EXPECT_TRUE(world.rollBack(marks[2]));
}

// It went back to where an edit was pending. That is committed then, and undone before the world goes forward; the mark
// of there may be forgotten.
TEST(GoingForwardWithPendingEdits, ACommitEndsNoRedo) {
  for (const bool isForgotten : {false, true}) {
    for (const bool isFollowed : {false, true}) {
      World world;
      EXPECT_TRUE(world.followCells(isFollowed));
      const Mark first = world.checkpoint();
      place(world, {0, 0}, unitSquare());
      const Mark pending = world.checkpoint();
      place(world, {1, 0}, unitSquare());
      world.commit();
      const Mark ahead = world.checkpoint();
      const std::vector<SegmentId> ids = world.segments();
      ASSERT_TRUE(world.rollBack(pending, Undone::keep));
      ASSERT_TRUE(!isForgotten || world.forget(pending));
      EXPECT_EQ(world.commit().added.size(), 4U);
      ASSERT_TRUE(world.rollForward(ahead));
      EXPECT_EQ(world.segments(), ids);
      EXPECT_EQ(world.cellChanges().size(), isFollowed ? 1U : 0U) << "the other one was told";
      ASSERT_TRUE(world.rollBack(first));
      EXPECT_EQ(world.segments().size(), 0U);
      EXPECT_EQ(world.cellChanges().size(), isFollowed ? 2U : 0U);
    }
  }
}

TEST_F(GoingForwardByHand, WhatIsDroppedTakesNoMemory) {
  const auto work = [&](Undone undone) {
    const Mark begin = world.checkpoint();
    for (std::int32_t k = 1; k <= 3'000; ++k) {
      place(world, {1, 1}, {{0, 0}, {k, 0}, {0, k}});
      world.commit();
      (void)world.checkpoint();
      removeAll(world, {1, 1});
      world.commit();
    }
    const Mark end = world.checkpoint();
    ASSERT_TRUE(world.rollBack(begin, undone));
    EXPECT_EQ(isForward(end), undone == Undone::keep);
    ASSERT_TRUE(world.rollBack(begin, undone));
    ASSERT_TRUE(world.forget(begin));
  };
  work(Undone::drop);
  const std::uint64_t dropped = world.stats().bytes;
  work(Undone::keep);
  EXPECT_GT(world.stats().bytes, dropped + 100'000) << "an earlier mark is there to come back to";
  for (std::size_t k = 0; k < 4; ++k) ASSERT_TRUE(world.forget(marks[k]));
  world.commit();
  EXPECT_LT(world.stats().bytes, dropped + 10'000);
  EXPECT_LT(world.stats().contents, 10U);
}

}  // namespace
}  // namespace lgs::test
