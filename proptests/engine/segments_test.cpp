// Reading segments: every field, ids, rectangles of cells.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lgs::test {
namespace {

Segment segmentAt(const World& world, Point start, Point end) {
  for (const SegmentId id : world.segments()) {
    const Segment s = *world.segment(id);
    if (s.start == start && s.end == end) return s;
  }
  ADD_FAILURE() << "no segment " << start.x << ' ' << start.y << " to " << end.x << ' ' << end.y;
  return {};
}

TEST(Segments, SayAllAboutThemselves) {
  World world;
  const PolygonHandle square = place(world, {0, 0}, unitSquare(), 7), slope = place(world, {1, 0}, ramp(), 8);
  world.commit();
  // The ramp's wall is on its right, so the square's right side stays: together one loop through (U, 0).
  ASSERT_EQ(world.segments().size(), 7U);
  const Segment floor = segmentAt(world, {U, 0}, {2 * U, 0});
  EXPECT_EQ(floor.block, 8U);
  EXPECT_EQ(floor.polygon, slope);
  EXPECT_EQ(floor.cell, (Cell{1, 0}));
  EXPECT_EQ(floor.ghost1, (Point{0, 0}));
  EXPECT_EQ(floor.ghost2, (Point{2 * U, U}));
  const Segment before = *world.segment(floor.predecessor), after = *world.segment(floor.successor);
  EXPECT_EQ(before.polygon, square);
  EXPECT_EQ(before.block, 7U);
  EXPECT_EQ(before.cell, (Cell{0, 0}));
  EXPECT_EQ(before.end, floor.start);
  EXPECT_EQ(before.successor, floor.id);
  EXPECT_EQ(after.start, floor.end);
  EXPECT_EQ(after.predecessor, floor.id);
  const Segment wall = segmentAt(world, {U, 0}, {U, U});  // through the wedge between wall and slope
  EXPECT_EQ(wall.ghost1, (Point{2 * U, U}));
}

TEST(Segments, OfARectangleAreThoseOfItsCells) {
  World world;
  ASSERT_TRUE(world.fill({{-40, -2}, {40, 2}}, shapeOf(world, shapeNamed("diamond")), 1));
  world.commit();
  EXPECT_EQ(world.segments().size(), 4U * 81U * 5U);
  for (const CellRect& rect : {CellRect{{-33, -1}, {-31, 0}},
                               {{30, 2}, {35, 2}},
                               {{-100, -100}, {100, 100}},
                               {{-33, -100}, {-31, 100}},
                               {{5, 3}, {9, 9}}}) {
    std::set<SegmentId> expected;
    for (const SegmentId id : world.segments())
      if (contains(rect, world.segment(id)->cell)) expected.insert(id);
    const std::vector<SegmentId> actual = world.segments(rect);
    EXPECT_EQ(std::set<SegmentId>(actual.begin(), actual.end()), expected);
    EXPECT_EQ(actual.size(), expected.size());
  }
  const std::vector<SegmentId> all = world.segments();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  EXPECT_EQ(all.back().value, world.maxSegmentId());
}

TEST(Segments, UnknownIdsAreRefused) {
  World world;
  place(world, {}, ramp());
  world.commit();
  for (const std::uint32_t value : {0U, 4U, 5000U, 0xffff'ffffU}) {
    const auto refused = world.segment({value});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::unknownSegment);
    EXPECT_EQ(refused.error().segment, (SegmentId{value}));
    EXPECT_EQ(message(refused.error()),
              "segment " + std::to_string(value) + " is not alive; it was removed, or never existed");
  }
  EXPECT_TRUE(world.segment({3}));
  removeAll(world, {});
  EXPECT_TRUE(world.segment({3})) << "alive until the commit";
  world.commit();
  EXPECT_FALSE(world.segment({3}));
}

TEST(Segments, IdsOfTheRemovedAreUsedAgainOnlyByTheNextCommit) {
  World world;
  std::set<SegmentId> lastRemoved;
  bool reused = false;
  for (int k = 0; k < 60; ++k) {
    const Cell cell{k % 4, k % 3};
    removeAll(world, cell);
    if (k % 5 != 0) place(world, cell, k % 2 ? ramp() : unitSquare());
    const Changes& changes = world.commit();
    for (const SegmentId id : changes.added) {
      EXPECT_EQ(std::count(changes.removed.begin(), changes.removed.end(), id), 0);
      reused |= lastRemoved.contains(id);
    }
    for (const SegmentId id : changes.removed) EXPECT_FALSE(world.segment(id));
    lastRemoved = {changes.removed.begin(), changes.removed.end()};
  }
  EXPECT_TRUE(reused);
  EXPECT_LT(world.maxSegmentId(), 120U) << "ids stay dense";
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

TEST(Segments, AnEditTakenBackChangesNothing) {
  World world;
  ASSERT_TRUE(world.fill({{0, 0}, {3, 3}}, shapeOf(world, shapeNamed("diamond")), 1));
  world.commit();
  const Snapshot before = snapshotOf(world, {});
  ASSERT_TRUE(world.remove(place(world, {9, 1}, unitSquare())));
  ASSERT_TRUE(world.remove(place(world, {1, 1}, {{0, 0}, {9, 0}, {0, 9}})));
  const Changes& changes = world.commit();
  EXPECT_TRUE(changes.added.empty() && changes.removed.empty() && changes.relinked.empty());
  EXPECT_EQ(snapshotOf(world, {}).segments, before.segments);
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

// Law 2 skips a coincident direction: where nothing else meets a kept wall, its two sides have no neighbours.
TEST(Segments, OfAKeptWallInsideASolidHaveNoLinks) {
  World world([](Block a, Block b) { return a == 1 && b == 2; });
  ASSERT_TRUE(world.fill({{0, 0}, {3, 2}}, shapeOf(world, {unitSquare()}), 3));
  removeAll(world, {1, 1});
  removeAll(world, {2, 1});
  place(world, {1, 1}, unitSquare(), 1);
  place(world, {2, 1}, unitSquare(), 2);
  world.commit();
  EXPECT_EQ(world.stats().segments, 2U * (4U + 3U) + 2U);
  for (const auto& [start, end] : {std::pair(Point{2 * U, U}, Point{2 * U, 2 * U}), {{2 * U, 2 * U}, {2 * U, U}}}) {
    const Segment side = segmentAt(world, start, end);
    EXPECT_FALSE(side.predecessor || side.successor);
  }
  ASSERT_EQ(world.loops().size(), 1U);
  EXPECT_EQ(world.loops()[0].segments.size(), 14U);
}

}  // namespace
}  // namespace lgs::test
