#include "ground.h"

#include "geometry/ring.h"

#include <algorithm>

namespace lgs::brush {
namespace {

using detail::nextVertex;

/// All vertices, and where the region's edges cross each other or the cell's rim. They end on the rim, but a rounded
/// end can lie beside the edge.
std::vector<Point> knownPoints(const std::vector<CellPolygon>& polygons, const Pieces& region) {
  constexpr std::int64_t kEnd = kUnitsPerCell;
  std::size_t count = 4 + 2 * region.size();
  for (const CellPolygon& p : polygons) count += p.ring.size();
  std::vector<Point> points;
  points.reserve(count);
  points.assign({{0, 0}, {kEnd, 0}, {kEnd, kEnd}, {0, kEnd}});
  for (const CellPolygon& p : polygons) points.insert(points.end(), p.ring.begin(), p.ring.end());
  std::vector<Segment> edges;
  edges.reserve(4 + region.size());
  for (std::size_t k = 0; k < 4; ++k) {
    const Point a = points[k], b = points[(k + 1) % 4];
    edges.push_back({a, b, a, b, {}, true});
  }
  for (const Piece& p : region) {
    edges.push_back({p.a, p.b, p.start, p.end, {}, true});
    points.insert(points.end(), {p.start, p.end});
  }
  addCrossings(edges, points);
  normalize(points);
  return points;
}

std::vector<Side> sidesOf(const std::vector<CellPolygon>& polygons, const std::vector<Point>& points) {
  std::vector<Side> sides;
  sides.reserve(points.size());
  std::vector<Point> cuts;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const Ring& ring = polygons[k].ring;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      detail::cutEdge(ring[i], nextVertex(ring, i), points, cuts);
      for (std::size_t c = 1; c < cuts.size(); ++c) {
        const bool isLeft = isLower(cuts[c - 1], cuts[c]);
        sides.push_back(isLeft ? Side{cuts[c - 1], cuts[c], k, true} : Side{cuts[c], cuts[c - 1], k, false});
      }
    }
  }
  std::stable_sort(sides.begin(), sides.end());
  return sides;
}

std::vector<std::size_t> groupsOf(const std::vector<CellPolygon>& polygons, const std::vector<bool>& meeting,
                                  const std::vector<Side>& sides) {
  std::vector<std::size_t> groups(polygons.size(), kNoGroup);
  for (std::size_t k = 0; k < polygons.size(); ++k)
    if (meeting[k]) groups[k] = k;
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (sides[k - 1] < sides[k]) continue;  // nobody shares it
    const std::size_t p = sides[k - 1].polygon, q = sides[k].polygon, a = groups[p], b = groups[q];
    if (a == b || !meeting[p] || !meeting[q] || polygons[p].block != polygons[q].block) continue;
    for (std::size_t& group : groups)
      if (group == a || group == b) group = std::min(a, b);
  }
  return groups;
}

}  // namespace

Ground groundOf(const std::vector<CellPolygon>& polygons, const std::vector<bool>& meeting, const Pieces& region) {
  Ground ground{polygons, knownPoints(polygons, region), {}, {}};
  ground.sides = sidesOf(polygons, ground.known);
  ground.groups = groupsOf(polygons, meeting, ground.sides);
  return ground;
}

std::vector<Edge> oldOutline(const Ground& ground, std::size_t group) {
  std::vector<Edge> edges;
  for (auto s = ground.sides.begin(); s != ground.sides.end();) {
    bool isLeft = false, isRight = false;
    const Side& first = *s;
    for (; s != ground.sides.end() && !(first < *s); ++s)
      if (ground.groups[s->polygon] == group) (s->isLeft ? isLeft : isRight) = true;
    if (isLeft && !isRight) edges.push_back({first.low, first.high});
    if (isRight && !isLeft) edges.push_back({first.high, first.low});
  }
  return edges;
}

}  // namespace lgs::brush
