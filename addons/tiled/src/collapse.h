// Whether an outline falls together when it is put on the grid.
#pragma once

#include "loops.h"

namespace lgs::tiled {

/// Whether sides of an outline meet on the grid that did not meet as drawn: both sides of a thin wall came to lie on
/// one line, or a narrow waist was closed. Neighbouring vertices may become one. Both rings have the same number of
/// vertices, which belong together. Cost: O(n²).
bool collapses(const Polygon& drawn, const Polygon& snapped);

}  // namespace lgs::tiled
