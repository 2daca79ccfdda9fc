// Handles and ids as values, and until when they last. That they are stale for good once a polygon is removed the checker
// sees (library_engine.h).
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <set>
#include <unordered_set>

namespace lgs::test {
namespace {

TEST(Handles, AndIdsAreValues) {
  World world;
  EXPECT_TRUE(shapeOf(world, {unitSquare()}));
  EXPECT_FALSE(ShapeId{});
  std::set<PolygonHandle> sorted;
  for (const Cell cell : {Cell{9, 9}, Cell{0, 0}, Cell{0, 0}})
    sorted.insert(
        place(world, cell, cell.i || world.polygons(cell).empty() ? ramp() : eighths({{0, 1}, {6, 8}, {0, 8}})));
  EXPECT_EQ(sorted.size(), 3U);
  for (const PolygonHandle a : sorted)
    for (const PolygonHandle b : sorted) EXPECT_EQ(a < b, a.packed() < b.packed());
  for (const PolygonHandle a : sorted) EXPECT_EQ(PolygonHandle::unpack(a.packed()), a);
  EXPECT_EQ(std::unordered_set<PolygonHandle>(sorted.begin(), sorted.end()).size(), 3U);
  world.commit();
  const std::vector<SegmentId> ids = world.segments();
  EXPECT_EQ(std::unordered_set<SegmentId>(ids.begin(), ids.end()).size(), ids.size());
}

TEST(Handles, SegmentsKeepTheHandleOfARemovedPolygonUntilTheCommit) {
  World world;
  const PolygonHandle gone = place(world, {}, ramp());
  world.commit();
  const SegmentId id = world.segments().at(0);
  ASSERT_TRUE(world.remove(gone));
  const PolygonHandle next = place(world, {}, ramp());
  EXPECT_EQ(world.segment(id).value().polygon, gone);
  EXPECT_FALSE(world.polygon(gone));
  const ChangeLists changes = copyOf(world.commit());
  EXPECT_EQ(changes.removed.size(), 3U)
      << "another polygon's segments are others, though they lie where the old ones did";
  EXPECT_EQ(changes.added.size(), 3U);
  EXPECT_FALSE(world.segment(id));
  EXPECT_EQ(world.segment(world.segments().at(0)).value().polygon, next);
}

}  // namespace
}  // namespace lgs::test
