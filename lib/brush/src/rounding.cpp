#include "rounding.h"

#include "geometry/relation.h"
#include "pairs.h"

#include <algorithm>

namespace lgs::brush {
namespace {

using detail::nextVertex;

/// Whether an atom runs through a polygon.
bool reachesInto(const Atom& atom, const Points& ring) {
  const Points piece{atom.low, atom.high};
  return detail::anyCrossing(piece, ring) || detail::sightOf(piece, ring, Points{}).inside;
}

/// Whether a polygon that no atom runs through came to lie inside the region, or inside another polygon.
bool isSwallowed(const Points& ring, const List<Atom>& atoms, FillRule rule) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = nextVertex(ring, k);
    if (a.y >= b.y) continue;
    const Sum sum = sumLeftOf({a.x + b.x, a.y + b.y}, atoms);  // the polygon is left of an edge that rises
    return sum.group != 0 || isFilled(sum.winding, rule);
  }
  return false;
}

/// Whether no atoms cross or end on each other.
bool isPlane(const List<Atom>& atoms) {
  const auto ends = [](const Atom& a) { return std::array{a.low, a.high}; };
  return !anyPair(atoms, ends, [](const Atom& a, const Atom& b) {
    return detail::crossProperly(a.low, a.high, b.low, b.high) || detail::isOnOpenSegment(a.low, b.low, b.high) ||
           detail::isOnOpenSegment(a.high, b.low, b.high) || detail::isOnOpenSegment(b.low, a.low, a.high) ||
           detail::isOnOpenSegment(b.high, a.low, a.high);
  });
}

/// Atoms of segments that are snapped do not cross, unless they reach into a polygon that is to stay.
Rounding roundOnce(const Arrangement& arrangement, FillRule rule, bool isSnapped) {
  Rounding result;
  result.atoms.reserve(arrangement.segments.size() + arrangement.hot.size());
  Points chain;
  for (const Segment& segment : arrangement.segments) {
    route(segment, arrangement.hot, chain);
    addAtoms(chain, segment.sum, result.atoms);
  }
  merge(result.atoms);
  const auto findInTheWay = [&](auto&& isInTheWay) {
    for (std::size_t k = 0; k < arrangement.staying.size(); ++k)
      if (const Points* const ring = arrangement.staying[k]; ring != nullptr && isInTheWay(*ring))
        result.inTheWay.push_back(k);
  };
  findInTheWay([&](const Points& ring) {
    const auto box = detail::boundingBox(ring);
    return std::any_of(result.atoms.begin(), result.atoms.end(), [&](const Atom& a) {
      return detail::boxesMeet(a.low, a.high, box.min, box.max) && reachesInto(a, ring);
    });
  });
  // Atoms that reach into a polygon may cross others. Then nobody asks for their sides.
  result.isPlane = result.inTheWay.empty() && (isSnapped || isPlane(result.atoms));
  if (!result.isPlane) return result;
  findSides(result.atoms);
  findInTheWay([&](const Points& ring) { return isSwallowed(ring, result.atoms, rule); });
  return result;
}

/// Leaves the edges of groups straight that nothing crosses.
void stiffen(List<Segment>& segments) {
  for (Segment& edge : segments) {
    if (edge.sum.group == 0) continue;
    edge.bends = std::any_of(segments.begin(), segments.end(), [&](const Segment& other) {
      return edge.bends && other.sum.winding != 0 && crossingPixel(edge, other);
    });
  }
}

}  // namespace

Rounding snapRounded(Arrangement arrangement, FillRule rule) {
  Rounding result = roundOnce(arrangement, rule, true);
  if (result.inTheWay.empty()) return result;
  stiffen(arrangement.segments);
  Rounding stiff = roundOnce(arrangement, rule, false);
  return stiff.inTheWay.empty() && stiff.isPlane ? stiff : result;
}

}  // namespace lgs::brush
