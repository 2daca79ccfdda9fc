#include "polygon.h"

#include "predicates.h"

#include <lgs/world.h>

#include <algorithm>
#include <vector>

namespace lgs::detail {
namespace {

std::int32_t index(std::size_t i) { return static_cast<std::int32_t>(i); }

LocalPoint next(PolygonView p, std::size_t i) { return p[i + 1 == p.size() ? 0 : i + 1]; }

bool isInsideCell(LocalPoint p) { return p.x >= 0 && p.x <= kUnitsPerCell && p.y >= 0 && p.y <= kUnitsPerCell; }

std::optional<Defect> findRepeatedVertex(PolygonView p) {
  std::vector<std::int32_t> order(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) order[i] = index(i);
  const auto at = [&](std::int32_t i) { return p[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return at(a) != at(b) ? at(a) < at(b) : a < b; });
  std::optional<Defect> first;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (at(order[k - 1]) != at(order[k])) continue;
    if (!first || order[k] < first->vertex2) first = Defect{ErrorCode::repeatedVertex, order[k - 1], order[k]};
  }
  return first;
}

/// Whether the closed segments a–b and c–d, which share no end, have a point in common.
bool touch(LocalPoint a, LocalPoint b, LocalPoint c, LocalPoint d) {
  return crossProperly(a, b, c, d) || isInside(c, a, b) || isInside(d, a, b) || isInside(a, c, d) || isInside(b, c, d);
}

/// The vertices are known to be distinct, so neighbouring edges can meet wrongly only by folding back.
std::optional<Defect> findSelfIntersection(PolygonView p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const LocalPoint a = p[i], b = next(p, i);
    const LocalPoint after = next(p, i + 1 == n ? 0 : i + 1);
    if (orientation(a, b, after) == 0 && dot(a - b, after - b) > 0)
      return Defect{ErrorCode::selfIntersecting, index(i), index(i + 1 == n ? 0 : i + 1)};
    const std::size_t last = i == 0 ? n - 1 : n;  // the edge before edge 0 is its neighbour
    for (std::size_t j = i + 2; j < last; ++j)
      if (touch(a, b, p[j], next(p, j))) return Defect{ErrorCode::selfIntersecting, index(i), index(j)};
  }
  return std::nullopt;
}

/// Twice the signed area.
std::int64_t doubleArea(PolygonView polygon) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i] - LocalPoint{}, next(polygon, i) - LocalPoint{});
  return sum;
}

struct Box {
  LocalPoint min, max;
};

Box boundingBox(PolygonView p) {
  Box box{p[0], p[0]};
  for (const LocalPoint v : p) {
    box.min = {std::min(box.min.x, v.x), std::min(box.min.y, v.y)};
    box.max = {std::max(box.max.x, v.x), std::max(box.max.y, v.y)};
  }
  return box;
}

bool interiorsMeet(const Box& a, const Box& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

LocalPoint doubled(LocalPoint p) { return {2 * p.x, 2 * p.y}; }

/// Whether m (in half units) is strictly inside the polygon: a crossing count along the ray to the right.
bool isStrictlyInside(PolygonView polygon, LocalPoint m) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LocalPoint a = doubled(polygon[i]), b = doubled(next(polygon, i));
    if (a == m || isInside(m, a, b)) return false;
    if ((a.y > m.y) == (b.y > m.y)) continue;
    inside ^= (orientation(a, b, m) > 0) == (b.y > a.y);
  }
  return inside;
}

/// Whether some edge of p crosses one of q, or runs along one in the same direction (then both solids are on its left).
bool edgesConflict(PolygonView p, PolygonView q) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const LocalPoint a = p[i], b = next(p, i);
    for (std::size_t j = 0; j < q.size(); ++j) {
      const LocalPoint c = q[j], d = next(q, j);
      if (crossProperly(a, b, c, d)) return true;
      if (orientation(a, b, c) != 0 || orientation(a, b, d) != 0 || dot(b - a, d - c) < 0) continue;
      if (dot(b - a, d - a) > 0 && dot(b - a, c - b) < 0) return true;
    }
  }
  return false;
}

/// Cuts the edges of p at the vertices of q that lie on them; whether the middle of some piece is strictly inside q.
/// Where no edges conflict each piece is inside, outside or on the boundary of q as a whole.
bool someBoundaryIsInside(PolygonView p, PolygonView q) {
  std::vector<LocalPoint> cuts;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const LocalPoint a = p[i], b = next(p, i);
    cuts.assign({a, b});
    for (const LocalPoint v : q)
      if (isInside(v, a, b)) cuts.push_back(v);
    std::sort(cuts.begin(), cuts.end(), [&](auto u, auto v) { return dot(u - a, b - a) < dot(v - a, b - a); });
    for (std::size_t k = 1; k < cuts.size(); ++k)
      if (isStrictlyInside(q, {cuts[k - 1].x + cuts[k].x, cuts[k - 1].y + cuts[k].y})) return true;
  }
  return false;
}

}  // namespace

std::optional<Defect> findDefect(PolygonView polygon) {
  if (polygon.size() < 3) return Defect{ErrorCode::tooFewVertices};
  if (polygon.size() > kMaxVerticesPerCell) return Defect{ErrorCode::capacity};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (!isInsideCell(polygon[i])) return Defect{ErrorCode::outsideCell, index(i)};
  if (const auto repeated = findRepeatedVertex(polygon)) return repeated;
  const std::int64_t area = doubleArea(polygon);
  if (area == 0) return Defect{ErrorCode::zeroArea};
  if (area < 0) return Defect{ErrorCode::clockwise};
  return findSelfIntersection(polygon);
}

// Sound and complete: if no edges conflict and no piece of either boundary is inside the other polygon, the interior of
// p avoids the boundary of q, so it is inside q or outside it as a whole, and the other way round. Inside both ways
// means p = q, and then their edges conflict.
bool interiorsMeet(PolygonView p, PolygonView q) {
  if (!interiorsMeet(boundingBox(p), boundingBox(q))) return false;
  return edgesConflict(p, q) || someBoundaryIsInside(p, q) || someBoundaryIsInside(q, p);
}

}  // namespace lgs::detail
