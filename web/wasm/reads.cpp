// Polygons, loops, questions about places, and how much there is. Answers are numbers, one after the other.
#include "bridge.h"

namespace lgs::web {
namespace {

double real(std::uint64_t v) { return static_cast<double>(v); }

/// handle, i, j, block, number of vertices, then these in cells.
void putPolygon(Cell cell, const PlacedPolygon& polygon) {
  auto& out = answer();
  out.insert(out.end(), {toNumber(polygon.handle), static_cast<double>(cell.i), static_cast<double>(cell.j),
                         static_cast<double>(polygon.block), real(polygon.vertices.size())});
  for (const LocalPoint v : polygon.vertices) out.insert(out.end(), {cellsOf(v.x), cellsOf(v.y)});
}

/// How many numbers the answer has.
std::size_t answered() { return answer().size(); }

}  // namespace

LGS_EXPORT("polygons") std::size_t polygons(const Bridge* bridge) {
  answer().clear();
  bridge->world.forEachPolygon(putPolygon);
  return answered();
}

LGS_EXPORT("polygonsIn")
std::size_t polygonsIn(const Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  answer().clear();
  bridge->world.forEachPolygon(CellRect{{i0, j0}, {i1, j1}}, putPolygon);
  return answered();
}

LGS_EXPORT("polygon") std::size_t polygon(const Bridge* bridge, double handle) {
  const auto found = bridge->world.polygon(toHandle(handle));
  if (!found) return refused(found.error(), std::size_t{0});
  answer().clear();
  putPolygon(*bridge->world.cellOf(found->handle), *found);
  return answered();
}

/// start, end, ghost1, ghost2, predecessor, successor, block, polygon, i, j.
LGS_EXPORT("segment") std::int32_t segment(const Bridge* bridge, std::uint32_t id) {
  const auto found = bridge->world.segment(SegmentId{id});
  if (!found) return refused(found.error(), 0);
  auto& out = answer();
  out.clear();
  for (const Point p : {found->start, found->end, found->ghost1, found->ghost2})
    out.insert(out.end(), {cellsOf(p.x), cellsOf(p.y)});
  out.insert(out.end(), {static_cast<double>(found->predecessor.value), static_cast<double>(found->successor.value),
                         static_cast<double>(found->block), toNumber(found->polygon),
                         static_cast<double>(found->cell.i), static_cast<double>(found->cell.j)});
  return 1;
}

/// For each loop: the number of its vertices, that of its segments, the vertices in cells, the segments.
LGS_EXPORT("loops") std::size_t loops(const Bridge* bridge, std::int32_t merge) {
  auto& out = answer();
  out.clear();
  for (const Loop& loop : bridge->world.loops(merge != 0 ? Collinear::merge : Collinear::keep)) {
    out.insert(out.end(), {real(loop.vertices.size()), real(loop.segments.size())});
    for (const Point v : loop.vertices) out.insert(out.end(), {cellsOf(v.x), cellsOf(v.y)});
    for (const SegmentId id : loop.segments) out.push_back(static_cast<double>(id.value));
  }
  return answered();
}

/// where, polygon, block, i, j.
LGS_EXPORT("at") std::int32_t at(const Bridge* bridge, double x, double y) {
  const Point point = latticePoint({x, y});
  if (!inRange(point)) return refused({.code = ErrorCode::outOfReach}, 0);
  const Spot spot = bridge->world.at(point);
  answer() = {static_cast<double>(spot.where), toNumber(spot.polygon), static_cast<double>(spot.block),
              static_cast<double>(spot.cell.i), static_cast<double>(spot.cell.j)};
  return 1;
}

/// segment (0: none), x, y, distance.
LGS_EXPORT("nearest") std::int32_t nearest(const Bridge* bridge, double x, double y, double radius) {
  const auto found = bridge->world.nearest(latticePoint({x, y}), radius);
  if (!found) return refused(found.error(), 0);
  answer() = {static_cast<double>(found->segment.value), found->point.x, found->point.y, found->distance};
  return 1;
}

/// segment (0: none), fraction, x, y, normal.
LGS_EXPORT("rayCast") std::int32_t rayCast(const Bridge* bridge, double x0, double y0, double x1, double y1) {
  const auto hit = bridge->world.rayCast(latticePoint({x0, y0}), latticePoint({x1, y1}));
  if (!hit) return refused(hit.error(), 0);
  answer() = {
      static_cast<double>(hit->segment.value), hit->fraction, hit->point.x, hit->point.y, hit->normal.x, hit->normal.y};
  return 1;
}

/// i0, j0, i1, j1. Returns 0 for an empty world.
LGS_EXPORT("bounds") std::int32_t bounds(const Bridge* bridge) {
  const auto cells = bridge->world.bounds();
  if (!cells) return 0;
  answer() = {static_cast<double>(cells->min.i), static_cast<double>(cells->min.j), static_cast<double>(cells->max.i),
              static_cast<double>(cells->max.j)};
  return 1;
}

LGS_EXPORT("stats") void stats(const Bridge* bridge) {
  const Stats s = bridge->world.stats();
  answer() = {real(s.polygons), real(s.cells),  real(s.segments), real(s.shapes),
              real(s.contents), real(s.chunks), real(s.bytes)};
}

LGS_EXPORT("version") double version(const Bridge* bridge) { return real(bridge->world.version()); }
LGS_EXPORT("maxSegmentId") std::uint32_t maxSegmentId(const Bridge* bridge) { return bridge->world.maxSegmentId(); }

}  // namespace lgs::web
