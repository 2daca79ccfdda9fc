// Islands as bodies of Box2D 2.4: see lgs/box2d/falling_ground.h.
#pragma once

#include <lgs/box2d/falling_parts.h>
#include <lgs/box2d/terrain.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lgs::box2d {

inline bool isPhysicsThere(b2World& /*physics*/) { return true; }

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
  const float ofMiddle = data.mass * b2Dot(center, center);
  // About the origin. Box2D takes the part of the middle off again, and of a body far from its origin nothing may be left.
  data.I = std::max(static_cast<float>(mass.inertia) + ofMiddle, std::nextafter(ofMiddle, HUGE_VALF));
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

/// How a body moves: its centre of mass, in metres a second, and radians a second.
struct Moving {
  b2Vec2 velocity;
  float spin;
};
inline Moving movingOf(const b2Body* body) { return {body->GetLinearVelocity(), body->GetAngularVelocity()}; }
inline void setMotion(b2Body* body, Place origin, double cosine, double sine, Moving moving) {
  body->SetTransform({static_cast<float>(origin.x), static_cast<float>(origin.y)},
                     static_cast<float>(std::atan2(sine, cosine)));
  body->SetLinearVelocity(moving.velocity);
  body->SetAngularVelocity(moving.spin);
}
/// Whether a body touches the ground.
inline bool touchesGround(const Terrain& terrain, b2Body* body) {
  const b2ContactEdge* edge = body->GetContactList();
  while (edge != nullptr && !terrain.hit(*edge->contact)) edge = edge->next;
  return edge != nullptr;
}
inline b2Vec2 middleOfMass(const b2Body* body) { return body->GetWorldCenter(); }
inline bool isEnabled(const b2Body* body) { return body->IsEnabled(); }
inline void enable(b2Body* body, bool enabled) { body->SetEnabled(enabled); }
inline void makeStatic(b2Body* body) { body->SetType(b2_staticBody); }

/// Calls a function for each dynamic body that is enabled; or only for those that moved in the last step, at least.
template <class Call>
void forEachBody(b2World& physics, const Terrain& /*terrain*/, bool moved, const Call& call) {
  for (b2Body* body = physics.GetBodyList(); body != nullptr; body = body->GetNext())
    if (body->GetType() == b2_dynamicBody && body->IsEnabled() && (body->IsAwake() || !moved)) call(body);
}

inline void noteWhereItIs(Terrain& terrain, const b2Body* body) { terrain.moved(*body); }
inline void destroyBody(b2World& physics, b2Body* body) { physics.DestroyBody(body); }

}  // namespace lgs::box2d

#include <lgs/box2d/falling_ground.h>
