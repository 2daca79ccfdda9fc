// Islands as an engine of others puts them out: each named by what depends on the polygons alone.
#pragma once

#include <lgs/lattice.h>

#include <compare>
#include <cstdint>
#include <vector>

namespace lgs::oracle {

struct NamedIsland {
  Point west;                   ///< the westernmost vertex of its polygons; of several the southernmost
  std::int64_t doubleArea = 0;  ///< twice the area of its polygons, in square units
  friend auto operator<=>(const NamedIsland&, const NamedIsland&) = default;
};

/// Sorted.
using NamedIslands = std::vector<NamedIsland>;

}  // namespace lgs::oracle
