#include "beyond.h"

#include "rings.h"

#include <algorithm>

namespace lgs::detail {
namespace {

constexpr std::int32_t kInChunk = 31;  ///< the bits of an index that say where in its chunk it is

/// How long the vector is on the axis on which it is longest: of vectors along one line these add up.
std::int64_t reach(Vector v) { return std::max(v.x < 0 ? -v.x : v.x, v.y < 0 ? -v.y : v.y); }

/// On which side of the cell an edge of a polygon lies, with the interior inside; no side.
Cell beyondSide(Cell cell, Point a, Point b) {
  const Point low = toWorld(cell, {0, 0}), high = toWorld(cell, {kUnitsPerCell, kUnitsPerCell});
  if (a.x == b.x && (a.x == low.x || a.x == high.x)) return {a.x == low.x ? -1 : 1, 0};
  if (a.y == b.y && (a.y == low.y || a.y == high.y)) return {0, a.y == low.y ? -1 : 1};
  return {0, 0};
}

}  // namespace

CellRect chunkWith(Cell cell) {
  return {{std::max(cell.i & ~kInChunk, -kMaxCell), std::max(cell.j & ~kInChunk, -kMaxCell)},
          {std::min(cell.i | kInChunk, kMaxCell), std::min(cell.j | kInChunk, kMaxCell)}};
}

CellRect cellsAround(Cell cell) {
  return {{inWorld(std::int64_t{cell.i} - 1), inWorld(std::int64_t{cell.j} - 1)},
          {inWorld(std::int64_t{cell.i} + 1), inWorld(std::int64_t{cell.j} + 1)}};
}

bool reachesUnloaded(const World& outline, const Standing& standing) {
  const Cell cell = standing.cell;
  if (!isAtRimOfChunk(cell)) return false;
  const CellRect around = cellsAround(cell);
  if (!outline.firstUnloaded(around)) return false;
  std::vector<Segment> shown;
  for (const SegmentId id : outline.segments(CellRect{cell, cell})) shown.push_back(*outline.segment(id));
  return anyEdge(ringOf(cell, standing.polygon.vertices), [&](Point a, Point b) {
    std::int64_t hidden = reach(b - a);
    for (const Segment& s : shown) {
      if (!isOnSegment(s.start, a, b) || !isOnSegment(s.end, a, b) || !sameDirection(b - a, s.end - s.start)) continue;
      hidden -= reach(s.end - s.start);
      for (const SegmentId link : {s.predecessor, s.successor})
        if (const auto other = outline.segment(link); !other && other.error().code == ErrorCode::unloaded) return true;
    }
    const Cell side = beyondSide(cell, a, b);
    const Cell other{cell.i + side.i, cell.j + side.j};
    return hidden > 0 && other != cell && contains(around, other) && isUnloaded(outline, other);
  });
}

}  // namespace lgs::detail

namespace lgs {

std::vector<CellRect> unloadedChunks(const World& world) noexcept {
  std::vector<CellRect> chunks;
  Cell from{-kMaxCell, -kMaxCell};
  while (from.j <= kMaxCell) {
    const auto first = world.firstUnloaded({from, {kMaxCell, kMaxCell}});
    if (!first) break;
    for (std::int32_t i = -kMaxCell; i <= kMaxCell;) {
      const auto next = world.firstUnloaded({{i, first->j}, {kMaxCell, first->j}});
      if (!next) break;
      chunks.push_back(detail::chunkWith(*next));
      i = (next->i | 31) + 1;
    }
    from.j = (first->j | 31) + 1;
  }
  return chunks;
}

}  // namespace lgs
