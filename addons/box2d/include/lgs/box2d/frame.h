// From the lattice to metres. Each chunk is a body, placed where the chunk's lower left corner is. Its vertices are
// relative to that corner: the difference is taken on the lattice, where it is exact, and then rounded to `float`. So a
// vertex is as precise at the far end of the world as at the origin. The place of the corner is a `double` here. Where
// Box2D's positions are `float` it is rounded, and is less precise the further it is from the origin.
#pragma once

#include <lgs/lattice.h>
#include <lgs/questions.h>

#include <cassert>
#include <cmath>
#include <compare>
#include <cstdint>

namespace lgs::box2d {

/// A square of cells, named by its column and row among the squares.
struct Chunk {
  std::int32_t x = 0;  ///< the column, counted to the right
  std::int32_t y = 0;  ///< the row, counted upwards
  friend constexpr auto operator<=>(Chunk, Chunk) = default;
};

/// Relative to the body of a chunk.
struct Metres {
  float x = 0;  ///< to the right
  float y = 0;  ///< up
};

/// In the physics world, in metres.
struct Place {
  double x = 0;  ///< to the right
  double y = 0;  ///< up
};

/// Where the lattice is in the physics world, and how large.
struct Frame {
  double cellSize = 1;           ///< metres
  Cell origin;                   ///< its lower left corner is (0, 0) of the physics world
  std::int32_t chunkCells = 16;  ///< cells along the side of a chunk

  /// a / b, rounded down. `b` must be more than 0.
  static constexpr std::int32_t floorDiv(std::int32_t a, std::int32_t b) {
    assert(b > 0);
    return a / b - (a % b < 0 ? 1 : 0);
  }

  /// The chunk of a cell.
  constexpr Chunk chunkOf(Cell c) const { return {floorDiv(c.i, chunkCells), floorDiv(c.j, chunkCells)}; }
  /// The lower left corner of a chunk, in lattice units.
  constexpr Point cornerOf(Chunk c) const {
    const std::int64_t side = std::int64_t{chunkCells} * kUnitsPerCell;
    return {c.x * side, c.y * side};
  }

  /// Where a lattice point is in the physics world.
  Place position(Point p) const { return scaled(p, toWorld(origin, {})); }
  /// Where a position in cells is in the physics world.
  Place position(DoublePoint p) const { return {(p.x - origin.i) * cellSize, (p.y - origin.j) * cellSize}; }
  /// Where a lattice point is relative to the body of a chunk.
  Metres local(Point p, Chunk chunk) const {
    const Place m = scaled(p, cornerOf(chunk));
    return {static_cast<float>(m.x), static_cast<float>(m.y)};
  }
  /// The cell at a place in the physics world; not inRange() if that is beyond the last cell, or no number.
  Cell cellAt(Place p) const {
    const auto index = [&](double metres, std::int32_t from) {
      const double cells = std::floor(metres / cellSize) + from;
      return cells >= -kMaxCell && cells <= kMaxCell ? static_cast<std::int32_t>(cells) : kMaxCell + 1;
    };
    return {index(p.x, origin.i), index(p.y, origin.j)};
  }
  /// The lattice point nearest to a place in the physics world; not inRange() if that is beyond the last cell.
  Point latticePoint(Place p) const {
    return lgs::latticePoint({p.x / cellSize + origin.i, p.y / cellSize + origin.j});
  }
  /// A place of the physics world in lattice units, rounded as doubles are.
  DoublePoint units(Place p) const {
    return {(p.x / cellSize + origin.i) * kUnitsPerCell, (p.y / cellSize + origin.j) * kUnitsPerCell};
  }
  /// Where a point in lattice units is in the physics world, rounded as doubles are.
  Place placeOf(DoublePoint units) const {
    return position(DoublePoint{units.x / kUnitsPerCell, units.y / kUnitsPerCell});
  }
  /// A length in lattice units.
  double units(double metres) const { return metres / cellSize * kUnitsPerCell; }
  /// A length in metres.
  float metres(double units) const { return static_cast<float>(units * cellSize / kUnitsPerCell); }
  /// A length in lattice units, rounded up. It is a tenth longer than given, so that what is at least as long on
  /// the lattice is still long enough after rounding to `float`. At most 2^62, also for what is no number. Asserts that
  /// the cell size is finite and at least 2e-6.
  std::int64_t unitsOf(double metres) const {
    assert(cellSize >= 2e-6 && std::isfinite(cellSize));
    const double units = std::ceil(1.1 * metres / cellSize * kUnitsPerCell);
    return units >= 0 && units < 0x1p62 ? static_cast<std::int64_t>(units) : std::int64_t{1} << 62;
  }

 private:
  Place scaled(Point p, Point from) const {
    const double scale = cellSize / kUnitsPerCell;
    // Coordinates of points in range, and their differences, are exact as `double`; all others are numbers, too.
    return {(static_cast<double>(p.x) - static_cast<double>(from.x)) * scale,
            (static_cast<double>(p.y) - static_cast<double>(from.y)) * scale};
  }
};

}  // namespace lgs::box2d
