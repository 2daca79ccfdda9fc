// What rounding can do to a cut, and what makes up for it. "Near" means: within two lattice units.
#pragma once

#include "polygon.h"

namespace lgs::tiled {

/// Whether every vertex of a lies in b or near its outline. Cost: O(n·m).
bool nearlyInside(const Polygon& a, const Polygon& b);

/// a with those vertices of b put into its outline that its edges pass near. Cost: O(n·m).
Polygon bentAround(const Polygon& a, const Polygon& b);

}  // namespace lgs::tiled
