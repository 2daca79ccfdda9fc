// The outlines of groups of polygons in a cell and the region's edges there, before they are rounded.
#pragma once

#include "ground.h"
#include "snap.h"

#include <optional>

namespace lgs::brush {

struct Arrangement {
  List<Segment> segments;       ///< of groups and of the region: group k has number k + 1
  Points hot;                   ///< normalized
  List<const Points*> staying;  ///< polygons that are to stay, by index; null: it has a group
};

/// Nothing if the edges cross in too many points. Cost: O(n²).
std::optional<Arrangement> arrangementOf(const Ground& ground, PieceSpan region);

/// The sides of groups as segments. Those that a polygon has too that is to stay do not bend.
List<Segment> groupSegments(const Ground& ground);

}  // namespace lgs::brush
