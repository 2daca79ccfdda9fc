// Brushes by hand: fill rules, whole cells, and who keeps a handle.
#include "proptests/brush/strokes.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

namespace lgs::test::rules {
namespace {

constexpr std::int64_t kCell = kUnitsPerCell;

Ring box(Point min, Point max) { return {min, {max.x, min.y}, max, {min.x, max.y}}; }

Ring reversed(Ring ring) {
  std::ranges::reverse(ring);
  return ring;
}

TEST(BrushRules, VerticesMayBeRepeated) {
  World world;
  ASSERT_TRUE(
      paint(world, {{{{0, 0}, {0, 0}, {9, 0}, {9, 9}, {9, 9}, {9, 9}, {0, 0}}}}, 1, PaintMode::fill).has_value());
  ASSERT_EQ(world.stats().polygons, 1U);
  EXPECT_EQ(world.polygons({0, 0})[0].vertices.size(), 3U);
}

TEST(BrushRules, WholeCellsKnowAllRings) {
  World world;
  const Ring hole = box({kCell, kCell}, {2 * kCell, 2 * kCell}), all = box({0, 0}, {3 * kCell, 3 * kCell});
  ASSERT_TRUE(paint(world, {{hole, all}, FillRule::evenOdd}, 1, PaintMode::fill).has_value());
  EXPECT_EQ(world.stats().cells, 8U);
  EXPECT_TRUE(world.isEmpty({1, 1}));
  ASSERT_TRUE(carve(world, {{all, hole}, FillRule::evenOdd}).has_value());
  EXPECT_EQ(world.stats().cells, 0U);
}

// Whichever cells of a row or a column these are, each is found when the row is halved.
TEST(BrushRules, WholeCellsMayLieApart) {
  for (const bool isRow : {true, false}) {
    Region region;
    std::vector<Cell> cells;
    for (const std::int32_t k : {0, 4, 7, 11}) {
      const Cell cell = isRow ? Cell{k, 0} : Cell{0, k};
      cells.push_back(cell);
      region.rings.push_back(box(toWorld(cell, {0, 0}), toWorld(cell, {kUnitsPerCell, kUnitsPerCell})));
    }
    auto found = must(cellsOf(region));
    std::ranges::sort(found);
    EXPECT_EQ(found, cells);
  }
}

/// Four squares side by side. The third one has another block, if it should.
std::vector<PolygonHandle> row(World& world, Block third) {
  std::vector<PolygonHandle> squares;
  for (std::int32_t x = 0; x < 400; x += 100)
    squares.push_back(
        *world.add({0, 0}, {{x, 0}, {x + 100, 0}, {x + 100, 100}, {x, 100}}, x == 200 ? third : Block{1}));
  return squares;
}

TEST(BrushRules, WhatIsMetAndHangsTogetherIsUnitedIfAnyOfItChanges) {
  World world;
  const std::vector<PolygonHandle> squares = row(world, 1);
  // It touches the first two, cuts the third one, and does not meet the last one.
  const auto carved = must(carve(world, {{box({50, 100}, {150, 120}), box({250, 50}, {280, 200})}}));
  ASSERT_EQ(carved.changed.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(carved.changed[k].old, squares[k]);
    EXPECT_EQ(carved.changed[k].now, carved.changed[0].now);
  }
  EXPECT_EQ(carved.changed[0].now.size(), 1U);
  EXPECT_TRUE(world.polygon(squares[3]).has_value()) << "it is not met";
  EXPECT_EQ(world.stats().polygons, 2U);
}

TEST(BrushRules, WhatIsMetAndHangsTogetherStaysIfNothingOfItChanges) {
  World world;
  const std::vector<PolygonHandle> squares = row(world, 2);
  must(carve(world, {{box({50, 100}, {150, 120}), box({250, 50}, {280, 200})}}));
  EXPECT_TRUE(world.polygon(squares[0]).has_value()) << "another block parts it from what changes";
  EXPECT_TRUE(world.polygon(squares[1]).has_value());
}

TEST(BrushRules, WhatTouchesInAPointIsNotUnited) {
  World world;
  const PolygonHandle left = *world.add({0, 0}, {{100, 100}, {0, 300}, {0, 200}}, 1);
  const PolygonHandle right = *world.add({0, 0}, {{100, 100}, {200, 200}, {200, 300}}, 1);
  // It cuts the left one, and touches the right one.
  const auto carved = must(carve(world, {{box({20, 150}, {40, 400}), box({200, 220}, {250, 240})}}));
  ASSERT_EQ(carved.changed.size(), 1U);
  EXPECT_EQ(carved.changed[0].old, left);
  EXPECT_TRUE(world.polygon(right).has_value());
}

TEST(BrushRules, APolygonKeepsItsHandleWhereAnotherIsCutBesideIt) {
  World world;
  const PolygonHandle floor = *world.add({0, 0}, {{0, 0}, {900, 0}, {900, 300}, {0, 300}}, 1);
  const PolygonHandle ramp = *world.add({0, 0}, {{300, 300}, {700, 302}, {300, 900}}, 2);
  // It cuts the ramp 0.43 units above the floor, so the ramp is bent down to the floor there. It touches the floor.
  const auto carved = must(carve(world, {{{{340, 301}, {420, 300}, {420, 500}}}}));
  ASSERT_EQ(carved.changed.size(), 1U);
  EXPECT_EQ(carved.changed[0].old, ramp);
  EXPECT_TRUE(world.polygon(floor).has_value());
}

// --- What a region just misses. Each time a vertex of the region lies in a pixel that an edge passes
//  -------------------

TEST(BrushRules, ASpikeReachesNothing) {
  World world;
  const PolygonHandle wedge = *world.add({0, 0}, {{0, 0}, {536, 30}, {0, 20}}, 1);
  // A ring runs to a point in the wedge and back again.
  const Ring ring{{300, 1'000}, {300, 17}, {300, 1'000}, {900, 1'000}, {900, 2'000}, {300, 2'000}};
  const auto painted = must(paint(world, {{ring}}, 2, PaintMode::replace));
  EXPECT_EQ(painted.added.size(), 1U);
  EXPECT_TRUE(painted.changed.empty()) << "there is no area around a spike";
  EXPECT_TRUE(world.polygon(wedge).has_value());
}

// The corner of a triangle is a fifth of a unit above a wedge. An edge goes on from there into the wedge and back.
TEST(BrushRules, AnEdgeReachesNothingBeyondWhereASpikeBegins) {
  const Ring ring{{300, 2'000}, {300, 10}, {300, 17}, {900, 2'000}};
  for (const Ring& either : {ring, reversed(ring)}) {
    World world;
    const PolygonHandle wedge = *world.add({0, 0}, {{0, 0}, {536, 0}, {536, 30}}, 1);
    const auto painted = must(paint(world, {{either}}, 2, PaintMode::replace));
    EXPECT_EQ(painted.added.size(), 1U);
    EXPECT_TRUE(painted.changed.empty());
    EXPECT_TRUE(world.polygon(wedge).has_value());
  }
}

// Each edge begins at the tip of a spike, and no corner of the triangle is the first point of one.
TEST(BrushRules, SpikesAtAllCornersTakeNothingFromARegion) {
  const Ring triangle{{20'000, 20'000}, {40'000, 20'000}, {40'000, 40'000}};
  const Ring spiked{{15'000, 20'000}, triangle[1], {40'000, 15'000}, triangle[2], {45'000, 45'000}, triangle[0]};
  for (const FillRule rule : {FillRule::nonZero, FillRule::evenOdd}) {
    World world, same;
    for (World* const w : {&world, &same}) ASSERT_TRUE(w->add({0, 0}, kUnitSquare, 1));
    must(carve(world, {{spiked}, rule}));
    must(carve(same, {{triangle}, rule}));
    EXPECT_EQ(standingIn(world), standingIn(same));
  }
}

TEST(BrushRules, ARegionReachesNothingWhereItsRimPointIsRounded) {
  World world;
  const PolygonHandle wedge = *world.add({0, 0}, {{kCell - 536, 0}, {kCell, 0}, {kCell, 10}}, 1);
  // Its lowest edge is 0.4 units above the wedge, all along. It leaves the cell at a height of 10.4.
  const Ring ring{{kCell - 236, 6}, {kCell + 2'124, 50}, {kCell - 236, 1'000}};
  const auto painted = must(paint(world, {{ring}}, 2, PaintMode::replace));
  EXPECT_TRUE(painted.changed.empty());
  EXPECT_TRUE(world.polygon(wedge).has_value());
}

TEST(BrushRules, AnEdgeIsSharedAsFarAsItsNeighbourReaches) {
  World world;
  ASSERT_TRUE(world.add({0, 0}, {{0, 0}, {1'000, 0}, {1'000, 300}}, 1).has_value());
  const PolygonHandle above = *world.add({0, 0}, {{0, 0}, {500, 150}, {0, 600}}, 2);
  // Only the rock below is hit. Its edge along the other rock stays straight, and lies on that up to half of its
  // length.
  const auto carved = must(carve(world, {{{{301, 90}, {301, 20}, {600, 20}}}}));
  ASSERT_EQ(carved.changed.size(), 1U);
  EXPECT_TRUE(world.polygon(above).has_value());
  std::int64_t doubled = 0;  // area
  for (const PolygonHandle handle : carved.changed[0].now) {
    const std::span<const LocalPoint> ring = world.polygon(handle)->vertices;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const LocalPoint u = ring[k], v = ring[(k + 1) % ring.size()];
      doubled += std::int64_t{u.x} * v.y - std::int64_t{u.y} * v.x;
    }
  }
  EXPECT_EQ(doubled, 1'000 * 300 - 299 * 70);
}

}  // namespace
}  // namespace lgs::test::rules
