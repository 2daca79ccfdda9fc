// How degenerate the random worlds are: which situations that break boundary algorithms a scene holds.
#pragma once

#include "oracle/reference/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace lgs::oracle {

enum class Feature : std::size_t {
  midEdge,         ///< a vertex inside the edge of a polygon of another cell
  partialOverlap,  ///< edges of opposite direction that share a part, not the whole
  sharedInCell,    ///< an edge shared by two polygons of one cell, in whole or in part
  sharedSlope,     ///< the same, on a slanted edge
  fourSolids,      ///< polygons of four cells meet at their common corner
  manyInCell,      ///< two polygons or more in one cell
  preserve,        ///< a preserve relation that applies to blocks present
  refusal,         ///< an edit that must be refused; no scene shows it
  count
};

/// "vertex in mid-edge of a neighbour" and so on.
const char* describe(Feature feature);

using Features = std::array<bool, static_cast<std::size_t>(Feature::count)>;

/// Marks what the scene holds; leaves the other marks as they are. Meant for scenes of some dozen polygons.
void note(const Scene& scene, Features& features);

/// Of how many cases how many had each feature.
struct Distribution {
  std::uint64_t cases = 0;
  std::array<std::uint64_t, static_cast<std::size_t>(Feature::count)> with{};

  void add(const Features& features);
  double percent(Feature feature) const;
};

/// A line for each feature: its share of the cases, and what it is.
std::string table(const Distribution& distribution);

}  // namespace lgs::oracle
