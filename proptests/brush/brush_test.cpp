// Brushes by hand: their parts, chains that would run through what stays, and refusals.
#include "atoms.h"
#include "pieces.h"
#include "proptests/brush/strokes.h"
#include "proptests/support/must.h"
#include "snap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace lgs::test {
namespace {

constexpr std::int64_t kCell = kUnitsPerCell;  // in lattice units

Region box(Point min, Point max) { return {{{min, {max.x, min.y}, max, {min.x, max.y}}}}; }

TEST(BrushSnap, APixelHasItsLeftAndLowerSide) {
  using brush::passes;
  EXPECT_TRUE(passes({0, 0}, {4, 2}, {1, 1})) << "through the lower side";
  EXPECT_TRUE(passes({0, 0}, {4, 2}, {1, 0}));
  EXPECT_TRUE(passes({0, 1}, {1, 0}, {1, 1})) << "through its lower left corner";
  EXPECT_FALSE(passes({0, 1}, {1, 2}, {1, 1})) << "through its upper left corner";
  EXPECT_FALSE(passes({1, 0}, {2, 1}, {1, 1})) << "through its lower right corner";
  EXPECT_FALSE(passes({0, 0}, {4, 2}, {5, 2})) << "beyond its end";
}

TEST(BrushSnap, CrossingsAreRoundedToTheNearestPoint) {
  const auto segment = [](Point a, Point b) { return brush::Segment{a, b, a, b, {}, true}; };
  EXPECT_EQ(crossingPixel(segment({0, 0}, {3, 3}), segment({0, 3}, {3, 0})), (Point{2, 2})) << "halves go up";
  EXPECT_EQ(crossingPixel(segment({0, 0}, {-3, -3}), segment({0, -3}, {-3, 0})), (Point{-1, -1}));
  EXPECT_EQ(crossingPixel(segment({0, 0}, {3, 3}), segment({3, 3}, {5, 0})), std::nullopt);
  constexpr std::int64_t kFar = std::int64_t{1} << 28;
  EXPECT_EQ(crossingPixel(segment({-kFar, -kFar + 1}, {kFar, kFar}), segment({-kFar, kFar}, {kFar, -kFar})),
            (Point{0, 0}));
}

TEST(BrushPieces, APlaceOnAnEdgeHasTwoSides) {
  const brush::Pieces square = brush::piecesOf(std::array<Point, 4>{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const auto windings = [&](Point doubled) {
    return std::pair(windingLeftOf(doubled, square), windingRightOf(doubled, square));
  };
  using Windings = std::pair<std::int64_t, std::int64_t>;
  EXPECT_EQ(windings({0, 4}), Windings(0, 1)) << "its left edge";
  EXPECT_EQ(windings({4, 4}), Windings(1, 1)) << "inside";
  EXPECT_EQ(windings({8, 4}), Windings(1, 0)) << "its right edge";
  EXPECT_EQ(windings({12, 4}), Windings(0, 0)) << "beyond";
  EXPECT_EQ(windings({4, 0}), Windings(1, 0)) << "its lower edge: above, and below";
  EXPECT_EQ(windings({4, 8}), Windings(0, 1)) << "its upper edge";
}

TEST(BrushAtoms, ARayThroughAVertexMeetsOneOfItsEdges) {
  const brush::Sum solid{1, 0};
  const brush::List<brush::Atom> wall{{{0, 0}, {0, 10}, solid, {}, {}}, {{0, 10}, {0, 20}, solid, {}, {}}};
  EXPECT_EQ(sumLeftOf({10, 20}, wall), -solid);  // doubled
}

/// Plays strokes, and returns how many polygons the last one bends that it should have kept.
std::size_t bentByTheLast(Ground ground, const Strokes& strokes) {
  World world = worldOf(ground);
  std::size_t bent = 0;
  for (const oracle::BrushEdit& edit : strokes) {
    bent = must(stroke(world, edit)).rounded.size();
  }
  return bent;
}

TEST(Brush, APolygonThatAChainWouldRunThroughStays) {
  EXPECT_EQ(
      bentByTheLast(Ground::solid,
                    {{Deed::carve,
                      1,
                      {{{65496, 65526}, {65476, 65536}, {65521, 65511}, {65476, 65541}, {65481, 65541}, {65551, 65491}},
                       {{65501, 65526}, {65476, 65476}, {65506, 65521}, {65491, 65526}, {65556, 65491}}}},
                     {Deed::replace, 1, {{{65476, 65476}, {65481, 65476}, {65476, 65481}}}, false}}),
      0U);
}

TEST(Brush, APolygonThatAChainWouldRunAroundStays) {
  EXPECT_EQ(bentByTheLast(Ground::slanted, {{Deed::fill, 1, {{{65534, 65529}, {65524, 65524}, {65524, 65526}}}},
                                            {Deed::carve,
                                             1,
                                             {{{65534, 65525}, {65524, 65524}, {65527, 65532}},
                                              {{65539, 65524}, {65524, 65524}, {65526, 65533}}}},
                                            {Deed::fill, 3, {{{65527, 65530}, {65524, 65524}, {65537, 65527}}}, false},
                                            {Deed::replace, 1, {{{65524, 65524}, {65524, 65525}, {65525, 65524}}}}}),
            0U);
}

TEST(Brush, BadRegionsAreRefusedAndNothingChanges) {
  World world = worldOf(Ground::slanted);
  const auto before = standingIn(world);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<DoublePoint>> notANumber{{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {1, nan}}};
  const auto refused = refusal(carve(world, region(notANumber)));
  EXPECT_EQ(refused.code, ErrorCode::outOfReach);
  EXPECT_EQ(refused.polygon, 1);
  EXPECT_EQ(refused.vertex, 2);
  const std::int64_t most = kMaxRegionCells * kCell;
  EXPECT_FALSE(carve(world, box({0, 0}, {most + 1, 10})).has_value());
  EXPECT_FALSE(carve(world, box({0, 0}, {10, most + 1})).has_value());
  EXPECT_FALSE(carve(world, circle({kMaxCoordinate + 1, 0}, 10)).has_value());
  constexpr Point kFirst{-kMaxCell * kCell, -kMaxCell * kCell};  // where the first cell begins
  const auto beyond = refusal(carve(world, box({kFirst.x - 1, 0}, {kFirst.x + 5, 9})));
  EXPECT_EQ(beyond.code, ErrorCode::outOfReach);
  EXPECT_FALSE(carve(world, box({0, kFirst.y - 1}, {9, kFirst.y + 5})).has_value());
  EXPECT_EQ(standingIn(world), before);
  EXPECT_TRUE(carve(world, box(kFirst, {kFirst.x + 5, kFirst.y + 9})).has_value());
}

TEST(Brush, TooMuchForACellIsRefusedAsAWhole) {
  World world;
  Region comb;  // 300 teeth of a cell, and all of the cell beside it
  for (std::int64_t k = 0; k < 300; ++k) comb.rings.push_back(box({kCell + 4 * k, 1}, {kCell + 4 * k + 2, 9}).rings[0]);
  comb.rings.push_back(box({0, 0}, {kCell, kCell}).rings[0]);
  const auto refused = refusal(paint(world, comb, 1, PaintMode::fill));
  EXPECT_EQ(refused.code, ErrorCode::capacity);
  EXPECT_EQ(refused.cell, (Cell{1, 0}));
  EXPECT_EQ(world.stats().polygons, 0U);
}

TEST(Brush, RegionsWithoutAreaChangeNothing) {
  World world = worldOf(Ground::slanted);
  const auto before = standingIn(world);
  for (const Region& nothing :
       {Region{}, Region{{{}}}, Region{{{{5, 5}}}}, Region{{{{5, 5}, {70'000, 900}}}},
        Region{{{{5, 5}, {70'000, 905}, {5, 5}}}}, Region{{{{0, 0}, {90'000, 30'000}, {30'000, 10'000}}}},
        Region{{{{0, 0}, {90'000, 30'000}, {60'000, 20'000}}}, FillRule::evenOdd}}) {
    ASSERT_TRUE(paint(world, nothing, 1, PaintMode::replace).has_value());
    ASSERT_TRUE(carve(world, nothing).has_value());
    EXPECT_EQ(standingIn(world), before);
  }
}

}  // namespace
}  // namespace lgs::test
