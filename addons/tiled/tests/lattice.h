// All polygons of a tiny lattice, and slow rules for them that are plainly right.
#pragma once

#include "addons/tiled/src/pixel_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lgs::tiled {

/// For messages: "0,0 5,0 5,5".
inline std::string text(const Polygon& ring) {
  std::string result;
  for (Point p : ring) result += (result.empty() ? "" : " ") + std::to_string(p.x) + "," + std::to_string(p.y);
  return result;
}

/// Calls visit for every sequence of `length` points of a lattice of side × side points, `step` units apart. Stops when
/// an assertion fails.
template <class Visit>
void forAllRings(std::size_t length, std::int64_t side, std::int64_t step, Visit&& visit) {
  std::int64_t total = 1;
  for (std::size_t k = 0; k < length; ++k) total *= side * side;
  Polygon ring(length);
  for (std::int64_t code = 0; code < total && !testing::Test::HasFatalFailure(); ++code) {
    std::int64_t rest = code;
    for (Point& p : ring) {
      p = {rest % side * step, rest / side % side * step};
      rest /= side * side;
    }
    visit(std::as_const(ring));
  }
}

/// How many points two closed segments have in common: 0, 1, or 2 for infinitely many.
inline int common(Point a, Point b, Point c, Point d) {
  const auto det = [](Point p, Point q) { return p.x * q.y - p.y * q.x; };
  const Point u{b.x - a.x, b.y - a.y}, v{d.x - c.x, d.y - c.y}, w{c.x - a.x, c.y - a.y};
  if (const std::int64_t den = det(u, v); den != 0) {  // the lines meet in a + u·t/den = c + v·s/den
    const std::int64_t t = det(w, v), s = det(w, u);
    const auto onSegment = [&](std::int64_t k) { return den > 0 ? k >= 0 && k <= den : k <= 0 && k >= den; };
    return onSegment(t) && onSegment(s) ? 1 : 0;
  }
  if (det(u, w) != 0 || det(v, w) != 0) return 0;
  const Point low = std::max(std::min(a, b), std::min(c, d)), high = std::min(std::max(a, b), std::max(c, d));
  return low == high ? 1 : low < high ? 2 : 0;
}

/// Whether each edge has a length, neighbours have one point in common, and other edges none.
inline bool isSimpleByRule(const Polygon& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (ring[i] == ring[(i + 1) % n]) return false;
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      if (common(ring[i], ring[(i + 1) % n], ring[j], ring[(j + 1) % n]) != (neighbours ? 1 : 0)) return false;
    }
  }
  return true;
}

/// All simple counter-clockwise rings of 3 to `most` points, each once.
inline std::vector<Polygon> simpleRings(std::size_t most, std::int64_t side, std::int64_t step) {
  std::vector<Polygon> rings;
  for (std::size_t length = 3; length <= most; ++length) {
    forAllRings(length, side, step, [&](const Polygon& ring) {
      if (std::min_element(ring.begin(), ring.end()) == ring.begin() && doubleArea(ring) > 0 && isSimpleByRule(ring)) {
        rings.push_back(ring);
      }
    });
  }
  return rings;
}

// --- Areas of common parts, in floating point ------------------------------------------------------------------------

using RealRing = std::vector<DoublePoint>;

inline RealRing realRing(const Polygon& ring) {
  RealRing result;
  for (Point p : ring) result.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  return result;
}

inline double areaOf(const RealRing& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const DoublePoint a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += (a.x * b.y - a.y * b.x) / 2;
  }
  return sum;
}

/// The part of a ring on the left of a line, by the algorithm of Sutherland and Hodgman. Its pieces are joined along
/// the line, but its area is right.
inline RealRing leftOf(const RealRing& ring, Point from, Point to) {
  const double fromX = static_cast<double>(from.x), fromY = static_cast<double>(from.y);
  const double dx = static_cast<double>(to.x) - fromX, dy = static_cast<double>(to.y) - fromY;
  const auto side = [&](DoublePoint p) { return dx * (p.y - fromY) - dy * (p.x - fromX); };
  RealRing result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const DoublePoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const double sideA = side(a), sideB = side(b);
    if (sideA >= 0) result.push_back(a);
    if ((sideA > 0 && sideB < 0) || (sideA < 0 && sideB > 0)) {
      const double part = sideA / (sideA - sideB);
      result.push_back({a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part});
    }
  }
  return result;
}

/// The area that two simple counter-clockwise rings have in common. b is taken as a sum of signed triangles.
inline double commonArea(const Polygon& a, const Polygon& b) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < b.size(); ++i) {
    Point u = b[i], v = b[i + 1];
    const int turn = orientation(b[0], u, v);
    if (turn == 0) continue;
    if (turn < 0) std::swap(u, v);
    const double area = areaOf(leftOf(leftOf(leftOf(realRing(a), b[0], u), u, v), v, b[0]));
    sum += turn > 0 ? area : -area;
  }
  return sum;
}

}  // namespace lgs::tiled
