// Segments and polygons, one or many.
#include "inside.h"

#include <array>

using namespace lgs::c;
using lgs::CellRect;
using lgs::PlacedPolygon;
using lgs::SegmentId;

namespace lgs::c {

lgs_polygon described(Cell cell, const PlacedPolygon& p) {
  return {toC(p.handle), toC(cell), p.block, static_cast<std::uint32_t>(p.vertices.size())};
}

}  // namespace lgs::c

namespace {

/// A segment as C sees it, in lattice units or in cells.
template <class Out, class In>
Out converted(const In& s) {
  return {toC(s.id),   toC(s.predecessor), toC(s.successor), s.block,       toC(s.polygon),
          toC(s.cell), toC(s.start),       toC(s.end),       toC(s.ghost1), toC(s.ghost2)};
}

/// Reads a few segments, then the next few, in a small array on the stack: so nothing is allocated, and several threads
/// can read. `read` fills it.
template <class In, class Out, class Read>
lgs_status readSegments(const lgs_world* world, const lgs_segment_id* ids, std::size_t count, Out* out,
                        lgs_error* error, Read&& read) {
  if (!world || !isArray(ids, count) || !isArray(out, count)) return refuse(LGS_BAD_ARGUMENT, error);
  if (count > lgs::kMaxEntries) return refuse(LGS_CAPACITY, error);
  constexpr std::size_t kAtOnce = 8;
  std::array<SegmentId, kAtOnce> some;
  std::array<In, kAtOnce> segments;
  if (const auto origin = read(std::span(some).first(0), std::span(segments)); !origin)
    return refuse(origin.error(), error);
  for (std::size_t from = 0; from < count; from += kAtOnce) {
    const std::size_t size = std::min(kAtOnce, count - from);
    for (std::size_t k = 0; k < size; ++k) some[k] = fromC(ids[from + k]);
    const auto done = read(std::span(some).first(size), std::span(segments));
    const std::size_t fine = done ? size : static_cast<std::size_t>(done.error().index);
    for (std::size_t k = 0; k < fine; ++k) out[from + k] = converted<Out>(segments[k]);
    if (done) continue;
    lgs::Error moved = done.error();
    moved.index += static_cast<std::int32_t>(from);
    return refuse(moved, error);
  }
  return LGS_OK;
}

template <class In, class Out>
lgs_status readReals(const lgs_world* world, const lgs_segment_id* ids, std::size_t count, lgs_point origin, Out* out,
                     lgs_error* error) {
  return readSegments<In>(world, ids, count, out, error, [&](auto some, std::span<In> segments) {
    return world->world.segments(some, fromC(origin), segments);
  });
}

}  // namespace

lgs_status lgs_segments(const lgs_world* world, const lgs_segment_id* ids, size_t count, lgs_segment* segments,
                        lgs_error* error) noexcept {
  return readSegments<lgs::Segment>(world, ids, count, segments, error, [&](auto some, std::span<lgs::Segment> out) {
    return world->world.segments(some, out);
  });
}
lgs_status lgs_segments_float(const lgs_world* world, const lgs_segment_id* ids, size_t count, lgs_point origin,
                              lgs_segment_float* segments, lgs_error* error) noexcept {
  return readReals<lgs::FloatSegment>(world, ids, count, origin, segments, error);
}
lgs_status lgs_segments_double(const lgs_world* world, const lgs_segment_id* ids, size_t count, lgs_point origin,
                               lgs_segment_double* segments, lgs_error* error) noexcept {
  return readReals<lgs::DoubleSegment>(world, ids, count, origin, segments, error);
}

lgs_status lgs_all_segments(const lgs_world* world, lgs_segment_id* ids, size_t capacity, size_t* count) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  return putList(world->world.segments(), ids, capacity, count);
}

lgs_status lgs_segments_in(const lgs_world* world, lgs_cell_rect cells, lgs_segment_id* ids, size_t capacity,
                           size_t* count) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  return putList(world->world.segments(fromC(cells)), ids, capacity, count);
}

// --- Polygons --------------------------------------------------------------------------------------------------------

lgs_status lgs_polygon_of(const lgs_world* world, lgs_polygon_id id, lgs_polygon* polygon, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  const auto found = world->world.polygon(fromC(id));
  if (!found) return refuse(found.error(), error);
  put(polygon, described(*world->world.cellOf(found->handle), *found));
  return LGS_OK;
}

lgs_status lgs_polygon_vertices(const lgs_world* world, lgs_polygon_id id, lgs_local_point* vertices, size_t capacity,
                                size_t* count, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  const auto found = world->world.polygon(fromC(id));
  if (!found) return refuse(found.error(), error);
  const lgs_status status = putList(found->vertices, vertices, capacity, count);
  return status == LGS_OK ? LGS_OK : refuse(status, error);
}

lgs_status lgs_owner(const lgs_world* world, lgs_segment_id segment, lgs_polygon* owner, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  const auto found = world->world.segment(fromC(segment));
  if (!found) return refuse(found.error(), error);
  PlacedPolygon polygon{found->polygon, found->block, {}};
  if (const auto placed = world->world.polygon(found->polygon)) polygon.vertices = placed->vertices;
  put(owner, described(found->cell, polygon));
  return LGS_OK;
}

lgs_status lgs_polygons_in(const lgs_world* world, lgs_cell cell, lgs_polygon* polygons, size_t capacity,
                           size_t* count) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  return putList(world->world.polygons(fromC(cell)), polygons, capacity, count,
                 [&](const PlacedPolygon& polygon) { return described(fromC(cell), polygon); });
}

lgs_status lgs_is_empty(const lgs_world* world, lgs_cell cell, int32_t* is_empty) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  put(is_empty, std::int32_t{world->world.isEmpty(fromC(cell))});
  return LGS_OK;
}

lgs_status lgs_visit_polygons(const lgs_world* world, lgs_cell_rect cells, lgs_polygon_fn visit, void* user) noexcept {
  if (!world || !visit) return LGS_BAD_ARGUMENT;
  std::vector<lgs_local_point> vertices;
  world->world.forEachPolygon(fromC(cells), [&](lgs::Cell cell, const PlacedPolygon& p) {
    copyBytes(p.vertices.data(), p.vertices.size(), vertices);
    const lgs_polygon polygon = described(cell, p);
    visit(user, &polygon, vertices.data());
  });
  return LGS_OK;
}

lgs_status lgs_follow_cells(lgs_world* world, int32_t follow, lgs_error* error) noexcept {
  if (!world || (follow != 0 && follow != 1)) return refuse(LGS_BAD_ARGUMENT, error);
  const auto done = world->world.followCells(follow != 0);
  return done ? LGS_OK : refuse(done.error(), error);
}

lgs_status lgs_visit_cell_changes(const lgs_world* world, lgs_cell_change_fn visit, void* user) noexcept {
  if (!world || !visit) return LGS_BAD_ARGUMENT;
  std::vector<lgs_polygon> polygons;
  std::vector<lgs_local_point> vertices;
  for (const lgs::CellChange& change : world->world.cellChanges()) {
    polygons.clear();
    vertices.clear();
    for (const auto& side : {change.before, change.now}) {
      for (const PlacedPolygon& p : side) {
        polygons.push_back(described(change.cell, p));
        for (const lgs::LocalPoint v : p.vertices) vertices.push_back(toC(v));
      }
    }
    const lgs_cell_change told{toC(change.cell),     polygons.data(),   polygons.data() + change.before.size(),
                               change.before.size(), change.now.size(), vertices.data()};
    visit(user, &told);
  }
  return LGS_OK;
}

lgs_status lgs_bounds(const lgs_world* world, lgs_cell_rect* cells) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const CellRect bounds = world->world.bounds().value_or(CellRect{{0, 0}, {-1, -1}});
  put(cells, lgs_cell_rect{toC(bounds.min), toC(bounds.max)});
  return LGS_OK;
}
