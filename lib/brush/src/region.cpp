#include "fraction.h"
#include "geometry/predicates.h"

#include <lgs/brush.h>

#include <algorithm>

namespace lgs {
namespace {

constexpr std::int64_t kMaxLength = kMaxRegionCells / 2 * kUnitsPerCell;

bool isLength(std::int64_t v) { return v >= 1 && v <= kMaxLength; }

/// ⌊√v⌋, by Newton's way from above.
std::int64_t squareRoot(std::int64_t v) {
  if (v < 2) return v;
  std::int64_t root = std::int64_t{1} << 31, next = root;
  do {
    root = next;
    next = (root + v / root) / 2;
  } while (next < root);
  return root;
}

/// The first eighth of a circle, from the x axis on, without the diagonal: points (1 - t², 2t) / (1 + t²). tan 22.5° is
/// nearly 29/70, and t has even steps up to there: so the corners are nearly evenly spread.
std::vector<Point> eighth(std::int64_t radius, std::int64_t steps) {
  std::vector<Point> points;
  for (std::int64_t k = 0; k < steps; ++k) {
    const std::int64_t u = 70 * steps, v = 29 * k, divisor = u * u + v * v;
    points.push_back(
        {brush::roundedProduct(radius, u * u - v * v, divisor), brush::roundedProduct(radius, 2 * u * v, divisor)});
  }
  return points;
}

Ring circleRing(Point center, std::int64_t radius, int corners) {
  const std::int64_t steps = (std::clamp(corners, 8, 4'096) + 7) / 8;
  std::vector<Point> quarter = eighth(radius, steps);
  const std::size_t count = quarter.size();
  const std::int64_t below = squareRoot(radius * radius / 2);
  const std::int64_t diagonal = (2 * below + 1) * (2 * below + 1) <= 2 * radius * radius ? below + 1 : below;
  quarter.push_back({diagonal, diagonal});
  for (std::size_t k = count; k-- > 1;) quarter.push_back({quarter[k].y, quarter[k].x});
  Ring ring;
  for (int turn = 0; turn < 4; ++turn) {
    for (Point& p : quarter) {
      ring.push_back({center.x + p.x, center.y + p.y});
      p = {-p.y, p.x};
    }
  }
  return ring;
}

Ring rectangleRing(Point center, Point along, std::int64_t halfLength, std::int64_t halfWidth) {
  if (along == Point{}) along = {1, 0};
  const auto reaches = [&along](std::int64_t size) {  // without std::abs(), as the least number has no opposite
    return along.x >= size || along.x <= -size || along.y >= size || along.y <= -size;
  };
  while (reaches(std::int64_t{1} << 30)) along = {along.x / 2, along.y / 2};
  while (!reaches(std::int64_t{1} << 29)) along = {along.x * 2, along.y * 2};
  const std::int64_t norm = squareRoot(along.x * along.x + along.y * along.y);
  const auto part = [norm](std::int64_t size, std::int64_t v) { return brush::roundedProduct(size, v, norm); };
  const Point l{part(halfLength, along.x), part(halfLength, along.y)};
  const Point w{-part(halfWidth, along.y), part(halfWidth, along.x)};
  return {{center.x - l.x - w.x, center.y - l.y - w.y},
          {center.x + l.x - w.x, center.y + l.y - w.y},
          {center.x + l.x + w.x, center.y + l.y + w.y},
          {center.x - l.x + w.x, center.y - l.y + w.y}};
}

/// A region that is refused when it is used, as this point is in no cell.
Region refusable(Point point) { return {{{point}}}; }
/// The same for a length that is out of range: it is too wide.
Region tooWide() { return {{{{0, 0}, {2 * kMaxLength + 1, 0}}}}; }

}  // namespace

Region region(std::span<const std::vector<DoublePoint>> rings, FillRule rule) {
  Region result{{}, rule};
  for (const std::vector<DoublePoint>& ring : rings) {
    result.rings.emplace_back();
    for (const DoublePoint vertex : ring) result.rings.back().push_back(latticePoint(vertex));
  }
  return result;
}

Region circle(Point center, std::int64_t radius, int corners) {
  if (!inRange(center)) return refusable(center);
  if (!isLength(radius)) return tooWide();
  return {{circleRing(center, radius, corners)}};
}

Region rectangle(Point center, Point along, std::int64_t halfLength, std::int64_t halfWidth) {
  if (!inRange(center)) return refusable(center);
  if (!isLength(halfLength) || !isLength(halfWidth)) return tooWide();
  return {{rectangleRing(center, along, halfLength, halfWidth)}};
}

Region thickLine(std::span<const Point> points, std::int64_t radius, int corners) {
  Region result;
  for (const Point p : points)
    if (!inRange(p)) return refusable(p);
  if (!isLength(radius)) return tooWide();
  for (std::size_t k = 0; k < points.size(); ++k) {
    result.rings.push_back(circleRing(points[k], radius, corners));
    if (k == 0 || points[k] == points[k - 1]) continue;
    const Point a = points[k - 1], b = points[k];
    // Each side is the line moved by the radius. The ends stay where the line has them, so that pieces fit together.
    const Ring side = rectangleRing({0, 0}, {b.x - a.x, b.y - a.y}, 1, radius);
    const Point w{(side[2].x - side[1].x) / 2, (side[2].y - side[1].y) / 2};
    result.rings.push_back(
        {{a.x - w.x, a.y - w.y}, {b.x - w.x, b.y - w.y}, {b.x + w.x, b.y + w.y}, {a.x + w.x, a.y + w.y}});
  }
  return result;
}

}  // namespace lgs
