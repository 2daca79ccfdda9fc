// A convex shape of a body, as the ground meets it. Physics moves bodies in floating point, so what is said about forms
// is rounded. What is said about the ground is exact.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

namespace lgs::box2d {

/// All that is within `radius` of a hull. In lattice units of the world.
struct Form {
  std::vector<DoublePoint> hull;     ///< one point, two, or a convex polygon, counter-clockwise
  double radius = 0;                 ///< of the rounding
  DoublePoint middle;                ///< an edge of the ground holds the form on the side on which this is
  std::function<bool(Block)> holds;  ///< whether the form collides with a block
};

/// A box in lattice units of the world.
struct Box {
  DoublePoint min;  ///< the lower left corner
  DoublePoint max;  ///< the upper right corner; below `min` if there is nothing in the box
};

/// All places where a body may be.
inline constexpr Box kEverywhere{{-1e15, -1e15}, {1e15, 1e15}};

/// The least box around two.
inline Box around(const Box& a, const Box& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

/// Whether two boxes have a point in common.
inline bool overlap(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// A lattice point, exactly.
inline DoublePoint real(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// A point that was moved.
inline DoublePoint moved(DoublePoint p, DoublePoint by) { return {p.x + by.x, p.y + by.y}; }

/// The least box around a line.
inline Box boxOf(Point a, Point b) {
  return {real({std::min(a.x, b.x), std::min(a.y, b.y)}), real({std::max(a.x, b.x), std::max(a.y, b.y)})};
}

/// The least box around forms.
Box boxOf(std::span<const Form> forms);

/// A polygon around a form, counter-clockwise and rounded to the lattice.
std::vector<Point> outlineOf(const Form& form);

/// How deep the middle is in its form: the distance to the outline.
double coreOf(const Form& form);

/// Whether some point of the line from `a` to `b` is more than so deep in a form. The depth is at least 0.
bool reaches(const Form& form, DoublePoint a, DoublePoint b, double depth);

}  // namespace lgs::box2d
