#include "outline.h"

#include "geometry/ring.h"
#include "geometry/sort.h"

#include <algorithm>
#include <optional>

namespace lgs::brush {
namespace {

using detail::cross;
using detail::dot;
using detail::Vector;
using detail::operator-;

/// Whether u comes before v when one turns clockwise from a direction. The direction itself comes last.
bool comesFirst(Vector from, Vector u, Vector v) {
  const auto part = [from](Vector w) {
    const std::int64_t turn = cross(from, w);
    if (turn != 0) return turn < 0 ? 0 : 2;
    return dot(from, w) < 0 ? 1 : 3;
  };
  const int ofU = part(u), ofV = part(v);
  return ofU != ofV ? ofU < ofV : cross(u, v) < 0;
}

/// The closed walks along the edges with the area on the left. At each vertex the walk stays beside the area that it
/// came along. `edges` is sorted.
List<Points> walks(const List<HalfEdge>& edges) {
  List<bool> isDone(edges.size(), false);
  const auto after = [&](const HalfEdge& edge) {
    const auto first = std::lower_bound(edges.begin(), edges.end(), edge.to,
                                        [](const HalfEdge& e, Point vertex) { return e.from < vertex; });
    auto best = first;
    for (auto e = first; e != edges.end() && e->from == edge.to; ++e)
      if (comesFirst(edge.from - edge.to, e->to - e->from, best->to - best->from)) best = e;
    return static_cast<std::size_t>(best - edges.begin());
  };
  List<Points> rings;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (isDone[first]) continue;
    Points& ring = rings.emplace_back();
    ring.reserve(edges.size() - first);
    for (std::size_t k = first; !isDone[k]; k = after(edges[k])) {
      isDone[k] = true;
      ring.push_back(edges[k].from);
    }
  }
  return rings;
}

/// A walk, parted where it comes to a vertex again.
List<Points> loops(const Points& walk) {
  List<Points> parts;
  Points open;
  open.reserve(walk.size());
  for (const Point p : walk) {
    const auto before = std::find(open.begin(), open.end(), p);
    if (before != open.end()) {
      parts.emplace_back(before, open.end());
      open.erase(before, open.end());
    }
    open.push_back(p);
  }
  parts.push_back(std::move(open));
  return parts;
}

/// Whether an edge meets the open line between two vertices.
bool blocks(const HalfEdge& edge, Point from, Point to) {
  return detail::boxesMeet(edge.from, edge.to, from, to) &&
         (detail::crossProperly(from, to, edge.from, edge.to) || detail::isOnOpenSegment(edge.from, from, to) ||
          detail::isOnOpenSegment(edge.to, from, to));
}

/// The nearest vertex on one side of a vertex that can be seen from it. There is always one.
std::optional<Point> visible(Point from, bool isLess, const List<HalfEdge>& edges) {
  Points candidates;
  for (const HalfEdge& e : edges)
    if (isLess ? e.from < from : from < e.from) candidates.push_back(e.from);
  const auto distance = [from](Point p) { return dot(p - from, p - from); };
  detail::sort(candidates,
               [&](Point p, Point q) { return distance(p) != distance(q) ? distance(p) < distance(q) : p < q; });
  for (const Point to : candidates)
    if (std::none_of(edges.begin(), edges.end(), [&](const HalfEdge& e) { return blocks(e, from, to); })) return to;
  return std::nullopt;
}

/// Adds a chord from an end of a hole, in both directions. There is none if an edge leads on from there, or if what
/// lies in that direction is not of the area: then the hole touches the outer outline.
void addChord(Point from, bool isLess, List<HalfEdge>& edges) {
  std::optional<Vector> first;  // met by a turn clockwise from that direction
  bool leaves = false;
  const Vector ahead{isLess ? -1 : 1, 0};
  for (const HalfEdge& e : edges) {
    if (e.from != from && e.to != from) continue;
    const Point other = e.from == from ? e.to : e.from;
    if (isLess ? other < from : from < other) return;
    const bool isChord = first && other - from == *first;  // seen before the other way around
    if (first && !isChord && !comesFirst(ahead, other - from, *first)) continue;
    first = other - from;
    leaves = isChord || e.from == from;
  }
  if (!leaves) return;  // the area is on the left of its edges, so it ends where an edge comes in
  if (const auto to = visible(from, isLess, edges)) {
    edges.push_back({from, *to});
    edges.push_back({*to, from});
  }
}

}  // namespace

Points straightened(const Points& ring) {
  Points kept;
  kept.reserve(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point before = ring[k == 0 ? ring.size() - 1 : k - 1];
    if (detail::orientation(before, ring[k], detail::nextVertex(ring, k)) != 0) kept.push_back(ring[k]);
  }
  if (!kept.empty()) std::rotate(kept.begin(), std::min_element(kept.begin(), kept.end()), kept.end());
  return kept;
}

List<Points> ringsOf(List<HalfEdge> edges) {
  detail::sort(edges);
  List<Points> rings = walks(edges);
  for (Points& ring : rings) ring = straightened(ring);
  return rings;
}

List<Points> simplePolygons(List<HalfEdge> edges) {
  detail::sort(edges);
  List<Points> polygons = walks(edges);
  const std::size_t outlines = edges.size();
  const bool touches = std::ranges::adjacent_find(edges, {}, &HalfEdge::from) != edges.end();
  for (const Points& walk : polygons) {
    for (const Points& loop : touches ? loops(walk) : List<Points>{walk}) {
      if (detail::doubleArea(loop) > 0) continue;
      addChord(*std::min_element(loop.begin(), loop.end()), true, edges);
      addChord(*std::max_element(loop.begin(), loop.end()), false, edges);
    }
  }
  if (edges.size() != outlines) {
    detail::sort(edges);
    polygons = walks(edges);
  }
  for (Points& polygon : polygons) polygon = straightened(polygon);
  return polygons;
}

}  // namespace lgs::brush
