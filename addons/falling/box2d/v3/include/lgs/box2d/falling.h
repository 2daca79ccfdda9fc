// Islands as bodies of Box2D 3: see lgs/box2d/falling_ground.h.
#pragma once

#include <lgs/box2d/falling_parts.h>
#include <lgs/box2d/terrain.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lgs::box2d {

/// Ids of Box2D are plain structs.
inline bool operator==(b2BodyId a, b2BodyId b) { return B2_ID_EQUALS(a, b); }

inline bool isPhysicsThere(b2WorldId physics) { return b2World_IsValid(physics); }

inline Place gravityOf(b2WorldId physics) {
  const b2Vec2 g = b2World_GetGravity(physics);
  return {g.x, g.y};
}

inline double slopOf(b2WorldId /*physics*/) { return 0.005 * double{b2GetLengthUnitsPerMeter()}; }
/// How far two shapes that rest on each other may be apart: shapes have no skin.
inline double restingGap(b2WorldId physics) { return slopOf(physics); }

/// A dynamic body at rest, with its origin at a place; null, if it would have no shape.
template <class MaterialOf>
b2BodyId makeBody(b2WorldId physics, Position at, const std::vector<FallingPart>& parts, const FallingMass& mass,
                  const MaterialOf& materialOf) {
  b2BodyId body = b2_nullBodyId;
  for (const FallingPart& part : parts) {
    std::vector<b2Vec2> corners;
    for (const Place& p : part.corners) corners.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
    const b2Hull hull = b2ComputeHull(corners.data(), static_cast<int>(corners.size()));
    if (hull.count < 3) continue;
    if (B2_IS_NULL(body)) {
      b2BodyDef definition = b2DefaultBodyDef();
      definition.type = b2_dynamicBody;
      definition.position = at;
      body = b2CreateBody(physics, &definition);
    }
    const b2Polygon polygon = b2MakePolygon(&hull, 0);
    b2ShapeDef shape = definitionOf(materialOf(part.block));
    shape.updateBodyMass = false;
    b2CreatePolygonShape(body, &shape, &polygon);
  }
  if (B2_IS_NULL(body)) return body;
  b2MassData data{};
  data.mass = static_cast<float>(mass.mass);
  data.center = {static_cast<float>(mass.center.x), static_cast<float>(mass.center.y)};
  data.rotationalInertia = static_cast<float>(mass.inertia);  // about the centre
  b2Body_SetMassData(body, data);
  return body;
}

/// How a body lies: its origin in metres, and its angle.
struct Lying {
  Position origin;
  double cosine, sine;
};
inline Lying lyingOf(b2BodyId body) {
  const b2Rot q = b2Body_GetRotation(body);
  return {b2Body_GetPosition(body), q.c, q.s};
}

/// Whether the ground leaves room for a body that is moved by so much.
inline bool fitsBy(Terrain& terrain, b2BodyId body, b2Vec2 by) {
  Position at = b2Body_GetPosition(body);
  at.x += by.x;
  at.y += by.y;
  return terrain.fits(body, at, b2Body_GetRotation(body));
}

/// How a body moves: its centre of mass, in metres a second, and radians a second.
struct Moving {
  b2Vec2 velocity;
  float spin;
};
inline Moving movingOf(b2BodyId body) { return {b2Body_GetLinearVelocity(body), b2Body_GetAngularVelocity(body)}; }
inline void setMoving(b2BodyId body, Moving moving) {
  b2Body_SetLinearVelocity(body, moving.velocity);  // who moves is awake
  b2Body_SetAngularVelocity(body, moving.spin);
}
inline void setMotion(b2BodyId body, Place origin, double cosine, double sine, Moving moving) {
  Position at{};
  at.x = static_cast<decltype(at.x)>(origin.x);
  at.y = static_cast<decltype(at.y)>(origin.y);
  b2Rot rotation;
  rotation.c = static_cast<float>(cosine);
  rotation.s = static_cast<float>(sine);
  b2Body_SetTransform(body, at, rotation);
  setMoving(body, moving);
}
/// The function has another name since a state after 3.1.
template <class Body>
Position middleOfMass(Body body) {
  if constexpr (requires { b2Body_GetWorldCenterOfMass(body); })
    return b2Body_GetWorldCenterOfMass(body);
  else
    return b2Body_GetWorldCenter(body);
}
/// What a body stands on: whether some of that is ground, and where it is touched, from its centre of mass.
struct Support {
  bool isGround = false;
  std::vector<Place> at;
};
/// Since a state after 3.1 there are no points of the world.
template <class ManifoldPoint>
Place fromMiddle(const ManifoldPoint& p, b2BodyId body, b2ShapeId shapeA) {
  if constexpr (requires { p.point; }) {
    const Position middle = middleOfMass(body);
    return {static_cast<double>(p.point.x) - static_cast<double>(middle.x),
            static_cast<double>(p.point.y) - static_cast<double>(middle.y)};
  } else {
    const b2Vec2 at = b2Shape_GetBody(shapeA) == body ? p.anchorA : p.anchorB;
    return {at.x, at.y};
  }
}
inline Support supportOf(const Terrain& terrain, b2BodyId body) {
  std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(body)));
  const int count = b2Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size()));
  contacts.resize(static_cast<std::size_t>(count));
  const float slop = 0.005F * b2GetLengthUnitsPerMeter();  // what is further away only may be touched soon
  Support support;
  for (const b2ContactData& contact : contacts) {
    support.isGround = support.isGround || terrain.hit(contact);
    for (int k = 0; k < contact.manifold.pointCount; ++k)
      if (const auto& p = contact.manifold.points[k]; p.separation <= slop)
        support.at.push_back(fromMiddle(p, body, contact.shapeIdA));
  }
  return support;
}
/// How far from its centre all of its mass would be, to turn as it does.
inline double gyrationOf(b2BodyId body) {
  return std::sqrt(double{b2Body_GetRotationalInertia(body)} / double{b2Body_GetMass(body)});
}
inline bool isEnabled(b2BodyId body) { return b2Body_IsEnabled(body); }
inline void enable(b2BodyId body, bool enabled) { enabled ? b2Body_Enable(body) : b2Body_Disable(body); }
inline void makeStatic(b2BodyId body) { b2Body_SetType(body, b2_staticBody); }

/// Calls a function for each dynamic body that is enabled; or only for those that moved in the last step, at least.
template <class Call>
void forEachBody(b2WorldId physics, const Terrain& terrain, bool moved, const Call& call) {
  std::vector<b2BodyId> bodies;
  if (moved) {
    const b2BodyEvents events = b2World_GetBodyEvents(physics);
    for (int k = 0; k < events.moveCount; ++k) bodies.push_back(events.moveEvents[k].bodyId);
  } else {
    bodies = terrain.bodiesIn(CellRect{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}});
  }
  for (const b2BodyId body : bodies)
    if (b2Body_IsValid(body) && b2Body_GetType(body) == b2_dynamicBody && b2Body_IsEnabled(body)) call(body);
}

inline void noteWhereItIs(Terrain& terrain, b2BodyId body) { terrain.moved(body); }
inline void destroyBody(b2WorldId /*physics*/, b2BodyId body) { b2DestroyBody(body); }

}  // namespace lgs::box2d

#include <lgs/box2d/falling_ground.h>
