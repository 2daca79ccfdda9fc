// The published algorithm has vertices of floats: polygons as floats, and its output on the lattice.
#pragma once

#include "bench/published/published.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <vector>

namespace lgs::bench {

/// The vertices of a polygon as floats. They are exact up to 128 cells from the origin, and rounded beyond, because a
/// float has too few bits there.
std::vector<Vec2> floatVertices(const oracle::ScenePolygon& polygon);

/// The lattice point nearest to a vertex.
Point toLattice(Vec2 vertex);

/// The algorithm's output on the lattice, sorted.
oracle::Outline outlineOf(const Published& published);

}  // namespace lgs::bench
