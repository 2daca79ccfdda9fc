// Taking one polygon out of another.
#pragma once

#include "split.h"

namespace lgs::tiled {

struct Difference {
  std::vector<Polygon> parts;  ///< simple, counter-clockwise; none overlaps b
  bool lost = false;  ///< whether a part worth mentioning had to be given up (intricate, or spoilt by rounding)
};

/// a without b; both simple and counter-clockwise, inside one cell. Cuts keep clear of the obstacles, b among them, so
/// that as a rule the parts overlap none that a did not overlap; check it.
Difference subtract(const Polygon& a, const Polygon& b, Obstacles obstacles);

}  // namespace lgs::tiled
