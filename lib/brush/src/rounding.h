// Snap rounding of a cell, and whether it leaves alone what must stay.
#pragma once

#include "arrangement.h"
#include "atoms.h"

#include <cstddef>
#include <vector>

namespace lgs::brush {

struct Rounding {
  std::vector<Atom> atoms;
  std::vector<std::size_t> inTheWay;  ///< polygons that must stay, but something reaches into them, by number
};

/// Rounds an arrangement. Where snap rounding would reach into a polygon that must stay, edges of groups are left
/// straight if nothing crosses them, in case that helps. Cost: O(n²).
Rounding rounded(Arrangement arrangement, FillRule rule);

}  // namespace lgs::brush
