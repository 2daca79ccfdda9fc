// Which segment is nearest to a point, and which one a ray meets first. Every comparison is one of integers or of
// fractions of integers.
#include "ground/refusal.h"
#include "outline/read.h"
#include "outline/segment_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <tuple>

namespace lgs::detail {
namespace {

double inCells(double units) { return units / kUnitsPerCell; }

/// A part of the way from one point to another, in cells.
DoublePoint pointOn(Point from, Point to, double part) {
  return {inCells(static_cast<double>(from.x) + part * static_cast<double>(to.x - from.x)),
          inCells(static_cast<double>(from.y) + part * static_cast<double>(to.y - from.y))};
}

Cell cellOf(std::int64_t i, std::int64_t j) { return {static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)}; }

/// The cells of the world whose closed squares are at most `reach` lattice units away from a point on each axis.
CellRect cellsWithin(Point p, std::int64_t reach) {
  const auto clamped = [](std::int64_t at) { return std::clamp<std::int64_t>(at >> kCellBits, -kMaxCell, kMaxCell); };
  return {cellOf(clamped(p.x - reach - 1), clamped(p.y - reach - 1)),
          cellOf(clamped(p.x + reach), clamped(p.y + reach))};
}

/// Rounded down.
constexpr std::int64_t floorOf(std::int64_t numerator, std::int64_t denominator) {
  return numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
}

/// The closed cells that a ray touches, slab by slab. A slab is a column if the ray is wider than high, and a row if it
/// is higher than wide. Calls visit(cell) for the cells of a slab, which may lie just beyond the last one of the world,
/// then slabDone(), which says whether to go on.
template <class Visit, class SlabDone>
void walk(const Ray& ray, Visit&& visit, SlabDone&& slabDone) {
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
      visit(byColumns ? cellOf(slab, other) : cellOf(other, slab));
    if (!slabDone(leave, length)) return;
  }
}

SegmentEnds endsOf(const Grid& grid, const Outline& outline, std::uint32_t id) {
  return {outline.startOf(grid, id), outline.endOf(grid, id)};
}

/// The chunks with cells of a rectangle that were unloaded at the last commit: calls visit(cells) with those of each.
template <class Visit>
void forEachHidden(const Grid& grid, const Outline& outline, const CellRect& cells, Visit&& visit) {
  grid.forEachNumber(cells, [&](std::uint32_t number) {
    if (!outline.hides(number)) return;
    const Cell first = grid.cellOfAny(number * kChunkCells);
    visit(
        CellRect{first, {std::min(first.i + kChunkSize - 1, kMaxCell), std::min(first.j + kChunkSize - 1, kMaxCell)}});
  });
}

/// The cell of a rectangle that is nearest to a point, and how far it is.
std::pair<Cell, SquaredDistance> nearestCell(const CellRect& cells, Point p) {
  const Point low = toWorld(cells.min, {}), high = toWorld(cells.max, {kUnitsPerCell, kUnitsPerCell});
  const Point nearest{std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)};
  const auto square = [](std::int64_t v) { return static_cast<std::uint64_t>(v * v); };
  const Cell cell = lgs::cellAt(nearest);
  return {{std::min(cell.i, cells.max.i), std::min(cell.j, cells.max.j)},
          {{0, square(p.x - nearest.x) + square(p.y - nearest.y)}, 1}};
}

/// Whether a ray meets a closed cell; `at` receives where first.
bool meets(const Ray& ray, Cell cell, Fraction& at) {
  Fraction enter{0, 1}, leave{1, 1};
  const auto narrow = [&](std::int64_t from, std::int64_t to, std::int64_t low) {
    const std::int64_t high = low + kUnitsPerCell, length = std::abs(to - from);
    if (length == 0) return low <= from && from <= high;
    const std::int64_t first = to > from ? low - from : from - high, last = first + kUnitsPerCell;
    if (last < 0) return false;
    enter = std::max(enter, Fraction{std::max<std::int64_t>(first, 0), length});
    leave = std::min(leave, Fraction{last, length});
    return true;
  };
  const Point low = toWorld(cell, {});
  if (!narrow(ray.from.x, ray.to.x, low.x) || !narrow(ray.from.y, ray.to.y, low.y) || leave < enter) return false;
  at = enter;
  return true;
}

/// Of two segments that a question can not tell apart: the order that no history has a part in.
bool comesFirst(const Grid& grid, const Outline& outline, std::uint32_t a, std::uint32_t b) {
  const auto key = [&](std::uint32_t id) {
    return std::tuple(outline.startOf(grid, id), outline.endOf(grid, id), outline.segments[id].block);
  };
  return key(a) < key(b);
}

}  // namespace

// Looks at ever larger squares around the point: what is found in one is the answer if nothing outside can be nearer.
Expected<Nearest> nearest(const Grid& grid, const Outline& outline, Point p, double radius) {
  if (!inRange(p) || !(radius >= 0 && radius <= kMaxRadius)) return refuse({.code = ErrorCode::outOfReach});
  const auto squared = [](std::int64_t distance) {
    return SquaredDistance{{0, static_cast<std::uint64_t>(distance * distance)}, 1};
  };
  const std::int64_t most = std::llround(radius * kUnitsPerCell);
  std::uint32_t nearest = kNoSegment;
  NearestOnEdge best{squared(most), {}};
  std::int64_t reach = std::min<std::int64_t>(most, kUnitsPerCell);
  for (;; reach = std::min(most, 2 * reach)) {
    grid.forEachCell(cellsWithin(p, reach), [&](CellAt at, Cell) {
      if (outline.hides(at.chunk->index)) return;
      for (const std::uint32_t id : outline.lists.of(at).all()) {
        const NearestOnEdge here = nearestOnEdge(endsOf(grid, outline, id), p);
        const auto order = here.squared <=> best.squared;
        if (order > 0) continue;
        if (order == 0 && nearest != kNoSegment && !comesFirst(grid, outline, id, nearest)) continue;
        best = here;
        nearest = id;
      }
    });
    if (reach == most || (nearest != kNoSegment && best.squared <= squared(reach))) break;
  }
  if (outline.hidesAny()) {
    std::optional<Cell> unseen;
    forEachHidden(grid, outline, cellsWithin(p, reach), [&](const CellRect& chunk) {
      const auto [cell, distance] = nearestCell(chunk, p);
      if (distance <= best.squared && (!unseen || std::pair(cell.j, cell.i) < std::pair(unseen->j, unseen->i)))
        unseen = cell;
    });
    if (unseen) return refuse({.code = ErrorCode::unloaded, .cell = *unseen});
  }
  if (nearest == kNoSegment) return Nearest{};
  const double part = static_cast<double>(best.along.numerator) / static_cast<double>(best.along.denominator);
  return Nearest{{nearest},
                 pointOn(outline.startOf(grid, nearest), outline.endOf(grid, nearest), part),
                 inCells(std::sqrt(best.squared.value()))};
}

Expected<RayHit> rayCast(const Grid& grid, const Outline& outline, Point from, Point to) {
  constexpr std::int64_t kMax = std::int64_t{kMaxRay} * kUnitsPerCell;
  if (!inRange(from) || !inRange(to) || std::abs(to.x - from.x) > kMax || std::abs(to.y - from.y) > kMax)
    return refuse({.code = ErrorCode::outOfReach});
  const Ray ray{from, to};
  Fraction best, unseenAt;
  std::optional<Cell> unseen;  // the first unloaded cell on the way
  std::uint32_t first = kNoSegment;
  walk(
      ray,
      [&](Cell cell) {
        if (outline.hidesAny() && outline.hides(grid.numberAt(cell.i >> 5, cell.j >> 5))) {
          Fraction at;
          if (!inRange(cell) || !meets(ray, cell, at) || (unseen && unseenAt <= at)) return;
          unseenAt = at;
          unseen = cell;
          return;
        }
        for (const std::uint32_t id : outline.lists.of(grid.find(cell)).all()) {
          Fraction at;
          if (!meets(ray, endsOf(grid, outline, id), at)) continue;
          const auto order = at <=> best;
          if (first != kNoSegment && (order > 0 || (order == 0 && !comesFirst(grid, outline, id, first)))) continue;
          best = at;
          first = id;
        }
      },
      [&](std::int64_t passed, std::int64_t length) {  // what comes later is met there at the earliest
        const Fraction now{passed, length};
        return (first == kNoSegment || !(best < now)) && (!unseen || !(unseenAt < now));
      });
  if (unseen && (first == kNoSegment || unseenAt <= best))
    return refuse({.code = ErrorCode::unloaded, .cell = *unseen});
  if (first == kNoSegment) return RayHit{};
  const double fraction = static_cast<double>(best.numerator) / static_cast<double>(best.denominator);
  return RayHit{{first}, fraction, pointOn(from, to, fraction), segmentOf(grid, outline, first).normal()};
}

}  // namespace lgs::detail
