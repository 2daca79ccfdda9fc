// Handles: one for each polygon, stale for good once it is removed, never another polygon.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <unordered_set>

namespace lgs::test {
namespace {

void expectStale(World& world, PolygonHandle handle) {
  const auto refused = world.remove(handle);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::staleHandle);
  EXPECT_EQ(refused.error().other, handle);
  EXPECT_FALSE(world.polygon(handle));
  EXPECT_FALSE(world.cellOf(handle));
}

TEST(Handles, NameTheirPolygon) {
  World world;
  const PolygonHandle a = place(world, {-7, 40}, ramp(), 5), b = place(world, {-7, 41}, unitSquare(), 6);
  const PlacedPolygon polygon = world.polygon(a).value();
  EXPECT_EQ(polygon.handle, a);
  EXPECT_EQ(polygon.block, 5U);
  EXPECT_EQ(LocalPolygon(polygon.vertices.begin(), polygon.vertices.end()), ramp());
  EXPECT_EQ(world.cellOf(a), (Cell{-7, 40}));
  EXPECT_EQ(world.cellOf(b), (Cell{-7, 41}));
  EXPECT_TRUE(a);
  EXPECT_FALSE(PolygonHandle{});
  EXPECT_EQ(PolygonHandle::unpack(a.packed()), a);
  EXPECT_NE(a.packed(), b.packed());
  EXPECT_EQ((std::unordered_set<PolygonHandle>{a, b, a}).size(), 2U);
}

TEST(Handles, ThatNoWorldGaveNameNothing) {
  World world;
  const PolygonHandle real = place(world, {}, ramp());
  for (const PolygonHandle forged :
       {PolygonHandle{}, PolygonHandle{0, real.serial}, PolygonHandle{real.cellRef, 0}, PolygonHandle{1, 1},
        PolygonHandle{real.cellRef + 1, real.serial}, PolygonHandle{5 * 1024, 1}, PolygonHandle{0xffff'ffff, 1}})
    expectStale(world, forged);
  EXPECT_EQ(world.polygons({}).size(), 1U);
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
        if (beside) {
          ASSERT_TRUE(seen.insert(place(world, {}, other, 77)).second);
        }
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
  EXPECT_EQ(changes.removed.size(),
            3U);  // another polygon's segments are others, though they lie where the old ones did
  EXPECT_EQ(changes.added.size(), 3U);
  EXPECT_FALSE(world.segment(id));
  EXPECT_EQ(world.segment(world.segments().at(0)).value().polygon, next);
}

TEST(Handles, OfAShapeComeInItsOrder) {
  World world;
  std::vector<LocalPolygon> parts = shapeNamed("four around the middle");
  for (int turn = 0; turn < 4; ++turn) {
    const ShapeId shape = shapeOf(world, parts);
    std::array<PolygonHandle, 4> handles;
    const Cell cell{turn, -turn};
    EXPECT_EQ(world.add(cell, shape, 10 + static_cast<Block>(turn), handles).value(), handles[0]);
    for (std::size_t k = 0; k < 4; ++k) {
      const PlacedPolygon p = world.polygon(handles[k]).value();
      EXPECT_EQ(LocalPolygon(p.vertices.begin(), p.vertices.end()), parts[k]);
      EXPECT_EQ(p.block, 10U + static_cast<Block>(turn));
      EXPECT_EQ(world.cellOf(handles[k]), cell);
    }
    const auto without = world.add({turn, 9}, shape, 1);
    EXPECT_EQ(world.polygon(*without)->vertices[0], parts[0][0]);
    std::rotate(parts.begin(), parts.begin() + 1, parts.end());
  }
}

TEST(Handles, SurviveTheRemovalOfOthersInTheCell) {
  World world;
  const std::vector<LocalPolygon> parts = shapeNamed("four around the middle");
  std::array<PolygonHandle, 4> handles;
  ASSERT_TRUE(world.add({}, shapeOf(world, parts), 1, handles));
  for (const std::size_t gone : {2U, 0U, 3U}) {
    ASSERT_TRUE(world.remove(handles[gone]));
    expectStale(world, handles[gone]);
    for (const PlacedPolygon& p : world.polygons({})) {
      const auto k = static_cast<std::size_t>(std::find(handles.begin(), handles.end(), p.handle) - handles.begin());
      ASSERT_LT(k, 4U);
      EXPECT_EQ(LocalPolygon(p.vertices.begin(), p.vertices.end()), parts[k]);
    }
    world.commit();
  }
  EXPECT_EQ(world.polygons({}).size(), 1U);
  EXPECT_EQ(world.polygons({})[0].handle, handles[1]);
}

}  // namespace
}  // namespace lgs::test
