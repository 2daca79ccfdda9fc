#include "pixel_grid.h"

#include <lgs/brush.h>
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
  std::int64_t drawn = 0;  // the same without snapping
  double moved = 0;        // pixels, if it snapped to a grid line
  double miss = 0;         // pixels to the nearest grid line, if it did not
};

Snap snapOne(double pixels, double tile, double tolerance) {
  const double line = std::round(pixels / tile);
  const double miss = std::fabs(pixels - line * tile);
  const std::int64_t drawn = std::llround(pixels / tile * kUnitsPerCell);
  if (miss <= tolerance + kNoise) return {static_cast<std::int64_t>(line) * kUnitsPerCell, drawn, miss, 0};
  return {drawn, drawn, 0, miss};
}

std::int64_t nearestLine(std::int64_t v) { return ((v + kUnitsPerCell / 2) >> kCellBits) * kUnitsPerCell; }

/// Whether a ring is a polygon of the home cell just as it is.
bool isPolygon(const Polygon& ring) {
  const Box box = boundingBox(ring);
  return box.min.x >= 0 && box.min.y >= 0 && box.max.x <= kUnitsPerCell && box.max.y <= kUnitsPerCell && isSimple(ring);
}

}  // namespace

Snapped snap(const std::vector<DoublePoint>& outline, const PixelGrid& grid, double mostCells) {
  Snapped result;
  std::vector<std::pair<Point, double>> misses;  // a corner of the grid, and by how much a vertex misses it
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
      result.drawn.clear();
      return result;
    }
    const Snap x = snapOne(p.x, grid.tile.x, grid.tolerance.x), y = snapOne(p.y, grid.tile.y, grid.tolerance.y);
    result.ring.push_back({x.value, y.value});
    result.drawn.push_back({x.drawn, y.drawn});
    result.moved += unsigned{x.moved > kNoise} + unsigned{y.moved > kNoise};
    result.furthest = std::max({result.furthest, x.moved, y.moved});
    if (isNear(x.miss, y.miss))
      misses.push_back({{nearestLine(x.drawn), nearestLine(y.drawn)}, std::fmax(x.miss, y.miss)});
  }
  for (const auto& [corner, miss] :
       misses) {  // a vertex in the corner is joined already, and this one is apart from it
    if (std::find(result.ring.begin(), result.ring.end(), corner) == result.ring.end()) {
      result.nearMiss = std::fmax(result.nearMiss, miss);
    }
  }
  return result;
}

void takeBackCollapse(Snapped& snapped) {
  if (snapped.ring == snapped.drawn || tidyLoops(snapped.drawn).empty()) return;
  if (!collapses(snapped.drawn, snapped.ring)) return;
  snapped.ring = snapped.drawn;
  snapped.takenBack = true;
  snapped.nearMiss = 0;
}

bool isTangled(const Polygon& outline) {
  constexpr std::size_t kTwice = 2 * kMaxCrossings;  // each crossing is seen from both of its edges
  return crossings(outline, outline, kTwice) > kTwice;
}

std::optional<std::size_t> cutAlongGrid(const Polygon& outline, const PartSink& sink) {
  std::vector<Polygon> loops = tidyLoops(outline);
  if (loops.empty()) return 0;
  if (loops.size() == 1 && isPolygon(loops[0])) {  // as in most tiles; a world for each of them would take longer
    if (doubleArea(loops[0]) < 0) std::reverse(loops[0].begin(), loops[0].end());
    sink({}, loops[0]);
    return 1;
  }
  World world;
  if (!paint(world, {{outline}, FillRule::evenOdd}, 1, PaintMode::fill)) return std::nullopt;
  std::size_t parts = 0;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) {
    ++parts;
    sink(cell, ringOf(polygon.vertices));
  });
  return parts;
}

}  // namespace lgs::tiled
