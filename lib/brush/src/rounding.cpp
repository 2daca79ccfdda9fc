#include "rounding.h"

#include "geometry/relation.h"

#include <algorithm>

namespace lgs::brush {
namespace {

using detail::nextVertex;

/// Whether an atom runs through a polygon.
bool reachesInto(const Atom& atom, const Ring& ring) {
  const Ring piece{atom.low, atom.high};
  return detail::anyCrossing(piece, ring) || detail::sightOf(piece, ring).inside;
}

/// Whether a polygon that no atom runs through came to lie inside the region, or inside another polygon.
bool isSwallowed(const Ring& ring, const std::vector<Atom>& atoms, FillRule rule) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = nextVertex(ring, k);
    if (a.y >= b.y) continue;
    const Sum sum = sumLeftOf({a.x + b.x, a.y + b.y}, atoms);  // the polygon is left of an edge that rises
    return sum.group != 0 || isInside(sum.winding, rule);
  }
  return false;
}

/// Whether no atoms cross or end on each other.
bool isPlane(const std::vector<Atom>& atoms) {
  for (const Atom& a : atoms)
    for (const Atom& b : atoms)
      if (detail::crossProperly(a.low, a.high, b.low, b.high) || detail::isInside(a.low, b.low, b.high) ||
          detail::isInside(a.high, b.low, b.high))
        return false;
  return true;
}

Rounding roundOnce(const Arrangement& arrangement, FillRule rule) {
  Rounding result;
  result.atoms.reserve(arrangement.segments.size() + arrangement.hot.size());
  std::vector<Point> chain;
  for (const Segment& segment : arrangement.segments) {
    route(segment, arrangement.hot, chain);
    addAtoms(chain, segment.sum, result.atoms);
  }
  settle(result.atoms);
  for (std::size_t k = 0; k < arrangement.staying.size(); ++k) {
    const Ring* const ring = arrangement.staying[k];
    if (ring == nullptr) continue;
    const auto reaches = [&](const Atom& a) { return reachesInto(a, *ring); };
    if (isSwallowed(*ring, result.atoms, rule) || std::any_of(result.atoms.begin(), result.atoms.end(), reaches))
      result.inTheWay.push_back(k);
  }
  return result;
}

/// Leaves the edges of groups straight that nothing crosses.
void stiffen(std::vector<Segment>& segments) {
  for (Segment& edge : segments) {
    if (edge.sum.group == 0) continue;
    edge.bends = std::any_of(segments.begin(), segments.end(), [&](const Segment& other) {
      return edge.bends && other.sum.winding != 0 && crossingPixel(edge, other);
    });
  }
}

}  // namespace

Rounding rounded(Arrangement arrangement, FillRule rule) {
  Rounding result = roundOnce(arrangement, rule);
  if (result.inTheWay.empty()) return result;
  stiffen(arrangement.segments);
  Rounding stiff = roundOnce(arrangement, rule);
  return stiff.inTheWay.empty() && isPlane(stiff.atoms) ? stiff : result;
}

}  // namespace lgs::brush
