// The rim of a cell, in units from the cell's corner.
#pragma once

#include "pieces.h"

namespace lgs::brush {

constexpr bool isCorner(Point p) { return (p.x == 0 || p.x == kUnitsPerCell) && (p.y == 0 || p.y == kUnitsPerCell); }

constexpr bool liesOnRim(Point p) { return p.x == 0 || p.y == 0 || p.x == kUnitsPerCell || p.y == kUnitsPerCell; }

/// Whether an edge of the cell runs along one of its sides.
constexpr bool runsAlongRim(Point u, Point v) {
  return (u.x == v.x && (u.x == 0 || u.x == kUnitsPerCell)) || (u.y == v.y && (u.y == 0 || u.y == kUnitsPerCell));
}

}  // namespace lgs::brush
