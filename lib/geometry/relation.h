// How two polygons lie to each other. Where no edges cross, each edge of one polygon, cut at the vertices of the other,
// lies as a whole inside, outside or on the boundary of the other one. So the middle of each piece tells where the
// piece is.
#pragma once

#include "ring.h"

namespace lgs::detail {

/// What some edges see of a ring.
struct Sight {
  bool inside = false;   ///< one of them is inside
  bool outside = false;  ///< one of them is outside
  bool sameWay = false;  ///< one of them runs along the boundary, in its direction: both interiors are on its left
};

/// Adds what the edge u→v sees, judged by its middle, to `sight`.
template <LatticePoint P, class Ring>
constexpr void see(P u, P v, const Ring& ring, Sight& sight) {
  const auto doubled = [](P p) { return P{2 * p.x, 2 * p.y}; };
  const P middle{u.x + v.x, u.y + v.y};  // doubled, too
  bool inside = false;                   // the ray from there to the right meets an odd number of edges
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const P a = doubled(ring[j]), b = doubled(nextVertex(ring, j));
    if (isOnSegment(middle, a, b)) {
      sight.sameWay |= dot(v - u, b - a) > 0;
      return;
    }
    if ((a.y <= middle.y) == (b.y <= middle.y)) continue;
    inside ^= (orientation(a, b, middle) > 0) == (b.y > a.y);
  }
  (inside ? sight.inside : sight.outside) = true;
}

/// What the edges of a, cut at the vertices of b, see of b. No edges may cross. `cuts` is memory to work with.
template <class Ring, class Cuts = std::vector<PointOf<Ring>>>
Sight sightOf(const Ring& a, const Ring& b, Cuts cuts = {}) {
  Sight sight;
  for (std::size_t i = 0; i < a.size(); ++i) {
    cutEdge(a[i], nextVertex(a, i), b, cuts);
    for (std::size_t k = 1; k < cuts.size(); ++k) see(cuts[k - 1], cuts[k], b, sight);
  }
  return sight;
}

template <class Ring>
constexpr bool anyCrossing(const Ring& a, const Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const PointOf<Ring> p = a[i], q = nextVertex(a, i);
    for (std::size_t j = 0; j < b.size(); ++j)
      if (crossProperly(p, q, b[j], nextVertex(b, j))) return true;
  }
  return false;
}

enum class Relation : std::uint8_t {
  apart,    ///< the interiors do not meet (the boundaries may touch)
  overlap,  ///< the interiors meet
  inside,   ///< a is a part of b, or all of it
};

/// How a lies to b. Both are simple and counter-clockwise. `cuts` is memory to work with. Cost: O(n·m).
template <class Ring, class Cuts = std::vector<PointOf<Ring>>>
Relation relation(const Ring& a, const Ring& b, const Cuts& cuts = {}) {
  if (!interiorsMeet(boundingBox(a), boundingBox(b))) return Relation::apart;
  if (anyCrossing(a, b)) return Relation::overlap;
  const Sight ofA = sightOf(a, b, cuts);
  if (!ofA.outside && (ofA.inside || ofA.sameWay)) return Relation::inside;
  // If no part of either boundary is inside the other polygon, the interior of a avoids the boundary of b: it is inside
  // b or outside b as a whole, and the other way round. Inside both ways means that a is b, which was seen above.
  if (ofA.inside || ofA.sameWay || sightOf(b, a, cuts).inside) return Relation::overlap;
  return Relation::apart;
}

}  // namespace lgs::detail
