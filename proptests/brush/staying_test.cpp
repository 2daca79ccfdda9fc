// Blocks that stay, whatever a brush does around them; and the questions about regions.
#include "oracle/calls/random.h"
#include "proptests/brush/strokes.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lgs::test {
namespace {

LGS_LAW(BrushStaying, AllIsToFillAndNoneIsNothingSpecial, 1'500, (const AnyRegion& any)) {
  const Region region = any.region();
  World around = worldOf(Ground::slanted), filled = around, plain = around, none = around;
  must(paint(around, region, 2, PaintMode::replace, [](Block) { return true; }));
  must(paint(filled, region, 2, PaintMode::fill));
  EXPECT_TRUE(standingIn(around) == standingIn(filled));
  must(carve(plain, region));
  must(carve(none, region, [](Block block) { return block == 4'711; }));  // which is nowhere
  EXPECT_TRUE(standingIn(plain) == standingIn(none));
}

LGS_LAW(BrushRegions, CellsAreThoseInWhichSomethingChanges, 1'000, (const AnyRegion& any)) {
  World world;
  const Region region = any.region();
  const auto painted = paint(world, region, 1, PaintMode::fill);
  const auto cells = cellsOf(region);
  const auto bounds = boundsOf(region);
  ASSERT_TRUE(painted && cells && bounds);
  const std::set<Cell> all(cells->begin(), cells->end());
  EXPECT_EQ(all.size(), cells->size()) << "a cell is named twice";
  for (const Cell cell : all) EXPECT_TRUE(contains(*bounds, cell));
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    EXPECT_TRUE(all.contains(cell));
    Ring ring;
    for (const LocalPoint v : p.vertices) ring.push_back(toWorld(cell, v));
    EXPECT_TRUE(meets(region, ring));
    for (Point& v : ring) v.x += 9 * kUnitsPerCell;
    EXPECT_FALSE(meets(region, ring));
  });
}

/// Of a point whose coordinates are doubled: how often a ring runs around it.
std::int64_t windingOf(const Ring& ring, Point doubled) {
  std::int64_t winding = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a{2 * ring[k].x, 2 * ring[k].y}, next = ring[(k + 1) % ring.size()], b{2 * next.x, 2 * next.y};
    const std::int64_t side = (b.x - a.x) * (doubled.y - a.y) - (b.y - a.y) * (doubled.x - a.x);
    if (a.y <= doubled.y && b.y > doubled.y && side > 0) ++winding;
    if (b.y <= doubled.y && a.y > doubled.y && side < 0) --winding;
  }
  return winding;
}

bool isIn(const Region& region, Point doubled) {
  std::int64_t winding = 0;
  for (const Ring& ring : region.rings) winding += windingOf(ring, doubled);
  return region.rule == FillRule::evenOdd ? winding % 2 != 0 : winding != 0;
}

/// Whether an edge is at most so many units from a point whose coordinates are doubled.
bool isNearAnEdge(const Region& region, Point doubled, double units) {
  for (const Ring& ring : region.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point a{2 * ring[k].x, 2 * ring[k].y}, next = ring[(k + 1) % ring.size()], b{2 * next.x, 2 * next.y};
      const auto ux = static_cast<double>(b.x - a.x), uy = static_cast<double>(b.y - a.y);
      const auto x = static_cast<double>(doubled.x - a.x), y = static_cast<double>(doubled.y - a.y);
      const double t = std::clamp((x * ux + y * uy) / std::max(ux * ux + uy * uy, 1e-9), 0.0, 1.0);
      if (std::hypot(x - t * ux, y - t * uy) <= 2 * units) return true;
    }
  }
  return false;
}

LGS_LAW(BrushRegions, WithoutIsTheDifference, 300, (const AnyRegion& any, const AnyRegion& except, int seed)) {
  const Region region = any.region(), taken = except.region();
  const auto rest = must(without(region, taken));
  const CellRect cells = boundsOf(region).value();
  if (isEmpty(cells)) return failUnless(rest.rings.empty(), "something is left of nothing");
  Point min = region.rings[0][0], max = min;
  for (const Ring& ring : region.rings) {
    for (const Point p : ring) {
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
  }
  oracle::Random random(static_cast<std::uint64_t>(seed));
  for (int k = 0; k < 400; ++k) {
    const Point p{2 * min.x - 5 + random.below(static_cast<int>(2 * (max.x - min.x) + 10)),
                  2 * min.y - 5 + random.below(static_cast<int>(2 * (max.y - min.y) + 10))};
    if (isNearAnEdge(region, p, 2) || isNearAnEdge(taken, p, 2)) continue;
    EXPECT_EQ(isIn(rest, p), isIn(region, p) && !isIn(taken, p)) << p.x << " " << p.y << " / 2";
  }
}

constexpr std::int64_t kCellUnits = kUnitsPerCell;

Region rect(Point min, Point max) { return {{{min, {max.x, min.y}, max, {min.x, max.y}}}}; }

TEST(BrushRegionsByHand, WithoutSaysWhichRingWasRefused) {
  const Region region = rect({0, 0}, {3 * kCellUnits, kCellUnits}), far = rect({5, 5}, {kMaxCoordinate + 1, 9});
  const Region hole = rect({kCellUnits, 9}, {2 * kCellUnits, 90});
  EXPECT_EQ(
      without(region, hole)->rings,
      (std::vector<Ring>{region.rings[0], {hole.rings[0][0], hole.rings[0][3], hole.rings[0][2], hole.rings[0][1]}}));
  EXPECT_TRUE(without(hole, region)->rings.empty());
  EXPECT_EQ(without(far, region).error().polygon, 0);
  EXPECT_EQ(without(region, far).error().polygon, 1);
  const Region wide = rect({0, 0}, {(kMaxRegionCells + 1) * kCellUnits, 9});
  EXPECT_EQ(without(region, wide).error().polygon, -1) << "none of its rings, but all of it";
}

TEST(BrushRegionsByHand, BoundsAndCells) {
  const Region region = rect({5, 5}, {2 * kCellUnits, kCellUnits + 1});
  EXPECT_EQ(boundsOf(region).value(), (CellRect{{0, 0}, {1, 1}}));
  EXPECT_EQ(cellsOf(region)->size(), 4U);
  // Where its right edge runs from cell to cell it is rounded to the line on which it ends.
  const Region leaning{{{{9, -3 * kCellUnits}, {kCellUnits - 1, -3 * kCellUnits}, {kCellUnits, 3 * kCellUnits}}}};
  EXPECT_EQ(cellsOf(leaning)->size(), 6U) << "nothing of it is in the next column";
  EXPECT_TRUE(isEmpty(boundsOf(Region{}).value()));
  EXPECT_TRUE(isEmpty(boundsOf(rect({0, 0}, {0, 5})).value()));
  EXPECT_TRUE(cellsOf(Region{})->empty());
  const Region far = rect({5, 5}, {kMaxCoordinate + 1, 9});
  EXPECT_EQ(boundsOf(far).error().code, ErrorCode::outOfReach);
  EXPECT_EQ(cellsOf(far).error().code, ErrorCode::outOfReach);
  EXPECT_FALSE(meets(far, region.rings[0]));
  EXPECT_TRUE(meets(region, {{2 * kCellUnits, 9}, {2 * kCellUnits + 9, 9}, {2 * kCellUnits, 20}})) << "they touch";
  EXPECT_TRUE(meets(region, {{9, 9}, {20, 9}, {9, 20}})) << "inside";
  EXPECT_TRUE(meets(rect({9, 9}, {20, 20}), region.rings[0])) << "around";
  EXPECT_FALSE(meets(region, {{2 * kCellUnits + 1, 9}, {2 * kCellUnits + 9, 9}, {2 * kCellUnits + 1, 20}}));
  EXPECT_FALSE(
      meets({{region.rings[0], rect({7, 7}, {90, 90}).rings[0]}, FillRule::evenOdd}, {{20, 20}, {30, 20}, {20, 30}}))
      << "in a hole";
}

}  // namespace
}  // namespace lgs::test
