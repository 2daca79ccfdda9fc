// Strokes on tight lattices, each of which a law depends on in a way that random ones seldom show. Those of which the
// checker sees all that matters are a trace: ../regressions/brush-on-tight-lattices.trace.
#include "calm.h"
#include "cells.h"
#include "oracle/generate/strokes.h"
#include "proptests/brush/strokes.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace lgs::test::tight {
namespace {

// The region's edge passes a third of a unit below a corner of the ground, so its chain goes through the corner: nothing
// crosses. That is another thing where the corner is three units higher.
TEST(BrushTight, AnEdgeMayBeCrossedInThePixelWhereItEnds) {
  const brush::Frame frame;
  const brush::Pieces region = brush::piecesOf(Ring{{0, 9'999}, {30'000, 10'001}, {15'000, 40'000}});
  for (const std::int64_t y : {10'000, 10'003}) {
    const brush::List<brush::CellPolygon> polygons{{{{9'000, 5'000}, {11'000, 5'000}, {10'000, y}}, 1}};
    brush::Ground ground = brush::groundOf(polygons, {true});
    ASSERT_TRUE(addKnown(ground, region));
    EXPECT_EQ(brush::calmAtoms(ground, region, {}).has_value(), y == 10'000);
  }
}

// Where a polygon stands in the way, some edges are left straight and others bend. Both may begin at one vertex: then
// none need cross for the group between them to be turned over.
TEST(BrushTight, EachPlaceIsOfOneGroupAtMost) {
  const Effort effort = effortOf(3'000);
  for (std::int64_t n = 0; n < effort.cases; ++n) {
    const std::uint64_t seed = effort.seed + static_cast<std::uint64_t>(n);
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::Random random(seed);
    const std::vector<oracle::Call> calls = oracle::acrossSlivers({0, 0}, {1, 2}, random);
    const brush::Frame frame;
    brush::List<brush::CellPolygon> polygons;
    for (const auto& comes : calls[1].comes) {
      brush::CellPolygon& polygon = polygons.emplace_back();
      polygon.block = comes.block;
      for (const LocalPoint v : comes.shape[0]) polygon.ring.push_back({v.x, v.y});
    }
    const Region region = oracle::regionOf(calls[2].brush);
    const brush::Coverage coverage = brush::coverage(region);
    const auto cell = std::ranges::find(coverage.cut, Cell{0, 0}, &brush::CutCell::cell);
    if (cell == coverage.cut.end()) continue;
    brush::Ground ground = groundOf(polygons, meetingOf(polygons, cell->pieces, region.rule));
    ASSERT_TRUE(addKnown(ground, cell->pieces));
    const brush::Rounding rounding = snapRounded(*arrangementOf(ground, cell->pieces), region.rule);
    if (!rounding.inTheWay.empty()) continue;
    ASSERT_TRUE(rounding.isPlane);
    for (const brush::Atom& atom : rounding.atoms)
      for (const brush::Sum& side : {atom.left, atom.right})
        ASSERT_TRUE(side.group >= 0 && std::cmp_less_equal(side.group, polygons.size()));
  }
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
  const oracle::Scene before = bareScene(world);
  const auto result = must(stroke(world, edit));
  EXPECT_EQ(result.rounded.size(), 1U);
  EXPECT_EQ(farFromExact(before, edit, bareScene(world)), std::nullopt);
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

}  // namespace
}  // namespace lgs::test::tight
