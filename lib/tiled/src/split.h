// Cutting a polygon along a line.
#pragma once

#include "loops.h"

namespace lgs::tiled {

struct Line {
  Point at;
  Vector direction;
};

/// The pieces of a polygon on both sides of a line. All are counter-clockwise and tidy.
struct Halves {
  std::vector<Polygon> left;
  std::vector<Polygon> right;
};

/// The polygons that a piece should not be pushed into when its new vertices are rounded.
using Obstacles = std::span<const Polygon>;

/// Cuts a simple counter-clockwise polygon along a line.
///
/// A new vertex is rounded to a lattice point beside the exact place. If an obstacle has a vertex that near, it is that
/// one. Otherwise it is the nearest point that is in no obstacle and not on the left of the line, as far as there is
/// such a point. Along a horizontal or vertical line, without obstacles, the new vertices stay on the line. An edge is
/// cut in the same point from both of its sides. Rounding can make a piece touch itself, so check isSimple().
///
/// Range: inside one cell any line between lattice points of the cell. Up to kMaxReach cells away only horizontal and
/// vertical lines, with a direction of length 1.
Halves split(const Polygon& ring, const Line& line, Obstacles obstacles = {});

}  // namespace lgs::tiled
