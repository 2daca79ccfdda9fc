// Where something changed: boxes that lie beside each other are one place. So whoever looks for bodies there need not
// look at all that is between two places. It knows no Box2D.
#pragma once

#include "form.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::box2d {

/// Boxes that are in one place.
struct ChangedPlace {
  Box box;                           ///< around them
  std::vector<std::uint32_t> boxes;  ///< which they are, as indices, in increasing order
};

/// The places of boxes. Two whose lower left corners are in one cell, or in cells that have a corner in common, are in
/// one place: so are lines of at most a cell that touch, and a closed outline of such lines, with all that it goes
/// around. Cost: O(n log n).
std::vector<ChangedPlace> placesOf(std::span<const Box> boxes);

}  // namespace lgs::box2d
