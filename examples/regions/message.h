// What ranks tell each other: lists of edits, and lists of names of segments, as 64-bit words. So any transport will do
// that keeps the order of what one rank sends to another one. A message is believed: all ranks run one program.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <vector>

namespace regions {

using Message = std::vector<std::int64_t>;

/// For each rank, what is to be sent to it.
using Outbox = std::vector<Message>;

/// An edit that any rank can play. Handles mean something to one world only, so a polygon is named by its cell and its
/// vertices: no two polygons of a cell have the same.
struct Edit {
  enum class Kind : std::uint8_t { add, remove, clear };
  Kind kind = Kind::clear;
  lgs::Cell cell;
  lgs::Block block = 0;                  ///< of add
  std::vector<lgs::LocalPoint> polygon;  ///< of add and remove
};

void append(Message& message, const Edit& edit);
std::vector<Edit> readEdits(const Message& message);

/// The ends of a segment name it in the whole world. What is solid on the left of an edge belongs to one polygon, since
/// interiors are disjoint: so no two segments have the same start and the same end.
struct Ends {
  lgs::Point start;
  lgs::Point end;
  friend bool operator==(const Ends&, const Ends&) = default;
};

/// The id that a segment has got in the world of its owner; null if it is gone.
struct Naming {
  Ends ends;
  lgs::SegmentId id;
};

void append(Message& message, const Naming& naming);
std::vector<Naming> readNamings(const Message& message);

}  // namespace regions
