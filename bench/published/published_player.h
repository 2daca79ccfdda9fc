// The published algorithm under the project's harness: traces go in, outlines come out.
#pragma once

#include "bench/published/published.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/trace.h"

#include <string>
#include <unordered_map>

namespace lgs::oracle {

/// The vertices of a polygon as the published algorithm wants them. Exact up to 128 cells from the origin, where a
/// float has the bits for the lattice; rounded beyond.
std::vector<Vec2> floatVertices(const ScenePolygon& polygon);

/// The nearest lattice point.
Point toLattice(Vec2 vertex);

/// Its output on the lattice, sorted.
Outline outlineOf(const Published& published);

/// What it puts out for the edits of a trace, each commit computed. The edits must be good ones: play them on a world
/// first (player.h).
Outline publishedOutline(const Trace& trace);

/// The same for a scene, in one go.
Outline publishedOutline(const Scene& scene);

}  // namespace lgs::oracle
