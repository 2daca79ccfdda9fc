#include "ground.h"

#include "geometry/relation.h"
#include "geometry/sort.h"
#include "outline.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace lgs::brush {
namespace {

using detail::nextVertex;

/// All vertices, and where the region's edges cross each other or the cell's rim. They end on the rim, but a rounded
/// end can lie beside the edge. Nothing if the region crosses itself too often.
std::optional<Points> knownPoints(const List<Outline>& outlines, PieceSpan region) {
  Points points(kCorners.begin(), kCorners.end());
  addVertices(outlines, points);
  List<Segment> edges;
  edges.reserve(region.size());
  for (const Piece& p : region) {
    points.insert(points.end(), {p.start, p.end});
    if (p.isOfRegion) edges.push_back({p.a, p.b, p.start, p.end, {}, true});  // the others are on the rim
  }
  if (!addCrossings(edges, points)) return std::nullopt;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point a = kCorners[k], b = kCorners[(k + 1) % 4];
    for (const Segment& edge : edges)
      if (const auto pixel = crossingPixel({a, b, a, b, {}, true}, edge)) points.push_back(*pixel);
  }
  normalize(points);
  return points;
}

/// The edges of outlines, cut at points, which are sorted.
List<Side> sidesOf(const List<Outline>& outlines, const Points& points) {
  List<Side> sides;
  sides.reserve(points.size());
  Points cuts;
  for (const auto& [area, ring] : outlines) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      detail::cutEdge(ring[i], nextVertex(ring, i), between(points, ring[i], nextVertex(ring, i)), cuts);
      for (std::size_t c = 1; c < cuts.size(); ++c) {
        const bool isLeft = isLower(cuts[c - 1], cuts[c]);
        sides.push_back(isLeft ? Side{cuts[c - 1], cuts[c], area, true} : Side{cuts[c], cuts[c - 1], area, false});
      }
    }
  }
  detail::sort(sides, [](const Side& a, const Side& b) { return a < b || (!(b < a) && a.area < b.area); });
  return sides;
}

List<std::size_t> groupsOf(const List<CellPolygon>& polygons, const List<bool>& meeting, const List<Side>& sides) {
  List<std::size_t> groups(polygons.size(), kNoGroup);
  for (std::size_t k = 0; k < polygons.size(); ++k)
    if (meeting[k]) groups[k] = k;
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (sides[k - 1] < sides[k]) continue;  // no polygon shares it
    const std::size_t p = sides[k - 1].area, q = sides[k].area, a = groups[p], b = groups[q];
    if (a == b || polygons[p].block != polygons[q].block) continue;
    for (std::size_t& group : groups)
      if (group == a || group == b) group = std::min(a, b);
  }
  return groups;
}

/// The outline of a group, with the group on its left. `sides` are those of the polygons.
List<HalfEdge> outlineOf(std::size_t group, const List<std::size_t>& groups, const List<Side>& sides) {
  List<HalfEdge> edges;
  for (auto s = sides.begin(); s != sides.end();) {
    bool isLeft = false, isRight = false;
    const Side& first = *s;
    for (; s != sides.end() && !(first < *s); ++s)
      if (groups[s->area] == group) (s->isLeft ? isLeft : isRight) = true;
    if (isLeft && !isRight) edges.push_back({first.low, first.high});
    if (isRight && !isLeft) edges.push_back({first.high, first.low});
  }
  return edges;
}

}  // namespace

void addVertices(const List<Outline>& outlines, Points& points) {
  std::size_t count = points.size();
  for (const Outline& o : outlines) count += o.ring.size();
  points.reserve(count);
  for (const Outline& o : outlines) points.insert(points.end(), o.ring.begin(), o.ring.end());
}

Ground groundOf(const List<CellPolygon>& polygons, const List<bool>& meeting) {
  List<Outline> outlines;
  List<Side> sides;  // of what may hang together
  if (std::ranges::count(meeting, true) > 1) {
    for (std::size_t k = 0; k < polygons.size(); ++k)
      if (meeting[k]) outlines.push_back({k, polygons[k].ring});
    Points vertices;
    addVertices(outlines, vertices);
    normalize(vertices);
    sides = sidesOf(outlines, vertices);
    outlines.clear();
  }
  Ground ground{polygons, groupsOf(polygons, meeting, sides), {}, {}, {}};
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const std::size_t group = ground.groups[k];
    if (group == kNoGroup) {
      outlines.push_back({k, polygons[k].ring});
    } else if (group == k && std::ranges::count(ground.groups, k) == 1) {
      outlines.push_back({k, straightened(polygons[k].ring)});
    } else if (group == k) {
      for (Points& ring : ringsOf(outlineOf(k, ground.groups, sides))) outlines.push_back({k, std::move(ring)});
    }
  }
  ground.outlines = std::move(outlines);
  return ground;
}

bool addKnown(Ground& ground, PieceSpan region) {
  auto known = knownPoints(ground.outlines, region);
  if (!known) return false;
  ground.known = std::move(*known);
  ground.sides = sidesOf(ground.outlines, ground.known);
  return true;
}

List<std::size_t> partsIn(const Points& ring, const List<std::size_t>& some, const Ground& ground) {
  List<std::size_t> parts;
  for (const std::size_t k : some)
    if (detail::relation(ground.polygons[k].ring, ring, Points{}) != detail::Relation::apart) parts.push_back(k);
  return parts;
}

List<HalfEdge> oldOutline(const Ground& ground, std::size_t group) {
  List<HalfEdge> edges;
  edges.reserve(ground.sides.size());
  for (const Side& s : ground.sides)
    if (s.area == group) edges.push_back(s.isLeft ? HalfEdge{s.low, s.high} : HalfEdge{s.high, s.low});
  return edges;
}

}  // namespace lgs::brush
