#include "snap.h"

#include "fraction.h"
#include "geometry/predicates.h"
#include "geometry/sort.h"

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

void normalize(std::vector<Point>& points) {
  detail::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

void addCrossings(const std::vector<Segment>& segments, std::vector<Point>& hot) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!segments[i].bends) continue;
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      if (!segments[j].bends) continue;
      const auto pixel = crossingPixel(segments[i], segments[j]);
      if (pixel) hot.push_back(*pixel);
    }
  }
}

void route(const Segment& segment, const std::vector<Point>& hot, std::vector<Point>& chain) {
  const auto& [a, b, start, end, sum, bends] = segment;
  chain.assign({start, end});
  const Point least{std::min(start.x, end.x), INT64_MIN}, greatest{std::max(start.x, end.x), INT64_MAX};
  const auto last = std::upper_bound(hot.begin(), hot.end(), greatest);
  for (auto z = std::lower_bound(hot.begin(), hot.end(), least); z != last; ++z) {
    if (*z == start || *z == end || !isInBox(*z, start, end)) continue;
    if (bends ? passes(a, b, *z) : orientation(a, b, *z) == 0) chain.push_back(*z);
  }
  // An edge passes pixels in the order of both coordinates.
  const std::int64_t alongX = detail::sign(b.x - a.x), alongY = detail::sign(b.y - a.y);
  detail::sort(
      chain, [&](Point u, Point v) { return u.x != v.x ? alongX * u.x < alongX * v.x : alongY * u.y < alongY * v.y; });
}

}  // namespace lgs::brush
