// Polygons as rings in the world, and whether they have points in common. All of what is compared lies in cells beside
// each other.
#pragma once

#include "geometry/predicates.h"
#include "geometry/relation.h"

#include <lgs/world.h>

#include <cstddef>
#include <span>
#include <vector>

namespace lgs::detail {

using WorldRing = std::vector<Point>;

inline WorldRing ringOf(Cell cell, std::span<const LocalPoint> vertices) {
  WorldRing ring;
  for (const LocalPoint p : vertices) ring.push_back(toWorld(cell, p));
  return ring;
}

/// Calls visit(a, b) for each edge until it says true. Whether it did.
template <class Visit>
bool anyEdge(const WorldRing& ring, Visit&& visit) {
  for (std::size_t k = 0; k < ring.size(); ++k)
    if (visit(ring[k], ring[k + 1 == ring.size() ? 0 : k + 1])) return true;
  return false;
}

/// Whether a point lies inside or on a ring.
inline bool contains(const WorldRing& ring, Point p) {
  Sight sight;
  see(p, p, ring, sight);
  return !sight.outside;
}

/// Whether a segment and the closed inside of a ring have a point in common.
inline bool meets(const WorldRing& ring, Point start, Point end) {
  return contains(ring, start) || anyEdge(ring, [&](Point a, Point b) { return segmentsMeet(a, b, start, end); });
}

/// Whether two rings whose interiors are disjoint have a point in common.
inline bool touch(const WorldRing& one, const WorldRing& other) {
  return anyEdge(one, [&](Point a, Point b) {
    return anyEdge(other, [&](Point c, Point d) { return segmentsMeet(a, b, c, d); });
  });
}

/// Whether they have more in common than points: parts of two edges, which run against each other.
inline bool shareAnEdge(const WorldRing& one, const WorldRing& other) {
  return anyEdge(one, [&](Point a, Point b) {
    return anyEdge(other, [&](Point c, Point d) {
      if (orientation(a, b, c) != 0 || orientation(a, b, d) != 0) return false;
      const Vector along = b - a;
      return dot(along, b - d) > 0 && dot(along, c - a) > 0 && dot(along, d - c) < 0;
    });
  });
}

}  // namespace lgs::detail
