// The importer's polygons: rings of lattice points. The origin is the lower left corner of a cell, and no vertex is further
// than kMaxReach cells (2^22 units) from it on either axis.
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

/// The ring without repeated and collinear vertices and without spikes, taken apart where it comes back to a vertex.
/// The orientation of each loop is kept; one whose area is 0 crosses itself.
std::vector<Polygon> tidyLoops(Polygon ring);

}  // namespace lgs::tiled
