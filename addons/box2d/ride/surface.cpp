#include "addons/box2d/ride/surface.h"

#include <algorithm>
#include <cmath>

namespace lgs::bench {
namespace {

constexpr float kNear = 0.06F;          // metres; a few times the skin of Box2D's polygons
constexpr float kSine = 0.0174524064F;  // the sine of a degree

b2Vec2 normalOf(b2Vec2 start, b2Vec2 end) {
  b2Vec2 normal(end.y - start.y, start.x - end.x);
  normal.Normalize();
  return normal;
}

float distance(b2Vec2 a, b2Vec2 b, b2Vec2 p) {
  const b2Vec2 u = b - a;
  const float t = std::clamp(b2Dot(p - a, u) / std::max(b2Dot(u, u), 1e-12F), 0.0F, 1.0F);
  return b2Distance(p, a + t * u);
}

// Whether n lies between two normals, or less than a degree outside. `to` is counter-clockwise of `from`.
bool isBetween(b2Vec2 from, b2Vec2 n, b2Vec2 to) {
  if (b2Dot(from, n) > 0 && std::abs(b2Cross(from, n)) <= kSine) return true;
  if (b2Dot(to, n) > 0 && std::abs(b2Cross(to, n)) <= kSine) return true;
  return b2Cross(from, n) > 0 && b2Cross(n, to) > 0;
}

}  // namespace

Surface::Surface(const World& world, const box2d::Frame& frame) : frame_(frame) {
  const auto at = [&](Point p) {
    const box2d::Place m = frame.position(p);
    return b2Vec2(static_cast<float>(m.x), static_cast<float>(m.y));
  };
  for (const SegmentId id : world.segments()) {
    const Segment s = *world.segment(id);
    const b2Vec2 normal = normalOf(at(s.start), at(s.end));
    Facet facet{at(s.start), at(s.end), normal, normal};
    if (s.successor) {
      const b2Vec2 next = normalOf(at(s.end), at(s.ghost2));
      if (b2Cross(normal, next) > 0) facet.next = next;
    }
    facets_[s.cell].push_back(facet);
  }
}

bool Surface::faces(b2Vec2 point, b2Vec2 normal) const {
  const Cell low = frame_.cellAt({point.x - kNear, point.y - kNear});
  const Cell high = frame_.cellAt({point.x + kNear, point.y + kNear});
  for (std::int32_t i = low.i; i <= high.i; ++i) {
    for (std::int32_t j = low.j; j <= high.j; ++j) {
      const auto here = facets_.find({i, j});
      if (here == facets_.end()) continue;
      for (const Facet& f : here->second) {
        if (distance(f.start, f.end, point) > kNear) continue;
        const bool atCorner = b2Distance(point, f.end) <= kNear;
        if (isBetween(f.normal, normal, atCorner ? f.next : f.normal)) return true;
      }
    }
  }
  return false;
}

}  // namespace lgs::bench
