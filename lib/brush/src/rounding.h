// Rounding beside polygons that the region does not reach: they do not bend, and nothing may reach into them.
#pragma once

#include "arrangement.h"
#include "atoms.h"

#include <cstddef>
#include <vector>

namespace lgs::brush {

struct Rounding {
  std::vector<Atom> atoms;
  bool isGood = false;                ///< no polygons overlap, and nothing reaches into those that must stay
  std::vector<std::size_t> inTheWay;  ///< if it is not good: polygons that must stay, and are a reason, by number
};

/// Rounds an arrangement. Where snap rounding would reach into a polygon that must stay, edges of polygons are left
/// straight if nothing crosses them, in case that helps. It is good if nothing follows and nothing must stay.
Rounding rounded(Arrangement arrangement, FillRule rule);

}  // namespace lgs::brush
