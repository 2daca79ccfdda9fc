#include "scene.h"

#include <algorithm>

namespace lgs::test {
namespace {

constexpr Cell kCorners[] = {{kMaxCell, kMaxCell}, {-kMaxCell, -kMaxCell}, {kMaxCell, -kMaxCell}};

SegmentFields fieldsOf(const lgs_segment& s) {
  SegmentFields fields{{s.id.value},
                       {s.start.x, s.start.y},
                       {s.end.x, s.end.y},
                       {s.predecessor.value},
                       {s.successor.value},
                       std::nullopt,
                       std::nullopt,
                       s.block,
                       {s.polygon.cell_ref, s.polygon.serial},
                       {s.cell.i, s.cell.j}};
  if (fields.predecessor) fields.ghost1 = {s.ghost1.x, s.ghost1.y};
  if (fields.successor) fields.ghost2 = {s.ghost2.x, s.ghost2.y};
  return fields;
}

}  // namespace

Scene::Scene() {
  const ShapeId square = shapeOf(world, {unitSquare()}), ramps = shapeOf(world, shapeNamed("two ramps"));
  shapes = {square, ramps, {0}, {3}, {0x8000'0000}, {0xffff'ffff}};
  static_cast<void>(world.fill({{-1, -1}, {1, 1}}, square, 1));
  static_cast<void>(world.replace({1, 1}, ramps, 0xffff'ffff));
  for (const Cell corner : kCorners) static_cast<void>(world.add(corner, square, 0));
  const PolygonHandle stale = place(world, {31, 31}, ramp(), 3);
  world.commit();
  const Mark early = world.mark(), forgotten = world.mark();
  static_cast<void>(world.forget(forgotten));
  static_cast<void>(world.remove(stale));
  static_cast<void>(world.clear(Cell{0, 1}));
  reported = world.commit();
  const SegmentId gone = reported.removed.at(0);
  const auto keep = [this](std::span<const std::byte> piece) { file.insert(file.end(), piece.begin(), piece.end()); };
  static_cast<void>(world.save(keep));
  static_cast<void>(world.add({0, 2}, ramps, 2));  // not committed

  const PolygonHandle elsewhere = place(other, {-40, 77}, unitSquare(), 9);
  other.commit();
  marks = {early, {}, forgotten, other.mark(), {early.value + 1}, {~std::uint64_t{0}}};
  polygons = {{}, {}, stale, elsewhere, {0xffff'ffff, 0xffff'ffff}, {0, 1}, {1, 1}, {1024, 0}, {1024, 0xffff'ffff}};
  segments = {{}, {0}, gone, {world.maxSegmentId() + 1}, {0x8000'0000}, {0xffff'ffff}};
  refresh();

  lgs_world* loaded = nullptr;
  static_cast<void>(
      lgs_load(reinterpret_cast<const std::uint8_t*>(file.data()), file.size(), nullptr, &loaded, nullptr));
  c.reset(loaded);
  lgs_mark mark{};
  static_cast<void>(lgs_set_mark(loaded, &mark));
  marksOfC = {{mark.value}, {0}, early, {~std::uint64_t{0}}};
}

void Scene::refresh() {
  polygons[0] = polygons[1] = {};
  world.forEachPolygon([this](Cell, const PlacedPolygon& p) {
    if (!polygons[0]) polygons[0] = p.handle;
    polygons[1] = p.handle;
  });
  const std::vector<SegmentId> alive = world.segments();
  segments[0] = alive.empty() ? SegmentId() : alive.back();
}

bool Scene::isAlive(PolygonHandle polygon) const {
  bool isThere = false;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) { isThere = isThere || p.handle == polygon; });
  return isThere;
}

bool Scene::isAlive(SegmentId segment) const { return std::ranges::binary_search(world.segments(), segment); }

Seen seenOf(const World& world) {
  Seen seen;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    seen.polygons.push_back({cell, {p.handle, p.block, {p.vertices.begin(), p.vertices.end()}}});
  });
  for (const SegmentId id : world.segments()) seen.segments.push_back(fieldsOf(*world.segment(id)));
  seen.maxSegmentId = world.maxSegmentId();
  seen.version = world.version();
  const Stats stats = world.stats();
  seen.shapes = stats.shapes;
  seen.chunks = stats.chunks;
  return seen;
}

Seen seenOf(const lgs_world* world) {
  Seen seen;
  const auto visit = [](void* user, const lgs_polygon* p, const lgs_local_point* vertices) {
    PolygonFields fields{{p->id.cell_ref, p->id.serial}, p->block, {}};
    for (std::uint32_t k = 0; k < p->vertices; ++k) fields.vertices.push_back({vertices[k].x, vertices[k].y});
    static_cast<Seen*>(user)->polygons.push_back({{p->cell.i, p->cell.j}, fields});
  };
  static_cast<void>(lgs_visit_polygons(world, {{INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX}}, visit, &seen));
  std::size_t count = 0;
  static_cast<void>(lgs_all_segments(world, nullptr, 0, &count));
  std::vector<lgs_segment_id> ids(count);
  static_cast<void>(lgs_all_segments(world, ids.data(), count, nullptr));
  std::vector<lgs_segment> segments(count);
  static_cast<void>(lgs_segments(world, ids.data(), count, segments.data(), nullptr));
  for (const lgs_segment& s : segments) seen.segments.push_back(fieldsOf(s));
  seen.maxSegmentId = lgs_max_segment_id(world);
  seen.version = lgs_world_version(world);
  lgs_stats stats{};
  static_cast<void>(lgs_count(world, &stats));
  seen.shapes = stats.shapes;
  seen.chunks = stats.chunks;
  return seen;
}

}  // namespace lgs::test
