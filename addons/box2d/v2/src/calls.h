// What the terrain asks of Box2D 2.4. The same functions are in v3/src/calls.h, for Box2D 3.
#pragma once

#include "form.h"
#include "local_edge.h"

#include <lgs/box2d/frame.h>
#include <lgs/box2d/physics.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lgs::box2d {

/// Where a body is.
struct Pose {
  b2Vec2 p;
  b2Rot q;
  float angle = 0;  ///< that of `q`, which does not follow from it to the last bit
};

inline b2Vec2 toBox2D(Metres m) { return {m.x, m.y}; }
inline b2Vec2 toBox2D(Place p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

inline float slop() { return b2_linearSlop; }
/// New ground wakes who is not further away: who touches it, or would soon.
inline float wakingDistance() { return 0.2F * b2_lengthUnitsPerMeter; }
/// A body that is further than this from where it was noted may be another one: numbers are addresses, which come again.
/// In a step no body goes further.
inline float surelyTheSameWithin() { return b2_maxTranslation; }
/// Whether Box2D itself wakes what touched a shape that is destroyed.
inline constexpr bool kDestroyingWakes = true;

// --- the physics world

inline bool isThere(const b2World& /*physics*/) { return true; }
inline std::size_t bodyCountOf(const b2World& physics) { return static_cast<std::size_t>(physics.GetBodyCount()); }
inline void assertUnlocked([[maybe_unused]] const b2World& physics) { assert(!physics.IsLocked()); }
inline void afterMovingOf(const b2World& /*physics*/) {}

/// Calls a function for each shape whose box overlaps one that is given by two corners, the first relative to `at`.
template <class Call>
void forEachShapeIn(b2World& physics, b2Vec2 at, b2Vec2 lower, b2Vec2 upper, const Call& call) {
  struct Callback : b2QueryCallback {
    explicit Callback(const Call& to) : call(to) {}
    bool ReportFixture(b2Fixture* fixture) override {
      call(fixture);
      return true;
    }
    const Call& call;
  } callback(call);
  physics.QueryAABB(&callback, {at + lower, at + upper});
}

// --- bodies

inline const b2Body* handleOf(const b2Body& body) { return &body; }
inline std::uint64_t numberOf(const b2Body* body) { return reinterpret_cast<std::uintptr_t>(body); }
inline bool isThere(const b2Body* body) { return body != nullptr; }
inline bool isEnabled(const b2Body* body) { return body->IsEnabled(); }
inline bool canOverlap(const b2Body* body) { return body->GetType() == b2_dynamicBody && body->IsEnabled(); }

inline Pose poseOf(const b2Body* body) { return {body->GetPosition(), body->GetTransform().q, body->GetAngle()}; }
/// What Box2D can make of a place and a rotation: it sets angles.
inline Pose settled(b2Vec2 p, b2Rot q) { return {p, b2Rot(q.GetAngle()), q.GetAngle()}; }
inline Place placed(b2Vec2 local, const Pose& at) {
  const b2Vec2 p = b2Mul(b2Transform(at.p, at.q), local);
  return {p.x, p.y};
}
inline b2Vec2 velocityOf(const b2Body* body) { return body->GetLinearVelocity(); }

inline b2Body* makeStaticBody(b2World& physics, b2Vec2 at) {
  b2BodyDef definition;
  definition.position = at;
  return physics.CreateBody(&definition);
}
inline void destroyBody(b2World& physics, b2Body* body) { physics.DestroyBody(body); }
inline void wakeUp(b2Body* body) { body->SetAwake(true); }
inline void setEnabled(b2Body* body, bool enabled) { body->SetEnabled(enabled); }
inline void setVelocity(b2Body* body, b2Vec2 velocity) { body->SetLinearVelocity(velocity); }
inline void stop(b2Body* body) {
  body->SetLinearVelocity({0, 0});
  body->SetAngularVelocity(0);
}
inline void moveTo(b2Body* body, b2Vec2 at) { body->SetTransform(at, body->GetAngle()); }
inline void setPose(b2Body* body, const Pose& at) { body->SetTransform(at.p, at.angle); }

// --- shapes

inline b2Body* bodyOf(b2Fixture* fixture) { return fixture->GetBody(); }
inline bool isSensor(const b2Fixture* fixture) { return fixture->IsSensor(); }
inline b2Filter filterOf(const b2Fixture* fixture) { return fixture->GetFilterData(); }

/// Those that edges hold: edges do not collide with edges.
inline std::vector<const b2Fixture*> shapesToHold(const b2Body* body) {
  std::vector<const b2Fixture*> shapes;
  for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
    if (!f->IsSensor() && (f->GetType() == b2Shape::e_circle || f->GetType() == b2Shape::e_polygon))
      shapes.push_back(f);
  return shapes;
}

/// By this Box2D judges on which side of an edge a shape is.
inline b2Vec2 middleOf(const b2Fixture* fixture) {
  const b2Shape& shape = *fixture->GetShape();
  return shape.GetType() == b2Shape::e_circle ? static_cast<const b2CircleShape&>(shape).m_p
                                              : static_cast<const b2PolygonShape&>(shape).m_centroid;
}

/// A shape is what is within the radius of a hull.
inline std::vector<b2Vec2> hullOf(const b2Fixture* fixture) {
  if (fixture->GetType() == b2Shape::e_circle) return {middleOf(fixture)};
  const auto& polygon = static_cast<const b2PolygonShape&>(*fixture->GetShape());
  return {polygon.m_vertices, polygon.m_vertices + polygon.m_count};
}
inline float radiusOf(const b2Fixture* fixture) {
  return fixture->GetType() == b2Shape::e_circle ? fixture->GetShape()->m_radius : 0;
}

// --- segments

inline b2EdgeShape edgeShapeOf(const LocalEdge& edge) {
  b2EdgeShape shape;
  shape.SetOneSided(toBox2D(edge.ghost1), toBox2D(edge.start), toBox2D(edge.end), toBox2D(edge.ghost2));
  return shape;
}

inline b2Fixture* makeSegment(b2Body* body, EdgeId id, const Material& material, const LocalEdge& edge) {
  const b2EdgeShape shape = edgeShapeOf(edge);
  b2FixtureDef definition = definitionOf(material);
  definition.shape = &shape;
  definition.userData.pointer = id.value;
  return body->CreateFixture(&definition);
}

inline bool isMade(const b2Fixture* fixture) { return fixture != nullptr; }
inline void destroySegment(b2Fixture* fixture) { fixture->GetBody()->DestroyFixture(fixture); }

/// Gives a segment other ghosts.
inline void turnSegment(b2Fixture* fixture, b2Body* /*body*/, EdgeId /*id*/, const Material& /*material*/,
                        const LocalEdge& edge) {
  auto& shape = static_cast<b2EdgeShape&>(*fixture->GetShape());
  const b2EdgeShape with = edgeShapeOf(edge);
  shape.m_vertex0 = with.m_vertex0;
  shape.m_vertex3 = with.m_vertex3;
}

}  // namespace lgs::box2d
