// Bytes to edits, and back.
//
// An input is a header and records of 16 bytes each. What is short is filled up with zeros, so any bytes are some
// edits. A record makes one edit, or a few that belong together: a shape's polygons, a rectangle. It says where and
// what by itself. So a flipped byte changes that edit and leaves the others as they are. There are two exceptions:
//   - later removes in its cells may take other polygons;
//   - another action may take, or leave, the vertices kept for the next polygon.
//
//   header  byte  bits  meaning
//           0, 1        preserve pairs, a bit each
//           2     0, 1  3: the preserve pairs count
//           3           the window of cells
//           4           where in the world the window lies
//
//   record  byte  bits  meaning
//           0     0-3   the action
//           0     4, 5  0: no commit follows; otherwise one does
//           0     6, 7  the block, 1 to 4
//           1           the cell of the window
//           2           the shape; or how many vertices; or which polygon to remove
//           3     0-2   the symmetry
//           3     3, 4  the grid of the vertices
//           3     7     0: one block for a shape's polygons; 1: one block after the other
//           4-15        six vertices, x and y
//
// The actions that are called *full width* below read the bytes in another way. They hold cells and coordinates of any
// size. So a trace from elsewhere has an input too (encode) and can be a seed. It must have fewer than kMaxEdits edits.
// Its polygons must have at most kMaxVertices vertices, and lie near their cells.
//
// A polygon's name is the number of its record, and letters that follow from the number: p7haa, or p7.2haa for the
// second polygon of a record. The letters choose the door of the edit (oracle/trace/step.h).
#pragma once

#include "oracle/trace/trace.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline constexpr std::size_t kRecord = 16;        ///< bytes
inline constexpr std::size_t kMaxEdits = 2'048;   ///< adds and removes of one input; what comes after them is ignored
inline constexpr std::size_t kMaxVertices = 512;  ///< of one polygon; what comes after them is ignored

inline constexpr std::uint32_t kNoRecord = 0xffff'ffff;  ///< a name that nothing has

/// What a record does: its first byte modulo 16.
enum class Action : std::uint8_t {
  replace,   ///< clears the cell and places one of the degenerate shapes, turned
  replaceB,  ///< the same: what is done most has most numbers
  replaceC,
  place,   ///< one of the degenerate shapes beside what is there, or some of its polygons
  fill,    ///< one of the degenerate shapes in a rectangle of up to 20 cells
  spoilt,  ///< a polygon of a degenerate shape with something wrong
  hull,    ///< the convex hull of the vertices
  hullB,
  free,          ///< the vertices as they stand; mostly a bad polygon
  remove,        ///< one polygon of the cell
  removeRecord,  ///< full width: the polygon of a record before it, by number, in bytes 4 to 7; or kNoRecord
  clear,         ///< all polygons of the cell
  commit,
  vertices,  ///< full width: three vertices that go before those of the next polygon; 20 bits a coordinate
  raw,       ///< full width: a polygon of such vertices; cell and block in bytes 4 to 15
  preserve,  ///< full width: a pair of blocks in bytes 4 to 11
};

/// Total, and a function of the bytes alone. What it makes may have to be refused.
oracle::Trace decode(Bytes bytes);

/// Bytes that decode to this trace, but for the polygons' names; or why there are none.
tl::expected<std::vector<std::uint8_t>, std::string> encode(const oracle::Trace& trace);

}  // namespace lgs::fuzz
