// Whether a polygon may be placed: the rules of a placed polygon, the slow and obvious way. The generator makes its
// scenes by it, and the checker holds the engine's refusals against it.
#pragma once

#include <lgs/error.h>
#include <lgs/lattice.h>
#include <cstddef>
#include <optional>
#include <vector>

namespace lgs::oracle {

using LocalPolygon = std::vector<LocalPoint>;

/// What is wrong with a polygon by itself, in the order of ErrorCode; nothing if it is simple, counter-clockwise, inside
/// the closed cell and small enough for one.
std::optional<ErrorCode> faultOf(const LocalPolygon& polygon);

/// Whether two edges of a polygon of distinct vertices, each named by its first one, have a point in common that they must
/// not have: any but the vertex between them, if they follow each other.
bool edgesMeet(const LocalPolygon& polygon, std::size_t i, std::size_t j);

/// Whether the interiors of two faultless polygons of one cell meet.
bool overlap(const LocalPolygon& a, const LocalPolygon& b);

}  // namespace lgs::oracle
