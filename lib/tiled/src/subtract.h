// Taking one polygon out of another.
#pragma once

#include "split.h"

namespace lgs::tiled {

struct Difference {
  std::vector<Polygon> parts;  ///< simple, counter-clockwise, and apart from b
  bool lost = false;           ///< a part of some size was given up: it is too intricate, or rounding spoilt it
};

/// Takes b out of a. Both are simple, counter-clockwise and inside one cell. Cuts try to keep clear of the obstacles,
/// which b should be one of. So a part rarely overlaps an obstacle that a is apart from; but it can, so check it. Cost:
/// O(n·m) for each cut; after some milliseconds it gives up.
Difference subtract(const Polygon& a, const Polygon& b, Obstacles obstacles);

}  // namespace lgs::tiled
