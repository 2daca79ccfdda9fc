// Regions by hand: circles, rectangles, thick lines, and what is refused of them.
#include "proptests/brush/strokes.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lgs::test::shapes {
namespace {

constexpr std::int64_t kCell = kUnitsPerCell;  // in lattice units

TEST(BrushRegion, ACircleHasItsCornersOnTheCircle) {
  for (const std::int64_t radius : {std::int64_t{1}, std::int64_t{7}, 3 * kCell, 2'000 * kCell}) {
    const Region region = circle({5, -7}, radius, 30);
    ASSERT_EQ(region.rings.size(), 1U);
    EXPECT_EQ(region.rings[0].size(), 32U);
    for (const Point p : region.rings[0]) {
      const double away = std::hypot(static_cast<double>(p.x - 5), static_cast<double>(p.y + 7));
      EXPECT_NEAR(away, static_cast<double>(radius), 0.75);
    }
  }
}

TEST(BrushRegion, ARectangleIsTurned) {
  const Region region = rectangle({100, 100}, {0, 5}, 50, 20);
  EXPECT_EQ(region.rings, (std::vector<Ring>{{{120, 50}, {120, 150}, {80, 150}, {80, 50}}}));
  EXPECT_EQ(rectangle({100, 100}, {3, 4}, 50, 25).rings,
            (std::vector<Ring>{{{90, 45}, {150, 125}, {110, 155}, {50, 75}}}));
  EXPECT_EQ(rectangle({0, 0}, {0, 0}, 2, 1).rings, rectangle({0, 0}, {1, 0}, 2, 1).rings);
}

// A game that says nothing, or far too much, is told so when it uses the region.
TEST(BrushRegion, LengthsOutOfRangeAreRefused) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max(), kLongest = kMaxRegionCells / 2 * kCell;
  World world;
  const Point line[] = {{0, 0}, {kCell, 0}};
  for (const std::int64_t length : {std::int64_t{0}, std::int64_t{-5}, -kMost, INT64_MIN, kLongest + 1, kMost}) {
    for (const Region& region :
         {circle({0, 0}, length, 8), rectangle({0, 0}, {1, 0}, length, 5), rectangle({0, 0}, {1, 0}, 5, length),
          rectangle({0, 0}, {1, 1}, length, 5), thickLine(line, length)}) {
      const auto done = carve(world, region);
      ASSERT_FALSE(done) << length;
      EXPECT_EQ(done.error().code, ErrorCode::outOfReach);
      EXPECT_NE(message(done.error()).find("1 lattice unit to 2,048 cells"), std::string::npos);
    }
  }
  for (const std::int64_t length : {std::int64_t{1}, kLongest}) {
    EXPECT_TRUE(carve(world, circle({0, 0}, length, 8)));
    EXPECT_TRUE(carve(world, rectangle({0, 0}, {1, 0}, length, 1)));
  }
}

TEST(BrushRegion, WhatIsNoNumberIsTold) {
  World world;
  const std::vector<DoublePoint> ring{{0, 0}, {1, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}};
  const auto done = refusal(paint(world, region({&ring, 1}), 1, PaintMode::fill));
  EXPECT_EQ(message(done), "polygon 0: vertex 2 is beyond the last cell, or was no number");
}

TEST(BrushRegion, CornersAndDirectionsAreBroughtIntoTheirRange) {
  EXPECT_EQ(circle({0, 0}, kCell, -3).rings[0].size(), 8U);
  EXPECT_EQ(circle({0, 0}, kCell, 5'000).rings[0].size(), 4'096U);
  EXPECT_EQ(rectangle({0, 0}, {INT64_MIN, INT64_MIN}, kCell, 5).rings, rectangle({0, 0}, {-1, -1}, kCell, 5).rings);
  EXPECT_EQ(rectangle({0, 0}, {kMaxCoordinate, -kMaxCoordinate}, kCell, 5).rings,
            rectangle({0, 0}, {1, -1}, kCell, 5).rings);
  EXPECT_EQ(rectangle({0, 0}, {INT32_MAX, INT32_MAX}, kCell, 5).rings, rectangle({0, 0}, {1, 1}, kCell, 5).rings);
}

// Also where some of the corners would lie in a cell, and where numbers would overflow.
TEST(BrushRegion, APointBeyondTheLastCellIsTheVertexThatIsRefused) {
  World world;
  constexpr std::int64_t kBeyond = kMaxCoordinate + 1;
  for (const Point point : {Point{kBeyond, 0}, Point{-kBeyond, 0}, Point{INT64_MIN, INT64_MAX}}) {
    for (const Region& region :
         {circle(point, 9 * kCell), rectangle(point, {1, 0}, 9 * kCell, 5), thickLine({&point, 1}, 9 * kCell)}) {
      const Error error = refusal(carve(world, region));
      EXPECT_EQ(message(error), "polygon 0: vertex 0 is beyond the last cell, or was no number");
    }
  }
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
