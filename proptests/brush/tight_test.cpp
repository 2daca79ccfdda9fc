// Strokes on tight lattices, each of which a law depends on in a way that random ones seldom show.
#include "proptests/brush/strokes.h"

#include <gtest/gtest.h>

#include <vector>

namespace lgs::test::tight {
namespace {

/// Makes the strokes. Each must hold law 8, and none may bend what it does not reach.
void expectRounding(Ground ground, const std::vector<BrushStroke>& strokes) {
  World world = worldOf(ground);
  for (const BrushStroke& stroke : strokes) {
    const oracle::Scene before = sceneOf(world);
    const auto result = brush(world, stroke);
    ASSERT_TRUE(result.has_value()) << message(result.error());
    EXPECT_TRUE(result->bent.empty());
    EXPECT_EQ(farFromExact(before, editOf(stroke), sceneOf(world)), std::nullopt);
  }
}

// The region's edge begins beside a line between blocks, crosses it at once, and runs on less than a unit from it.
TEST(BrushTight, ALineThatIsCrossedWhereTheRegionBegins) {
  expectRounding(Ground::slanted,
                 {{Deed::replace, 1, {{{{65530, 65524}, {65526, 65530}, {65529, 65524}}}}},
                  {Deed::replace, 2, {{{{65531, 65529}, {65525, 65524}, {65527, 65524}}}, FillRule::evenOdd}}});
}

// The region's edge runs along an edge of the ground. Its chain passes beside, with ground between.
TEST(BrushTight, GroundBetweenTheRegionAndItsChain) {
  expectRounding(
      Ground::empty,
      {{Deed::fill, 1, {{{{65531, 65524}, {65524, 65524}, {65524, 65524}, {65533, 65540}}}, FillRule::evenOdd}},
       {Deed::carve,
        1,
        {{{{65531, 65536},
           {65534, 65542},
           {65528, 65524},
           {65533, 65539},
           {65527, 65545},
           {65530, 65545},
           {65536, 65534}}},
         FillRule::evenOdd}}});
}

// In the upper cell the region is half a unit high. Both ends of its edge are rounded to the line between the cells.
TEST(BrushTight, AnEdgeWhoseEndsAreRoundedToTheRim) {
  expectRounding(Ground::solid,
                 {{Deed::carve, 1, {{{{65524, 65538}, {65524, 65524}, {65540, 65535}}}, FillRule::evenOdd}},
                  {Deed::fill, 1, {{{{65524, 65524}, {65525, 65535}, {65540, 65537}}}, FillRule::evenOdd}}});
}

// Near the line between the two polygons of a cell, and near an end of that: what was carved can be filled again.
TEST(BrushTight, ACornerInsideTheGroundIsForgotten) {
  World world = worldOf(Ground::halved);
  world.commit();
  const std::size_t solid = world.loops(Collinear::merge).size();
  const Region region{{{{65544, 65539}, {65533, 65529}, {65540, 65526}, {65534, 65532}}}, FillRule::evenOdd};
  ASSERT_TRUE(carve(world, region).has_value());
  ASSERT_TRUE(paint(world, region, 1, PaintMode::fill).has_value());
  world.commit();
  EXPECT_EQ(world.loops(Collinear::merge).size(), solid);
}

}  // namespace
}  // namespace lgs::test::tight
