#include "form.h"

#include <lgs/questions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lgs::box2d {

namespace {

DoublePoint minus(DoublePoint a, DoublePoint b) { return {a.x - b.x, a.y - b.y}; }
double dot(DoublePoint a, DoublePoint b) { return a.x * b.x + a.y * b.y; }

double distance(DoublePoint p, DoublePoint a, DoublePoint b) {
  const DoublePoint u = minus(b, a);
  const double square = dot(u, u);
  const double t = square > 0 ? std::clamp(dot(minus(p, a), u) / square, 0.0, 1.0) : 0;
  return std::hypot(a.x + t * u.x - p.x, a.y + t * u.y - p.y);
}

/// How far a point is to the left of a line.
double leftOf(DoublePoint a, DoublePoint b, DoublePoint p) {
  const DoublePoint u = minus(b, a);
  return (u.x * (p.y - a.y) - u.y * (p.x - a.x)) / std::max(std::hypot(u.x, u.y), 1e-30);
}

/// Whether some point of a line is more than `depth` to the left of each side of a polygon: the line is clipped by one
/// side after the other.
bool isDeepIn(const std::vector<DoublePoint>& polygon, DoublePoint a, DoublePoint b, double depth) {
  double from = 0, to = 1;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const DoublePoint p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    const double atA = leftOf(p, q, a) - depth, atB = leftOf(p, q, b) - depth;
    if (atA <= 0 && atB <= 0) return false;
    if (atA < 0) from = std::max(from, atA / (atA - atB));
    if (atB < 0) to = std::min(to, atA / (atA - atB));
    if (from >= to) return false;
  }
  return true;
}

/// The distance of two lines that do not cross.
double distance(DoublePoint a, DoublePoint b, DoublePoint c, DoublePoint d) {
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

bool cross(DoublePoint a, DoublePoint b, DoublePoint c, DoublePoint d) {
  return leftOf(a, b, c) * leftOf(a, b, d) < 0 && leftOf(c, d, a) * leftOf(c, d, b) < 0;
}

/// Whether a line is less than `radius` away from a hull.
bool isNear(const std::vector<DoublePoint>& hull, DoublePoint a, DoublePoint b, double radius) {
  if (hull.size() == 1) return distance(hull[0], a, b) < radius;
  if (hull.size() > 2 && isDeepIn(hull, a, b, 0)) return true;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const DoublePoint c = hull[k], d = hull[(k + 1) % hull.size()];
    if (cross(a, b, c, d) || distance(a, b, c, d) < radius) return true;
  }
  return false;
}

}  // namespace

Box boxOf(std::span<const Form> forms) {
  constexpr double kMost = std::numeric_limits<double>::infinity();
  Box box{{kMost, kMost}, {-kMost, -kMost}};
  for (const Form& form : forms) {
    for (const DoublePoint& p : form.hull) {
      box.min = {std::min(box.min.x, p.x - form.radius), std::min(box.min.y, p.y - form.radius)};
      box.max = {std::max(box.max.x, p.x + form.radius), std::max(box.max.y, p.y + form.radius)};
    }
  }
  return box;
}

// What is rounded is followed by its tangents.
std::vector<Point> outlineOf(const Form& form) {
  constexpr int kTangents = 24;
  std::vector<DoublePoint> corners;
  if (form.radius == 0) corners = form.hull;
  for (int k = 0; form.radius > 0 && k < kTangents; ++k) {
    const double half = std::numbers::pi / kTangents, angle = 2 * half * k;
    const DoublePoint direction{std::cos(angle), std::sin(angle)};
    const auto isNearer = [&](DoublePoint a, DoublePoint b) { return dot(a, direction) < dot(b, direction); };
    const DoublePoint farthest = *std::max_element(form.hull.begin(), form.hull.end(), isNearer);
    const double reach = form.radius / std::cos(half);
    corners.push_back({farthest.x + reach * direction.x, farthest.y + reach * direction.y});
  }
  std::vector<Point> outline;
  for (const DoublePoint& p : corners) outline.push_back(latticePoint({p.x / kUnitsPerCell, p.y / kUnitsPerCell}));
  return outline;
}

double coreOf(const Form& form) {
  if (form.hull.size() < 3) return form.radius;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < form.hull.size(); ++k)
    least = std::min(least, leftOf(form.hull[k], form.hull[(k + 1) % form.hull.size()], form.middle));
  return form.radius + least;
}

bool reaches(const Form& form, DoublePoint a, DoublePoint b, double depth) {
  if (depth < form.radius) return isNear(form.hull, a, b, form.radius - depth);
  return form.hull.size() > 2 && isDeepIn(form.hull, a, b, depth - form.radius);
}

}  // namespace lgs::box2d
