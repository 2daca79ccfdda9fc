#include "object_outline.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace lgs::tiled {
namespace {

using Kind = CollisionObject::Kind;

/// Cosine and sine of an angle in degrees. They are exact for quarter turns, so that turned rectangles stay on the
/// grid.
std::pair<double, double> turn(double degrees) {
  const double rest = std::fmod(degrees, 360.0);
  const double quarters = rest / 90.0;
  if (quarters == std::floor(quarters)) {
    constexpr double kCosines[] = {1, 0, -1, 0};
    const auto quarter = static_cast<unsigned>(static_cast<int>(quarters) + 4) % 4;
    return {kCosines[quarter], kCosines[(quarter + 3) % 4]};
  }
  const double angle = rest / 180.0 * std::numbers::pi;
  return {std::cos(angle), std::sin(angle)};
}

/// A rounded box: quarter circles of kCurveVertices / 4 steps around the four corners of an inner box. If the inner box
/// is a point, the result is an ellipse; if it is a line, a capsule.
std::vector<DoublePoint> roundedBox(DoublePoint size, DoublePoint radius) {
  constexpr int kSteps = kCurveVertices / 4;
  const DoublePoint inner{size.x - 2 * radius.x, size.y - 2 * radius.y};
  std::vector<DoublePoint> points;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const DoublePoint centre{radius.x + (quarter == 0 || quarter == 3 ? inner.x : 0),
                             radius.y + (quarter < 2 ? inner.y : 0)};
    for (int step = 0; step <= kSteps; ++step) {  // the ends of two quarters can coincide; tidyLoops() drops one
      const auto [cosine, sine] = turn(90.0 * quarter + 90.0 * step / kSteps);
      points.push_back({centre.x + radius.x * cosine, centre.y + radius.y * sine});
    }
  }
  return points;
}

}  // namespace

std::vector<DoublePoint> outline(const CollisionObject& object) {
  const DoublePoint size = object.size;
  std::vector<DoublePoint> points;
  switch (object.kind) {
    case Kind::rectangle:
      points = {{0, 0}, {size.x, 0}, size, {0, size.y}};
      break;
    case Kind::polygon:
      points = object.points;
      break;
    case Kind::ellipse:
      points = roundedBox(size, {size.x / 2, size.y / 2});
      break;
    case Kind::capsule: {
      const double radius = std::fmin(size.x, size.y) / 2;
      points = roundedBox(size, {radius, radius});
      break;
    }
    case Kind::polyline:
    case Kind::tile:
    case Kind::unsupported:
      break;
  }
  for (DoublePoint& p : points) {
    const DoublePoint q = turned(p, object.rotation);
    p = {object.at.x + q.x, object.at.y + q.y};
  }
  return points;
}

DoublePoint turned(DoublePoint p, double degrees) {
  const auto [cosine, sine] = turn(degrees);
  return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine};
}

std::uint32_t tileNumber(std::uint32_t gid) { return gid & 0x0FFF'FFFF; }  // one flag is only for hexagonal maps

Flips flipsOf(std::uint32_t gid) {
  return {(gid & 0x8000'0000) != 0, (gid & 0x4000'0000) != 0, (gid & 0x2000'0000) != 0};
}

void ImageFrame::scaleTo(DoublePoint size) {
  const DoublePoint box = flips.diagonal ? DoublePoint{image.y, image.x} : image;
  scale = {size.x / box.x, size.y / box.y};
}

DoublePoint ImageFrame::toCell(DoublePoint p) const {
  DoublePoint box = image;
  if (flips.diagonal) {
    std::swap(p.x, p.y);
    std::swap(box.x, box.y);
  }
  if (flips.horizontal) p.x = box.x - p.x;
  if (flips.vertical) p.y = box.y - p.y;
  return {p.x * scale.x + shift.x, (box.y - p.y) * scale.y - shift.y};
}

}  // namespace lgs::tiled
