// What a stroke finds in a cell, before anything is rounded.
#pragma once

#include "atoms.h"
#include "cell_edit.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lgs::brush {

/// An edge of a polygon between neighbouring known points, from its lower end.
struct Side {
  Point low, high;
  std::size_t polygon;
  bool isLeft;  ///< the polygon is on the left
  friend bool operator<(const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; }
};

/// Polygons that the region meets are one group if they have the same block and share edges. A group is taken as one
/// area: edges inside it are not rounded.
inline constexpr std::size_t kNoGroup = SIZE_MAX;

struct Ground {
  const std::vector<CellPolygon>& polygons;
  std::vector<Point> known;         ///< the hot points that do not depend on how polygons and region lie to each other
  std::vector<Side> sides;          ///< sorted
  std::vector<std::size_t> groups;  ///< by polygon: the least polygon of its group, or kNoGroup if it is to stay
};

Ground groundOf(const std::vector<CellPolygon>& polygons, const std::vector<bool>& meeting, const Pieces& region);

/// The outline of a group before the stroke, with the group on its left. Cost: O(n).
std::vector<Edge> oldOutline(const Ground& ground, std::size_t group);

}  // namespace lgs::brush
