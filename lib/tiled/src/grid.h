// The step from pixels to the lattice: snapping to the grid, rounding, and cutting along the grid.
#pragma once

#include "polygon.h"

namespace lgs::tiled {

/// The grid as the importer sees it.
struct PixelGrid {
  DoublePoint tile;       ///< pixels of one cell
  DoublePoint tolerance;  ///< pixels, on each axis
};

/// A polygon put on the lattice, and what that took.
struct Snapped {
  Polygon ring;         ///< lattice units from the cell's lower left corner
  bool tooFar = false;  ///< a vertex is further than kMaxReach cells away: no ring
  int moved = 0;        ///< coordinates moved to the grid
  double furthest = 0;  ///< pixels
  double nearMiss =
      0;  ///< pixels by which a vertex on the grid misses a corner, if not by much more than the tolerance
};

/// `outline` in pixels from the cell's lower left corner, y up.
Snapped snap(const std::vector<DoublePoint>& outline, const PixelGrid& grid);

struct CellPart {
  Cell shift;    ///< from the home cell
  Polygon ring;  ///< from the lower left corner of its own cell
};

/// The parts of a simple counter-clockwise ring in each cell that it reaches, by columns. A part can touch itself where
/// rounding pressed it together: check isSimple().
std::vector<CellPart> cutAlongGrid(const Polygon& ring);

}  // namespace lgs::tiled
