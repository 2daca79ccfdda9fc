#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lgs::test {

LocalPolygon eighths(std::initializer_list<LocalPoint> vertices) {
  LocalPolygon polygon(vertices);
  for (LocalPoint& p : polygon) p = {p.x * (U / 8), p.y * (U / 8)};
  return polygon;
}

LocalPolygon unitSquare() { return {kUnitSquare.begin(), kUnitSquare.end()}; }
LocalPolygon ramp() { return {{0, 0}, {U, 0}, {U, U}}; }

std::vector<LocalPolygon> shapeNamed(std::string_view name) {
  for (const oracle::NamedShape& shape : oracle::degenerateShapes())
    if (shape.name == name) return shape.polygons;
  throw std::invalid_argument("no degenerate shape of this name: " + std::string(name));
}

PolygonHandle place(World& world, Cell cell, const LocalPolygon& polygon, Block block) {
  const auto handle = world.add(cell, std::span<const LocalPoint>(polygon), block);
  EXPECT_TRUE(handle) << message(handle.error());
  return handle.value_or(PolygonHandle{});
}

ShapeId shapeOf(World& world, const std::vector<LocalPolygon>& polygons) {
  const auto shape = world.shape(polygons);
  EXPECT_TRUE(shape) << message(shape.error());
  return shape.value_or(ShapeId{});
}

void fill(World& world, const CellRect& cells, const LocalPolygon& polygon) {
  EXPECT_TRUE(world.fill(cells, shapeOf(world, {polygon}), 1));
}

void removeAll(World& world, Cell cell) {
  for (const PlacedPolygon& p : world.polygons(cell)) EXPECT_TRUE(world.remove(p.handle));
}

std::vector<ShapeId> turnedShapes(World& world, oracle::Random& random) {
  std::vector<ShapeId> shapes;
  for (const oracle::NamedShape& shape : oracle::degenerateShapes()) {
    const int symmetry = random.below(8);
    std::vector<LocalPolygon> polygons;
    for (const LocalPolygon& p : shape.polygons) polygons.push_back(oracle::turned(p, symmetry));
    shapes.push_back(shapeOf(world, polygons));
  }
  return shapes;
}

SegmentFields fieldsOf(const Segment& s) {
  SegmentFields fields{s.id, s.start, s.end, s.predecessor, s.successor, {}, {}, s.block, s.polygon, s.cell};
  if (s.predecessor) fields.ghost1 = s.ghost1;
  if (s.successor) fields.ghost2 = s.ghost2;
  return fields;
}

PolygonFields fieldsOf(const PlacedPolygon& p) { return {p.handle, p.block, {p.vertices.begin(), p.vertices.end()}}; }

std::vector<PolygonFields> polygonsIn(const World& world, Cell cell) {
  std::vector<PolygonFields> out;
  for (const PlacedPolygon& p : world.polygons(cell)) out.push_back(fieldsOf(p));
  return out;
}

Snapshot snapshotOf(const World& world, std::span<const Cell> cells) {
  Snapshot snapshot;
  for (const SegmentId id : world.segments()) snapshot.segments.push_back(fieldsOf(*world.segment(id)));
  for (const Cell& cell : cells) snapshot.polygons[cell] = polygonsIn(world, cell);
  for (const Loop& loop : world.loops()) snapshot.loops.push_back(loop.vertices);
  snapshot.maxSegmentId = world.maxSegmentId();
  const Stats stats = world.stats();
  snapshot.polygonCount = stats.polygons;
  snapshot.cellCount = stats.cells;
  snapshot.segmentCount = stats.segments;
  snapshot.shapeCount = stats.shapes;
  snapshot.chunkCount = stats.chunks;
  return snapshot;
}

std::vector<std::byte> saved(const World& world) {
  std::vector<std::byte> bytes;
  EXPECT_TRUE(
      world.save([&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); }));
  return bytes;
}

bool isCommitted(const World& world) {
  return world.save([](auto) {}).has_value();
}

std::vector<Cell> cellsOf(const CellRect& rect) {
  std::vector<Cell> cells;
  for (std::int32_t j = rect.min.j; j <= rect.max.j; ++j)
    for (std::int32_t i = rect.min.i; i <= rect.max.i; ++i) cells.push_back({i, j});
  return cells;
}

}  // namespace lgs::test
