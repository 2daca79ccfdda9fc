// What can be known of a cell from its own polygons. It is worked out once for all cells that hold the same: the edges
// are cut, cancelled and linked inside the cell, and prepared for its four sides (phase 1) and the vertices on them
// (phase 2).
#pragma once

#include "polygon.h"
#include "radial_match.h"
#include "segment_pool.h"

#include <lgs/lattice.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

/// Index of a polygon in its cell's content.
using Slot = std::uint16_t;

/// The four sides, counter-clockwise. Edges along them run counter-clockwise too: to the right along the south side.
enum SideIndex : unsigned { kSouth, kEast, kNorth, kWest, kSides };

constexpr unsigned opposite(unsigned side) { return (side + 2) % kSides; }
constexpr unsigned sideBefore(unsigned side) { return (side + 3) % kSides; }
constexpr bool isVertical(unsigned side) { return side % 2 == 1; }

/// The corners, counter-clockwise. Side k starts at corner k.
constexpr std::array<LocalPoint, 4> kCorners{
    {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};

/// Where on a side a point is, by its x or its y; and the point there.
constexpr std::int32_t along(unsigned side, LocalPoint p) { return isVertical(side) ? p.y : p.x; }
constexpr LocalPoint pointAt(unsigned side, std::int32_t at) {
  switch (side) {
    case kSouth:
      return {at, 0};
    case kEast:
      return {kUnitsPerCell, at};
    case kNorth:
      return {at, kUnitsPerCell};
    default:
      return {0, at};
  }
}
/// Whether edges along this side run towards increasing x or y.
constexpr bool runsForward(unsigned side) { return side == kSouth || side == kEast; }

/// An exposed atomic edge that lies along no side.
struct InteriorSegment {
  static constexpr std::uint32_t kNone = 0xffff'ffff;  ///< no candidate
  static constexpr std::uint32_t kRim = 0xffff'fffe;   ///< that end is on the rim, and it is for a commit to link it
  PackedEnds ends;
  std::uint32_t predecessor = kRim;  ///< index in Content::interior
  std::uint32_t successor = kRim;
  Slot slot = 0;
};

/// The interior half-edges at a vertex on the rim, counter-clockwise. Most have one or none, so the first is stored
/// here.
struct SpokeRange {
  std::uint32_t count = 0;
  std::uint32_t rest = 0;  ///< where the others begin in Content::spokes
  Spoke first;             ///< can be read even if there is none
};

/// The half-edges with which a cell's fans at its four corners begin and end, counter-clockwise: the first one if it is
/// outgoing, the last one if it is incoming. No other cell has a say in what lies between. Bits 4q … 4q + 3 are for
/// corner q: the place in a list of segments, counted from 1; or 0 if there is none, or if it is beyond kMaxPlace.
struct CornerEnds {
  static constexpr std::uint32_t kMaxPlace = 15;
  std::uint16_t first = 0;
  std::uint16_t last = 0;
};

/// A stretch of a side that one polygon covers. No vertex of the cell lies inside it.
struct Interval {
  std::int32_t begin = 0;
  std::int32_t end = 0;
  Slot slot = 0;
};

/// A vertex on a side that is not a corner.
struct RimPoint {
  std::int32_t at = 0;
  SpokeRange spokes;
};

/// The profile of a side.
struct Side {
  std::vector<Interval> covered;  ///< in increasing order, disjoint
  std::vector<RimPoint> points;   ///< in increasing order
};

/// What a commit asks first of a content, and of those beside it. Each cell keeps this byte. Zero if the cell is empty.
using Facts = std::uint8_t;
inline constexpr Facts kWholeSides = 0x0f;    ///< bit s: side s is whole, one edge runs from corner to corner
inline constexpr Facts kRimPoints = 0x10;     ///< there are rim points
inline constexpr Facts kInside = 0x20;        ///< there are interior segments
inline constexpr Facts kLinkedInside = 0x40;  ///< some interior segments are linked to each other
inline constexpr Facts kAllFacts = kWholeSides | kRimPoints | kInside | kLinkedInside;

/// The sides of a cell that are hidden by whole sides of the cells across them, by the facts of those: bit s for side
/// s.
constexpr unsigned hiddenSides(unsigned south, unsigned east, unsigned north, unsigned west) {
  return (south >> 2 & 1u) | (east >> 2 & 2u) | (north << 2 & 4u) | (west << 2 & 8u);
}

struct Content {
  Facts facts = 0;
  std::array<SpokeRange, 4> corners{};
  CornerEnds cornerEnds;                  ///< of the half-edges inside, by their places in `interior`
  std::uint32_t widestFan = 0;            ///< the longest of the ranges
  std::vector<InteriorSegment> interior;  ///< sorted by start, then end
  std::vector<Spoke> spokes;              ///< `segment` is an index in `interior`, `direction` a rank at that vertex
  std::array<Side, 4> sides;
  std::vector<std::pair<Slot, Slot>> contacts;  ///< polygons with a common edge inside the cell, smaller slot first

  /// The polygon that covers a whole side.
  Slot wholeSlot(unsigned side) const { return sides[side].covered.front().slot; }
};

/// The edge along a whole side, as its cell has it.
constexpr std::array<PackedEnds, 4> kSideEnds{
    {PackedEnds::of(kCorners[0], kCorners[1]), PackedEnds::of(kCorners[1], kCorners[2]),
     PackedEnds::of(kCorners[2], kCorners[3]), PackedEnds::of(kCorners[3], kCorners[0])}};

/// Works out the content of a cell with these polygons, which have no defects and disjoint interiors. `preserved` lists
/// pairs of slots, sorted, the smaller slot first: overlaps between them inside the cell are kept. Cost: O(n log n)
/// in the vertices. With several polygons each edge is also compared with the vertices between its ends by x, then y.
Content buildContent(std::span<const PolygonView> polygons, std::span<const std::pair<Slot, Slot>> preserved);

}  // namespace lgs::detail
