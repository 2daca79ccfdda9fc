// How two polygons lie to each other, decided on integers. Once crossings are ruled out, each edge, cut at the other
// polygon's vertices, lies in one piece inside, outside or on the other polygon, and so its midpoint tells where.
#include "geometry.h"

#include <algorithm>

namespace lgs::tiled {
namespace {

enum class Place : std::uint8_t { outside, inside, on };

Point doubled(Point p) { return {2 * p.x, 2 * p.y}; }

bool strictlyOpposite(std::int64_t a, std::int64_t b) { return (a > 0 && b < 0) || (a < 0 && b > 0); }

bool anyCrossing(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point p = a[i], q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Point r = b[j], s = b[(j + 1) % b.size()];
      if (strictlyOpposite(cross(p, q, r), cross(p, q, s)) && strictlyOpposite(cross(r, s, p), cross(r, s, q))) {
        return true;
      }
    }
  }
  return false;
}

/// What an atomic edge sees of the other polygon.
struct Sight {
  bool inside = false, outside = false, sameWay = false;
};

/// Where the middle of u→v lies; on b's boundary it also tells whether b's edge runs the same way.
void look(Point u, Point v, const Polygon& b, Sight& sight) {
  const Point middle{u.x + v.x, u.y + v.y};  // doubled
  bool inside = false;
  for (std::size_t j = 0; j < b.size(); ++j) {
    const Point r = doubled(b[j]), s = doubled(b[(j + 1) % b.size()]);
    const std::int64_t side = cross(r, s, middle);
    if (side == 0 && std::min(r.x, s.x) <= middle.x && middle.x <= std::max(r.x, s.x) &&
        std::min(r.y, s.y) <= middle.y && middle.y <= std::max(r.y, s.y)) {
      sight.sameWay |= (v.x - u.x) * (s.x - r.x) + (v.y - u.y) * (s.y - r.y) > 0;
      return;
    }
    if ((r.y <= middle.y) != (s.y <= middle.y) && (side > 0) == (s.y > r.y)) inside = !inside;
  }
  (inside ? sight.inside : sight.outside) = true;
}

Sight sightOf(const Polygon& a, const Polygon& b) {
  Sight sight;
  Polygon cuts;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point p = a[i], q = a[(i + 1) % a.size()];
    const auto along = [&](Point r) { return (r.x - p.x) * (q.x - p.x) + (r.y - p.y) * (q.y - p.y); };
    cuts = {p, q};
    for (Point r : b) {
      if (cross(p, q, r) == 0 && along(r) > 0 && along(r) < along(q)) cuts.push_back(r);
    }
    std::sort(cuts.begin(), cuts.end(), [&](Point l, Point r) { return along(l) < along(r); });
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) look(cuts[k], cuts[k + 1], b, sight);
  }
  return sight;
}

}  // namespace

Relation relation(const Polygon& a, const Polygon& b) {
  const Box boxA = boxOf(a), boxB = boxOf(b);
  if (boxA.max.x <= boxB.min.x || boxB.max.x <= boxA.min.x || boxA.max.y <= boxB.min.y || boxB.max.y <= boxA.min.y) {
    return Relation::apart;
  }
  if (anyCrossing(a, b)) return Relation::overlap;
  const Sight ofA = sightOf(a, b);
  if (!ofA.outside && (ofA.inside || ofA.sameWay)) return Relation::inside;
  if (ofA.inside || ofA.sameWay || sightOf(b, a).inside) return Relation::overlap;
  return Relation::apart;
}

}  // namespace lgs::tiled
