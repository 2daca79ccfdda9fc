// What the terrain asks of Box2D 3. The same functions are in v2/src/calls.h, for Box2D 2.4.
#pragma once

#include "form.h"
#include "local_edge.h"
#include "segment_shape.h"

#include <lgs/box2d/frame.h>
#include <lgs/box2d/physics.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace lgs::box2d {

/// Where a body is.
struct Pose {
  Position p;
  b2Rot q;
};

inline b2Vec2 toBox2D(Metres m) { return {m.x, m.y}; }
inline Position toBox2D(Place p) {
  using Real = decltype(Position::x);
  return {static_cast<Real>(p.x), static_cast<Real>(p.y)};
}

inline float slop() { return 0.005F * b2GetLengthUnitsPerMeter(); }  // B2_LINEAR_SLOP is public from 3.2 on
/// New ground wakes who is not further away: who touches it, or would soon.
inline float wakingDistance() { return 0.2F * b2GetLengthUnitsPerMeter(); }
/// A body that is further than this from where it was noted may be another one. Here none is: ids have generations.
inline float surelyTheSameWithin() { return std::numeric_limits<float>::infinity(); }
/// Whether Box2D itself wakes what touched a shape that is destroyed.
inline constexpr bool kDestroyingWakes = false;

// --- the physics world

inline bool isThere(b2WorldId physics) { return b2World_IsValid(physics); }
inline std::size_t bodyCountOf(b2WorldId physics) {
  return static_cast<std::size_t>(b2World_GetCounters(physics).bodyCount);
}
inline void assertUnlocked(b2WorldId /*physics*/) {}

/// Box2D puts shapes that move back into its tree one by one. After some moves the tree would be so deep that Box2D
/// does not find all of them.
inline void afterMovingOf(b2WorldId physics) { b2World_RebuildStaticTree(physics); }

/// The default filter has one category, which the mask of a body may leave out.
inline b2QueryFilter everyShape() {
  b2QueryFilter all = b2DefaultQueryFilter();
  all.categoryBits = UINT64_MAX;
  all.maskBits = UINT64_MAX;
  return all;
}

/// Calls a function for each shape whose box overlaps one that is given by two corners, relative to `at`.
template <class Call>
void forEachShapeIn(b2WorldId physics, Position at, b2Vec2 lower, b2Vec2 upper, Call call) {
  const auto report = [](b2ShapeId shape, void* to) {
    (*static_cast<Call*>(to))(shape);
    return true;
  };
  overlapBox(physics, at, {lower, upper}, everyShape(), report, &call);
}

// --- bodies

inline b2BodyId handleOf(b2BodyId body) { return body; }
inline std::uint64_t numberOf(b2BodyId body) { return b2StoreBodyId(body); }
inline bool isThere(b2BodyId body) { return B2_IS_NON_NULL(body); }
inline bool isEnabled(b2BodyId body) { return b2Body_IsEnabled(body); }
inline bool canOverlap(b2BodyId body) { return b2Body_GetType(body) == b2_dynamicBody && b2Body_IsEnabled(body); }

inline Pose poseOf(b2BodyId body) { return {b2Body_GetPosition(body), b2Body_GetRotation(body)}; }
/// What Box2D can make of a place and a rotation.
inline Pose settled(Position p, b2Rot q) { return {p, q}; }
/// Rounded as b2Body_GetWorldPoint() rounds.
inline Place placed(b2Vec2 local, const Pose& at) {
  const b2Vec2 turned = b2RotateVector(at.q, local);
  return {at.p.x + turned.x, at.p.y + turned.y};
}
inline b2Vec2 velocityOf(b2BodyId body) { return b2Body_GetLinearVelocity(body); }

inline b2BodyId makeStaticBody(b2WorldId physics, Position at) {
  b2BodyDef definition = b2DefaultBodyDef();
  definition.position = at;
  return b2CreateBody(physics, &definition);
}
inline void destroyBody(b2WorldId /*physics*/, b2BodyId body) { b2DestroyBody(body); }
inline void wakeUp(b2BodyId body) { b2Body_SetAwake(body, true); }
inline void setEnabled(b2BodyId body, bool enabled) { enabled ? b2Body_Enable(body) : b2Body_Disable(body); }
inline void setVelocity(b2BodyId body, b2Vec2 velocity) { b2Body_SetLinearVelocity(body, velocity); }
inline void stop(b2BodyId body) {
  b2Body_SetLinearVelocity(body, {0, 0});
  b2Body_SetAngularVelocity(body, 0);
}
inline void setPose(b2BodyId body, const Pose& at) { b2Body_SetTransform(body, at.p, at.q); }
inline void moveTo(b2BodyId body, Position at) { setPose(body, {at, b2Body_GetRotation(body)}); }

// --- shapes

inline b2BodyId bodyOf(b2ShapeId shape) { return b2Shape_GetBody(shape); }
inline bool isSensor(b2ShapeId shape) { return b2Shape_IsSensor(shape); }
inline b2Filter filterOf(b2ShapeId shape) { return b2Shape_GetFilter(shape); }

/// Those that edges hold.
inline std::vector<b2ShapeId> shapesToHold(b2BodyId body) {
  std::vector<b2ShapeId> shapes(static_cast<std::size_t>(b2Body_GetShapeCount(body)));
  b2Body_GetShapes(body, shapes.data(), static_cast<int>(shapes.size()));
  std::erase_if(shapes, [](b2ShapeId shape) {
    const b2ShapeType type = b2Shape_GetType(shape);
    return b2Shape_IsSensor(shape) || (type != b2_circleShape && type != b2_capsuleShape && type != b2_polygonShape);
  });
  return shapes;
}

/// By this Box2D judges on which side of an edge a shape is.
inline b2Vec2 middleOf(b2ShapeId shape) {
  const b2ShapeType type = b2Shape_GetType(shape);
  if (type == b2_circleShape) return b2Shape_GetCircle(shape).center;
  if (type == b2_polygonShape) return b2Shape_GetPolygon(shape).centroid;
  const b2Capsule capsule = b2Shape_GetCapsule(shape);
  return b2Lerp(capsule.center1, capsule.center2, 0.5F);
}

/// A shape is what is within the radius of a hull.
inline std::vector<b2Vec2> hullOf(b2ShapeId shape) {
  const b2ShapeType type = b2Shape_GetType(shape);
  if (type == b2_circleShape) return {middleOf(shape)};
  if (type == b2_capsuleShape) {
    const b2Capsule capsule = b2Shape_GetCapsule(shape);
    return {capsule.center1, capsule.center2};
  }
  const b2Polygon polygon = b2Shape_GetPolygon(shape);
  return {polygon.vertices, polygon.vertices + polygon.count};
}
inline float radiusOf(b2ShapeId shape) {
  const b2ShapeType type = b2Shape_GetType(shape);
  if (type == b2_circleShape) return b2Shape_GetCircle(shape).radius;
  return type == b2_capsuleShape ? b2Shape_GetCapsule(shape).radius : b2Shape_GetPolygon(shape).radius;
}

// --- segments

inline void* userDataOf(EdgeId id) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(id.value));  // NOLINT(performance-no-int-to-ptr)
}

inline b2ShapeDef definitionOf(EdgeId id, const Material& material) {
  b2ShapeDef definition = definitionOf(material);
  definition.userData = userDataOf(id);
  return definition;
}

inline b2ChainSegment chainSegmentOf(const LocalEdge& edge) {
  return {toBox2D(edge.ghost1), {toBox2D(edge.start), toBox2D(edge.end)}, toBox2D(edge.ghost2), 0};
}

inline SegmentShape makeSegment(b2BodyId body, EdgeId id, const Material& material, const LocalEdge& edge) {
  return makeSegment(body, definitionOf(id, material), chainSegmentOf(edge));
}

inline bool isMade(const SegmentShape& segment) { return B2_IS_NON_NULL(segment.shape); }

/// Gives a segment other ghosts.
inline void turnSegment(SegmentShape& segment, b2BodyId body, EdgeId id, const Material& material,
                        const LocalEdge& edge) {
  changeSegment(segment, body, definitionOf(id, material), chainSegmentOf(edge));
}

}  // namespace lgs::box2d
