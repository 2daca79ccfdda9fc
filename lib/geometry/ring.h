// Polygons as rings of lattice points: the last vertex is followed by the first. A ring is any range of LocalPoint or
// Point with an index, such as std::vector or std::span. Ranges of coordinates are those of predicates.h.
#pragma once

#include "predicates.h"
#include "sort.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace lgs::detail {

template <class Ring>
using PointOf = typename Ring::value_type;

template <class Ring>
constexpr PointOf<Ring> nextVertex(const Ring& ring, std::size_t i) {
  return ring[i + 1 == ring.size() ? 0 : i + 1];
}

/// Twice the signed area: positive for a counter-clockwise ring. It fits in 64 bits while the number of vertices times
/// the square of the ring's extent is below 2^62: 65,536 vertices for the importer's 2^23 units.
template <class Ring>
constexpr std::int64_t doubleArea(const Ring& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return sum;
}

template <LatticePoint P>
struct Box {
  P min, max;
};

/// The least box around one or more points.
template <class Points>
constexpr Box<PointOf<Points>> boundingBox(const Points& points) {
  Box<PointOf<Points>> box{points[0], points[0]};
  for (const auto p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }
  return box;
}

/// Whether the interiors meet. A box without width or height counts as its open segment.
template <LatticePoint P>
constexpr bool interiorsMeet(const Box<P>& a, const Box<P>& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

/// Cuts the edge a→b at those of the points that lie inside it: `cuts` becomes a, these points in order, and b.
template <LatticePoint P, class Points, class Cuts>
void cutEdge(P a, P b, const Points& points, Cuts& cuts) {
  cuts.assign({a, b});
  for (const P p : points)
    if (isOnOpenSegment(p, a, b)) cuts.push_back(p);
  if (cuts.size() > 2) detail::sort(cuts, [&](P u, P v) { return dot(u - a, b - a) < dot(v - a, b - a); });
}

/// The first two edges that have a point in common which they should not have, each named by the vertex that it leaves.
/// Neighbours should have only their common vertex, other edges nothing. Cost: O(n²). simple.h
/// says sooner whether there are any.
template <class Ring>
std::optional<std::pair<std::size_t, std::size_t>> findSelfIntersection(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t following = i + 1 == n ? 0 : i + 1;
    const PointOf<Ring> a = ring[i], b = ring[following], c = nextVertex(ring, following);
    // Neighbours meet in b. They share more if the second one folds back, or if one of them has no length.
    if (orientation(a, b, c) == 0 && dot(a - b, c - b) >= 0) return std::pair(i, following);
    const std::size_t last = i == 0 ? n - 1 : n;  // the edge before edge 0 is its neighbour
    for (std::size_t j = i + 2; j < last; ++j)
      if (segmentsMeet(a, b, ring[j], nextVertex(ring, j))) return std::pair(i, j);
  }
  return std::nullopt;
}

}  // namespace lgs::detail
