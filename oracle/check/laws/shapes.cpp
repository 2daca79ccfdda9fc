// Circles, rectangles and thick lines are what they are called, to a unit and a half; what is no length, and what is
// beyond the last cell, is refused when the region is used.
#include "oracle/calls/random.h"
#include "oracle/check/laws/list.h"

#include <lgs/brush.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace lgs::oracle {
namespace {

constexpr std::int64_t kMostLength = kMaxRegionCells / 2 * kUnitsPerCell;
constexpr double kNear = 1.5;

std::int64_t anyNumber(Random& random, std::int64_t most) {
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  const std::array numbers{std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, most,         -most,
                           most + 1,        -most - 1,       kLeast,           -(kLeast + 1)};
  if (random.chance(30)) return numbers[random.below(numbers.size())];
  return random.between(std::int64_t{1}, std::int64_t{1} << random.between(1, 27));
}

bool isLengthOfRegion(std::int64_t v) { return v >= 1 && v <= kMostLength; }

double lengthOf(double x, double y) { return std::hypot(x, y); }
double gapOf(Point a, double x, double y) {
  return lengthOf(static_cast<double>(a.x) - x, static_cast<double>(a.y) - y);
}
double gapOf(Point a, Point b) { return gapOf(a, static_cast<double>(b.x), static_cast<double>(b.y)); }

/// Whether a region that is used is refused as it must be: for a length, or for its first vertex.
bool isRefusedRegion(const Region& region, bool isOfPlace) {
  const auto bounds = boundsOf(region);
  return !bounds && bounds.error().code == ErrorCode::outOfReach && (bounds.error().vertex == 0) == isOfPlace;
}

bool isCircle(const Ring& ring, Point center, std::int64_t radius, int corners) {
  const auto count = static_cast<std::size_t>((std::clamp(corners, 8, 4'096) + 7) / 8 * 8);
  return ring.size() == count && std::ranges::all_of(ring, [&](Point p) {
           return std::abs(gapOf(p, center) - static_cast<double>(radius)) < kNear / 2;
         });
}

bool isRectangle(const Ring& ring, Point center, Point along, std::int64_t halfLength, std::int64_t halfWidth) {
  const auto x = static_cast<double>(along.x), y = static_cast<double>(along.y), norm = lengthOf(x, y);
  const double ux = norm == 0 ? 1 : x / norm, uy = norm == 0 ? 0 : y / norm;
  const auto l = static_cast<double>(halfLength), w = static_cast<double>(halfWidth);
  constexpr std::array<std::array<int, 2>, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t k = 0; k < kCorners.size() && ring.size() == 4; ++k) {
    const double dx = kCorners[k][0] * l * ux - kCorners[k][1] * w * uy;
    const double dy = kCorners[k][0] * l * uy + kCorners[k][1] * w * ux;
    if (gapOf(ring[k], static_cast<double>(center.x) + dx, static_cast<double>(center.y) + dy) > kNear) return false;
  }
  return ring.size() == 4;
}

/// A circle around each point, and a strip of this width along each part of the line.
bool isThickLine(const std::vector<Ring>& rings, const std::vector<Point>& line, std::int64_t radius, int corners) {
  std::size_t at = 0;
  const auto isNext = [&](auto&& is) { return at < rings.size() && is(rings[at++]); };
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (!isNext([&](const Ring& ring) { return isCircle(ring, line[k], radius, corners); })) return false;
    if (k == 0 || line[k] == line[k - 1]) continue;
    const Point a = line[k - 1], b = line[k];
    const auto isStrip = [&](const Ring& ring) {
      const auto r = static_cast<double>(radius);
      return ring.size() == 4 && std::abs(gapOf(ring[0], a) - r) < kNear && std::abs(gapOf(ring[3], a) - r) < kNear &&
             std::abs(gapOf(ring[1], b) - r) < kNear && std::abs(gapOf(ring[2], b) - r) < kNear &&
             std::abs(gapOf(ring[0], ring[3]) - 2 * r) < 2 * kNear && ring[1].x - ring[0].x == b.x - a.x &&
             ring[2].y - ring[3].y == b.y - a.y;
    };
    if (!isNext(isStrip)) return false;
  }
  return at == rings.size();
}

std::string wrongShape(Random& random) {
  const auto number = [&] { return anyNumber(random, kMostLength); };
  const auto place = [&] {
    const std::int64_t x = anyNumber(random, kMaxCoordinate), y = anyNumber(random, kMaxCoordinate);
    return random.chance(80) ? Point{x % kUnitsPerCell, y % kUnitsPerCell} : Point{x, y};
  };
  const Point center = place();
  const bool isAway = !inRange(center);
  const std::int64_t radius = number(), halfWidth = number();
  const int corners = random.chance(70) ? random.below(70) : random.chance(50) ? -3 : 5'000;
  const auto isRight = [&](const Region& region, bool isLengthGood, auto&& is) {
    return isAway || !isLengthGood ? isRefusedRegion(region, isAway) : is(region.rings);
  };
  if (!isRight(circle(center, radius, corners), isLengthOfRegion(radius),
               [&](const auto& rings) { return rings.size() == 1 && isCircle(rings[0], center, radius, corners); }))
    return "circle() is no circle, or is not refused";
  const std::int64_t alongX = number(), alongY = number();
  const Point along = random.chance(10) ? Point{} : Point{alongX, random.chance(50) ? alongY : alongX};
  if (!isRight(rectangle(center, along, radius, halfWidth), isLengthOfRegion(radius) && isLengthOfRegion(halfWidth),
               [&](const auto& rings) {
                 return rings.size() == 1 && isRectangle(rings[0], center, along, radius, halfWidth);
               }))
    return "rectangle() is no rectangle, or is not refused";
  std::vector<Point> line{center};
  for (int k = random.below(3); k > 0; --k)
    line.push_back(random.chance(20) ? line.back() : Point{random.below(kUnitsPerCell), line.back().y / 2});
  if (!isRight(thickLine(line, radius, corners), isLengthOfRegion(radius),
               [&](const auto& rings) { return isThickLine(rings, line, radius, corners); }))
    return "thickLine() is no thick line, or is not refused";
  const double none = random.chance(50) ? std::numeric_limits<double>::quiet_NaN() : 1e300;
  const std::vector<DoublePoint> ring{{random.chance(50) ? none : 0.5, none}, {1, 0}, {1, 1}};
  if (!isRefusedRegion(region({&ring, 1}), true)) return "region() takes what is no number for one";
  return "";
}

class ShapesLaw : public Law {
 public:
  Found atEnd(Seen& seen) override {
    constexpr int kTries = 12;
    Random random(seen.edits);
    for (int k = 0; k < kTries; ++k)
      if (std::string wrong = wrongShape(random); !wrong.empty())
        return seen.mismatch(Mismatch::Kind::rounding, std::move(wrong));
    return std::nullopt;
  }
};

}  // namespace

std::unique_ptr<Law> laws::shapes() { return std::make_unique<ShapesLaw>(); }

}  // namespace lgs::oracle
