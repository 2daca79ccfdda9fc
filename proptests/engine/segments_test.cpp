// What calls of segments mean that no outline shows: ids that are none, and what is seen before a commit.
#include "proptests/support/must.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

TEST(Segments, UnknownIdsAreRefused) {
  World world;
  place(world, {}, ramp());
  world.commit();
  for (const std::uint32_t value : {0U, 4U, 5000U, 0xffff'ffffU}) {
    const auto refused = refusal(world.segment({value}));
    EXPECT_EQ(refused.code, ErrorCode::unknownSegment);
    EXPECT_EQ(refused.segment, (SegmentId{value}));
    EXPECT_EQ(message(refused), "segment " + std::to_string(value) + " is not alive; it was removed, or never existed");
  }
  EXPECT_TRUE(world.segment({3}));
  removeAll(world, {});
  EXPECT_TRUE(world.segment({3})) << "alive until the commit";
  world.commit();
  EXPECT_FALSE(world.segment({3}));
}

TEST(Segments, StayAsTheyAreWhileEditsAreNotCommitted) {
  World world;
  place(world, {}, unitSquare(), 1);
  world.commit();
  const Snapshot before = snapshotOf(world, {});
  place(world, {1, 0}, unitSquare(), 2);
  place(world, {0, 5}, ramp(), 2);
  Snapshot after = snapshotOf(world, {});
  EXPECT_EQ(after.segments, before.segments);
  EXPECT_EQ(after.loops, before.loops);
  EXPECT_EQ(after.segmentCount, before.segmentCount);
  EXPECT_EQ(after.polygonCount, 3U);
}

TEST(Segments, PreserveKeepsOverlapsAndLeavesLoopsThatAreMutual) {
  World world([](Block a, Block b) {
    EXPECT_LE(a, b) << "asked with the smaller block first";
    return a == 1 && b == 2;
  });
  place(world, {0, 0}, unitSquare(), 2);
  place(world, {1, 0}, unitSquare(), 1);
  place(world, {2, 0}, unitSquare(), 3);
  world.commit();
  EXPECT_EQ(world.segments().size(), 10U);  // 1|2 kept on both sides, 1|3 cancelled
  for (const Loop& loop : world.loops())
    for (std::size_t k = 0; k < loop.segments.size(); ++k)
      EXPECT_EQ(world.segment(loop.segments[k])->successor, loop.segments[(k + 1) % loop.segments.size()]);
}

}  // namespace
}  // namespace lgs::test
