#include "find_hit.h"

#include <algorithm>
#include <cmath>

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

Metres unitNormal(DoublePoint n) { return {static_cast<float>(n.x), static_cast<float>(n.y)}; }

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
  const auto& material = set.options().material;
  const auto isAlike = [&](Block block) {
    return block == nearest.block || !material || material(block) == material(nearest.block);
  };
  double least = squaredDistance(frame, *s, point);
  // Links that the set has not seen may lead in a circle that misses the last segment. No honest walk is longer than
  // there are ids.
  for (std::uint32_t left = world.maxSegmentId(); s->id != last; --left) {
    s = world.segment(s->successor);
    if (!s || set.edgeOf(s->id) != id || left == 0) return {};
    const double distance = squaredDistance(frame, *s, point);
    if (distance < least && isAlike(s->block)) {
      least = distance;
      nearest = *s;
    }
  }
  return hitOf(nearest);
}

Metres normalOf(const Edge& edge) {
  const auto x = static_cast<double>(edge.end.x - edge.start.x);
  const auto y = static_cast<double>(edge.end.y - edge.start.y);
  const double length = std::hypot(x, y);
  return {static_cast<float>(y / length), static_cast<float>(-x / length)};
}

std::optional<NearestOnFrame> nearestTo(const World& world, const Frame& frame, Place point, float radius) {
  const double cells = std::min(radius / frame.cellSize, double{kMaxRadius});
  const auto nearest = world.nearest(frame.latticePoint(point), cells);
  if (!nearest || !nearest->segment) return {};
  const Segment s = *world.segment(nearest->segment);
  return NearestOnFrame{hitOf(s), frame.position(nearest->point), unitNormal(s.normal()),
                        static_cast<float>(nearest->distance * frame.cellSize)};
}

std::optional<RayOnFrame> rayCast(const World& world, const Frame& frame, Place from, Place to) {
  const auto ray = world.rayCast(frame.latticePoint(from), frame.latticePoint(to));
  if (!ray || !ray->segment) return {};
  const Segment s = *world.segment(ray->segment);
  return RayOnFrame{hitOf(s), frame.position(ray->point), unitNormal(ray->normal), static_cast<float>(ray->fraction)};
}

}  // namespace lgs::box2d
