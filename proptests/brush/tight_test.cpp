// Strokes on tight lattices, each of which a law depends on in a way that random ones seldom show.
#include "calm.h"
#include "proptests/brush/strokes.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

namespace lgs::test::tight {
namespace {

/// Makes the strokes. Each must hold law 8, and none may bend what it does not reach.
void expectRounding(Ground ground, const Strokes& strokes) {
  World world = worldOf(ground);
  for (const oracle::BrushEdit& edit : strokes) {
    const oracle::Scene before = sceneOf(world);
    const auto result = must(stroke(world, edit));
    EXPECT_TRUE(result.bent.empty());
    EXPECT_EQ(farFromExact(before, edit, sceneOf(world)), std::nullopt);
  }
}

// The region's edge begins beside a line between blocks, crosses it at once, and runs on less than a unit from it.
TEST(BrushTight, ALineThatIsCrossedWhereTheRegionBegins) {
  expectRounding(Ground::slanted, {{Deed::replace, 1, {{{65530, 65524}, {65526, 65530}, {65529, 65524}}}, false},
                                   {Deed::replace, 2, {{{65531, 65529}, {65525, 65524}, {65527, 65524}}}}});
}

// The region's edge runs along an edge of the ground. Its chain passes beside, with ground between.
TEST(BrushTight, GroundBetweenTheRegionAndItsChain) {
  expectRounding(Ground::empty, {{Deed::fill, 1, {{{65531, 65524}, {65524, 65524}, {65524, 65524}, {65533, 65540}}}},
                                 {Deed::carve,
                                  1,
                                  {{{65531, 65536},
                                    {65534, 65542},
                                    {65528, 65524},
                                    {65533, 65539},
                                    {65527, 65545},
                                    {65530, 65545},
                                    {65536, 65534}}}}});
}

// In the upper cell the region is half a unit high, or wide in the right one. Both ends of its edge are rounded to the
// line between the cells.
TEST(BrushTight, AnEdgeWhoseEndsAreRoundedToTheRim) {
  Ring carved{{65524, 65538}, {65524, 65524}, {65540, 65535}}, filled{{65524, 65524}, {65525, 65535}, {65540, 65537}};
  for (int k = 0; k < 2; ++k) {
    expectRounding(Ground::solid, {{Deed::carve, 1, {carved}}, {Deed::fill, 1, {filled}}});
    for (Ring* const ring : {&carved, &filled})
      for (Point& p : *ring) std::swap(p.x, p.y);
  }
}

// Near the line between the two polygons of a cell, and near an end of that: what was carved can be filled again.
TEST(BrushTight, ACornerInsideTheGroundIsForgotten) {
  expectNoSeam(Ground::halved, {{{{65544, 65539}, {65533, 65529}, {65540, 65526}, {65534, 65532}}}, FillRule::evenOdd});
}

/// What a region carves out of ground of one block is whole when it is filled again.
void expectNoSeams(const Ring& ring) {
  for (const Ground ground : {Ground::solid, Ground::halved}) expectNoSeam(ground, {{ring}, FillRule::evenOdd});
}

// In the cell on the right, or above, the region is so thin that its chains lie on the rim. It is there all the same.
TEST(BrushTight, TheRegionBetweenTheRimAndItsChain) {
  Ring ring{{65524, 65524}, {65536, 65524}, {65537, 65529}, {65524, 65529}, {65541, 65527}};
  expectNoSeams(ring);
  for (Point& p : ring) std::swap(p.x, p.y);
  expectNoSeams(ring);
}

// The region's edge passes a third of a unit below a corner of the ground, so its chain goes through the corner: nothing
// crosses. That is another thing where the corner is three units higher.
TEST(BrushTight, AnEdgeMayBeCrossedInThePixelWhereItEnds) {
  const brush::Frame frame;
  const brush::Pieces region = brush::piecesOf(Ring{{0, 9'999}, {30'000, 10'001}, {15'000, 40'000}});
  for (const std::int64_t y : {10'000, 10'003}) {
    const brush::List<brush::CellPolygon> polygons{{{{9'000, 5'000}, {11'000, 5'000}, {10'000, y}}, 1}};
    const auto ground = brush::groundOf(polygons, {true}, region);
    ASSERT_TRUE(ground.has_value());
    EXPECT_EQ(brush::calmAtoms(*ground, region, FillRule::nonZero).has_value(), y == 10'000);
  }
}

// An edge of the ground begins where one of the rounded region begins, and is another one.
TEST(BrushTight, TwoEdgesThatBeginInTheSamePoint) {
  expectNoSeams({{65314, 65240}, {65869, 65832}, {65092, 65092}, {65832, 65795}});
}

// A polygon stands in the way, so edges that nothing crosses are left straight. One of them lies between the region and
// a vertex that its chain goes through: it would be crossed. So the polygon is bent, and told.
TEST(BrushTight, AnEdgeThatMayNotBeLeftStraight) {
  World world = worldOf(Ground::solid);
  must(stroke(world, {Deed::carve,
                      1,
                      {{{65496, 65526}, {65476, 65536}, {65521, 65511}, {65476, 65541}, {65481, 65541}, {65551, 65491}},
                       {{65501, 65526}, {65476, 65476}, {65506, 65521}, {65491, 65526}, {65556, 65491}},
                       {{900, 800}, {1200, 800}, {1200, 1100}, {900, 1100}}}}));
  ASSERT_TRUE(world.add({0, 0}, {{1000, 1000}, {1100, 900}, {1100, 1007}}, 2).has_value());
  ASSERT_TRUE(world.add({0, 0}, {{1009, 1001}, {1020, 1010}, {1000, 1010}}, 3).has_value());
  const oracle::BrushEdit edit{
      Deed::replace,
      1,
      {{{65476, 65476}, {65481, 65476}, {65476, 65481}}, {{1000, 1000}, {1099, 990}, {1099, 1006}}},
      false};
  const oracle::Scene before = sceneOf(world);
  const auto result = must(stroke(world, edit));
  EXPECT_EQ(result.bent.size(), 1U);
  EXPECT_EQ(farFromExact(before, edit, sceneOf(world)), std::nullopt);
}

// Two edges of the region cross half a unit below a polygon's edge, between its ends. The pixel's centre is inside the
// polygon, and chains come to it through the polygon's vertices. So they cross no edge, and still paint may not go
// there.
TEST(BrushTight, AChainThatEntersAtAVertex) {
  World world;
  ASSERT_TRUE(world.add({0, 0}, {{5000, 5000}, {5020, 5001}, {5010, 5040}}, 2).has_value());
  const auto result = must(stroke(world, {Deed::fill,
                                          1,
                                          {{{5000 - 475, 5000 - 24}, {5500, 4000}, {5000 + 1525, 5000 + 77}},
                                           {{5000 - 404, 5000 - 20}, {5500, 4000}, {5000 + 1596, 5000 + 79}}},
                                          false}));
  EXPECT_EQ(result.bent.size(), 1U);
}

// The same edges, with the region on their other side. The polygon is inside of it, and nothing of it may be left
// between its lowest edge and the chains.
TEST(BrushTight, AnEdgeBetweenTheRegionAndItsChains) {
  World world;
  ASSERT_TRUE(world.add({0, 0}, {{5000, 5000}, {5020, 5001}, {5010, 5040}}, 2).has_value());
  must(stroke(world, {Deed::carve,
                      1,
                      {{{5000 - 475, 5000 - 24}, {5000 + 1525, 5000 + 77}, {5010, 6000}},
                       {{5000 - 404, 5000 - 20}, {5000 + 1596, 5000 + 79}, {5010, 6000}}},
                      false}));
  EXPECT_TRUE(world.isEmpty({0, 0}));
}

// An edge of the ground lies on that of the region, which goes through another vertex of the region beside it. On
// either side, the triangle between must go.
TEST(BrushTight, AnEdgeOnThatOfTheRegion) {
  const auto shifted = [](Ring ring) {
    for (Point& p : ring) p = {p.x + 30'000, p.y + 30'000};
    return ring;
  };
  const std::vector<std::pair<Ring, std::vector<Ring>>> sides{
      {{{0, 0}, {20, 10}, {6, 50}}, {{{0, 0}, {20, 10}, {0, 300}}, {{5, 3}, {8, 40}, {6, 40}}}},
      {{{0, 0}, {14, -40}, {20, 10}}, {{{0, 0}, {20, -290}, {20, 10}}, {{5, 2}, {12, -30}, {14, -30}}}}};
  for (const auto& [ground, rings] : sides) {
    World world;
    ASSERT_TRUE(paint(world, {{shifted(ground)}}, 1, PaintMode::fill).has_value());
    ASSERT_TRUE(carve(world, {{shifted(rings[0]), shifted(rings[1])}}).has_value());
    EXPECT_TRUE(world.isEmpty({0, 0}));
  }
}

// An edge of the ground begins above the region's chain, crosses it, and ends on it, but does not meet the region's
// edge.
TEST(BrushTight, AnEdgeThatCrossesTheChainAlone) {
  World world;
  const auto at = [](std::int32_t x, std::int32_t y) { return LocalPoint{30'000 + x, 30'000 + y}; };
  ASSERT_TRUE(world.add({0, 0}, {at(-50, -100), at(20, -100), at(20, 1), at(-50, 0)}, 1).has_value());
  ASSERT_TRUE(world.add({0, 0}, {at(0, 1), at(2, 9), at(-2, 9)}, 2).has_value());
  const auto point = [](std::int64_t x, std::int64_t y) { return Point{30'000 + x, 30'000 + y}; };
  const oracle::BrushEdit edit{
      Deed::carve,
      1,
      {{point(-970, -14), point(0, -2'000), point(1'030, 16)}, {point(-40, 0), point(-45, -30), point(-35, -30)}},
      false};
  const oracle::Scene before = sceneOf(world);
  must(stroke(world, edit));
  EXPECT_EQ(farFromExact(before, edit, sceneOf(world)), std::nullopt);
}

}  // namespace
}  // namespace lgs::test::tight
