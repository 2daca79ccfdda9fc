// Law 12, redo: what can no longer be redone takes no memory. That the edits come back as if they had
// never been undone is for any calls to show (oracle/check/laws/past.cpp).
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

TEST(RedoByHand, RollingBackFurtherWithoutKeepingDropsWhatIsAhead) {
  World world;
  std::vector<Mark> marks{world.mark()};
  for (std::int32_t i = 0; i < 3; ++i) {
    place(world, {40 * i, 0}, unitSquare());
    world.commit();
    marks.push_back(world.mark());
  }
  ASSERT_TRUE(world.rollBack(marks[2], Undone::keep));
  ASSERT_TRUE(world.rollBack(marks[1]));
  EXPECT_FALSE(world.redo(marks[3]));
  place(world, {80, 0}, unitSquare(), 9);  // as many edits as there were
  world.commit();
  EXPECT_FALSE(world.redo(marks[3]));
}

TEST(RedoByHand, WhatIsDroppedTakesNoMemory) {
  World world;
  const Mark first = world.mark();
  const auto work = [&](Undone undone) {
    const Mark begin = world.mark();
    for (std::int32_t k = 1; k <= 3'000; ++k) {
      place(world, {1, 1}, {{0, 0}, {k, 0}, {0, k}});
      world.commit();
      (void)world.mark();
      removeAll(world, {1, 1});
      world.commit();
    }
    const Mark end = world.mark();
    ASSERT_TRUE(world.rollBack(begin, undone));
    EXPECT_EQ(world.redo(end).has_value(), undone == Undone::keep);
    ASSERT_TRUE(world.rollBack(begin, undone));
    ASSERT_TRUE(world.forget(begin));
  };
  work(Undone::drop);
  const std::uint64_t dropped = world.stats().bytes;
  work(Undone::keep);
  EXPECT_GT(world.stats().bytes, dropped + 100'000) << "an earlier mark is there to come back to";
  ASSERT_TRUE(world.forget(first));
  world.commit();
  EXPECT_LT(world.stats().bytes, dropped + 10'000);
  EXPECT_LT(world.stats().contents, 10U);
}

}  // namespace
}  // namespace lgs::test
