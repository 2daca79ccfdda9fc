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

/// An edge of a group bends: its chain goes through a vertex beside it.
struct Bend {
  const Segment* edge;
  Point vertex;
};

/// Whether a bend can come to lie beyond an edge that is left straight: both pass the pixel, and an end of the one that
/// bends is on the other side than the vertex. Where both have their ends in common nothing crosses, and still what was
/// between them is turned over.
bool foldsOver(const Bend& bend, const Segment& straight) {
  if (!passes(straight.a, straight.b, bend.vertex)) return false;
  const auto side = [&](Point p) { return detail::orientation(straight.a, straight.b, p); };
  const int beyond = side(bend.vertex);
  return side(bend.edge->a) * beyond < 0 || side(bend.edge->b) * beyond < 0;
}

/// Whether an edge is a part of one of a ring.
bool isPartOf(const Segment& edge, const Points& ring) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point u = ring[k], v = nextVertex(ring, k);
    if (detail::isOnSegment(edge.a, u, v) && detail::isOnSegment(edge.b, u, v)) return true;
  }
  return false;
}

/// Atoms of segments that are snapped do not cross, unless they reach into a polygon that is to stay.
Rounding roundOnce(const Arrangement& arrangement, FillRule rule, bool isSnapped) {
  Rounding result;
  result.atoms.reserve(arrangement.segments.size() + arrangement.hot.size());
  Points chain;
  List<Bend> bends;
  for (const Segment& segment : arrangement.segments) {
    route(segment, arrangement.hot, chain);
    addAtoms(chain, segment.sum, result.atoms);
    if (segment.sum.group == 0) continue;
    for (const Point z : chain)
      if (detail::orientation(segment.a, segment.b, z) != 0) bends.push_back({&segment, z});
  }
  List<const Segment*> folded;
  for (const Segment& segment : arrangement.segments)
    if (!segment.bends && std::ranges::any_of(bends, [&](const Bend& b) { return foldsOver(b, segment); }))
      folded.push_back(&segment);
  merge(result.atoms);
  const auto findInTheWay = [&](auto&& isInTheWay) {
    for (std::size_t k = 0; k < arrangement.staying.size(); ++k)
      if (const Points* const ring = arrangement.staying[k]; ring != nullptr && isInTheWay(*ring))
        result.inTheWay.push_back(k);
  };
  findInTheWay([&](const Points& ring) {
    const auto box = detail::boundingBox(ring);
    return std::any_of(result.atoms.begin(), result.atoms.end(),
                       [&](const Atom& a) {
                         return detail::boxesMeet(a.low, a.high, box.min, box.max) && reachesInto(a, ring);
                       }) ||
           std::ranges::any_of(folded, [&](const Segment* s) { return isPartOf(*s, ring); });
  });
  // Atoms that reach into a polygon may cross others. Then their sides are not asked for.
  result.isPlane = result.inTheWay.empty() && folded.empty() && (isSnapped || isPlane(result.atoms));
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
