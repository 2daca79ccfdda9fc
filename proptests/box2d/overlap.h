// How far bodies are from a box, in doubles and the slow way.
#pragma once

#include <box2d/box2d.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lgs::box2d_test {

struct Box {
  b2Vec2 min, max;
};

struct Place {
  double x = 0, y = 0;
};

inline double distanceToEdge(Place p, b2Vec2 a, b2Vec2 b) {
  const double ux = static_cast<double>(b.x) - a.x, uy = static_cast<double>(b.y) - a.y;
  const double square = ux * ux + uy * uy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / square, 0.0, 1.0) : 0;
  return std::hypot(a.x + t * ux - p.x, a.y + t * uy - p.y);
}

inline double distanceToBox(Place p, const Box& box) {
  return std::hypot(std::max({box.min.x - p.x, p.x - box.max.x, 0.0}),
                    std::max({box.min.y - p.y, p.y - box.max.y, 0.0}));
}

/// Of two convex polygons that run counter-clockwise: a side of which one has the other one in front of it, if any.
inline bool areApart(const std::vector<b2Vec2>& one, const std::vector<b2Vec2>& other) {
  for (std::size_t k = 0; k < one.size(); ++k) {
    const b2Vec2 a = one[k], b = one[(k + 1) % one.size()];
    if (std::all_of(other.begin(), other.end(), [&](b2Vec2 p) { return b2Cross(b - a, p - a) < 0; })) return true;
  }
  return false;
}

inline double distanceBetween(const std::vector<b2Vec2>& one, const std::vector<b2Vec2>& other) {
  if (!areApart(one, other) && !areApart(other, one)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < one.size(); ++k)
    for (std::size_t n = 0; n < other.size(); ++n)
      least = std::min({least, distanceToEdge({one[k].x, one[k].y}, other[n], other[(n + 1) % other.size()]),
                        distanceToEdge({other[n].x, other[n].y}, one[k], one[(k + 1) % one.size()])});
  return least;
}

/// From a body of circles and polygons with their skin, sensors apart, to a box: less than 0 if one reaches into it.
inline double distanceBetween(const b2Body& body, const Box& box) {
  double least = std::numeric_limits<double>::infinity();
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) {
    if (f->IsSensor()) continue;
    if (f->GetType() == b2Shape::e_circle) {
      const auto& circle = static_cast<const b2CircleShape&>(*f->GetShape());
      const b2Vec2 at = body.GetWorldPoint(circle.m_p);
      least = std::min(least, distanceToBox({at.x, at.y}, box) - circle.m_radius);
      continue;
    }
    const auto& polygon = static_cast<const b2PolygonShape&>(*f->GetShape());
    std::vector<b2Vec2> corners;
    for (int k = 0; k < polygon.m_count; ++k) corners.push_back(body.GetWorldPoint(polygon.m_vertices[k]));
    const std::vector<b2Vec2> cell{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    least = std::min(least, distanceBetween(corners, cell) - b2_polygonRadius);
  }
  return least;
}

}  // namespace lgs::box2d_test
