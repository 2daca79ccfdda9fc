// Differences of points, and the two products that decide everything. The products are exact for components up to 2^30,
// which is 16,384 cells.
#pragma once

#include <lgs/lattice.h>

#include <cstdint>
#include <numeric>

namespace lgs::oracle {

struct Vector {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend constexpr bool operator==(Vector, Vector) = default;
};

constexpr Vector operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }

/// Positive: b is to the left of a, negative: to the right, zero: along a or against it.
constexpr std::int64_t cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }

constexpr std::int64_t dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

/// Whether c lies on the closed segment from a to b, a ≠ b.
constexpr bool isOnSegment(Point c, Point a, Point b) {
  if (cross(b - a, c - a) != 0) return false;
  const std::int64_t along = dot(c - a, b - a);
  return along >= 0 && along <= dot(b - a, b - a);
}

/// The shortest integer vector of the same direction: equal for vectors of one direction, however long they are.
constexpr Vector direction(Vector v) {
  const std::int64_t divisor = std::gcd(v.x, v.y);
  return divisor == 0 ? v : Vector{v.x / divisor, v.y / divisor};
}

/// The column or row of cells that a world coordinate lies in. On a line between two it is the upper one.
constexpr std::int64_t cellIndex(std::int64_t coordinate) {
  return (coordinate >= 0 ? coordinate : coordinate - (kUnitsPerCell - 1)) / kUnitsPerCell;
}

}  // namespace lgs::oracle
