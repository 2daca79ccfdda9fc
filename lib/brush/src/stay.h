// Rounding beside polygons that the region does not meet: they do not bend, and nothing may reach into them.
#pragma once

#include "atoms.h"

#include <cstddef>
#include <vector>

namespace lgs::brush {

/// The arrangement of a cell before it is rounded.
struct Arrangement {
  std::vector<Segment> segments;
  std::vector<Point> hot;            ///< normalized
  std::vector<const Ring*> staying;  ///< polygons, by index; null: it need not stay
};

using Chains = std::vector<std::vector<Point>>;  ///< one for each segment

/// Rounds an arrangement. Returns the polygons that could not stay, by index: then the chains are of no use.
std::vector<std::size_t> roundBeside(const Arrangement& arrangement, Chains& chains);

}  // namespace lgs::brush
