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

Segment nearestSegment(const World& world, const Edge& edge, const Frame& frame, Metres point) {
  Segment s = *world.segment(edge.first);
  Segment nearest = s;
  double least = squaredDistance(frame, s, point);
  while (s.id != edge.last) {
    s = *world.segment(s.successor);
    const double distance = squaredDistance(frame, s, point);
    if (distance < least) {
      least = distance;
      nearest = s;
    }
  }
  return nearest;
}

}  // namespace lgs::box2d
