// Exact predicates on lattice points: every answer is a sign of integers, so none is ever a little wrong.
//
// Private to lib/: the engine, the importer and the terrain share these headers, and none of them is installed. They
// need nothing but <lgs/lattice.h>.
//
// Units and range. A point is a LocalPoint or a Point, in lattice units or in halves of them. The points of one call
// lie at most 2^30 units apart on either axis. So each product of two differences is at most 2^60, a sum of two such
// products is at most 2^61, and all of it fits in 64 bits. The callers keep far below that: points of one cell are 2^16
// units apart, points of the importer 2^23 (its polygons reach at most 64 cells from the cell's corner), and doubling
// adds one bit.
#pragma once

#include <lgs/lattice.h>

#include <algorithm>
#include <concepts>
#include <cstdint>

namespace lgs::detail {

template <class P>
concept LatticePoint = std::same_as<P, LocalPoint> || std::same_as<P, Point>;

struct Vector {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend constexpr bool operator==(Vector, Vector) = default;
};

template <LatticePoint P>
constexpr Vector operator-(P a, P b) {
  return {std::int64_t{a.x} - b.x, std::int64_t{a.y} - b.y};
}

constexpr std::int64_t cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
constexpr std::int64_t dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

constexpr int sign(std::int64_t v) { return (v > 0) - (v < 0); }

/// +1: c is on the left of a→b, -1: on the right, 0: on the line.
template <LatticePoint P>
constexpr int orientation(P a, P b, P c) {
  return sign(cross(b - a, c - a));
}

/// Whether p lies on the open segment a–b.
template <LatticePoint P>
constexpr bool isOnOpenSegment(P p, P a, P b) {
  return orientation(a, b, p) == 0 && dot(a - p, b - p) < 0;
}

/// Whether p lies on the closed segment a–b, which may be a single point.
template <LatticePoint P>
constexpr bool isOnSegment(P p, P a, P b) {
  return orientation(a, b, p) == 0 && dot(a - p, b - p) <= 0;
}

/// Whether the segments cross in a single point that is an end of neither.
template <LatticePoint P>
constexpr bool crossProperly(P a, P b, P c, P d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// Whether the closed boxes of a–b and c–d have a point in common.
template <LatticePoint P>
constexpr bool boxesMeet(P a, P b, P c, P d) {
  return std::min(a.x, b.x) <= std::max(c.x, d.x) && std::min(c.x, d.x) <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= std::max(c.y, d.y) && std::min(c.y, d.y) <= std::max(a.y, b.y);
}

/// Whether the closed segments a–b and c–d have a point in common: neither lies on one side of the other's line. On one
/// line their boxes tell (Cormen, Leiserson, Rivest: Introduction to Algorithms, 1st ed., section 35.1).
template <LatticePoint P>
constexpr bool segmentsMeet(P a, P b, P c, P d) {
  return boxesMeet(a, b, c, d) && orientation(a, b, c) * orientation(a, b, d) <= 0 &&
         orientation(c, d, a) * orientation(c, d, b) <= 0;
}

/// Order of directions by their angle from the x axis in [0, 360°): by half-plane, then by turn.
constexpr bool angleLess(Vector a, Vector b) {
  const auto lower = [](Vector v) { return v.y < 0 || (v.y == 0 && v.x < 0); };
  if (lower(a) != lower(b)) return lower(b);
  return cross(a, b) > 0;
}

/// Whether two directions coincide exactly.
constexpr bool sameDirection(Vector a, Vector b) { return cross(a, b) == 0 && dot(a, b) > 0; }

}  // namespace lgs::detail
