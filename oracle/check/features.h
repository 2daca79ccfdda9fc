// How degenerate the random worlds are: which situations that break boundary algorithms a scene holds.
#pragma once

#include "oracle/reference/scene.h"

#include <array>
#include <cstddef>

namespace lgs::oracle {

enum class Feature : std::size_t {
  midEdge,         ///< a vertex inside the edge of a polygon of another cell
  partialOverlap,  ///< edges of opposite direction that share a part, not the whole
  sharedInCell,    ///< an edge shared by two polygons of one cell, in whole or in part
  sharedSlope,     ///< the same, on a slanted edge
  fourSolids,      ///< polygons of four cells meet at their common corner
  manyInCell,      ///< two polygons or more in one cell
  preserve,        ///< a preserve relation that applies to blocks present
  count
};

/// "vertex in mid-edge of a neighbour" and so on.
const char* describe(Feature feature);

using Features = std::array<bool, static_cast<std::size_t>(Feature::count)>;

/// Marks what the scene holds; leaves the other marks as they are. Meant for scenes of some dozen polygons.
void note(const Scene& scene, Features& features);

}  // namespace lgs::oracle
