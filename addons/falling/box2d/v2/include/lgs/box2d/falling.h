// Islands as bodies of Box2D 2.4: see lgs/box2d/falling_ground.h.
#pragma once

#include <lgs/box2d/falling_parts.h>
#include <lgs/box2d/terrain.h>

#include <cmath>
#include <vector>

namespace lgs::box2d {

/// Of one step down, as gravity pulls: where there is none the length is 0.
inline Place downOf(b2World& physics) {
  const b2Vec2 g = physics.GetGravity();
  const double length = std::hypot(double{g.x}, double{g.y});
  return length > 0 ? Place{g.x / length, g.y / length} : Place{};
}

/// How far two shapes that rest on each other may be apart: their skins, but for the slop.
inline double restingGap(b2World& /*physics*/) { return 2 * b2_polygonRadius; }
inline double slopOf(b2World& /*physics*/) { return b2_linearSlop; }

/// A dynamic body at rest, with its origin at a place; null, if it would have no shape.
template <class MaterialOf>
b2Body* makeBody(b2World& physics, b2Vec2 at, const std::vector<FallingPart>& parts, const FallingMass& mass,
                 const MaterialOf& materialOf) {
  if (parts.empty()) return nullptr;
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = at;
  b2Body* const body = physics.CreateBody(&definition);
  for (const FallingPart& part : parts) {
    std::vector<b2Vec2> corners;
    for (const Place& p : part.corners) corners.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    b2PolygonShape shape;
    shape.Set(corners.data(), static_cast<int32>(corners.size()));
    b2FixtureDef fixture = definitionOf(materialOf(part.block));
    fixture.shape = &shape;
    body->CreateFixture(&fixture);
  }
  const b2Vec2 center{static_cast<float>(mass.center.x), static_cast<float>(mass.center.y)};
  b2MassData data;
  data.mass = static_cast<float>(mass.mass);
  data.center = center;
  data.I = static_cast<float>(mass.inertia) + data.mass * b2Dot(center, center);  // about the origin
  body->SetMassData(&data);
  return body;
}

/// How a body lies: its origin in metres, and its angle.
struct Lying {
  b2Vec2 origin;
  double cosine, sine;
};
inline Lying lyingOf(const b2Body* body) {
  const b2Transform& at = body->GetTransform();
  return {at.p, at.q.c, at.q.s};
}

/// Whether the ground leaves room for a body that is moved by so much.
inline bool fitsBy(Terrain& terrain, const b2Body* body, b2Vec2 by) {
  b2Transform at = body->GetTransform();
  at.p += by;
  return terrain.fits(*body, at);
}

inline void noteWhereItIs(Terrain& terrain, const b2Body* body) { terrain.moved(*body); }
inline void destroyBody(b2World& physics, b2Body* body) { physics.DestroyBody(body); }

}  // namespace lgs::box2d

#include <lgs/box2d/falling_ground.h>
