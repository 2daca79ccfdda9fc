// Validation of polygons: what makes one acceptable by itself, and two of them beside each other in a cell.
#pragma once

#include <lgs/error.h>
#include <lgs/lattice.h>

#include <optional>
#include <span>

namespace lgs::detail {

using PolygonView = std::span<const LocalPoint>;

/// Why a polygon is refused, and at which vertices (see Error).
struct Defect {
  ErrorCode code{};
  std::int32_t vertex = -1;
  std::int32_t vertex2 = -1;
};

/// The first defect in the order of ErrorCode, or nothing: simple, counter-clockwise, in the closed cell, positive
/// area. Cost: O(n²).
std::optional<Defect> findDefect(PolygonView polygon);

/// Whether the interiors of two polygons without defects meet. Touching in points or along edges is not meeting.
/// Cost: O(n·m).
bool interiorsMeet(PolygonView p, PolygonView q);

}  // namespace lgs::detail
