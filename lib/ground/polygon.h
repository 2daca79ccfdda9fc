// Validation of polygons: what makes one acceptable by itself, and two of them beside each other in a cell.
#pragma once

#include <lgs/error.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lgs::detail {

using PolygonView = std::span<const LocalPoint>;

/// A vertex in one number: its point, then its index. Such numbers are in the order of the points, and quicker to sort.
/// Indices go up to kMaxVerticesPerCell, 2^12.
using PlacedVertex = std::uint64_t;
constexpr std::uint64_t indexOf(PlacedVertex v) { return v & 0xfff; }
constexpr LocalPoint pointOf(PlacedVertex v) {
  return {static_cast<std::int32_t>(v >> 32), static_cast<std::int32_t>(v >> 12 & 0xfffff)};
}
constexpr bool isSamePoint(PlacedVertex v, PlacedVertex w) { return v >> 12 == w >> 12; }

/// The vertices of polygons, which are numbered one polygon after the other: `order` has them in the order of their
/// points.
void inOrder(std::span<const PolygonView> polygons, std::vector<PlacedVertex>& order);

/// Why a polygon is refused, and at which vertices (see Error).
struct Defect {
  ErrorCode code{};
  std::int32_t vertex = -1;
  std::int32_t vertex2 = -1;
};

/// The first defect in the order of ErrorCode, or nothing: simple, counter-clockwise, in the closed cell, positive
/// area. Cost: O(n log n); O(n²) if edges meet that should not.
std::optional<Defect> findDefect(PolygonView polygon);

/// Whether the interiors of two polygons without defects meet. Touching in points or along edges is not meeting.
/// Cost: O(n·m).
bool interiorsMeet(PolygonView p, PolygonView q);

}  // namespace lgs::detail
