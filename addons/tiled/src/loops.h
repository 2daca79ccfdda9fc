// The importer's polygons, which are rings of lattice points, and how such a ring falls into loops. The origin is the
// lower left corner of a cell. No ring is more than kMaxRegionCells cells (2^28 units) wide or high.
#pragma once

#include "geometry/relation.h"
#include "geometry/simple.h"

#include <span>
#include <vector>

namespace lgs::tiled {

using Polygon = std::vector<Point>;
using Box = detail::Box<Point>;

using detail::boundingBox;
using detail::cross;
using detail::crossProperly;
using detail::doubleArea;
using detail::isSimple;
using detail::nextVertex;
using detail::operator-;
using detail::orientation;
using detail::Relation;
using detail::relation;
using detail::segmentsMeet;

/// How often edges of two rings cross, each inside the other. It stops counting after `most`. Cost: O(n·m).
std::size_t crossings(const Polygon& a, const Polygon& b, std::size_t most);

/// From the vertices of a polygon of World, and to them.
Polygon ringOf(std::span<const LocalPoint> vertices);
std::vector<LocalPoint> localRing(const Polygon& ring);

/// Drops vertices that repeat their neighbour, lie straight between their neighbours, or are the tip of a spike. Then
/// takes the ring apart wherever it comes back to a vertex. Each loop keeps its direction. A loop of area 0 crosses
/// itself.
std::vector<Polygon> tidyLoops(Polygon ring);

/// Whether sides of an outline meet on the grid that did not meet as drawn: both sides of a thin wall came to lie on
/// one line, or a narrow waist was closed. Neighbouring vertices may become one. Both rings have the same number of
/// vertices, which belong together. Cost: O(n²).
bool collapses(const Polygon& drawn, const Polygon& snapped);

}  // namespace lgs::tiled
