// Which bodies a region of a brush meets. Link LocalGridSeg::brush as well.
#pragma once

#include <lgs/box2d/terrain.h>
#include <lgs/brush.h>

#include <algorithm>

namespace lgs::box2d {

/// The bodies that reach into a region, as Terrain::bodiesIn() would find them: but sensors, and what has no area, are
/// not looked at, and round ones count as somewhat larger. None, if the region has vertices in no cell. Cost: the
/// shapes near the cells of the region; for each that is found its corners, times those of the region.
inline auto bodiesIn(Terrain& terrain, const Region& region) noexcept {
  const Expected<CellRect> cells = boundsOf(region);
  auto bodies = terrain.bodiesIn(cells.value_or(CellRect{{0, 0}, {-1, -1}}));
  std::erase_if(bodies, [&](const auto& body) {
    const auto outlines = terrain.outlinesOf(body);
    return std::none_of(outlines.begin(), outlines.end(), [&](const Ring& ring) { return meets(region, ring); });
  });
  return bodies;
}

}  // namespace lgs::box2d
