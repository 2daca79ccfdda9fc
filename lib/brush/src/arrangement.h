// The outlines of groups of polygons in a cell and the region's edges there, before they are rounded.
#pragma once

#include "ground.h"
#include "snap.h"

#include <vector>

namespace lgs::brush {

struct Arrangement {
  std::vector<Segment> segments;     ///< of the region and of groups: group k has number k + 1
  std::vector<Point> hot;            ///< normalized
  std::vector<const Ring*> staying;  ///< polygons that are to stay, by index; null: it has a group
};

/// If `follows`, outlines follow the region (docs/brushes.md, "Coming back"). Cost: O(n²).
Arrangement arrangementOf(const Ground& ground, const Pieces& region, FillRule rule, bool follows);

}  // namespace lgs::brush
