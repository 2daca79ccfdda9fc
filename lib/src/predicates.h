// Exact predicates on points of one closed cell. Coordinates are at most 65,536 in magnitude, so every product below
// fits in 64 bits with room to spare (doubled coordinates included).
#pragma once

#include <lgs/lattice.h>

#include <cstdint>

namespace lgs::detail {

struct Vector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

constexpr Vector operator-(LocalPoint a, LocalPoint b) { return {std::int64_t{a.x} - b.x, std::int64_t{a.y} - b.y}; }

constexpr std::int64_t cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
constexpr std::int64_t dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

constexpr int sign(std::int64_t v) { return (v > 0) - (v < 0); }

/// +1: c is on the left of a→b, -1: on the right, 0: on the line.
constexpr int orientation(LocalPoint a, LocalPoint b, LocalPoint c) { return sign(cross(b - a, c - a)); }

/// Whether p, known to be on the line through a and b, lies strictly between them.
constexpr bool isStrictlyBetween(LocalPoint p, LocalPoint a, LocalPoint b) { return dot(a - p, b - p) < 0; }

/// Whether p lies on the open segment a–b.
constexpr bool isInside(LocalPoint p, LocalPoint a, LocalPoint b) {
  return orientation(a, b, p) == 0 && isStrictlyBetween(p, a, b);
}

/// Whether the open segments cross in a single point that is an end of neither.
constexpr bool crossProperly(LocalPoint a, LocalPoint b, LocalPoint c, LocalPoint d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
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
