#include "pixel_grid.h"

#include "xml.h"

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
  std::int64_t line = 0;   // the nearest grid line
  double moved = 0;        // pixels, if it snapped to it
  double miss = 0;         // pixels, if it did not
  double nearMiss = 0;     // the same, if that is so little more than the tolerance that it is hardly meant
};

Snap snapOne(double pixels, double tile, double tolerance) {
  const double line = std::round(pixels / tile), miss = std::fabs(pixels - line * tile);
  const std::int64_t drawn = std::llround(pixels / tile * kUnitsPerCell);
  const std::int64_t at = static_cast<std::int64_t>(line) * kUnitsPerCell;
  if (miss <= tolerance + kNoise) return {at, drawn, at, miss};
  return {drawn, drawn, at, 0, miss, miss <= std::fmin(2 * tolerance, tile / 32) ? miss : 0};
}

/// Whether a ring is a polygon of the home cell just as it is.
bool isPolygon(const Polygon& ring) {
  const Box box = boundingBox(ring);
  return box.min.x >= 0 && box.min.y >= 0 && box.max.x <= kUnitsPerCell && box.max.y <= kUnitsPerCell && isSimple(ring);
}

/// Whether sides of an outline meet on the grid that did not meet as drawn: both sides of a thin wall came to lie on
/// one line, or a narrow waist was closed. Neighbouring vertices may become one. Of an outline that meets itself as
/// drawn nobody can tell.
bool collapses(const Polygon& drawn, const Polygon& snapped) {
  const auto meetsItself = [](Polygon ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return !isSimple(ring);
  };
  return meetsItself(snapped) && !meetsItself(drawn);
}

}  // namespace

std::size_t crossings(const Polygon& a, const Polygon& b, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size() && count <= most; ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) count += crossProperly(a[i], nextVertex(a, i), b[j], nextVertex(b, j));
  }
  return count;
}

Polygon ringOf(std::span<const LocalPoint> vertices) {
  Polygon ring;
  for (const LocalPoint v : vertices) ring.push_back({v.x, v.y});
  return ring;
}

std::vector<LocalPoint> localRing(const Polygon& ring) {
  std::vector<LocalPoint> vertices;
  for (const Point p : ring) vertices.push_back({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)});
  return vertices;
}

Polygon tidied(Polygon ring) {
  for (std::size_t k = 0; k < ring.size() && ring.size() >= 3;) {
    const bool isFlat = orientation(ring[(k == 0 ? ring.size() : k) - 1], ring[k], nextVertex(ring, k)) == 0;
    if (isFlat) ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
    k = isFlat ? 0 : k + 1;  // a removal can flatten others
  }
  return ring;
}

tl::expected<Snapped, std::string> snap(const std::vector<DoublePoint>& outline, const PixelGrid& grid,
                                        double mostCells) {
  Snapped result;
  Polygon drawn;                                 // the ring as it would be without snapping, vertex by vertex
  std::vector<std::pair<Point, double>> misses;  // a corner of the grid, and by how much a vertex misses it
  for (const DoublePoint& p : outline) {
    // Huge coordinates can become not-a-number. The comparison is false for it, so that it counts as too far.
    if (!(std::fabs(p.x) <= mostCells * grid.tile.x && std::fabs(p.y) <= mostCells * grid.tile.y))
      return tl::unexpected(mostCells > kMaxReach
                                ? "it is too far away"
                                : concat("it reaches more than ", kMaxReach, " cells out of its cell"));
    const Snap x = snapOne(p.x, grid.tile.x, grid.tolerance.x), y = snapOne(p.y, grid.tile.y, grid.tolerance.y);
    result.ring.push_back({x.value, y.value});
    drawn.push_back({x.drawn, y.drawn});
    result.moved += unsigned{x.moved > kNoise} + unsigned{y.moved > kNoise};
    result.furthest = std::max({result.furthest, x.moved, y.moved});
    if (std::fmin(x.miss, y.miss) == 0 && x.nearMiss + y.nearMiss > 0)  // it is on one line, and misses the other
      misses.push_back({{x.line, y.line}, x.nearMiss + y.nearMiss});
  }
  constexpr std::int64_t kExtent = kMaxRegionCells * kUnitsPerCell;
  const Box box = boundingBox(result.ring);
  if (box.max.x - box.min.x > kExtent || box.max.y - box.min.y > kExtent)
    return tl::unexpected(concat("it is more than ", kMaxRegionCells, " cells wide or high"));
  result.takenBack = result.ring != drawn && collapses(drawn, result.ring);
  if (result.takenBack) {
    result.ring = std::move(drawn);
    return result;
  }
  for (const auto& [corner, miss] : misses) {
    const bool isJoined = std::find(result.ring.begin(), result.ring.end(), corner) != result.ring.end();
    if (!isJoined) result.nearMiss = std::fmax(result.nearMiss, miss);
  }
  return result;
}

std::optional<std::size_t> cutAlongGrid(const Polygon& outline, const PartSink& sink) {
  Polygon ring = tidied(outline);
  if (ring.size() < 3) return 0;
  if (isPolygon(ring)) {  // as in most tiles; a world for each of them would take longer
    if (doubleArea(ring) < 0) std::reverse(ring.begin(), ring.end());
    sink({}, ring);
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
