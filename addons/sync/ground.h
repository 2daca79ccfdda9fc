// What stands in some cells, as a value that one end of a line sends to the other: polygons and blocks, no handles.
#pragma once

#include "bytes.h"

#include <lgs/world.h>

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

namespace in_step {

/// Its vertices begin with the least one.
struct Polygon {
  std::vector<lgs::LocalPoint> vertices;
  lgs::Block block = 0;
  friend auto operator<=>(const Polygon&, const Polygon&) = default;
};

/// What a cell holds, sorted.
using Content = std::vector<Polygon>;

/// Cells and what they hold. An empty content says that the cell holds nothing; of other cells nothing is said.
using Ground = std::map<lgs::Cell, Content>;

/// What a cell holds.
Content contentOf(const std::vector<lgs::PlacedPolygon>& polygons);

/// What there is in a rectangle: the cells that hold something.
Ground groundIn(const lgs::World& world, const lgs::CellRect& cells);

/// Each content is written once, and runs of cells in a row with the same one are written as one.
void put(Bytes& out, const Ground& ground);

/// Fails the reader, if these are not the bytes of some ground, of at most this many cells and vertices: a few bytes
/// can stand for many.
Ground readGround(Reader& in);
inline constexpr std::size_t kMaxCells = 1 << 12;
inline constexpr std::size_t kMaxVertices = kMaxCells * 1'024;

/// Makes the cells hold this, and empties all other cells of a rectangle that has them all, or is empty. All of it
/// happens, or nothing. What stands there already keeps its handle. The next commit reports it.
[[nodiscard]] bool setGround(lgs::World& world, const Ground& ground, const lgs::CellRect& cells);

}  // namespace in_step
