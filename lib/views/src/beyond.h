// What lies beyond the edge of memory: chunks that are unloaded, and which ground reaches them.
#pragma once

#include "walk.h"

#include <lgs/unloaded.h>
#include <lgs/world.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lgs::detail {

inline constexpr std::int64_t kChunkSide = 32;  ///< cells along a chunk

/// The nearest index of a cell that is in range.
constexpr std::int32_t inWorld(std::int64_t index) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(index, -kMaxCell, kMaxCell));
}

/// The cells of the chunk that a cell is in, as far as they are in range.
CellRect chunkWith(Cell cell);

/// Whether a cell lies at the rim of its chunk.
constexpr bool isAtRimOfChunk(Cell cell) {
  const auto isFirstOrLast = [](std::int32_t index) { return (index & 31) == 0 || (index & 31) == 31; };
  return isFirstOrLast(cell.i) || isFirstOrLast(cell.j);
}

inline bool isUnloaded(const World& world, Cell cell) { return world.firstUnloaded({cell, cell}).has_value(); }

/// Whether a polygon of `world` touches ground in an unloaded chunk, as the segments of `outline` show it: an edge that
/// lies on the border of that chunk is not shown as a whole, or a segment of the polygon is linked with one there. Of
/// polygons that touch there in a point only at least one of those that hang together there says so.
bool reachesUnloaded(const World& outline, const Standing& standing);

/// The cells around one, as far as they are in range.
CellRect cellsAround(Cell cell);

}  // namespace lgs::detail
