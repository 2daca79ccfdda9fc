// Regions by hand; oracle/check/laws/shapes.cpp has their laws.
#include "proptests/brush/strokes.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <limits>

namespace lgs::test::shapes {
namespace {

constexpr std::int64_t kCell = kUnitsPerCell;  // in lattice units

TEST(BrushRegion, ARectangleIsTurned) {
  const Region region = rectangle({100, 100}, {0, 5}, 50, 20);
  EXPECT_EQ(region.rings, (std::vector<Ring>{{{120, 50}, {120, 150}, {80, 150}, {80, 50}}}));
  EXPECT_EQ(rectangle({100, 100}, {3, 4}, 50, 25).rings,
            (std::vector<Ring>{{{90, 45}, {150, 125}, {110, 155}, {50, 75}}}));
  EXPECT_EQ(rectangle({0, 0}, {0, 0}, 2, 1).rings, rectangle({0, 0}, {1, 0}, 2, 1).rings);
}

TEST(BrushRegion, WhatIsNoNumberIsTold) {
  World world;
  const std::vector<DoublePoint> ring{{0, 0}, {1, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}};
  const auto done = refusal(paint(world, region({&ring, 1}), 1, PaintMode::fill));
  EXPECT_EQ(message(done), "polygon 0: vertex 2 is beyond the last cell, or was no number");
}

TEST(BrushRegion, AThickLineHasRoundJoints) {
  const std::vector<Point> points{{0, 0}, {10'000, 0}, {10'000, 10'000}};
  EXPECT_EQ(thickLine(points, 1'000).rings.size(), 5U);
  World world;
  ASSERT_TRUE(paint(world, thickLine(points, 1'000), 1, PaintMode::fill).has_value());
  EXPECT_EQ(world.at({10'700, -700}).where, Spot::Where::inside) << "the joint is round";
  EXPECT_EQ(world.at({10'800, -800}).where, Spot::Where::outside);
  EXPECT_TRUE(thickLine({}, 10).rings.empty());
}

TEST(BrushRegion, PositionsInCellsAreRounded) {
  const std::vector<std::vector<DoublePoint>> rings{{{0, 0}, {1, 0}, {0.5 / kCell, 2}}};
  EXPECT_EQ(region(rings).rings, (std::vector<Ring>{{{0, 0}, {kCell, 0}, {1, 2 * kCell}}}));
}

}  // namespace
}  // namespace lgs::test::shapes
