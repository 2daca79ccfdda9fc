// A triangulation of a cell with respect to its polygons: each triangle lies in one polygon, or is free.
//
// By plane sweep, after Hertel and Mehlhorn: Fast triangulation of the plane with respect to simple polygons,
// Information and Control 64 (1985). It decides by orientations of three vertices alone, so it is exact, and the same
// everywhere.
#pragma once

#include <lgs/lattice.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lgs::pieces {

using Ring = std::vector<LocalPoint>;
using Index = std::uint32_t;
inline constexpr Index kNone = UINT32_MAX;  ///< what no index is

/// Says which polygon a triangle is in, by its index. kFree: in none.
using Label = std::uint32_t;
inline constexpr Label kFree = UINT32_MAX;

struct Triangle {
  std::array<Index, 3> corners{};  ///< counter-clockwise
  Label label = kFree;
};

struct Triangulation {
  std::vector<LocalPoint> points;  ///< the vertices of the polygons and the corners of the cell, each once, in order
  std::vector<Triangle> triangles;
};

/// The polygons are good ones of one cell: simple, counter-clockwise, with disjoint interiors. They may touch in any
/// way. Each point is a corner of some triangle, and in no triangle's edge beside. Cost: O(n log n) for n vertices, and
/// moves of at most n² words.
Triangulation triangulate(std::span<const Ring> polygons);

}  // namespace lgs::pieces
