// Islands as bodies of Box2D 2.4: see lgs/box2d/falling_ground.h.
#pragma once

#include <lgs/box2d/falling_parts.h>
#include <lgs/box2d/terrain.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lgs::box2d {

inline bool isPhysicsThere(b2World& /*physics*/) { return true; }

inline Place gravityOf(const b2World& physics) { return {physics.GetGravity().x, physics.GetGravity().y}; }

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
inline void setMoving(b2Body* body, Moving moving) {
  body->SetLinearVelocity(moving.velocity);  // who moves is awake
  body->SetAngularVelocity(moving.spin);
}
inline void setMotion(b2Body* body, Place origin, double cosine, double sine, Moving moving) {
  body->SetTransform({static_cast<float>(origin.x), static_cast<float>(origin.y)},
                     static_cast<float>(std::atan2(sine, cosine)));
  setMoving(body, moving);
}
/// What a body stands on: whether some of that is ground, and where it is touched, from its centre of mass.
struct Support {
  bool isGround = false;
  std::vector<Place> at;
};
inline Support supportOf(const Terrain& terrain, b2Body* body) {
  const b2Vec2 middle = body->GetWorldCenter();
  Support support;
  for (const b2ContactEdge* edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
    if (!edge->contact->IsTouching()) continue;
    support.isGround = support.isGround || terrain.hit(*edge->contact);
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    for (std::int32_t k = 0; k < edge->contact->GetManifold()->pointCount; ++k)
      support.at.push_back({manifold.points[k].x - middle.x, manifold.points[k].y - middle.y});
  }
  return support;
}
/// How far from its centre all of its mass would be, to turn as it does.
inline double gyrationOf(const b2Body* body) {
  const b2Vec2 center = body->GetLocalCenter();
  return std::sqrt(double{body->GetInertia()} / body->GetMass() - double{b2Dot(center, center)});
}
inline b2Vec2 middleOfMass(const b2Body* body) { return body->GetWorldCenter(); }
inline bool isEnabled(const b2Body* body) { return body->IsEnabled(); }
inline void enable(b2Body* body, bool enabled) { body->SetEnabled(enabled); }
inline void makeStatic(b2Body* body) { body->SetType(b2_staticBody); }

/// Calls a function for each dynamic body that is enabled; or only for those that moved in the last step, at least.
template <class Call>
void forEachBody(b2World& physics, const Terrain& /*terrain*/, bool /*moved*/, const Call& call) {
  // One that falls asleep in a step has moved in it, and nothing says so: so those that sleep are visited, too.
  for (b2Body* body = physics.GetBodyList(); body != nullptr; body = body->GetNext())
    if (body->GetType() == b2_dynamicBody && body->IsEnabled()) call(body);
}

inline void noteWhereItIs(Terrain& terrain, const b2Body* body) { terrain.moved(*body); }
inline void destroyBody(b2World& physics, b2Body* body) { physics.DestroyBody(body); }

}  // namespace lgs::box2d

#include <lgs/box2d/falling_ground.h>
