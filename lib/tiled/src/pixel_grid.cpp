#include "pixel_grid.h"

#include "split.h"

#include <lgs/tiled/import.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs::tiled {
namespace {

/// Pixels. Arithmetic on doubles may move a coordinate by this much, which is not worth a note.
constexpr double kNoise = 1e-6;

struct Snap {
  std::int64_t value = 0;  // lattice units
  double moved = 0;        // pixels, if it snapped to a grid line
  double miss = 0;         // pixels to the nearest grid line, if it did not
};

Snap snapOne(double pixels, double tile, double tolerance) {
  const double line = std::round(pixels / tile);
  const double miss = std::fabs(pixels - line * tile);
  if (miss <= tolerance + kNoise) return {static_cast<std::int64_t>(line) * kUnitsPerCell, miss, 0};
  return {std::llround(pixels / tile * kUnitsPerCell), 0, miss};
}

std::int64_t cellOf(std::int64_t v) { return (v - (v < 0 ? kUnitsPerCell - 1 : 0)) / kUnitsPerCell; }

/// Cuts a ring into stripes one cell wide, columns (`upright`) or rows, and hands each part with its stripe to the
/// sink.
template <class Sink>
void slice(const Polygon& ring, bool upright, Sink&& sink) {
  std::vector<Polygon> rest{ring};
  while (!rest.empty()) {
    const Polygon part = std::move(rest.back());
    rest.pop_back();
    const Box box = boundingBox(part);
    const std::int64_t first = cellOf(upright ? box.min.x : box.min.y);
    const std::int64_t end = (first + 1) * kUnitsPerCell;
    // The line's left is the lower side.
    Halves halves = split(part, upright ? Line{{end, 0}, {0, 1}} : Line{{0, end}, {-1, 0}});
    for (const Polygon& p : halves.left) sink(static_cast<std::int32_t>(first), p);
    for (Polygon& p : halves.right) rest.push_back(std::move(p));
  }
}

}  // namespace

Snapped snap(const std::vector<DoublePoint>& outline, const PixelGrid& grid, double mostCells) {
  Snapped result;
  const auto isNear = [&](double missX, double missY) {
    // It is on one line and misses the other by at most twice the tolerance, and by so little that it is hardly meant.
    const double miss = std::fmax(missX, missY);
    const double tolerance = missX > 0 ? grid.tolerance.x : grid.tolerance.y;
    const double tile = missX > 0 ? grid.tile.x : grid.tile.y;
    return std::fmin(missX, missY) == 0 && miss > 0 && miss <= std::fmin(2 * tolerance, tile / 32);
  };
  for (const DoublePoint& p : outline) {
    // Huge coordinates can become not-a-number. The comparison is false for it, so that it counts as too far.
    if (!(std::fabs(p.x) <= mostCells * grid.tile.x && std::fabs(p.y) <= mostCells * grid.tile.y)) {
      result.tooFar = true;
      result.ring.clear();
      return result;
    }
    const Snap x = snapOne(p.x, grid.tile.x, grid.tolerance.x), y = snapOne(p.y, grid.tile.y, grid.tolerance.y);
    result.ring.push_back({x.value, y.value});
    result.moved += (x.moved > kNoise) + (y.moved > kNoise);
    result.furthest = std::max({result.furthest, x.moved, y.moved});
    if (isNear(x.miss, y.miss)) result.nearMiss = std::max({result.nearMiss, x.miss, y.miss});
  }
  return result;
}

std::vector<CellPart> cutAlongGrid(const Polygon& ring) {
  std::vector<CellPart> parts;
  slice(ring, true, [&](std::int32_t i, const Polygon& column) {
    slice(column, false, [&](std::int32_t j, const Polygon& part) {
      Polygon local = part;
      for (Point& p : local) {
        p.x -= std::int64_t{i} * kUnitsPerCell;
        p.y -= std::int64_t{j} * kUnitsPerCell;
      }
      parts.push_back({{i, j}, std::move(local)});
    });
  });
  return parts;
}

}  // namespace lgs::tiled
