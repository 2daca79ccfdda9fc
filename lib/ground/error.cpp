#include <lgs/error.h>

#include <array>
#include <cstddef>
#include <string>

namespace lgs {
namespace {

// As world.h has them, by the number of bits.
#ifdef LGS_HANDLES_IN_53_BITS
constexpr const char *kSerialBits = "23", *kChunkBits = "20";
#else
constexpr const char *kSerialBits = "28", *kChunkBits = "22";
#endif

std::string number(std::int64_t v) { return std::to_string(v); }

std::string where(const Error& e) {
  std::string s;
  const auto add = [&s](const std::string& part) { s += (s.empty() ? "" : ", ") + part; };
  if (e.index >= 0) add("entry " + number(e.index));
  if (e.hasCell()) add("cell (" + number(e.cell.i) + ", " + number(e.cell.j) + ")");
  if (e.polygon >= 0) add("polygon " + number(e.polygon));
  return s.empty() ? s : s + ": ";
}

std::string what(const Error& e) {
  const std::string vertex = "vertex " + number(e.vertex);
  const std::string handle = number(e.other.cellRef) + ":" + number(e.other.serial);
  switch (e.code) {
    case ErrorCode::cellOutOfRange:
      return "the cell is out of range; both indices must be within ±2^30";
    case ErrorCode::emptyShape:
      return "a shape needs at least one polygon";
    case ErrorCode::tooFewVertices:
      return "a polygon needs at least 3 vertices";
    case ErrorCode::capacity:
      return std::string("too much: a cell holds at most 254 polygons with 4,096 vertices, and 2^") + kSerialBits +
             " - 1 polygons in its time; a world 2^" + kChunkBits +
             " - 1 chunks of 32x32 cells, and 2^23 - 1 distinct contents of cells; a call 2^31 - 1 entries; "
             "in one cell a brush 4,096 edges and 32,768 crossings";
    case ErrorCode::notFinite:
      return vertex + " is infinite or not a number";
    case ErrorCode::outsideCell:
      return vertex + " is outside the cell; coordinates run from 0 to 1 cell, rim included";
    case ErrorCode::repeatedVertex:
      return vertex + " and vertex " + number(e.vertex2) + " are the same lattice point; leave one out";
    case ErrorCode::zeroArea:
      return "the polygon has no area, or crosses itself so that its areas cancel";
    case ErrorCode::clockwise:
      return "the polygon runs clockwise; reverse its vertices";
    case ErrorCode::selfIntersecting:
      return "the polygon crosses itself, or touches itself: the edge from " + vertex + " meets the edge from vertex " +
             number(e.vertex2);
    case ErrorCode::overlap:
      if (e.polygon2 >= 0) return "its interior overlaps that of polygon " + number(e.polygon2);
      return "its interior overlaps that of a polygon of block " + number(e.otherBlock) +
             (e.index2 >= 0 ? " that entry " + number(e.index2) + " places in this cell"
                            : " that is already in this cell (handle " + handle + ")");
    case ErrorCode::unknownShape:
      return "this world has no such shape";
    case ErrorCode::staleHandle:
      if (!e.other) return "the handle is null, and names no polygon; was the edit refused that should have given it?";
      if (e.index2 >= 0) return "the handle " + handle + " comes twice: entry " + number(e.index2) + " has it, too";
      return "the handle " + handle + " names no polygon; it was removed, or never existed";
    case ErrorCode::unknownSegment:
      return "segment " + number(e.segment.value) + " is not alive; it was removed, or never existed";
    case ErrorCode::unknownMark:
      return "this world has no such mark; it was forgotten, or the world rolled back to a moment before it";
    case ErrorCode::uncommitted:
      return "the world has edits that are not committed; commit them first (to follow or to forget cells, let go of "
             "marks, too)";
    case ErrorCode::outOfReach:
      if (e.vertex >= 0) return vertex + " is beyond the last cell, or was no number";
      return "a point is beyond the last cell, or a radius is not from 0 to 4,096 cells, "
             "or a ray is longer than 16,384 cells on an axis, or a region of a brush is more than 4,096 cells wide or "
             "high, or was made with a length that is not from 1 lattice unit to 2,048 cells";
    case ErrorCode::unloaded:
      if (e.segment) return "segment " + number(e.segment.value) + " is of ground that is unloaded";
      if (e.other) return "the handle " + handle + " is of a chunk that is unloaded; reload it first";
      return "the chunk with this cell is unloaded; reload it first";
    case ErrorCode::anchored:
      return "this island is anchored: only what nothing holds can fall";
  }
  return "unknown error";
}

}  // namespace

const char* name(ErrorCode code) {
  static constexpr std::array kNames{"unknown error", "cell out of range", "empty shape",      "too few vertices",
                                     "capacity",      "not finite",        "outside the cell", "repeated vertex",
                                     "zero area",     "self-intersecting", "clockwise",        "overlap",
                                     "unknown shape", "stale handle",      "unknown segment",  "unknown mark",
                                     "uncommitted",   "out of reach",      "unloaded",         "anchored"};
  static_assert(kNames.size() == static_cast<std::size_t>(ErrorCode::anchored) + 1);
  const auto number = static_cast<std::size_t>(code);
  return kNames[number < kNames.size() ? number : 0];
}

std::string message(const Error& error) { return where(error) + what(error); }

}  // namespace lgs
