// A cell of which a hole is clipped comes out as it does by an arrangement.
#include "clip.h"
#include "cells.h"
#include "geometry/ring.h"
#include "oracle/calls/shapes.h"
#include "proptests/brush/same_edit.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test::clip {
namespace {

using brush::CellEdit;
using brush::CellPolygon;
using Polygons = brush::List<CellPolygon>;

/// One of the generator's shapes in the cell (0, 0), of one block or two: as it is, or so small that rounding matters.
struct Place {
  std::int64_t size = kUnitsPerCell;
  Point corner;
};

Place anyPlace(Chance& chance) {
  if (chance.below(2) == 0) return {};
  const std::int64_t size = std::int64_t{8} << chance.below(4), last = kUnitsPerCell - size;
  const auto coordinate = [&] {
    const auto kind = chance.below(3);
    return kind == 0 ? 0 : kind == 1 ? last : static_cast<std::int64_t>(chance.below(static_cast<std::size_t>(last)));
  };
  return {size, {coordinate(), coordinate()}};
}

Polygons anyGround(const Place& place, Chance& chance) {
  const auto& shapes = oracle::degenerateShapes();
  const auto& shape = shapes[chance.below(shapes.size())].polygons;
  const int symmetry = static_cast<int>(chance.below(8));
  const bool isOfTwo = chance.below(3) == 0;
  Polygons polygons;
  for (const oracle::LocalPolygon& polygon : shape) {
    CellPolygon& p = polygons.emplace_back();
    p.block = isOfTwo && polygons.size() % 2 == 0 ? 2 : 1;
    for (const LocalPoint v : oracle::turned(polygon, symmetry))
      p.ring.push_back(
          {place.corner.x + v.x * place.size / kUnitsPerCell, place.corner.y + v.y * place.size / kUnitsPerCell});
    if (detail::findSelfIntersection(p.ring)) return {};  // slivers vanish where all is small
  }
  return polygons;
}

/// Round, or a triangle or another convex polygon, with an edge near the place.
Region anyHole(const Place& place, Chance& chance) {
  const auto upTo = [&](std::int64_t most) {
    return static_cast<std::int64_t>(chance.below(static_cast<std::size_t>(most + 1)));
  };
  const std::int64_t radius = 1 + upTo(4 * place.size - 1);
  const Ring around = circle({}, radius, 32).rings[0];
  const Point rim = around[chance.below(std::size_t{32})];
  const Point center{place.corner.x + upTo(place.size) - rim.x, place.corner.y + upTo(place.size) - rim.y};
  if (chance.below(3) != 0) return circle(center, radius, chance.below(2) == 0 ? 8 : 32);
  Ring ring;
  const std::size_t step = 5 + chance.below(std::size_t{9});
  for (std::size_t k = chance.below(std::size_t{3}); k < 32; k += step)
    ring.push_back({center.x + around[k].x, center.y + around[k].y});
  return {{ring}};
}

TEST(Brush, AClippedCellComesOutAsArranged) {
  const Effort effort = effortOf(20'000);
  std::int64_t clipped = 0, cut = 0;
  for (std::int64_t n = 0; n < effort.cases && !HasFailure(); ++n) {
    const std::uint64_t seed = effort.seed + static_cast<std::uint64_t>(n);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Chance chance(seed);
    const brush::Frame frame;
    const Place place = anyPlace(chance);
    Polygons polygons = anyGround(place, chance);
    for (int stroke = 0; stroke < 3 && !polygons.empty(); ++stroke) {  // each in what the others have left
      const Region region = anyHole(place, chance);
      const brush::Coverage coverage = brush::coverage(region);
      const auto cell = std::ranges::find(coverage.cut, Cell{0, 0}, &brush::CutCell::cell);
      if (cell == coverage.cut.end()) continue;
      const brush::Stroke carve{brush::Deed::carve, 0, region.rule};
      const CellEdit arranged = arrangedEdit(polygons, cell->pieces, carve);
      const auto edit =
          clippedEdit(groundOf(polygons, meetingOf(polygons, cell->pieces, region.rule)), cell->pieces, carve);
      ++cut;
      if (edit) {
        ++clipped;
        expectSame(*edit, arranged);
      }
      Polygons left;
      for (std::size_t k = 0; k < polygons.size(); ++k)
        if (std::ranges::find(arranged.gone, k) == arranged.gone.end()) left.push_back(polygons[k]);
      for (const brush::NewPart& part : arranged.placed) left.push_back({part.ring, part.block});
      polygons = left;
    }
  }
  EXPECT_GT(2 * clipped, cut) << "it is usual";
}

}  // namespace
}  // namespace lgs::test::clip
