#include "oracle/reference/validity.h"

#include <lgs/world.h>
#include <algorithm>
#include <cstdint>

namespace lgs::oracle {
namespace {

// A lattice point with doubled coordinates, so that the middle of two points has integer coordinates as well.
struct Doubled {
  std::int64_t x;
  std::int64_t y;
  friend auto operator<=>(const Doubled&, const Doubled&) = default;
};

Doubled doubled(LocalPoint p) { return {2 * std::int64_t{p.x}, 2 * std::int64_t{p.y}}; }

// Positive: c is on the left of a→b.
std::int64_t orientation(Doubled a, Doubled b, Doubled c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int sign(std::int64_t v) { return (v > 0) - (v < 0); }

bool onSegment(Doubled p, Doubled a, Doubled b) {
  return orientation(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

// Whether two edges cross in one point that is inside both.
bool doCross(Doubled a, Doubled b, Doubled c, Doubled d) {
  return sign(orientation(a, b, c)) * sign(orientation(a, b, d)) < 0 &&
         sign(orientation(c, d, a)) * sign(orientation(c, d, b)) < 0;
}

bool doTouch(Doubled a, Doubled b, Doubled c, Doubled d) {
  return doCross(a, b, c, d) || onSegment(a, c, d) || onSegment(b, c, d) || onSegment(c, a, b) || onSegment(d, a, b);
}

template <class Visit>
void forEachEdge(const LocalPolygon& polygon, Visit visit) {
  Doubled last = doubled(polygon.back());
  for (const LocalPoint& p : polygon) {
    const Doubled next = doubled(p);
    visit(last, next);
    last = next;
  }
}

enum class Position { inside, alongBoundary, againstBoundary, outside };

// Where the middle of the directed edge a→b lies in relation to a polygon. The polygon's boundary must not cross the
// edge.
Position positionOf(Doubled a, Doubled b, const LocalPolygon& polygon) {
  const Doubled middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  Position position = Position::outside;
  bool odd = false;
  forEachEdge(polygon, [&](Doubled u, Doubled v) {
    if (onSegment(middle, u, v)) {
      const bool same = (b.x - a.x) * (v.x - u.x) + (b.y - a.y) * (v.y - u.y) > 0;
      position = same ? Position::alongBoundary : Position::againstBoundary;
    }
    // A ray to the right; the half-open rule counts a vertex once.
    if ((u.y > middle.y) != (v.y > middle.y) && (orientation(u, v, middle) > 0) == (v.y > u.y)) odd = !odd;
  });
  return position == Position::outside && odd ? Position::inside : position;
}

// Whether a piece of a's boundary lies inside b, or along b's boundary with the solid on the same side.
bool boundaryEnters(const LocalPolygon& a, const LocalPolygon& b) {
  bool enters = false;
  std::vector<Doubled> cuts;
  forEachEdge(a, [&](Doubled from, Doubled to) {
    if (enters) return;
    cuts.assign({from, to});
    for (const LocalPoint& p : b) {
      if (onSegment(doubled(p), from, to)) cuts.push_back(doubled(p));
    }
    std::sort(cuts.begin(), cuts.end());
    if (to < from) std::reverse(cuts.begin(), cuts.end());
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      if (cuts[k - 1] == cuts[k]) continue;
      const Position position = positionOf(cuts[k - 1], cuts[k], b);
      if (position == Position::inside || position == Position::alongBoundary) enters = true;
    }
  });
  return enters;
}

// Whether one polygon is over when the other begins, along one axis.
bool areApart(const LocalPolygon& a, const LocalPolygon& b, std::int32_t LocalPoint::*axis) {
  const auto [minA, maxA] = std::ranges::minmax(a, {}, axis);
  const auto [minB, maxB] = std::ranges::minmax(b, {}, axis);
  return maxA.*axis <= minB.*axis || maxB.*axis <= minA.*axis;
}

}  // namespace

std::optional<ErrorCode> faultOf(const LocalPolygon& polygon) {
  if (polygon.size() < 3) return ErrorCode::tooFewVertices;
  if (polygon.size() > kMaxVerticesPerCell) return ErrorCode::capacity;
  const auto outside = [](std::int32_t v) { return v < 0 || v > kUnitsPerCell; };
  for (const LocalPoint& p : polygon) {
    if (outside(p.x) || outside(p.y)) return ErrorCode::outsideCell;
  }
  LocalPolygon sorted = polygon;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return ErrorCode::repeatedVertex;
  std::int64_t area = 0;
  forEachEdge(polygon, [&](Doubled a, Doubled b) { area += a.x * b.y - a.y * b.x; });
  if (area == 0) return ErrorCode::zeroArea;
  for (std::size_t j = 0; j < polygon.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (edgesMeet(polygon, i, j)) return ErrorCode::selfIntersecting;
  if (area < 0) return ErrorCode::clockwise;
  return std::nullopt;
}

bool edgesMeet(const LocalPolygon& p, std::size_t i, std::size_t j) {
  const auto after = [&](std::size_t k) { return k + 1 == p.size() ? 0 : k + 1; };
  const Doubled a = doubled(p[i]), b = doubled(p[after(i)]), c = doubled(p[j]), d = doubled(p[after(j)]);
  if (i == j) return false;
  if (after(i) == j) return onSegment(d, a, b) || onSegment(a, c, d);  // folds back
  if (after(j) == i) return onSegment(c, a, b) || onSegment(b, c, d);
  return doTouch(a, b, c, d);
}

bool overlap(const LocalPolygon& a, const LocalPolygon& b) {
  if (areApart(a, b, &LocalPoint::x) || areApart(a, b, &LocalPoint::y)) return false;
  bool crossing = false;
  forEachEdge(a, [&](Doubled s, Doubled t) {
    forEachEdge(b, [&](Doubled u, Doubled v) { crossing = crossing || doCross(s, t, u, v); });
  });
  return crossing || boundaryEnters(a, b) || boundaryEnters(b, a);
}

}  // namespace lgs::oracle
