#include "rounding.h"

#include "geometry/relation.h"

#include <algorithm>

namespace lgs::brush {
namespace {

using detail::nextVertex;

/// Whether snap rounding would bend an edge of a polygon. If it bends none, no chain can reach into the polygon.
bool wouldBend(const Ring& ring, const std::vector<Point>& hot) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = nextVertex(ring, k);
    const auto isBeside = [&](Point z) { return detail::orientation(a, b, z) != 0 && passes(a, b, z); };
    if (std::any_of(hot.begin(), hot.end(), isBeside)) return true;
  }
  return false;
}

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
    return sum.polygons != 0 || isInside(sum.winding, rule);
  }
  return false;
}

}  // namespace

std::vector<std::size_t> rounded(const Arrangement& arrangement, FillRule rule, std::vector<Atom>& atoms) {
  std::vector<Point> chain;
  for (const Segment& segment : arrangement.segments) {
    route(segment, arrangement.hot, chain);
    addAtoms(chain, segment.sum, atoms);
  }
  settle(atoms);
  std::vector<std::size_t> reached;
  for (std::size_t k = 0; k < arrangement.staying.size(); ++k) {
    const Ring* const ring = arrangement.staying[k];
    if (ring == nullptr || !wouldBend(*ring, arrangement.hot)) continue;
    const bool isHit = std::any_of(atoms.begin(), atoms.end(), [&](const Atom& a) { return reachesInto(a, *ring); });
    if (isHit || isSwallowed(*ring, atoms, rule)) reached.push_back(k);
  }
  return reached;
}

}  // namespace lgs::brush
