// Handles: one for each polygon, stale for good once it is removed, never another polygon.
#include "proptests/support/must.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <set>
#include <unordered_set>

namespace lgs::test {
namespace {

void expectStale(World& world, PolygonHandle handle) {
  const auto refused = refusal(world.remove(handle));
  EXPECT_EQ(refused.code, ErrorCode::staleHandle);
  EXPECT_EQ(refused.other, handle);
  EXPECT_FALSE(world.polygon(handle));
  EXPECT_FALSE(world.cellOf(handle));
}

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

// Beyond the 255 placements that a compact cell can count; alone in the cell, and beside a polygon that stays.
TEST(Handles, StayStaleHoweverOftenACellIsEdited) {
  for (const bool beside : {false, true}) {
    World world;
    const ShapeId shape = shapeOf(world, {ramp()});
    const LocalPolygon other = eighths({{0, 1}, {6, 8}, {0, 8}});
    const PolygonHandle fixed = beside ? place(world, {}, other, 77) : PolygonHandle{};
    std::unordered_set<PolygonHandle> seen;
    std::vector<PolygonHandle> old;
    for (int k = 0; k < 700; ++k) {
      const PolygonHandle handle = k % 2 ? place(world, {}, ramp(), 1) : world.add({}, shape, 1).value();
      ASSERT_TRUE(seen.insert(handle).second);
      for (std::size_t o = 0; o < old.size(); o += 1 + old.size() / 7) expectStale(world, old[o]);
      if (k % 3 == 0) world.commit();
      if (k % 5 == 0) {
        ASSERT_EQ(world.clear({{0, 0}, {0, 0}}).value(), beside ? 2U : 1U);
        ASSERT_TRUE(!beside || seen.insert(place(world, {}, other, 77)).second);
      } else {
        ASSERT_TRUE(world.remove(handle));
      }
      old.push_back(handle);
    }
    if (beside) expectStale(world, fixed);
    for (const PolygonHandle handle : old) expectStale(world, handle);
    EXPECT_EQ(world.polygons({}).size(), beside ? 1U : 0U);
  }
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
