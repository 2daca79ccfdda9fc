#include "nearest.h"

#include <algorithm>

namespace lgs::box2d {

namespace {

double squaredDistance(const Frame& frame, const Segment& s, Metres point) {
  const Metres a = frame.position(s.start);
  const Metres b = frame.position(s.end);
  const double ux = b.x - a.x;
  const double uy = b.y - a.y;
  const double along = ((point.x - a.x) * ux + (point.y - a.y) * uy) / std::max(ux * ux + uy * uy, 1e-30);
  const double t = std::clamp(along, 0.0, 1.0);
  const double x = a.x + t * ux - point.x;
  const double y = a.y + t * uy - point.y;
  return x * x + y * y;
}

}  // namespace

// An id that a commit removes names nothing else before the next commit (ids.h).
std::optional<Segment> firstSegment(const World& world, const EdgeSet& set, EdgeId id) {
  const auto s = world.segment(set.edge(id).first);
  return s ? std::optional(*s) : std::nullopt;
}

std::optional<Segment> nearestSegment(const World& world, const EdgeSet& set, EdgeId id, const Frame& frame,
                                      Metres point) {
  const SegmentId last = set.edge(id).last;
  std::optional<Segment> s = firstSegment(world, set, id);
  std::optional<Segment> nearest = s;
  double least = s ? squaredDistance(frame, *s, point) : 0;
  // Links that the set has not seen may lead in a circle past the last segment: no walk is longer than there are ids.
  for (std::uint32_t left = world.maxSegmentId(); s && s->id != last; --left) {
    const auto next = world.segment(s->successor);
    if (!next || set.edgeOf(next->id) != id || left == 0) return {};
    s = *next;
    const double distance = squaredDistance(frame, *s, point);
    if (distance < least) {
      least = distance;
      nearest = s;
    }
  }
  return nearest;
}

}  // namespace lgs::box2d
