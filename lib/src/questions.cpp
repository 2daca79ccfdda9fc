// What a world answers about places. It only reads. Every comparison is one of integers or of fractions of integers.
#include "geometry/relation.h"
#include "refusal.h"
#include "segment_geometry.h"
#include "world_impl.h"

#include <lgs/questions.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <tuple>

namespace lgs {

using detail::CellAt;
using detail::Fraction;
using detail::PolygonView;
using detail::Slot;

namespace {

double inCells(double units) { return units / kUnitsPerCell; }

/// A part of the way from one point to another, in cells.
DoublePoint pointOn(Point from, Point to, double part) {
  return {inCells(static_cast<double>(from.x) + part * static_cast<double>(to.x - from.x)),
          inCells(static_cast<double>(from.y) + part * static_cast<double>(to.y - from.y))};
}

constexpr CellRect kWholeWorld{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// A cell that may lie just beyond the last one: nothing is there.
struct CellIndex {
  std::int64_t i = 0;
  std::int64_t j = 0;
};

/// Where a point lies as to one polygon.
Spot::Where locate(PolygonView polygon, LocalPoint p) {
  detail::Sight sight;
  detail::look(p, p, polygon, sight);
  if (sight.inside) return Spot::Where::inside;
  return sight.outside ? Spot::Where::outside : Spot::Where::edge;
}

/// The cells of the world whose closed squares are at most `reach` lattice units away from a point on each axis.
CellRect cellsWithin(Point p, std::int64_t reach) {
  const auto clamped = [](std::int64_t at) { return std::clamp<std::int64_t>(at >> kCellBits, -kMaxCell, kMaxCell); };
  const auto cell = [&](std::int64_t x, std::int64_t y) {
    return Cell{static_cast<std::int32_t>(clamped(x)), static_cast<std::int32_t>(clamped(y))};
  };
  return {cell(p.x - reach - 1, p.y - reach - 1), cell(p.x + reach, p.y + reach)};
}

/// Rounded down.
constexpr std::int64_t floorOf(std::int64_t numerator, std::int64_t denominator) {
  return numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
}

/// The closed cells that a ray touches, slab by slab. A slab is a column if the ray is wider than high, and a row if it
/// is higher than wide. Calls visit(cell) for the cells of a slab, then slabDone(), which says whether to go on.
template <class Visit, class SlabDone>
void walk(const detail::Ray& ray, Visit&& visit, SlabDone&& slabDone) {
  const std::int64_t width = ray.to.x - ray.from.x, height = ray.to.y - ray.from.y;
  const bool byColumns = std::abs(width) >= std::abs(height);
  const std::int64_t from = byColumns ? ray.from.x : ray.from.y, to = byColumns ? ray.to.x : ray.to.y;
  const std::int64_t otherFrom = byColumns ? ray.from.y : ray.from.x, otherTo = byColumns ? ray.to.y : ray.to.x;
  const std::int64_t length = std::abs(to - from), slope = otherTo - otherFrom, step = to < from ? -1 : 1;
  // A point on a common side is in the cells on both sides of it.
  const auto lowest = [](std::int64_t at) { return (at - 1) >> kCellBits; };
  const auto highest = [](std::int64_t at) { return at >> kCellBits; };
  const std::int64_t first = step > 0 ? lowest(from) : highest(from), last = step > 0 ? highest(to) : lowest(to);
  for (std::int64_t slab = first; slab != last + step; slab += step) {
    // The part of the ray that is in this slab, as distances from its start; then how far across it gets there.
    const std::int64_t low = slab << kCellBits, high = low + kUnitsPerCell;
    const std::int64_t enter = std::max<std::int64_t>(0, step > 0 ? low - from : from - high);
    const std::int64_t leave = std::min(length, step > 0 ? high - from : from - low);
    const auto across = [&](std::int64_t distance) {
      return length == 0 ? otherFrom : otherFrom + floorOf(slope * distance, length);
    };
    const std::int64_t a = across(enter), b = across(leave);
    for (std::int64_t other = lowest(std::min(a, b)); other <= highest(std::max(a, b) + 1); ++other)
      visit(byColumns ? CellIndex{slab, other} : CellIndex{other, slab});
    if (!slabDone(leave, length)) return;
  }
}

}  // namespace

Point latticePoint(DoublePoint position) {
  const auto nearest = [](double cells) {
    constexpr auto kMost = static_cast<double>(kMaxCoordinate);
    const double units = std::round(cells * kUnitsPerCell);
    return units >= -kMost && units <= kMost ? static_cast<std::int64_t>(units) : kMaxCoordinate + 1;
  };
  return {nearest(position.x), nearest(position.y)};
}

// The root of an integer is rounded once, and everywhere alike. std::hypot() is not.
double Segment::length() const {
  const std::int64_t x = end.x - start.x, y = end.y - start.y;
  return inCells(std::sqrt(static_cast<double>(x * x + y * y)));
}

DoublePoint Segment::normal() const {
  const std::int64_t x = end.y - start.y, y = start.x - end.x;
  const double length = std::sqrt(static_cast<double>(x * x + y * y));
  return {static_cast<double>(x) / length, static_cast<double>(y) / length};
}

Spot World::Impl::at(Point p) const {
  Spot spot;
  if (!inRange(p)) return spot;
  spot.cell = cellAt(p);
  std::vector<PlacedPolygon> polygons;
  // On a common side a point is in the closed cells on both sides of it.
  const Cell low = cellAt({p.x - 1, p.y - 1}), high = cellAt(p);
  for (Cell cell = low; cell.j <= high.j; ++cell.j) {
    for (cell.i = low.i; cell.i <= high.i; ++cell.i) {
      this->polygons(cell, polygons);
      const Point origin = toWorld(cell, {});
      const LocalPoint local{static_cast<std::int32_t>(p.x - origin.x), static_cast<std::int32_t>(p.y - origin.y)};
      for (const PlacedPolygon& polygon : polygons) {
        const Spot::Where where = locate(polygon.vertices, local);
        if (where == Spot::Where::outside || spot.where == where) continue;
        spot = {where, polygon.handle, polygon.block, cell};
        if (where == Spot::Where::inside) return spot;
      }
    }
  }
  return spot;
}

// Looks at ever larger squares around the point: what is found in one is the answer if nothing outside can be nearer.
Expected<Nearest> World::Impl::nearest(Point p, double radius) const {
  if (!inRange(p) || !(radius >= 0 && radius <= kMaxRadius)) return detail::refuse({.code = ErrorCode::outOfReach});
  const auto squared = [](std::int64_t distance) {
    return detail::SquaredDistance{{0, static_cast<std::uint64_t>(distance * distance)}, 1};
  };
  const std::int64_t most = std::llround(radius * kUnitsPerCell);
  std::uint32_t nearest = detail::kNoSegment;
  detail::NearestOnEdge best{squared(most), {}};
  for (std::int64_t reach = std::min<std::int64_t>(most, kUnitsPerCell);; reach = std::min(most, 2 * reach)) {
    grid.forEachCell(cellsWithin(p, reach), [&](CellAt at, Cell) {
      for (const std::uint32_t id : grid.segments(at)) {
        const detail::NearestOnEdge here = detail::nearestOnEdge(edgeOf(id), p);
        const auto order = here.squared <=> best.squared;
        if (order > 0) continue;
        if (order == 0 && nearest != detail::kNoSegment && !comesFirst(id, nearest)) continue;
        best = here;
        nearest = id;
      }
    });
    if (reach == most || (nearest != detail::kNoSegment && best.squared <= squared(reach))) break;
  }
  if (nearest == detail::kNoSegment) return Nearest{};
  const double part = static_cast<double>(best.along.numerator) / static_cast<double>(best.along.denominator);
  return Nearest{{nearest}, pointOn(startOf(nearest), endOf(nearest), part), inCells(std::sqrt(best.squared.value()))};
}

Expected<RayHit> World::Impl::rayCast(Point from, Point to) const {
  constexpr std::int64_t kMax = std::int64_t{kMaxRay} * kUnitsPerCell;
  if (!inRange(from) || !inRange(to) || std::abs(to.x - from.x) > kMax || std::abs(to.y - from.y) > kMax)
    return detail::refuse({.code = ErrorCode::outOfReach});
  const detail::Ray ray{from, to};
  const auto find = [&](CellIndex cell) {
    if (std::abs(cell.i) > kMaxCell || std::abs(cell.j) > kMaxCell) return CellAt{};
    return grid.find(Cell{static_cast<std::int32_t>(cell.i), static_cast<std::int32_t>(cell.j)});
  };
  Fraction best;
  std::uint32_t first = detail::kNoSegment;
  walk(
      ray,
      [&](CellIndex cell) {
        const CellAt here = find(cell);
        if (!here) return;
        for (const std::uint32_t id : grid.segments(here)) {
          Fraction at;
          if (!detail::meets(ray, edgeOf(id), at)) continue;
          const auto order = at <=> best;
          if (first != detail::kNoSegment && (order > 0 || (order == 0 && !comesFirst(id, first)))) continue;
          best = at;
          first = id;
        }
      },
      [&](std::int64_t passed, std::int64_t length) {  // what comes later is met there at the earliest
        return first == detail::kNoSegment || !(best < Fraction{passed, length});
      });
  if (first == detail::kNoSegment) return RayHit{};
  const double fraction = static_cast<double>(best.numerator) / static_cast<double>(best.denominator);
  return RayHit{{first}, fraction, pointOn(from, to, fraction), segment(first).normal()};
}

/// Of two segments that a question can not tell apart: the order that no history has a part in.
bool World::Impl::comesFirst(std::uint32_t a, std::uint32_t b) const {
  return std::tuple(startOf(a), endOf(a), segments[a].block) < std::tuple(startOf(b), endOf(b), segments[b].block);
}

void World::Impl::forEachPolygon(const CellRect& cells, const World::PolygonVisitor& visit) const {
  if (lgs::isEmpty(cells)) return;
  std::vector<PlacedPolygon> polygons;
  grid.forEachCell(cells, [&](CellAt, Cell cell) {
    this->polygons(cell, polygons);
    for (const PlacedPolygon& polygon : polygons) visit(cell, polygon);
  });
}

std::optional<CellRect> World::Impl::bounds() const {
  std::optional<CellRect> bounds;
  grid.forEachCell(kWholeWorld, [&](CellAt at, Cell cell) {
    if (grid.content(at) == detail::kEmptyContent) return;
    if (!bounds) bounds = CellRect{cell, cell};
    bounds->min = {std::min(bounds->min.i, cell.i), std::min(bounds->min.j, cell.j)};
    bounds->max = {std::max(bounds->max.i, cell.i), std::max(bounds->max.j, cell.j)};
  });
  return bounds;
}

}  // namespace lgs
