// Distances in doubles and the slow way.
#pragma once

#include "played.h"

#include <lgs/box2d/terrain.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lgs::box2d_test {

using box2d::Place;
using Convex = std::vector<Place>;  // counter-clockwise

/// A float of a range.
inline float between(Chance& random, float from, float to) {
  return from + (to - from) * static_cast<float>(random.below(100'001)) / 100'000;
}

/// Of whichever Box2D there is.
template <class Vector>
Place placeOf(const Vector& p) {
  return {p.x, p.y};
}

inline double distanceToEdge(Place p, Place a, Place b) {
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double square = ux * ux + uy * uy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / square, 0.0, 1.0) : 0;
  return std::hypot(a.x + t * ux - p.x, a.y + t * uy - p.y);
}

inline double distanceTo(const box2d::Terrain& terrain, const Segment& s, Place p) {
  return distanceToEdge(p, placeOf(terrain.position(s.start)), placeOf(terrain.position(s.end)));
}

/// Whether one has a side with the whole other one in front of it.
inline bool isInFrontOf(const Convex& other, const Convex& one) {
  for (std::size_t k = 0; k < one.size(); ++k) {
    const Place a = one[k], b = one[(k + 1) % one.size()];
    const auto isInFront = [&](Place p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0; };
    if (std::all_of(other.begin(), other.end(), isInFront)) return true;
  }
  return false;
}

/// 0 if they overlap.
inline double distanceBetween(const Convex& one, const Convex& other) {
  if (!isInFrontOf(one, other) && !isInFrontOf(other, one)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < one.size(); ++k)
    for (std::size_t n = 0; n < other.size(); ++n)
      least = std::min({least, distanceToEdge(one[k], other[n], other[(n + 1) % other.size()]),
                        distanceToEdge(other[n], one[k], one[(k + 1) % one.size()])});
  return least;
}

/// From the middle of a circle: 0 inside.
inline double distanceBetween(Place p, const Convex& polygon) {
  double least = std::numeric_limits<double>::infinity();
  bool isInside = true;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Place a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    least = std::min(least, distanceToEdge(p, a, b));
    isInside = isInside && (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) >= 0;
  }
  return isInside ? 0 : least;
}

/// A rectangle of cells, smaller by `skin` on each side.
inline Convex convexOf(const box2d::Terrain& terrain, const CellRect& cells, double skin = 0) {
  const Place min = placeOf(terrain.position(toWorld(cells.min, {})));
  const Place max = placeOf(terrain.position(toWorld(cells.max, {kUnitsPerCell, kUnitsPerCell})));
  return {{min.x + skin, min.y + skin},
          {max.x - skin, min.y + skin},
          {max.x - skin, max.y - skin},
          {min.x + skin, max.y - skin}};
}

}  // namespace lgs::box2d_test
