// Snap rounding of a cell, and whether it leaves alone what must stay.
#pragma once

#include "arrangement.h"
#include "atoms.h"

#include <cstddef>

namespace lgs::brush {

struct Rounding {
  List<Atom> atoms;
  List<std::size_t> inTheWay;  ///< polygons that must stay, but something reaches into them, by number
  bool isPlane = false;        ///< no atoms cross: what is on their sides is known
};

/// Rounds an arrangement. Where snap rounding would reach into a polygon that must stay, edges of groups are left
/// straight if nothing crosses them, in case that helps. Cost: O(n²).
Rounding snapRounded(Arrangement arrangement, FillRule rule);

}  // namespace lgs::brush
