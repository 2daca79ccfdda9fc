#include "locator.h"

#include "rings.h"

#include <algorithm>
#include <cassert>

namespace lgs::detail {

std::optional<Locator::Crossing> Locator::crossing(std::int64_t y, Cell cell, Point start, Point end) {
  if (start.y > end.y) std::swap(start, end);
  if (start.y > y || end.y <= y) return std::nullopt;
  const Point origin = toWorld(cell, {0, 0});
  const std::int64_t height = 2 * (end.y - start.y);
  const std::int64_t along = (end.x - start.x) * (2 * (y - start.y) + 1);
  return Crossing{y, cell.i, (start.x - origin.x) * height + along, height};
}

LoopId Locator::ofPolygon(Cell cell, std::span<const LocalPoint> vertices) const {
  const WorldRing ring = ringOf(cell, vertices);
  const std::int64_t y = std::ranges::min_element(ring, {}, &Point::y)->y;
  std::optional<Crossing> first;
  anyEdge(ring, [&](Point a, Point b) {
    const auto here = crossing(y, cell, a, b);
    if (here && (!first || *here < *first)) first = here;
    return false;
  });
  return ofLoop(leftWestOf(*first));
}

LoopId Locator::ofLoop(LoopId loop) const {
  for (;;) {
    const auto facts = loops_.loop(loop);
    if (!facts || !facts->isHole()) return loop;
    loop = leftWestOf(wallWestOf(*facts));
  }
}

/// A ray comes from a solid and runs to the west. The loop through which it leaves the island first.
LoopId Locator::leftWestOf(const Crossing& from) const {
  const auto j = static_cast<std::int32_t>(from.y >> kCellBits);
  std::int32_t last = from.i;
  for (std::int32_t width = 1; last >= -kMaxCell; width = std::min(2 * width, 64)) {
    const std::int32_t first = std::max(last - width + 1, -kMaxCell);
    std::optional<Crossing> best;
    LoopId found;
    for (const SegmentId id : outline_.segments(CellRect{{first, j}, {last, j}})) {
      const Segment s = *outline_.segment(id);
      if (s.end.y >= s.start.y) continue;  // the solid is on its western side
      const auto here = crossing(from.y, s.cell, s.start, s.end);
      if (!here || *here > from || (best && *here <= *best)) continue;
      best = here;
      found = loops_.of(id);
    }
    if (best) return found;
    last = first - 1;
  }
  assert(false && "every solid has a western end");
  return {};
}

/// Where a row beside the westernmost vertex of a hole crosses the hole's first edge from the west. Above the vertex,
/// if an edge leads up from there; otherwise one comes up to it from below.
Locator::Crossing Locator::wallWestOf(const LoopFacts& hole) const {
  const Point v = hole.west;
  std::optional<Crossing> above, below;
  const auto keep = [](std::optional<Crossing>& best, const std::optional<Crossing>& here) {
    if (here && (!best || *here < *best)) best = here;
  };
  const auto inWorld = [](std::int64_t index) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(index, -kMaxCell, kMaxCell));
  };
  const Cell low{inWorld((v.x - 1) >> kCellBits), inWorld((v.y - 1) >> kCellBits)};
  const Cell high{inWorld(v.x >> kCellBits), inWorld(v.y >> kCellBits)};
  for (const SegmentId id : outline_.segments(CellRect{low, high})) {
    const Segment s = *outline_.segment(id);
    if (s.end.y <= s.start.y || (s.start != v && s.end != v) || loops_.of(id) != hole.id) continue;
    if (s.start == v)
      keep(above, crossing(v.y, s.cell, s.start, s.end));
    else
      keep(below, crossing(v.y - 1, s.cell, s.start, s.end));
  }
  assert(above || below);
  return above ? *above : *below;
}

}  // namespace lgs::detail
