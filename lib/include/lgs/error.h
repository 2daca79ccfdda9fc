// The reasons for which an edit or a question is refused. A refused edit has changed nothing (law 7).
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <type_traits>

namespace lgs {

/// A polygon is checked in this order. The first reason that applies is reported.
enum class ErrorCode : std::uint32_t {
  cellOutOfRange = 1,  ///< a cell index beyond ±kMaxCell
  emptyShape,          ///< a shape without polygons
  tooFewVertices,      ///< fewer than 3 vertices
  capacity,            ///< more than the engine can hold; see limits.h
  notFinite,           ///< a coordinate is infinite or not a number
  outsideCell,         ///< a vertex, once rounded, is not in the closed cell
  repeatedVertex,      ///< two vertices are the same lattice point; vertex2 is the first that repeats an earlier one
  zeroArea,            ///< the signed area is 0
  selfIntersecting,    ///< two edges of one polygon cross, overlap, or touch: the first two
  clockwise,           ///< the signed area is negative
  overlap,             ///< the interior meets that of another polygon of the cell (or of the shape); the first polygon
                       ///< of the call that overlaps one before it is named, with the one that was placed first
  unknownShape,        ///< a ShapeId that this world did not make
  staleHandle,         ///< a PolygonHandle that is null, unknown, or whose polygon was removed
  unknownSegment,      ///< a SegmentId that names no live segment
  unknownMark,         ///< a Mark that this world did not make, or that was forgotten, or rolled back beyond
  uncommitted,         ///< edits are not committed, or there are marks where there may be none
  outOfReach,          ///< a point, a radius or a ray of a question goes beyond what questions.h allows
  unloaded,            ///< ground that is not in memory: see World::unload()
  anchored,            ///< an island that something holds can not fall
};

/// What was refused, and where. A field that does not apply is kNoCell, -1 or null.
struct Error {
  static constexpr Cell kNoCell{INT32_MIN, INT32_MIN};  ///< what `cell` is if no cell is meant
  ErrorCode code{};                                     ///< the reason
  Cell cell = kNoCell;                                  ///< the cell of the edit; kNoCell while a shape is made
  std::int32_t polygon = -1;                            ///< index in the polygons given to this call
  std::int32_t vertex = -1;                             ///< index in that polygon; for an edge, its first vertex
  std::int32_t vertex2 = -1;                            ///< the other vertex or edge involved
  std::int32_t polygon2 = -1;                           ///< overlap within one call: the index of the other polygon
  PolygonHandle other{};    ///< overlap with a placed polygon: that polygon, see index2; stale handle: the handle
  Block otherBlock = 0;     ///< overlap with a placed polygon: its block; it is in `cell`
  SegmentId segment{};      ///< unknown segment: that id
  std::int32_t index = -1;  ///< a call that takes many: index of the one that is refused, in what was given
  /// A call that takes many: index of the other one involved. It placed the other polygon, which is undone, so that
  /// `other` is null; or it has the same handle.
  std::int32_t index2 = -1;

  /// Whether `cell` is one.
  constexpr bool hasCell() const { return cell != kNoCell; }
};

// There is no padding. tl::expected has the error and the value in a union. If the error has padding where the value
// has data, GCC 12 gets the value wrong as it takes the union apart (-ftree-sra, on from -O1). A test of cellOf()
// showed it with a code of one byte.
static_assert(std::has_unique_object_representations_v<Error>);

/// A short name, e.g. "self-intersecting".
const char* name(ErrorCode code);

/// A whole sentence: the cell, the polygon, the vertex, what is wrong there, and what to do about it.
std::string message(const Error& error);

/// A value, or why there is none.
template <class T>
using Expected = tl::expected<T, Error>;

}  // namespace lgs
