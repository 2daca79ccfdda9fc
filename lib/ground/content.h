// What can be known of a cell from its own polygons. It is worked out once for all cells that hold the same: the edges
// are cut, cancelled and linked inside the cell, and prepared for its four sides (phase 1) and the vertices on them
// (phase 2).
#pragma once

#include "geometry/edge.h"
#include "geometry/predicates.h"
#include "geometry/radial_match.h"
#include "ground/polygon.h"
#include "storage/vectors.h"

#include <lgs/lattice.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

using PolygonId = std::uint32_t;
/// Index of a polygon in its cell's content.
using Slot = std::uint16_t;

/// An exposed atomic edge that lies along no side.
struct InteriorEdge {
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
/// corner q: the place in a list of edges, counted from 1; or 0 if there is none, or if it is beyond kMaxPlace.
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
  std::span<const Interval> covered;  ///< in increasing order, disjoint
  std::span<const RimPoint> points;   ///< in increasing order
};

/// What a commit asks first of a content, and of those beside it. Each cell keeps this byte. Zero if the cell is empty.
using Facts = std::uint8_t;
inline constexpr Facts kWholeSides = 0x0f;    ///< bit s: side s is whole, one edge runs from corner to corner
inline constexpr Facts kRimPoints = 0x10;     ///< there are rim points
inline constexpr Facts kInside = 0x20;        ///< there are interior edges
inline constexpr Facts kLinkedInside = 0x40;  ///< some interior edges are linked to each other
inline constexpr Facts kAllFacts = kWholeSides | kRimPoints | kInside | kLinkedInside;

/// The sides of a cell that are hidden by whole sides of the cells across them, by the facts of those: bit s for side
/// s.
constexpr unsigned hiddenSides(unsigned south, unsigned east, unsigned north, unsigned west) {
  return (south >> 2 & 1u) | (east >> 2 & 2u) | (north << 2 & 4u) | (west << 2 & 8u);
}

/// Never changed once it is made, so that copies of a world share it.
struct Content {
  Facts facts = 0;
  CornerEnds cornerEnds;        ///< of the half-edges inside, by their places in `interior`
  std::uint32_t widestFan = 0;  ///< the longest of the ranges
  std::array<SpokeRange, 4> corners{};
  std::array<Side, 4> sides;
  std::span<const InteriorEdge> interior;  ///< sorted by start, then end
  std::span<const Spoke> spokes;           ///< `segment` is an index in `interior`, `direction` a rank at that vertex
  std::span<const std::pair<Slot, Slot>> contacts;  ///< polygons with a common edge inside, smaller slot first

  // What it was worked out from.
  std::span<const PolygonId> polygons;               ///< by slot, in increasing order
  std::span<const std::pair<Slot, Slot>> preserved;  ///< the overlaps that are kept
  std::uint64_t hash = 0;                            ///< of these two

  std::unique_ptr<std::byte[]> lists;  ///< all of the above, one behind the other
  std::size_t listBytes = 0;

  /// The polygon that covers a whole side.
  Slot wholeSlot(unsigned side) const { return sides[side].covered.front().slot; }
};

/// Works out contents. It keeps its working memory from one to the next.
class ContentBuilder {
 public:
  /// The content of a cell with these polygons, which have no defects and disjoint interiors; `views` are their
  /// vertices. `preserved` lists pairs of slots, sorted, the smaller slot first: overlaps between them inside the cell
  /// are kept. Cost: O(n log n) in the vertices. With several polygons each edge is also compared with the vertices
  /// between its ends by x, then y.
  Content build(std::span<const PolygonId> polygons, std::span<const PolygonView> views,
                std::span<const std::pair<Slot, Slot>> preserved);

  std::uint64_t bytes() const {
    std::uint64_t sum = heldBytes(order_, points_, sidesAt_, ranks_, edges_, edgesAt_, ends_, endsAt_, sorted_, fan_,
                                  interior_, spokes_, keys_, contacts_);
    for (unsigned s = 0; s < kSides; ++s) sum += heldBytes(covered_[s], rimPoints_[s]);
    return sum;
  }

 private:
  /// Index of a vertex among all those of the cell in order.
  using Rank = std::uint32_t;
  /// A directed edge at one of its ends, without a vertex in between.
  struct HalfEdge {
    Rank at, to;
    std::uint32_t what;  ///< the slot of its polygon, or the interior edge and whether it leaves
  };
  /// By vertex, where its half-edges begin; and where the last ones end.
  using Begins = std::vector<std::uint32_t>;

  void takeVertices(std::span<const PolygonView> polygons);
  void takeEdges(std::span<const PolygonView> polygons);
  void cutEdges(std::span<const PolygonView> polygons);
  void sortByEnd(std::vector<HalfEdge>& edges, Rank HalfEdge::*end, Begins& begins);
  void placeInside(std::span<const std::pair<Slot, Slot>> preserved);
  std::span<HalfEdge> endsAt(Rank vertex);
  std::span<const Spoke> fanAt(Rank vertex, Vector from);
  void linkInside();
  void linkAtCorner(Content& content, unsigned corner, std::span<const Spoke> fan);
  SpokeRange storeFan(Content& content, std::span<const Spoke> fan);
  void takeSides(Content& content, bool linksCorners);

  // The vertices, and the edges between them.
  std::vector<PlacedVertex> order_;    ///< the polygons' vertices in order
  std::vector<LocalPoint> points_;     ///< the same, each once
  std::vector<std::uint8_t> sidesAt_;  ///< by point: bit s, if it is on side s
  std::vector<Rank> ranks_;            ///< of the polygons' vertices, one polygon after the other
  std::vector<HalfEdge> edges_;
  Begins edgesAt_;
  std::vector<HalfEdge> ends_;  ///< of the interior edges
  Begins endsAt_;
  std::vector<HalfEdge> sorted_;
  std::vector<Spoke> fan_;
  // The lists of the content.
  std::vector<InteriorEdge> interior_;
  std::vector<Spoke> spokes_;
  std::array<std::vector<Interval>, kSides> covered_;
  std::array<std::vector<RimPoint>, kSides> rimPoints_;
  std::vector<std::uint64_t> keys_;  ///< of contacts
  std::vector<std::pair<Slot, Slot>> contacts_;
};

}  // namespace lgs::detail
