#include "rounding.h"

#include <algorithm>
#include <cstdlib>

namespace lgs::tiled {
namespace {

/// Whether p lies within two lattice units of r→s.
bool isNear(Point p, Point r, Point s) {
  constexpr std::int64_t kSlack = 2;
  const std::int64_t longer = std::max(std::abs(s.x - r.x), std::abs(s.y - r.y));
  return p.x >= std::min(r.x, s.x) - kSlack && p.x <= std::max(r.x, s.x) + kSlack &&
         p.y >= std::min(r.y, s.y) - kSlack && p.y <= std::max(r.y, s.y) + kSlack &&
         std::abs(cross(s - r, p - r)) <= kSlack * longer;
}

}  // namespace

bool nearlyInside(const Polygon& a, const Polygon& b) {
  return std::all_of(a.begin(), a.end(), [&](Point p) {
    if (isStrictlyInside(p, b)) return true;
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (isNear(p, b[j], nextVertex(b, j))) return true;
    }
    return false;
  });
}

Polygon bentAround(const Polygon& a, const Polygon& b) {
  Polygon bent;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point p = a[i], q = nextVertex(a, i);
    const auto along = [&](Point r) { return dot(r - p, q - p); };
    Polygon passed;
    for (Point r : b) {
      if (along(r) > 0 && along(r) < along(q) && isNear(r, p, q)) passed.push_back(r);
    }
    std::sort(passed.begin(), passed.end(), [&](Point l, Point r) { return along(l) < along(r); });
    bent.push_back(p);
    bent.insert(bent.end(), passed.begin(), passed.end());
  }
  return bent;
}

}  // namespace lgs::tiled
