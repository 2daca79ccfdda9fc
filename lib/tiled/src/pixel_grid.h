// From pixels to the lattice: coordinates snap to the grid or are rounded, then polygons are cut along the grid.
#pragma once

#include "loops.h"

namespace lgs::tiled {

/// The grid of the map.
struct PixelGrid {
  DoublePoint tile;       ///< pixels of one cell
  DoublePoint tolerance;  ///< pixels. A coordinate this near to a grid line snaps to it
};

/// A polygon on the lattice, and how it got there.
struct Snapped {
  Polygon ring;         ///< lattice units from the cell's lower left corner
  bool tooFar = false;  ///< a vertex is too far away; then the ring is empty
  int moved = 0;        ///< how many coordinates snapped to the grid
  double furthest = 0;  ///< pixels that one of them moved
  double nearMiss = 0;  ///< pixels by which a vertex on a grid line misses a corner; 0 if it is too far from one
};

/// Puts an outline on the lattice. It is in pixels from the cell's lower left corner, y up. `mostCells` is how far away
/// a vertex may be.
Snapped snap(const std::vector<DoublePoint>& outline, const PixelGrid& grid, double mostCells);

/// What lies of a polygon in one cell.
struct CellPart {
  Cell shift;    ///< from the polygon's home cell to this one
  Polygon ring;  ///< lattice units from the lower left corner of this cell
};

/// Cuts a simple counter-clockwise ring along the grid: the parts in each cell that it reaches, column by column.
/// Rounding can press a part together until it touches itself, so check isSimple().
std::vector<CellPart> cutAlongGrid(const Polygon& ring);

}  // namespace lgs::tiled
