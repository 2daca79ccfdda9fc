#include "stay.h"

#include "geometry/relation.h"

#include <algorithm>

namespace lgs::brush {
namespace {

using detail::nextVertex;

/// Whether snap rounding would bend an edge of a polygon. If it bends none, no chain can reach into the polygon.
bool wouldBend(const Ring& ring, const std::vector<Point>& hot) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = nextVertex(ring, k);
    if (std::any_of(hot.begin(), hot.end(),
                    [&](Point z) { return detail::orientation(a, b, z) != 0 && passes(a, b, z); }))
      return true;
  }
  return false;
}

bool reachesInto(const std::vector<Point>& chain, const Ring& ring) {
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const Ring piece{chain[k - 1], chain[k]};
    if (detail::anyCrossing(piece, ring) || detail::sightOf(piece, ring).inside) return true;
  }
  return false;
}

}  // namespace

std::vector<std::size_t> roundBeside(const Arrangement& arrangement, Chains& chains) {
  chains.resize(arrangement.segments.size());
  for (std::size_t k = 0; k < chains.size(); ++k) route(arrangement.segments[k], arrangement.hot, chains[k]);
  std::vector<std::size_t> reached;
  for (std::size_t k = 0; k < arrangement.staying.size(); ++k) {
    const Ring* const ring = arrangement.staying[k];
    if (ring == nullptr || !wouldBend(*ring, arrangement.hot)) continue;
    if (std::any_of(chains.begin(), chains.end(), [&](const auto& chain) { return reachesInto(chain, *ring); }))
      reached.push_back(k);
  }
  return reached;
}

}  // namespace lgs::brush
