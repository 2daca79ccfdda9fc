// The edges of a cell's polygons and of the region there, before they are rounded.
#pragma once

#include "cell_edit.h"
#include "snap.h"

#include <vector>

namespace lgs::brush {

struct Arrangement {
  std::vector<Segment> segments;     ///< of the region, and of polygons that it reaches: number k is known as k + 1
  std::vector<Point> hot;            ///< normalized
  std::vector<const Ring*> staying;  ///< polygons that it does not reach, by number; null: it does
};

/// If `follows`, edges of polygons follow the region (docs/brushes.md, "Coming back"). Cost: O(n²).
Arrangement arrangementOf(const std::vector<CellPolygon>& polygons, const std::vector<bool>& reached,
                          const Pieces& region, FillRule rule, bool follows);

}  // namespace lgs::brush
