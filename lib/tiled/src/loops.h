// The importer's polygons, which are rings of lattice points, and how such a ring falls into loops. The origin is the
// lower left corner of a cell. No vertex is further from it than kMaxReach cells (2^22 units) on either axis.
#pragma once

#include "geometry/relation.h"

#include <span>
#include <vector>

namespace lgs::tiled {

using Polygon = std::vector<Point>;
using Box = detail::Box<Point>;

using detail::boundingBox;
using detail::cross;
using detail::dot;
using detail::doubleArea;
using detail::interiorsMeet;
using detail::isSimple;
using detail::isStrictlyInside;
using detail::nextVertex;
using detail::operator-;
using detail::orientation;
using detail::Relation;
using detail::relation;
using detail::sign;
using detail::Vector;

/// Drops vertices that repeat their neighbour, lie straight between their neighbours, or are the tip of a spike. Then
/// takes the ring apart wherever it comes back to a vertex. Each loop keeps its direction. A loop of area 0 crosses
/// itself.
std::vector<Polygon> tidyLoops(Polygon ring);

}  // namespace lgs::tiled
