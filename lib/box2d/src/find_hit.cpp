#include "find_hit.h"

#include <algorithm>

namespace lgs::box2d {

namespace {

double squaredDistance(const Frame& frame, const Segment& s, Place point) {
  const Place a = frame.position(s.start);
  const Place b = frame.position(s.end);
  const double ux = b.x - a.x;
  const double uy = b.y - a.y;
  const double along = ((point.x - a.x) * ux + (point.y - a.y) * uy) / std::max(ux * ux + uy * uy, 1e-30);
  const double t = std::clamp(along, 0.0, 1.0);
  const double x = a.x + t * ux - point.x;
  const double y = a.y + t * uy - point.y;
  return x * x + y * y;
}

Hit hitOf(const Segment& s) { return {s.id, s.polygon, s.block, s.cell}; }

}  // namespace

// An id that a commit removes names nothing else before the next commit (ids.h).
std::optional<Hit> firstHit(const World& world, const EdgeSet& set, EdgeId id) {
  const auto s = world.segment(set.edge(id).first);
  return s ? std::optional(hitOf(*s)) : std::nullopt;
}

std::optional<Hit> nearestHit(const World& world, const EdgeSet& set, EdgeId id, const Frame& frame, Place point) {
  const SegmentId last = set.edge(id).last;
  auto s = world.segment(set.edge(id).first);
  if (!s) return {};
  Segment nearest = *s;
  double least = squaredDistance(frame, *s, point);
  // Links that the set has not seen may lead in a circle that misses the last segment. No honest walk is longer than
  // there are ids.
  for (std::uint32_t left = world.maxSegmentId(); s->id != last; --left) {
    s = world.segment(s->successor);
    if (!s || set.edgeOf(s->id) != id || left == 0) return {};
    const double distance = squaredDistance(frame, *s, point);
    if (distance < least) {
      least = distance;
      nearest = *s;
    }
  }
  return hitOf(nearest);
}

}  // namespace lgs::box2d
