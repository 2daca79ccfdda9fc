// Edges of polygons that the region does not meet: nothing may cross them, and they do not bend.
#pragma once

#include "atoms.h"

#include <array>
#include <vector>

namespace lgs::brush {

/// An edge that must stay, and the polygons beside it that must: one or two, by index.
struct StayingEdge {
  Edge edge;
  std::vector<std::size_t> polygons;
};

/// The arrangement of a cell before it is rounded.
struct Arrangement {
  std::vector<Segment> segments;
  std::vector<StayingEdge> staying;
  std::vector<Point> hot;  ///< normalized
};

using Chains = std::vector<std::vector<Point>>;  ///< one for each segment

/// Rounds an arrangement. Returns the polygons that could not stay: then the chains are of no use.
std::vector<std::size_t> roundBeside(const Arrangement& arrangement, Chains& chains);

}  // namespace lgs::brush
