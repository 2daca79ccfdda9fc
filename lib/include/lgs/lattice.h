// The lattice: every coordinate in LocalGridSeg is an integer.
//
// A cell is 65,536 lattice units wide and high. In its cell a vertex is a LocalPoint, 0 … 65,536 on both axes, the
// boundary included. In the world it is a Point. Its 64-bit coordinates are exact as `double` too. The engine makes all
// decisions on these integers, and there is no epsilon anywhere.
#pragma once

#include <compare>
#include <cstdint>

namespace lgs {

/// Lattice units along one side of a cell.
inline constexpr std::int32_t kUnitsPerCell = 65'536;
inline constexpr int kCellBits = 16;  ///< kUnitsPerCell is 2 to this power

/// Cells run from -kMaxCell to +kMaxCell, both included, on both axes.
inline constexpr std::int32_t kMaxCell = 1 << 30;

/// A position inside one closed cell, in lattice units from its lower-left corner (y up).
struct LocalPoint {
  std::int32_t x = 0;  ///< to the right, 0 … kUnitsPerCell
  std::int32_t y = 0;  ///< up, 0 … kUnitsPerCell
  friend constexpr auto operator<=>(const LocalPoint&, const LocalPoint&) = default;
};

/// A box in one closed cell.
struct LocalBox {
  LocalPoint min;  ///< its lower-left corner
  LocalPoint max;  ///< its upper-right corner, included
  friend constexpr bool operator==(const LocalBox&, const LocalBox&) = default;
};

/// A position in its cell, in cells: 1.0 is the far side. It is rounded to the nearest lattice point where it enters,
/// halves away from zero. -0.0 is 0.
template <class Real>
struct RealPoint {
  Real x = 0;  ///< to the right
  Real y = 0;  ///< up
};
using FloatPoint = RealPoint<float>;    ///< in cells, as `float`
using DoublePoint = RealPoint<double>;  ///< in cells, as `double`

/// A position in the world, in lattice units. At most 2^46 + 2^16 in magnitude.
struct Point {
  std::int64_t x = 0;  ///< to the right
  std::int64_t y = 0;  ///< up
  friend constexpr auto operator<=>(const Point&, const Point&) = default;
};

/// The unit cell [i, i+1] × [j, j+1].
struct Cell {
  std::int32_t i = 0;  ///< the column, counted to the right; -kMaxCell … kMaxCell
  std::int32_t j = 0;  ///< the row, counted upwards; -kMaxCell … kMaxCell
  friend constexpr auto operator<=>(const Cell&, const Cell&) = default;
};

/// All cells from `min` to `max`, both included. Empty if an index of `max` is below that of `min`.
struct CellRect {
  Cell min;  ///< the lower-left cell
  Cell max;  ///< the upper-right cell
  friend constexpr bool operator==(const CellRect&, const CellRect&) = default;
};

/// Whether a cell is one of a world: its indices are at most kMaxCell in magnitude.
constexpr bool inRange(Cell c) { return c.i >= -kMaxCell && c.i <= kMaxCell && c.j >= -kMaxCell && c.j <= kMaxCell; }

/// Whether a cell is one of a rectangle.
constexpr bool contains(const CellRect& r, Cell c) {
  return c.i >= r.min.i && c.i <= r.max.i && c.j >= r.min.j && c.j <= r.max.j;
}

/// Whether a rectangle has no cell.
constexpr bool isEmpty(const CellRect& r) { return r.max.i < r.min.i || r.max.j < r.min.j; }

/// Where a position in a cell is in the world, exactly. Nothing is checked.
constexpr Point toWorld(Cell c, LocalPoint p) {
  return {std::int64_t{c.i} * kUnitsPerCell + p.x, std::int64_t{c.j} * kUnitsPerCell + p.y};
}

/// Points beyond this on either axis lie in no cell.
inline constexpr std::int64_t kMaxCoordinate = (std::int64_t{kMaxCell} + 1) * kUnitsPerCell;

/// Whether neither coordinate of a point is beyond kMaxCoordinate.
constexpr bool inRange(Point p) {
  return p.x >= -kMaxCoordinate && p.x <= kMaxCoordinate && p.y >= -kMaxCoordinate && p.y <= kMaxCoordinate;
}

/// The cell in which a point lies. Cells are half-open here, [i, i+1) × [j, j+1): a point on a common side belongs to
/// the cell on its right, or above it. So a point on the upper or right side of the last cell is in none that is in
/// range.
constexpr Cell cellAt(Point p) {
  return {static_cast<std::int32_t>(p.x >> kCellBits), static_cast<std::int32_t>(p.y >> kCellBits)};
}

}  // namespace lgs
