#include "snap.h"

#include "fraction.h"
#include "geometry/predicates.h"
#include "geometry/sort.h"
#include "pairs.h"

#include <algorithm>

namespace lgs::brush {

using detail::cross;
using detail::orientation;
using detail::Vector;
using detail::operator-;

namespace {

bool isBetween(std::int64_t v, std::int64_t a, std::int64_t b) { return std::min(a, b) <= v && v <= std::max(a, b); }

bool boxesMeet(const Segment& p, const Segment& q) {
  const auto meet = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b);
  };
  return meet(p.start.x, p.end.x, q.start.x, q.end.x) && meet(p.start.y, p.end.y, q.start.y, q.end.y);
}

}  // namespace

bool isInBox(Point p, Point a, Point b) { return isBetween(p.x, a.x, b.x) && isBetween(p.y, a.y, b.y); }

bool passes(Point a, Point b, Point pixel) {
  if (pixel == a || pixel == b) return true;
  if (!isInBox(pixel, a, b)) return false;  // a and b are centres of pixels
  const Vector d = b - a;
  const auto magnitude = [](std::int64_t v) { return v < 0 ? -v : v; };
  if (2 * magnitude(cross(d, pixel - a)) > magnitude(d.x) + magnitude(d.y)) return false;  // nearly always this tells
  const Point from{2 * a.x, 2 * a.y}, to{2 * b.x, 2 * b.y};
  const auto side = [&](int dx, int dy) { return orientation(from, to, Point{2 * pixel.x + dx, 2 * pixel.y + dy}); };
  const int corner = side(-1, -1);
  if (corner == 0) return true;
  // The other corners do not belong to the pixel, so it is not enough to touch them.
  return side(1, -1) == -corner || side(-1, 1) == -corner || side(1, 1) == -corner;
}

std::optional<Point> crossingPixel(const Segment& p, const Segment& q) {
  if (!boxesMeet(p, q) || !detail::crossProperly(p.a, p.b, q.a, q.b)) return std::nullopt;
  const Vector d = p.b - p.a, e = q.b - q.a;
  const std::int64_t divisor = cross(d, e), part = cross(q.a - p.a, e);
  const Point pixel{p.a.x + roundedProduct(d.x, part, divisor), p.a.y + roundedProduct(d.y, part, divisor)};
  if (!isInBox(pixel, p.start, p.end) || !isInBox(pixel, q.start, q.end)) return std::nullopt;
  return pixel;
}

void normalize(Points& points) {
  detail::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

bool addCrossings(const List<Segment>& segments, Points& hot) {
  const auto ends = [](const Segment& s) { return std::array{s.start, s.end}; };
  return !anyPair(segments, ends, [&](const Segment& p, const Segment& q) {
    if (!p.bends || !q.bends) return false;
    if (const auto pixel = crossingPixel(p, q)) hot.push_back(*pixel);
    return hot.size() > kMaxCrossingsPerCell;
  });
}

std::span<const Point> between(const Points& sorted, Point a, Point b) {
  const Point least{std::min(a.x, b.x), INT64_MIN}, greatest{std::max(a.x, b.x), INT64_MAX};
  return {std::lower_bound(sorted.begin(), sorted.end(), least),
          std::upper_bound(sorted.begin(), sorted.end(), greatest)};
}

void route(const Segment& segment, const Points& hot, Points& chain) {
  const auto& [a, b, start, end, sum, bends] = segment;
  chain.assign({start, end});
  const auto [least, greatest] = std::minmax(start.y, end.y);
  for (const Point z : between(hot, start, end)) {
    if (z.y < least || z.y > greatest || z == start || z == end) continue;
    if (bends ? passes(a, b, z) : orientation(a, b, z) == 0) chain.push_back(z);
  }
  if (chain.size() == 2) return;
  // An edge passes pixels in the order of both coordinates.
  const std::int64_t alongX = detail::sign(b.x - a.x), alongY = detail::sign(b.y - a.y);
  detail::sort(
      chain, [&](Point u, Point v) { return u.x != v.x ? alongX * u.x < alongX * v.x : alongY * u.y < alongY * v.y; });
}

}  // namespace lgs::brush
