// What tests of worlds share: shapes in eighths of a cell, shorter calls, and everything that can be seen of a world as
// one value that can be compared.
#pragma once

#include "oracle/calls/caller.h"
#include "oracle/calls/random.h"
#include "oracle/calls/shapes.h"
#include "oracle/reference/validity.h"

#include <lgs/world.h>

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lgs::test {

inline constexpr std::int32_t U = kUnitsPerCell;
using oracle::ChangeLists;
using oracle::copyOf;
using oracle::LocalPolygon;

/// Vertices given in eighths of a cell.
LocalPolygon eighths(std::initializer_list<LocalPoint> vertices);

LocalPolygon unitSquare();
LocalPolygon ramp();  ///< the lower right half of the cell

/// The polygons of one of the degenerate shapes, by its name.
std::vector<LocalPolygon> shapeNamed(std::string_view name);

/// Edits that must succeed.
PolygonHandle place(World& world, Cell cell, const LocalPolygon& polygon, Block block = 1);
ShapeId shapeOf(World& world, const std::vector<LocalPolygon>& polygons);
void fill(World& world, const CellRect& cells, const LocalPolygon& polygon = unitSquare());
void removeAll(World& world, Cell cell);

/// Every degenerate shape, each turned by chance.
std::vector<ShapeId> turnedShapes(World& world, oracle::Random& random);

/// What segment() says, as a value that compares: without ghosts where there are no links.
struct SegmentFields {
  SegmentId id;
  Point start, end;
  SegmentId predecessor, successor;
  std::optional<Point> ghost1, ghost2;
  Block block = 0;
  PolygonHandle polygon;
  Cell cell;
  friend bool operator==(const SegmentFields&, const SegmentFields&) = default;
};
SegmentFields fieldsOf(const Segment& segment);

/// What polygons() says, as values.
struct PolygonFields {
  PolygonHandle handle;
  Block block = 0;
  LocalPolygon vertices;
  friend bool operator==(const PolygonFields&, const PolygonFields&) = default;
};
PolygonFields fieldsOf(const PlacedPolygon& polygon);
std::vector<PolygonFields> polygonsIn(const World& world, Cell cell);

/// Everything that a user can see of a world, memory used and contents interned apart: those are caches.
struct Snapshot {
  std::vector<SegmentFields> segments;
  std::map<Cell, std::vector<PolygonFields>> polygons;
  std::vector<std::vector<Point>> loops;
  std::uint32_t maxSegmentId = 0;
  std::uint64_t polygonCount = 0, cellCount = 0, segmentCount = 0, shapeCount = 0, chunkCount = 0;
  friend bool operator==(const Snapshot&, const Snapshot&) = default;
};
Snapshot snapshotOf(const World& world, std::span<const Cell> cells);

/// The bytes of a world that has no pending edits; and whether it has none.
std::vector<std::byte> saved(const World& world);
bool isCommitted(const World& world);

/// All cells of a rectangle, by rows.
std::vector<Cell> cellsOf(const CellRect& rect);

}  // namespace lgs::test
