#include "locator.h"

#include "beyond.h"
#include "rings.h"

#include <algorithm>

namespace lgs::detail {

std::optional<Locator::Crossing> Locator::crossing(std::int64_t y, Cell cell, Point start, Point end) {
  if (start.y > end.y) std::swap(start, end);
  if (start.y > y || end.y <= y) return std::nullopt;
  const Point origin = toWorld(cell, {0, 0});
  const std::int64_t height = 2 * (end.y - start.y);
  const std::int64_t along = (end.x - start.x) * (2 * (y - start.y) + 1);
  return Crossing{y, cell.i, (start.x - origin.x) * height + along, height};
}

LoopId Locator::ofPolygon(Cell cell, std::span<const LocalPoint> vertices) {
  const WorldRing ring = ringOf(cell, vertices);
  const std::int64_t y = std::ranges::min_element(ring, {}, &Point::y)->y;
  std::optional<Crossing> first;
  anyEdge(ring, [&](Point a, Point b) {
    const auto here = crossing(y, cell, a, b);
    if (here && (!first || *here < *first)) first = here;
    return false;
  });
  return first ? ofLoop(leftWestOf(*first)) : LoopId();
}

LoopId Locator::ofLoop(LoopId loop) {
  std::vector<LoopId> passed;
  const LoopId outer = throughHoles(loop, passed);
  for (const LoopId hole : passed) outers_[hole.value] = outer.value;
  return outer;
}

// No hole lies to the east of the one before, and no more begin in one vertex than cells have vertices there; unless
// this is another world than the one that the loops are of.
LoopId Locator::throughHoles(LoopId loop, std::vector<LoopId>& passed) {
  std::optional<Point> last;
  for (std::size_t inOneVertex = 0; inOneVertex < 4 * kMaxVerticesPerCell; ++inOneVertex) {
    if (const auto known = outers_.find(loop.value); known != outers_.end()) return {known->second};
    const auto facts = loops_.loop(loop);
    if (!facts || !facts->isHole()) return loop;
    passed.push_back(loop);
    const auto wall = wallWestOf(*facts);
    if (!wall || (last && facts->west > *last)) return {};
    if (last && facts->west < *last) inOneVertex = 0;
    last = facts->west;
    loop = leftWestOf(*wall);
  }
  return {};
}

/// A ray comes from a solid and runs to the west. The loop through which it leaves the island first; null, if it comes
/// from what is no solid yet.
LoopId Locator::leftWestOf(const Crossing& from) {
  const auto j = static_cast<std::int32_t>(from.y >> kCellBits);
  const auto [place, isNew] =
      rows_.try_emplace(static_cast<std::uint64_t>(from.y), static_cast<std::uint32_t>(passages_.size()));
  if (isNew) passages_.emplace_back();
  Passage& known = passages_[place->second];
  std::int32_t last = from.i;
  std::int32_t most = 64;  // at a time; more where there is nothing at all, as the world may end far away
  for (std::int32_t width = 1; last >= -kMaxCell; width = std::min(2 * width, most)) {
    if (known.first <= last && last <= known.last) {
      known.last = std::max(known.last, from.i - 1);
      return known.loop;
    }
    const std::int32_t west = std::max(last - width + 1, -kMaxCell), unloaded = lastUnloaded(west, last, j);
    const std::int32_t first = std::max(west, unloaded + 1);
    std::optional<Crossing> best;
    LoopId found;
    const std::vector<SegmentId> here = outline_.segments(CellRect{{first, j}, {last, j}});
    most = here.empty() ? std::min(2 * most, 1 << 28) : 64;
    for (const SegmentId id : here) {
      const Segment s = *outline_.segment(id);
      if (s.end.y >= s.start.y) continue;  // the solid is on its western side
      const auto at = crossing(from.y, s.cell, s.start, s.end);
      if (!at || *at > from || (best && *at <= *best)) continue;
      best = at;
      found = loops_.of(id);
    }
    if (best) {
      if (best->i + 1 < from.i) known = {best->i + 1, from.i - 1, found};
      return found;
    }
    if (unloaded >= west) {
      known = {first, from.i - 1, {}};
      return {};
    }
    last = first - 1;
  }
  return {};
}

/// The last cell of a row that is unloaded; one before the first, if none is.
std::int32_t Locator::lastUnloaded(std::int32_t first, std::int32_t last, std::int32_t j) const {
  std::int32_t found = first - 1;
  for (std::int32_t from = first; from <= last;) {
    const auto unloaded = outline_.firstUnloaded({{from, j}, {last, j}});
    if (!unloaded) break;
    found = std::min(unloaded->i | 31, last);
    from = found + 1;
  }
  return found;
}

/// Where a row beside the westernmost vertex of a hole crosses the hole's first edge from the west. Above the vertex,
/// if an edge leads up from there; otherwise one comes up to it from below. Nothing, if the hole is of another world.
std::optional<Locator::Crossing> Locator::wallWestOf(const LoopFacts& hole) const {
  const Point v = hole.west;
  std::optional<Crossing> above, below;
  const auto keep = [](std::optional<Crossing>& best, const std::optional<Crossing>& here) {
    if (here && (!best || *here < *best)) best = here;
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
  return above ? above : below;
}

}  // namespace lgs::detail
