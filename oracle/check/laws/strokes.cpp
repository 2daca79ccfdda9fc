// What the region of a stroke does to ground of its own, and what is said of it. Law 10: full cells around it, whole or
// halved, that are carved and filled again have no seam. To paint around all blocks is to fill, around none nothing
// special. It has the cells in which something changes, it meets what it has made, and a region without another one is
// their difference.
#include "oracle/calls/caller.h"
#include "oracle/calls/random.h"
#include "oracle/check/laws/list.h"
#include "oracle/check/observed.h"

#include <lgs/brush.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lgs::oracle {
namespace {

constexpr std::int32_t kMostCells = 4;  // wide and high: beyond that nothing is tried

std::vector<std::vector<Point>> mergedLoops(World& world) {
  world.commit();
  std::vector<std::vector<Point>> all;
  for (const Loop& loop : world.loops(Collinear::merge)) all.push_back(loop.vertices);
  return all;
}

std::string wrongSeam(const Region& region, const CellRect& cells, bool areHalved) {
  constexpr std::int32_t kEnd = kUnitsPerCell, kLow = kEnd / 3, kHigh = kEnd - 5;
  World world;
  for (std::int32_t j = cells.min.j; j <= cells.max.j; ++j) {
    for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i) {
      const bool done = areHalved ? world.add({i, j}, {{0, 0}, {kEnd, 0}, {kEnd, kHigh}, {0, kLow}}, 1) &&
                                        world.add({i, j}, {{0, kLow}, {kEnd, kHigh}, {kEnd, kEnd}, {0, kEnd}}, 1)
                                  : world.add({i, j}, kUnitSquare, 1).has_value();
      if (!done) return "";
    }
  }
  const auto solid = mergedLoops(world);
  if (!carve(world, region)) return "";
  world.commit();
  if (!paint(world, region, 1, PaintMode::fill)) return "";
  return mergedLoops(world) == solid ? "" : "full ground that is carved and filled again has a seam";
}

std::string wrongStaying(const World& world, const Region& region, Block block) {
  World around = world, filled = world, plain = world, none = world;
  const auto all = paint(around, region, block, PaintMode::replace, [](Block) { return true; });
  const auto fill = paint(filled, region, block, PaintMode::fill);
  if (all.has_value() != fill.has_value() || !differenceOf(around, filled).empty())
    return "to paint around all blocks is not to fill";
  const auto carved = carve(plain, region), carvedToo = carve(none, region, [](Block) { return false; });
  if (carved.has_value() != carvedToo.has_value() || !differenceOf(plain, none).empty())
    return "to carve around no blocks is not to carve";
  return "";
}

std::string wrongCells(const Region& region, const CellRect& bounds) {
  World world;
  if (!paint(world, region, 1, PaintMode::fill)) return "";
  const auto cells = cellsOf(region);
  if (!cells) return "cellsOf() refuses what can be painted";
  const std::set<Cell> all(cells->begin(), cells->end());
  if (all.size() != cells->size()) return "cellsOf() names a cell twice";
  if (!std::ranges::all_of(all, [&](Cell cell) { return contains(bounds, cell); }))
    return "cellsOf() names a cell beyond boundsOf()";
  std::string wrong;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    Ring ring;
    for (const LocalPoint v : p.vertices) ring.push_back(toWorld(cell, v));
    if (!all.contains(cell)) wrong = "cellsOf() forgets a cell";
    if (!meets(region, ring)) wrong = "a region does not meet what it has painted";
    for (Point& v : ring) v.x += (2 * kMostCells + 1) * kUnitsPerCell;
    if (meets(region, ring)) wrong = "a region meets what is far away";
  });
  return wrong;
}

/// Of a point whose coordinates are doubled.
bool isInside(const Region& region, Point doubled) {
  std::int64_t winding = 0;
  for (const Ring& ring : region.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point a{2 * ring[k].x, 2 * ring[k].y}, next = ring[(k + 1) % ring.size()], b{2 * next.x, 2 * next.y};
      const std::int64_t side = (b.x - a.x) * (doubled.y - a.y) - (b.y - a.y) * (doubled.x - a.x);
      if (a.y <= doubled.y && b.y > doubled.y && side > 0) ++winding;
      if (b.y <= doubled.y && a.y > doubled.y && side < 0) --winding;
    }
  }
  return region.rule == FillRule::evenOdd ? winding % 2 != 0 : winding != 0;
}

/// Whether an edge is at most two units from it.
bool isAtAnEdge(const Region& region, Point doubled) {
  for (const Ring& ring : region.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point a{2 * ring[k].x, 2 * ring[k].y}, next = ring[(k + 1) % ring.size()], b{2 * next.x, 2 * next.y};
      const auto ux = static_cast<double>(b.x - a.x), uy = static_cast<double>(b.y - a.y);
      const auto x = static_cast<double>(doubled.x - a.x), y = static_cast<double>(doubled.y - a.y);
      const double t = std::clamp((x * ux + y * uy) / std::max(ux * ux + uy * uy, 1e-9), 0.0, 1.0);
      if (std::hypot(x - t * ux, y - t * uy) <= 4) return true;
    }
  }
  return false;
}

std::string wrongWithout(const Region& region, const Region& taken, Random& random) {
  const auto rest = without(region, taken);
  if (!rest) return "";
  std::vector<Point> corners;
  for (const Ring& ring : region.rings) corners.insert(corners.end(), ring.begin(), ring.end());
  constexpr int kTries = 60;
  for (int k = 0; k < kTries && !corners.empty(); ++k) {  // between two corners, or near to one
    const Point a = random.pick(corners), b = random.chance(70) ? random.pick(corners) : a;
    const std::int64_t dx = random.between(-12, 12), dy = random.between(-12, 12);
    const Point p{a.x + b.x + dx, a.y + b.y + dy};
    if (isAtAnEdge(region, p) || isAtAnEdge(taken, p)) continue;
    if (isInside(*rest, p) != (isInside(region, p) && !isInside(taken, p)))
      return "a region without another one is not their difference";
  }
  return "";
}

/// The cells that the vertices reach; those of a side that ends at the border of a cell are on its near side.
std::string wrongBounds(const Region& region, const CellRect& bounds) {
  Point min{INT64_MAX, INT64_MAX}, max{INT64_MIN, INT64_MIN};
  for (const Ring& ring : region.rings) {
    for (const Point p : ring) {
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
  }
  const bool isNothing = min.x >= max.x || min.y >= max.y;
  if (isNothing != isEmpty(bounds))
    return "boundsOf() has cells of a region without width or height, or none of another";
  const auto cell = [](std::int64_t v) { return static_cast<std::int32_t>(v >> kCellBits); };
  const bool isLeast = isNothing || bounds == CellRect{{cell(min.x), cell(min.y)}, {cell(max.x - 1), cell(max.y - 1)}};
  return isLeast ? "" : "boundsOf() is not the least rectangle of a region";
}

class StrokesLaw : public Law {
 public:
  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    if (judged.call.kind != Call::Kind::brush || isRefused) return std::nullopt;
    const Region region = regionOf(judged.call.brush);
    const auto bounds = boundsOf(region);
    const auto isWide = [](std::int32_t min, std::int32_t max) { return std::int64_t{max} - min >= kMostCells; };
    if (std::string wrong = bounds ? wrongBounds(region, *bounds) : ""; !wrong.empty())
      return seen.mismatch(Mismatch::Kind::reading, std::move(wrong));
    if (!bounds || isEmpty(*bounds) || isWide(bounds->min.i, bounds->max.i) || isWide(bounds->min.j, bounds->max.j))
      return std::nullopt;
    Random random(seen.edits);
    const Region before = std::exchange(last_, region);
    std::string wrong = wrongSeam(region, *bounds, false);
    if (wrong.empty()) wrong = wrongSeam(region, *bounds, true);
    if (wrong.empty()) wrong = wrongCells(region, *bounds);
    if (wrong.empty()) wrong = wrongWithout(region, before, random);
    if (wrong.empty() && random.chance(25)) wrong = wrongStaying(seen.world(), region, judged.call.brush.block);
    return wrong.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::rounding, std::move(wrong)));
  }

 private:
  Region last_;
};

}  // namespace

std::unique_ptr<Law> laws::strokes() { return std::make_unique<StrokesLaw>(); }

}  // namespace lgs::oracle
