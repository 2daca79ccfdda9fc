// Whether a polygon may be placed: the rules, checked the slow and obvious way. The generator makes its scenes by these
// rules, and the checker compares the engine's refusals with them.
#pragma once

#include <lgs/error.h>
#include <lgs/lattice.h>
#include <cstddef>
#include <optional>
#include <vector>

namespace lgs::oracle {

using LocalPolygon = std::vector<LocalPoint>;

/// What is wrong with a polygon by itself, in the order of ErrorCode; nothing if it is simple, counter-clockwise,
/// inside the closed cell and small enough for one.
std::optional<ErrorCode> faultOf(const LocalPolygon& polygon);

/// Whether two edges of a polygon have a point in common that they must not have. Edges that follow each other may
/// share the vertex between them, and nothing else. An edge has the number of its first vertex; the vertices are
/// distinct.
bool edgesMeet(const LocalPolygon& polygon, std::size_t i, std::size_t j);

/// Whether the interiors of two faultless polygons of one cell meet.
bool overlap(const LocalPolygon& a, const LocalPolygon& b);

}  // namespace lgs::oracle
