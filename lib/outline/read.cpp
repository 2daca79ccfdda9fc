#include "outline/read.h"

#include "geometry/predicates.h"
#include "geometry/sort.h"

#include <algorithm>

namespace lgs::detail {
namespace {

/// Where a cycle must start to be the least sequence, in lexicographic order.
std::size_t leastRotation(const std::vector<Point>& cycle) {
  const std::size_t n = cycle.size();
  const auto less = [&](std::size_t a, std::size_t b) {
    for (std::size_t k = 0; k < n; ++k)
      if (const Point& p = cycle[(a + k) % n], &q = cycle[(b + k) % n]; p != q) return p < q;
    return false;
  };
  std::size_t best = 0;
  for (std::size_t k = 1; k < n; ++k)
    if (cycle[k] <= cycle[best] && less(k, best)) best = k;
  return best;
}

/// Drops the vertices where one segment arrives and one leaves in the same direction.
void mergeCollinear(const Grid& grid, const Outline& outline, std::vector<Loop>& loops) {
  std::vector<Point> starts;  // as many segments arrive at a vertex as leave it, so these are enough to count
  for (std::uint32_t id = 1; id <= outline.segments.maxId(); ++id)
    if (outline.segments.isLive(id)) starts.push_back(outline.startOf(grid, id));
  detail::sort(starts);
  const auto isShared = [&](Point v) {
    const auto [begin, end] = std::equal_range(starts.begin(), starts.end(), v);
    return end - begin > 1;
  };
  for (Loop& loop : loops) {
    std::vector<Point> corners;
    const std::size_t n = loop.vertices.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Point v = loop.vertices[k];
      const Vector in = v - loop.vertices[(k + n - 1) % n], out = loop.vertices[(k + 1) % n] - v;
      if (!sameDirection(in, out) || isShared(v)) corners.push_back(v);
    }
    loop.vertices = std::move(corners);
    loop.segments.clear();
  }
}

}  // namespace

Segment segmentOf(const Grid& grid, const Outline& outline, std::uint32_t id) {
  const SegmentRecord& s = outline.segments[id];
  Segment out;
  out.id = {id};
  out.start = outline.startOf(grid, id);
  out.end = outline.endOf(grid, id);
  out.predecessor = {s.predecessor};
  out.successor = {s.successor};
  if (s.predecessor != kNoSegment) out.ghost1 = outline.startOf(grid, s.predecessor);
  if (s.successor != kNoSegment) out.ghost2 = outline.endOf(grid, s.successor);
  out.block = s.block;
  out.polygon = {s.cellRef, s.serial};
  out.cell = grid.cellOf(s.cellRef);
  return out;
}

std::vector<SegmentId> liveSegments(const Outline& outline) {
  std::vector<SegmentId> out;
  for (std::uint32_t id = 1; id <= outline.segments.maxId(); ++id)
    if (outline.isShown({id})) out.push_back({id});
  return out;
}

std::vector<SegmentId> segmentsIn(const Grid& grid, const Outline& outline, const CellRect& cells) {
  std::vector<SegmentId> out;
  if (lgs::isEmpty(cells)) return out;
  grid.forEachCell(cells, [&](CellAt at, Cell) {
    if (outline.hides(at.chunk->index)) return;
    for (const std::uint32_t id : outline.lists.of(at).all()) out.push_back({id});
  });
  return out;
}

std::vector<Loop> loopsOf(const Grid& grid, const Outline& outline, Collinear collinear) {
  const SegmentPool& segments = outline.segments;
  std::vector<Loop> loops;
  std::vector<bool> seen(segments.maxId() + std::size_t{1});
  for (const SegmentId first : liveSegments(outline)) {
    if (seen[first.value]) continue;
    Loop loop;
    std::uint32_t at = first.value;
    do {
      seen[at] = true;
      loop.vertices.push_back(outline.startOf(grid, at));
      loop.segments.push_back({at});
      const std::uint32_t next = segments[at].successor;
      if (next == kNoSegment || segments[next].predecessor != at || outline.isHidden(SegmentId{next})) break;
      at = next;
    } while (at != first.value && !seen[at]);
    const std::uint32_t last = loop.segments.back().value;
    const bool closed = segments[last].successor == first.value && segments[first.value].predecessor == last;
    if (closed) loops.push_back(std::move(loop));
  }
  if (collinear == Collinear::merge) mergeCollinear(grid, outline, loops);
  for (Loop& loop : loops) {
    const auto start = static_cast<std::ptrdiff_t>(leastRotation(loop.vertices));
    std::rotate(loop.vertices.begin(), loop.vertices.begin() + start, loop.vertices.end());
    if (!loop.segments.empty()) std::rotate(loop.segments.begin(), loop.segments.begin() + start, loop.segments.end());
  }
  detail::sort(loops, [](const Loop& a, const Loop& b) { return a.vertices < b.vertices; });
  return loops;
}

}  // namespace lgs::detail
