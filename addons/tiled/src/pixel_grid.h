// From pixels to the lattice: coordinates snap to the grid or are rounded, then polygons are cut along the grid.
#pragma once

#include "loops.h"

#include <functional>
#include <optional>

namespace lgs::tiled {

/// The grid of the map.
struct PixelGrid {
  DoublePoint tile;       ///< pixels of one cell
  DoublePoint tolerance;  ///< pixels. A coordinate this near to a grid line snaps to it
};

/// A polygon on the lattice, and how it got there.
struct Snapped {
  Polygon ring;            ///< lattice units from the cell's lower left corner
  Polygon drawn;           ///< the ring as it would be without snapping, vertex by vertex
  bool tooFar = false;     ///< a vertex is too far away; then the rings are empty
  bool takenBack = false;  ///< snapping would have collapsed the ring, so it stays as drawn
  unsigned moved = 0;      ///< how many coordinates snapped to the grid, or would have
  double furthest = 0;     ///< pixels that one of them moved, or would have
  double nearMiss = 0;     ///< pixels by which a vertex on a grid line misses a corner; 0 if it is too far from one
};

/// Puts an outline on the lattice. It is in pixels from the cell's lower left corner, y up. `mostCells` is how far away
/// a vertex may be.
Snapped snap(const std::vector<DoublePoint>& outline, const PixelGrid& grid, double mostCells);

/// Takes the snapping back if it collapses the ring: see collapses(). The ring is at most 2^30 units wide and high.
void takeBackCollapse(Snapped& snapped);

/// Whether an outline crosses itself so often (kMaxCrossings) that it is no drawing, and would take a brush minutes.
bool isTangled(const Polygon& outline);

/// Receives what lies of a polygon in one cell: how far this is from the polygon's home cell, and a ring in lattice
/// units from its lower left corner.
using PartSink = std::function<void(Cell shift, const Polygon& ring)>;

/// Cuts what an outline goes around along the grid: the polygons in each cell that it reaches. The outline may cross
/// itself; inside is what it goes around an odd number of times. Where edges cross each other or the grid, the rounding
/// is that of a brush. Returns how many parts there are; nothing if a cell would hold more than it can.
std::optional<std::size_t> cutAlongGrid(const Polygon& outline, const PartSink& sink);

}  // namespace lgs::tiled
