// From pixels to polygons in cells: coordinates snap to the grid or are rounded, then outlines are cut along the grid.
// Polygons are rings of lattice points. The origin is the lower left corner of a cell. No ring is more than
// kMaxRegionCells cells (2^28 units) wide or high.
#pragma once

#include "geometry/relation.h"
#include "geometry/simple.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::tiled {

using Polygon = std::vector<Point>;
using Box = detail::Box<Point>;

using detail::boundingBox;
using detail::crossProperly;
using detail::doubleArea;
using detail::isSimple;
using detail::nextVertex;
using detail::orientation;
using detail::Relation;
using detail::relation;

/// How often edges of two rings cross, each inside the other. It stops counting after `most`. Cost: O(n·m).
std::size_t crossings(const Polygon& a, const Polygon& b, std::size_t most);

/// From the vertices of a polygon of World, and to them.
Polygon ringOf(std::span<const LocalPoint> vertices);
std::vector<LocalPoint> localRing(const Polygon& ring);

/// Without vertices that repeat their neighbour, lie straight between their neighbours, or are the tip of a spike: what
/// it goes around stays. Fewer than three are left of a ring that goes around nothing.
Polygon tidied(Polygon ring);

/// The grid of the map.
struct PixelGrid {
  DoublePoint tile;       ///< pixels of one cell
  DoublePoint tolerance;  ///< pixels. A coordinate this near to a grid line snaps to it
};

/// A polygon on the lattice, and how it got there.
struct Snapped {
  Polygon ring;            ///< lattice units from the cell's lower left corner
  bool takenBack = false;  ///< snapping would have collapsed the ring, so it stays as drawn
  unsigned moved = 0;      ///< how many coordinates snapped to the grid, or would have
  double furthest = 0;     ///< pixels that one of them moved, or would have
  double nearMiss = 0;     ///< pixels by which a vertex on a grid line misses a corner; 0 if it is too far from one
};

/// Puts an outline on the lattice. It is in pixels from the cell's lower left corner, y up. `mostCells` is how far away
/// a vertex may be. The error is why nothing of it is taken.
tl::expected<Snapped, std::string> snap(const std::vector<DoublePoint>& outline, const PixelGrid& grid,
                                        double mostCells);

/// Receives what lies of a polygon in one cell: how far this is from the polygon's home cell, and a ring in lattice
/// units from its lower left corner.
using PartSink = std::function<void(Cell shift, const Polygon& ring)>;

/// Cuts what an outline goes around along the grid: the polygons in each cell that it reaches. The outline may cross
/// itself; inside is what it goes around an odd number of times. Where edges cross each other or the grid, the rounding
/// is that of a brush. Returns how many parts there are; nothing if a cell would hold more than it can.
std::optional<std::size_t> cutAlongGrid(const Polygon& outline, const PartSink& sink);

}  // namespace lgs::tiled
