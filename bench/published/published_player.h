// Plays traces with the published algorithm, and reads its output as outlines.
#pragma once

#include "bench/published/published.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/trace.h"

#include <vector>

namespace lgs::bench {

/// The vertices of a polygon as floats. They are exact up to 128 cells from the origin, and rounded beyond, because a
/// float has too few bits there.
std::vector<Vec2> floatVertices(const oracle::ScenePolygon& polygon);

/// The lattice point nearest to a vertex.
Point toLattice(Vec2 vertex);

/// The algorithm's output on the lattice, sorted.
oracle::Outline outlineOf(const Published& published);

/// What it puts out for the edits of a trace; each commit is computed. No edit may be bad, so play them on a world
/// first (player.h).
oracle::Outline publishedOutline(const oracle::Trace& trace);

/// What it puts out for a scene that is added in one go.
oracle::Outline publishedOutline(const oracle::Scene& scene);

}  // namespace lgs::bench
