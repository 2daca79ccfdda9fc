// What a cell contains, worked out once for all cells that contain the same: cut, cancelled and linked inside the cell,
// and prepared for its four sides (phase 1) and the vertices on its rim (phase 2).
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

/// The four sides, counter-clockwise; edges along them run in this direction too: south to the right, east up, …
enum SideIndex : unsigned { kSouth, kEast, kNorth, kWest, kSides };

constexpr unsigned opposite(unsigned side) { return (side + 2) % kSides; }
constexpr bool isVertical(unsigned side) { return side % 2 == 1; }

/// Corners, counter-clockwise; corner k is where side k starts.
constexpr std::array<LocalPoint, 4> kCorners{
    {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}}};

/// The position along a side (by increasing x or y) of a point on it, and back.
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

/// An exposed atomic edge that does not lie along the rim.
struct InteriorSegment {
  static constexpr std::uint32_t kNone = 0xffff'ffff;  ///< no candidate
  static constexpr std::uint32_t kRim = 0xffff'fffe;   ///< that end is on the rim: linked at run time
  PackedEnds ends;
  std::uint32_t predecessor = kRim;  ///< index in Content::interior
  std::uint32_t successor = kRim;
  Slot slot = 0;
};

/// Interior half-edges at one rim vertex, counter-clockwise: `first`, and the others from Content::spokes[rest] on.
struct SpokeRange {
  std::uint32_t count = 0;
  std::uint32_t rest = 0;
  Spoke first;  ///< can be read even where there is none
};

/// A part of a side covered by one polygon, between two neighbouring vertices.
struct Interval {
  std::int32_t begin = 0;
  std::int32_t end = 0;
  Slot slot = 0;
};

/// A vertex in the open side.
struct RimPoint {
  std::int32_t at = 0;
  SpokeRange spokes;
};

struct Side {
  std::vector<Interval> covered;  ///< in increasing order, disjoint
  std::vector<RimPoint> points;   ///< in increasing order
};

/// What neighbours and a commit ask of a content first, in one byte that each cell keeps. Bit s says that side s is
/// whole; the rest follows. Zero for an empty cell.
using Facts = std::uint8_t;
inline constexpr Facts kWholeSides = 0x0f;
inline constexpr Facts kRimPoints = 0x10;     ///< some vertex is in an open side
inline constexpr Facts kInside = 0x20;        ///< there are interior segments
inline constexpr Facts kLinkedInside = 0x40;  ///< some interior segment has an end inside the cell

/// The sides of a cell that whole sides of the cells across hide: bit s for side s.
constexpr unsigned hiddenSides(unsigned south, unsigned east, unsigned north, unsigned west) {
  return (south >> 2 & 1u) | (east >> 2 & 2u) | (north << 2 & 4u) | (west << 2 & 8u);
}

struct Content {
  Facts facts = 0;
  std::array<SpokeRange, 4> corners{};
  std::uint32_t widestFan = 0;            ///< the longest of the ranges
  std::vector<InteriorSegment> interior;  ///< sorted by start, then end
  std::vector<Spoke> spokes;              ///< `segment` is an index in `interior`, `direction` a rank at that vertex
  std::array<Side, 4> sides;
  std::vector<std::pair<Slot, Slot>> contacts;  ///< polygons that share an edge inside the cell, smaller slot first

  /// The polygon that covers a whole side.
  Slot wholeSlot(unsigned side) const { return sides[side].covered.front().slot; }
};

/// A whole side as an edge of the cell it belongs to.
constexpr std::array<PackedEnds, 4> kSideEnds{
    {PackedEnds::of(kCorners[0], kCorners[1]), PackedEnds::of(kCorners[1], kCorners[2]),
     PackedEnds::of(kCorners[2], kCorners[3]), PackedEnds::of(kCorners[3], kCorners[0])}};

/// Works out the content of a cell that holds these polygons (without defects, interiors disjoint). Overlaps inside the
/// cell between the pairs of slots in `preserved` (sorted, smaller first) are kept. Cost: O(n²) in the vertices.
Content buildContent(std::span<const PolygonView> polygons, std::span<const std::pair<Slot, Slot>> preserved);

}  // namespace lgs::detail
