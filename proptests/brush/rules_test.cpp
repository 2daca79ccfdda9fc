// Brushes by hand: fill rules, whole cells, and who keeps a handle.
#include "proptests/brush/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test::rules {
namespace {

constexpr std::int64_t kCell = kUnitsPerCell;

Ring box(Point min, Point max) { return {min, {max.x, min.y}, max, {min.x, max.y}}; }

Ring reversed(Ring ring) {
  std::ranges::reverse(ring);
  return ring;
}

bool isSolid(const World& world, Point p) { return world.at(p).where == Spot::Where::inside; }

TEST(BrushRules, RingsMayRunEitherWayAround) {
  const Ring outer = box({100, 100}, {900, 900}), inner = box({300, 300}, {500, 500});
  for (const FillRule rule : {FillRule::nonZero, FillRule::evenOdd}) {
    for (const auto& rings : {std::vector<Ring>{outer, inner},
                              {reversed(outer), reversed(inner)},
                              {reversed(outer), inner},
                              {outer, reversed(inner)}}) {
      World world;
      ASSERT_TRUE(paint(world, {rings, rule}, 1, PaintMode::fill).has_value());
      EXPECT_TRUE(isSolid(world, {200, 450}));
      const bool isSame = (rings[0] == outer) == (rings[1] == inner);
      EXPECT_EQ(isSolid(world, {400, 350}), rule == FillRule::nonZero && isSame);
    }
  }
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

TEST(BrushRules, AFillLeavesFullCellsAsTheyAre) {
  World world;
  const Region cells{{box({0, 0}, {2 * kCell, kCell})}};
  const PolygonHandle stone = *world.add({0, 0}, kUnitSquare, 1);
  const auto filled = paint(world, cells, 2, PaintMode::fill);
  ASSERT_TRUE(filled.has_value());
  EXPECT_EQ(filled->came.size(), 1U);
  EXPECT_TRUE(filled->changed.empty());
  EXPECT_EQ(world.polygon(stone)->block, 1U);
  const auto replaced = paint(world, cells, 2, PaintMode::replace);
  ASSERT_TRUE(replaced.has_value());
  ASSERT_EQ(replaced->changed.size(), 1U) << "the other cell has this block already";
  EXPECT_EQ(replaced->changed[0].old, stone);
}

TEST(BrushRules, WhatAWholeCellLosesIsTold) {
  for (const bool paints : {false, true}) {
    World world;
    const PolygonHandle left = *world.add({0, 0}, {{0, 0}, {9, 0}, {9, 9}}, 1);
    const PolygonHandle right = *world.add({0, 0}, {{20, 0}, {29, 0}, {29, 9}}, 1);
    const Region cell{{box({0, 0}, {kCell, kCell})}};
    const auto result = paints ? paint(world, cell, 1, PaintMode::replace) : carve(world, cell);
    ASSERT_TRUE(result.has_value());
    EXPECT_EQ(result->went, (std::vector{left, right}));
    EXPECT_EQ(result->came.size(), paints ? 1U : 0U);
  }
}

TEST(BrushRules, NeighboursOfNeighboursAreNotUnited) {
  World world;
  std::vector<PolygonHandle> row;
  for (std::int32_t x = 0; x < 300; x += 100)
    row.push_back(*world.add({0, 0}, {{x, 0}, {x + 100, 0}, {x + 100, 100}, {x, 100}}, 1));
  // It stands on the first two, and cuts the third one.
  const auto carved = carve(world, {{box({50, 100}, {150, 120}), box({250, 50}, {400, 200})}});
  ASSERT_TRUE(carved.has_value());
  EXPECT_TRUE(world.polygon(row[0]).has_value()) << "nothing beside it has changed";
  ASSERT_EQ(carved->changed.size(), 2U);
  EXPECT_EQ(carved->changed[0].now, carved->changed[1].now) << "the third one is united with the second";
}

}  // namespace
}  // namespace lgs::test::rules
