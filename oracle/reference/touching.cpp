#include "oracle/reference/touching.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace lgs::oracle {
namespace {

using Ring = std::vector<Point>;

Ring ringOf(const ScenePolygon& p) {
  Ring ring;
  for (const LocalPoint v : p.vertices) ring.push_back(toWorld(p.cell, v));
  return ring;
}

bool areBeside(Cell a, Cell b) {
  return std::abs(std::int64_t{a.i} - b.i) <= 1 && std::abs(std::int64_t{a.j} - b.j) <= 1;
}

/// Twice the area of a triangle, positive if it runs counter-clockwise.
std::int64_t triangle(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// By how often the ring winds around the point.
bool isInOrOn(Point p, const Ring& ring) {
  int winding = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = ring[(k + 1) % ring.size()];
    const std::int64_t side = triangle(a, b, p);
    const bool inBox = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
                       p.y <= std::max(a.y, b.y);
    if (side == 0 && inBox) return true;
    if (a.y <= p.y && b.y > p.y && side > 0) ++winding;
    if (a.y > p.y && b.y <= p.y && side < 0) --winding;
  }
  return winding != 0;
}

bool edgesCross(const Ring& one, const Ring& other) {
  const auto differ = [](std::int64_t a, std::int64_t b) { return (a > 0 && b < 0) || (a < 0 && b > 0); };
  for (std::size_t k = 0; k < one.size(); ++k) {
    for (std::size_t n = 0; n < other.size(); ++n) {
      const Point a = one[k], b = one[(k + 1) % one.size()], c = other[n], d = other[(n + 1) % other.size()];
      if (differ(triangle(a, b, c), triangle(a, b, d)) && differ(triangle(c, d, a), triangle(c, d, b))) return true;
    }
  }
  return false;
}

}  // namespace

bool haveCommonPoint(const ScenePolygon& one, const ScenePolygon& other) {
  if (!areBeside(one.cell, other.cell)) return false;
  const Ring a = ringOf(one), b = ringOf(other);
  return std::ranges::any_of(a, [&](Point p) { return isInOrOn(p, b); }) ||
         std::ranges::any_of(b, [&](Point p) { return isInOrOn(p, a); }) || edgesCross(a, b);
}

bool haveCommonEdge(const ScenePolygon& one, const ScenePolygon& other) {
  if (!areBeside(one.cell, other.cell)) return false;
  const Ring p = ringOf(one), q = ringOf(other);
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (std::size_t n = 0; n < q.size(); ++n) {
      const Point a = p[k], b = p[(k + 1) % p.size()], c = q[n], d = q[(n + 1) % q.size()];
      if (triangle(a, b, c) != 0 || triangle(a, b, d) != 0) continue;
      const bool isLong = std::max(std::min(a, b), std::min(c, d)) < std::min(std::max(a, b), std::max(c, d));
      const bool isOpposite = (a < b) != (c < d);
      if (isLong && isOpposite) return true;
    }
  }
  return false;
}

std::vector<std::size_t> setsOf(const std::vector<ScenePolygon>& polygons) {
  std::vector<std::size_t> set(polygons.size());
  for (std::size_t k = 0; k < set.size(); ++k) set[k] = k;
  for (std::size_t k = 0; k < set.size(); ++k) {
    for (std::size_t n = 0; n < k; ++n) {
      if (set[k] == set[n] || !haveCommonPoint(polygons[k], polygons[n])) continue;
      const std::size_t from = std::max(set[k], set[n]), into = std::min(set[k], set[n]);
      std::ranges::replace(set, from, into);
    }
  }
  return set;
}

}  // namespace lgs::oracle
