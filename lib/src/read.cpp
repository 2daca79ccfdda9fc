// Reads a world, and never changes it.
#include "geometry/predicates.h"
#include "geometry/sort.h"
#include "world_impl.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace lgs {

using detail::CellAt;
using detail::InternedContent;
using detail::operator-;  // NOLINT(misc-unused-using-decls): a template below uses it
using detail::Placed;
using detail::SegmentRecord;
using detail::Slot;

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

}  // namespace

void World::Impl::polygons(Cell cell, std::vector<PlacedPolygon>& out) const {
  out.clear();
  const CellAt at = grid.find(cell);
  if (!at) return;
  const InternedContent& content = contentOf(at);
  for (std::size_t slot = 0; slot < content.polygons.size(); ++slot) {
    const Placed placed = grid.placed(at)[static_cast<Slot>(slot)];
    out.push_back({{at.chunk->ref(at.local), placed.serial}, placed.block, catalogue.vertices(content.polygons[slot])});
  }
  detail::sort(out, [](const auto& a, const auto& b) { return a.handle < b.handle; });
}

std::optional<PlacedPolygon> World::Impl::polygon(PolygonHandle handle) const {
  const auto slot = slotOf(handle);
  if (!slot) return std::nullopt;
  const CellAt at = grid.find(handle.cellRef);
  assert(at);
  const InternedContent& content = contentOf(at);
  return PlacedPolygon{handle, grid.placed(at)[*slot].block, catalogue.vertices(content.polygons[*slot])};
}

Segment World::Impl::segment(std::uint32_t id) const {
  const SegmentRecord& s = segments[id];
  Segment out;
  out.id = {id};
  out.start = startOf(id);
  out.end = endOf(id);
  out.predecessor = {s.predecessor};
  out.successor = {s.successor};
  if (s.predecessor != detail::kNoSegment) out.ghost1 = startOf(s.predecessor);
  if (s.successor != detail::kNoSegment) out.ghost2 = endOf(s.successor);
  out.block = s.block;
  out.polygon = {s.cellRef, s.serial};
  out.cell = grid.cellOf(s.cellRef);
  return out;
}

std::vector<SegmentId> World::Impl::liveSegments() const {
  std::vector<SegmentId> out;
  for (std::uint32_t id = 1; id <= segments.maxId(); ++id)
    if (segments.isLive(id)) out.push_back({id});
  return out;
}

std::vector<SegmentId> World::Impl::segmentsIn(const CellRect& cells) const {
  std::vector<SegmentId> out;
  if (lgs::isEmpty(cells)) return out;
  grid.forEachCell(cells, [&](CellAt at, Cell) {
    for (const std::uint32_t id : grid.segments(at)) out.push_back({id});
  });
  return out;
}

std::vector<Loop> World::Impl::loops(Collinear collinear) const {
  std::vector<Loop> loops;
  std::vector<bool> seen(segments.maxId() + std::size_t{1});
  for (const SegmentId first : liveSegments()) {
    if (seen[first.value]) continue;
    Loop loop;
    std::uint32_t at = first.value;
    do {
      seen[at] = true;
      loop.vertices.push_back(startOf(at));
      loop.segments.push_back({at});
      const std::uint32_t next = segments[at].successor;
      if (next == detail::kNoSegment || segments[next].predecessor != at) break;
      at = next;
    } while (at != first.value && !seen[at]);
    const std::uint32_t last = loop.segments.back().value;
    const bool closed = segments[last].successor == first.value && segments[first.value].predecessor == last;
    if (closed) loops.push_back(std::move(loop));
  }
  if (collinear == Collinear::merge) mergeCollinear(loops);
  for (Loop& loop : loops) {
    const auto start = static_cast<std::ptrdiff_t>(leastRotation(loop.vertices));
    std::rotate(loop.vertices.begin(), loop.vertices.begin() + start, loop.vertices.end());
    if (!loop.segments.empty()) std::rotate(loop.segments.begin(), loop.segments.begin() + start, loop.segments.end());
  }
  detail::sort(loops, [](const Loop& a, const Loop& b) { return a.vertices < b.vertices; });
  return loops;
}

/// Drops the vertices where one segment arrives and one leaves in the same direction.
void World::Impl::mergeCollinear(std::vector<Loop>& loops) const {
  std::vector<Point> starts;  // as many segments arrive at a vertex as leave it, so these are enough to count
  for (const SegmentId id : liveSegments()) starts.push_back(startOf(id.value));
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
      const detail::Vector in = v - loop.vertices[(k + n - 1) % n], out = loop.vertices[(k + 1) % n] - v;
      if (!detail::sameDirection(in, out) || isShared(v)) corners.push_back(v);
    }
    loop.vertices = std::move(corners);
    loop.segments.clear();
  }
}

/// Whether every polygon of another world is here too.
bool World::Impl::holdsPolygonsOf(const Impl& other) const {
  using Vertices = std::vector<LocalPoint>;
  std::vector<PlacedPolygon> placed;
  const auto read = [&placed](const Impl& world, Cell cell) {
    std::vector<std::pair<Vertices, Block>> out;
    world.polygons(cell, placed);
    for (const PlacedPolygon& p : placed) {
      Vertices vertices(p.vertices.begin(), p.vertices.end());
      std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end()), vertices.end());
      out.emplace_back(std::move(vertices), p.block);
    }
    detail::sort(out);
    return out;
  };
  const auto chunks = other.grid.chunks();
  return std::all_of(chunks.begin(), chunks.end(), [&](const auto& chunk) {
    for (std::uint32_t local = 0; local < detail::kChunkCells; ++local) {
      if (other.grid.content({chunk.get(), local}) == detail::kEmptyContent) continue;
      const Cell cell = chunk->cell(local);
      if (read(*this, cell) != read(other, cell)) return false;
    }
    return true;
  });
}

Stats World::Impl::stats() const {
  Stats stats;
  for (const auto& chunk : grid.chunks()) {
    for (std::uint32_t local = 0; local < detail::kChunkCells; ++local) {
      const CellAt at{chunk.get(), local};
      const std::size_t polygons = contentOf(at).polygons.size();
      stats.polygons += polygons;
      stats.cells += polygons > 0;
      stats.segments += grid.segments(at).size();
    }
  }
  stats.shapes = catalogue.shapeCount();
  stats.contents = catalogue.contentCount();
  stats.chunks = grid.chunks().size();
  const auto of = []<class T>(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);  // NOLINT(bugprone-sizeof-expression): of pointers too
  };
  stats.bytes = sizeof(World) + sizeof *this + grid.bytes() + catalogue.bytes() + segments.bytes() + of(dirtyChunks) +
                of(changes.removed) + of(changes.added) + of(changes.relinked) + of(changesOfRollBack.removed) +
                of(changesOfRollBack.added) + of(changesOfRollBack.relinked) + journal.bytes() + workingBytes();
  return stats;
}

}  // namespace lgs
