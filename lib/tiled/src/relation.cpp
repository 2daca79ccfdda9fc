// How two polygons lie to each other, decided on integers. Once crossings are ruled out, each edge, cut at the other
// polygon's vertices, lies in one piece inside, outside or on the other polygon, and so its midpoint tells where.
#include "geometry.h"

#include <algorithm>
#include <cstdlib>

namespace lgs::tiled {
namespace {

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

/// Whether p lies within two lattice units of r→s.
bool isNear(Point p, Point r, Point s) {
  constexpr std::int64_t kSlack = 2;
  const std::int64_t longer = std::max(std::abs(s.x - r.x), std::abs(s.y - r.y));
  return p.x >= std::min(r.x, s.x) - kSlack && p.x <= std::max(r.x, s.x) + kSlack &&
         p.y >= std::min(r.y, s.y) - kSlack && p.y <= std::max(r.y, s.y) + kSlack &&
         std::abs(cross(r, s, p)) <= kSlack * longer;
}

}  // namespace

bool strictlyInside(Point p, const Polygon& ring) {
  Sight sight;
  look(p, p, ring, sight);
  return sight.inside;
}

bool nearlyInside(const Polygon& a, const Polygon& b) {
  return std::all_of(a.begin(), a.end(), [&](Point p) {
    if (strictlyInside(p, b)) return true;
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (isNear(p, b[j], b[(j + 1) % b.size()])) return true;
    }
    return false;
  });
}

Polygon bentAround(const Polygon& a, const Polygon& b) {
  Polygon bent;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point p = a[i], q = a[(i + 1) % a.size()];
    const auto along = [&](Point r) { return (r.x - p.x) * (q.x - p.x) + (r.y - p.y) * (q.y - p.y); };
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
