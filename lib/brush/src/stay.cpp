#include "stay.h"

#include "geometry/predicates.h"

#include <algorithm>

namespace lgs::brush {
namespace {

/// The edges that must stay and that snap rounding would bend. Nothing can cross any other.
std::vector<const StayingEdge*> endangered(const Arrangement& arrangement) {
  std::vector<const StayingEdge*> edges;
  for (const StayingEdge& s : arrangement.staying) {
    const auto& [from, to] = s.edge;
    const bool wouldBend = std::any_of(arrangement.hot.begin(), arrangement.hot.end(), [&](Point z) {
      return passes(from, to, z) && detail::orientation(from, to, z) != 0;
    });
    if (wouldBend) edges.push_back(&s);
  }
  return edges;
}

bool crosses(const std::vector<Point>& chain, const Edge& edge) {
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const Point u = chain[k - 1], v = chain[k];
    if (detail::crossProperly(u, v, edge.from, edge.to) || detail::isInside(edge.from, u, v) ||
        detail::isInside(edge.to, u, v))
      return true;
  }
  return false;
}

}  // namespace

std::vector<std::size_t> roundBeside(const Arrangement& arrangement, Chains& chains) {
  chains.resize(arrangement.segments.size());
  for (std::size_t k = 0; k < chains.size(); ++k) route(arrangement.segments[k], arrangement.hot, chains[k]);
  std::vector<std::size_t> crossed;
  for (const StayingEdge* const s : endangered(arrangement)) {
    if (std::any_of(chains.begin(), chains.end(), [&](const auto& chain) { return crosses(chain, s->edge); }))
      crossed.insert(crossed.end(), s->polygons.begin(), s->polygons.end());
  }
  return crossed;
}

}  // namespace lgs::brush
