// Where a segment is nearest to a point, and where a ray meets it: exact fractions of integers.
#pragma once

#include "geometry/wide.h"

#include <lgs/lattice.h>
#include <compare>
#include <cstdint>

namespace lgs::detail {

/// A segment of the outline: solid on the left. Longer than nothing, and at most a cell on each axis.
struct SegmentEnds {
  Point start;
  Point end;
};

/// A square of a distance, as a fraction.
struct SquaredDistance {
  Wide numerator;
  std::uint64_t denominator = 1;

  /// Needs numerators below 2^94 and denominators below 2^34.
  friend constexpr std::strong_ordering operator<=>(const SquaredDistance& a, const SquaredDistance& b) {
    return multiply(a.numerator, b.denominator) <=> multiply(b.numerator, a.denominator);
  }
  friend constexpr bool operator==(const SquaredDistance& a, const SquaredDistance& b) { return (a <=> b) == 0; }

  double value() const {
    return (static_cast<double>(numerator.high) * 0x1p64 + static_cast<double>(numerator.low)) /
           static_cast<double>(denominator);
  }
};

/// How far along a ray or a segment something lies: numerator / denominator, both below 2^62, denominator positive.
struct Fraction {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  friend constexpr std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
    return multiply(static_cast<std::uint64_t>(a.numerator), static_cast<std::uint64_t>(b.denominator)) <=>
           multiply(static_cast<std::uint64_t>(b.numerator), static_cast<std::uint64_t>(a.denominator));
  }
  friend constexpr bool operator==(const Fraction& a, const Fraction& b) { return (a <=> b) == 0; }
};

struct NearestOnEdge {
  SquaredDistance squared;
  Fraction along;
};

/// The nearest point of an edge to p, at most 2^29 away on each axis.
constexpr NearestOnEdge nearestOnEdge(const SegmentEnds& edge, Point p) {
  const std::int64_t dx = edge.end.x - edge.start.x, dy = edge.end.y - edge.start.y;
  const std::int64_t px = p.x - edge.start.x, py = p.y - edge.start.y;
  const std::int64_t length2 = dx * dx + dy * dy, along = px * dx + py * dy;
  const auto square = [](std::int64_t x, std::int64_t y) {
    return Wide{0, static_cast<std::uint64_t>(x * x) + static_cast<std::uint64_t>(y * y)};
  };
  if (along <= 0) return {{square(px, py), 1}, {0, 1}};
  if (along >= length2) return {{square(p.x - edge.end.x, p.y - edge.end.y), 1}, {1, 1}};
  const std::int64_t cross = dx * py - dy * px;
  const auto magnitude = static_cast<std::uint64_t>(cross < 0 ? -cross : cross);
  return {{multiply(magnitude, magnitude), static_cast<std::uint64_t>(length2)}, {along, length2}};
}

struct Ray {
  Point from;
  Point to;
};

/// Whether a ray meets the front of an edge (its right side), ends included; `at` receives where. A ray along the edge,
/// or from behind, does not meet it.
constexpr bool meets(const Ray& ray, const SegmentEnds& edge, Fraction& at) {
  const std::int64_t rx = ray.to.x - ray.from.x, ry = ray.to.y - ray.from.y;
  const std::int64_t ex = edge.end.x - edge.start.x, ey = edge.end.y - edge.start.y;
  // The outward normal is (ey, -ex): the ray runs against it where this is positive.
  const std::int64_t against = ry * ex - rx * ey;
  if (against <= 0) return false;
  const std::int64_t sx = edge.start.x - ray.from.x, sy = edge.start.y - ray.from.y;
  const std::int64_t alongRay = sy * ex - sx * ey, alongEdge = sy * rx - sx * ry;
  if (alongRay < 0 || alongRay > against || alongEdge < 0 || alongEdge > against) return false;
  at = {alongRay, against};
  return true;
}

}  // namespace lgs::detail
