// From the edges of an area to simple polygons.
#pragma once

#include "atoms.h"

namespace lgs::brush {

/// The ring without vertices in the middle of straight lines, its least vertex first.
Points straightened(const Points& ring);

/// The outline of an area as rings, with the area on their left. A ring may come to a vertex again. No vertex is in the
/// middle of a straight line. `edges` are all edges of the outline.
List<Points> ringsOf(List<HalfEdge> edges);

/// The simple counter-clockwise polygons that an area consists of. `edges` are all edges of its outline, the area on
/// their left; no two meet but in their ends. An area with holes is cut by chords between vertices of its outline.
/// No vertex is in the middle of a straight line. Polygons begin with their least vertex.
List<Points> simplePolygons(List<HalfEdge> edges);

}  // namespace lgs::brush
