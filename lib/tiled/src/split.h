// Cutting a polygon along a line.
#pragma once

#include "polygon.h"

namespace lgs::tiled {

struct Line {
  Point at;
  Vector direction;
};

/// Both sides of a polygon that was cut along a line. All pieces are counter-clockwise and tidy.
struct Halves {
  std::vector<Polygon> left;
  std::vector<Polygon> right;
};

/// The polygons that a cut should not push a piece into.
using Obstacles = std::span<const Polygon>;

/// Cuts a simple counter-clockwise polygon. The new vertices are rounded to a lattice point beside the exact place: to
/// an obstacle's vertex if one is that near, else to the nearest that is in no obstacle and not on the line's left.
/// Along a horizontal or vertical line, without obstacles, only the place on the line is rounded. Rounding can make a
/// piece touch itself: check isSimple(). The same edge, cut from either of its sides, is cut in the same point.
/// Limits: any line inside one cell; horizontal and vertical lines of direction ±1 within kMaxReach cells.
Halves split(const Polygon& ring, const Line& line, Obstacles obstacles = {});

}  // namespace lgs::tiled
