// Phase 2 on any directed edges: fans are sorted here, where the engine has them from the grid.
#include <lgs/radial_match.h>

#include "geometry/predicates.h"
#include "geometry/radial_match.h"
#include "geometry/sort.h"

#include <cstdlib>

namespace lgs {
namespace {

using detail::Spoke;
using detail::Vector;
using detail::operator-;

bool isInReach(std::span<const Point> points, DirectedEdge edge) {
  if (edge.from >= points.size() || edge.to >= points.size()) return false;
  if (!inRange(points[edge.from]) || !inRange(points[edge.to])) return false;
  const Vector v = points[edge.to] - points[edge.from];
  return v != Vector{} && std::abs(v.x) <= kMaxEdgeLength && std::abs(v.y) <= kMaxEdgeLength;
}

/// The spokes of all points in one list: those of point p are from first[p] to first[p + 1].
struct Fans {
  std::vector<std::size_t> first;
  std::vector<Spoke> spokes;

  std::span<Spoke> at(std::size_t point) {
    return std::span(spokes).subspan(first[point], first[point + 1] - first[point]);
  }
};

/// In the order of the edges.
Fans fansOf(std::size_t points, std::span<const DirectedEdge> edges) {
  Fans fans;
  fans.first.resize(points + 2);  // two more: counted two places on, the filling moves them one back
  for (const DirectedEdge& e : edges) {
    ++fans.first[e.from + 2];
    ++fans.first[e.to + 2];
  }
  for (std::size_t p = 2; p < fans.first.size(); ++p) fans.first[p] += fans.first[p - 1];
  fans.spokes.resize(2 * edges.size());
  for (std::uint32_t k = 0; k < edges.size(); ++k) {
    fans.spokes[fans.first[edges[k].from + 1]++] = {k, 0, 1};
    fans.spokes[fans.first[edges[k].to + 1]++] = {k, 0, 0};
  }
  return fans;
}

/// Sorts a fan counter-clockwise, and numbers its directions.
void sortFan(std::span<const Point> points, std::span<const DirectedEdge> edges, std::span<Spoke> fan) {
  const auto towards = [&](const Spoke& spoke) {
    const Vector v = points[edges[spoke.segment].to] - points[edges[spoke.segment].from];
    return spoke.outgoing ? v : Vector{-v.x, -v.y};
  };
  detail::sort(fan, [&](const Spoke& a, const Spoke& b) {
    const Vector u = towards(a), v = towards(b);
    if (!detail::sameDirection(u, v)) return detail::angleLess(u, v);
    return a.segment < b.segment;
  });
  for (std::size_t k = 1; k < fan.size(); ++k) {
    const bool turns = !detail::sameDirection(towards(fan[k - 1]), towards(fan[k]));
    fan[k].direction = (fan[k - 1].direction + (turns ? 1u : 0u)) & detail::kMaxDirection;
  }
}

}  // namespace

Expected<std::vector<EdgeLinks>> radialMatch(std::span<const Point> points, std::span<const DirectedEdge> edges) {
  if (edges.size() > INT32_MAX) return tl::unexpected(Error{.code = ErrorCode::capacity});
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (!isInReach(points, edges[k]))
      return tl::unexpected(Error{.code = ErrorCode::outOfReach, .index = static_cast<std::int32_t>(k)});
  std::vector<EdgeLinks> links(edges.size());
  Fans fans = fansOf(points.size(), edges);
  for (std::size_t p = 0; p < points.size(); ++p) {
    sortFan(points, edges, fans.at(p));
    detail::radialMatch(
        fans.at(p), kNoEdge, [&](std::uint32_t edge, std::uint32_t other) { links[edge].predecessor = other; },
        [&](std::uint32_t edge, std::uint32_t other) { links[edge].successor = other; });
  }
  return links;
}

std::vector<std::vector<std::uint32_t>> loopsOf(std::span<const EdgeLinks> links) {
  const auto after = [&](std::uint32_t edge) {
    const std::uint32_t next = links[edge].successor;
    return next < links.size() && links[next].predecessor == edge ? next : kNoEdge;
  };
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<bool> isDone(links.size(), false);
  for (std::uint32_t first = 0; first < links.size(); ++first) {
    if (isDone[first]) continue;
    std::vector<std::uint32_t> loop;
    std::uint32_t edge = first;
    for (; edge != kNoEdge && !isDone[edge]; edge = after(edge)) {
      isDone[edge] = true;
      loop.push_back(edge);
    }
    if (edge == first) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace lgs
