// The outlines of groups of polygons in a cell and the region's edges there, before they are rounded.
#pragma once

#include "ground.h"
#include "snap.h"

#include <vector>

namespace lgs::brush {

struct Arrangement {
  std::vector<Segment> segments;     ///< of groups and of the region: group k has number k + 1
  std::vector<Point> hot;            ///< normalized
  std::vector<const Ring*> staying;  ///< polygons that are to stay, by index; null: it has a group
};

/// Cost: O(n²).
Arrangement arrangementOf(const Ground& ground, const Pieces& region);

/// The sides of groups as segments. Those that a polygon has too that is to stay do not bend.
std::vector<Segment> groupSegments(const Ground& ground);

}  // namespace lgs::brush
