// What a stroke finds in a cell, before anything is rounded.
#pragma once

#include "atoms.h"
#include "cell_edit.h"

#include <cstddef>
#include <cstdint>

namespace lgs::brush {

/// An edge of an outline between neighbouring known points, from its lower end.
struct Side {
  Point low, high;
  std::size_t area;
  bool isLeft;  ///< the area is on the left
  friend bool operator<(const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; }
};

/// Polygons that the region meets are one group if they have the same block and share edges. A group is taken as one
/// area: edges inside it count for nothing, nor do vertices that are no corners of its outline. So it does not matter
/// how an area was divided.
inline constexpr std::size_t kNoGroup = SIZE_MAX;

/// A ring of an area's outline, with the area on its left. An area is a group, by its least polygon, or a polygon that
/// is to stay.
struct Outline {
  std::size_t area;
  Points ring;
};

struct Ground {
  const List<CellPolygon>& polygons;
  List<std::size_t> groups;  ///< by polygon: the least polygon of its group, or kNoGroup if it is to stay
  List<Outline> outlines;    ///< sorted by area
  Points known;              ///< the hot points that do not depend on how outlines and region lie to each other
  List<Side> sides;          ///< sorted
};

void addVertices(const List<Outline>& outlines, Points& points);

/// What there is without the region: neither known points nor sides.
Ground groundOf(const List<CellPolygon>& polygons, const List<bool>& meeting);

/// Adds known points and sides. False if the region crosses itself in too many points.
[[nodiscard]] bool addKnown(Ground& ground, PieceSpan region);

/// Those of some polygons that have a part in a ring, by index.
List<std::size_t> partsIn(const Points& ring, const List<std::size_t>& some, const Ground& ground);

/// The outline of a group before the stroke, with the group on its left. Cost: O(n).
List<HalfEdge> oldOutline(const Ground& ground, std::size_t group);

}  // namespace lgs::brush
