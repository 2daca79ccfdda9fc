// What the versions of Box2D 3 have different names for. The compiler looks into the headers of the Box2D that it
// compiles with, so this does not lean on version numbers: versions between two releases have the same number and not
// the same functions. What a Box2D may lack is named in templates only, in branches that are then left out.
#pragma once

#include <lgs/box2d/physics.h>

namespace lgs::box2d {

/// Whether chain segments can be made without a chain, and changed.
template <class Segment>
constexpr bool kLooseSegments = requires(b2BodyId body, const b2ShapeDef& definition, b2ShapeId shape,
                                         const Segment& segment) {
  b2CreateChainSegmentShape(body, &definition, &segment);
  b2Shape_SetChainSegment(shape, &segment);
};

/// A segment in an open chain of its own. What b2ChainDef has no member for is set afterwards.
template <class ChainDef>
SegmentShape makeChain(ChainDef chain, b2BodyId body, const b2ShapeDef& definition, const b2ChainSegment& segment) {
  const b2Vec2 points[] = {segment.ghost1, segment.segment.point1, segment.segment.point2, segment.ghost2};
  chain.userData = definition.userData;
  chain.points = points;
  chain.count = 4;
  chain.materials = &definition.material;
  chain.materialCount = 1;
  chain.filter = definition.filter;
  chain.enableSensorEvents = definition.enableSensorEvents;
  SegmentShape made;
  made.chain = b2CreateChain(body, &chain);
  b2Chain_GetSegments(made.chain, &made.shape, 1);
  b2Shape_EnableContactEvents(made.shape, definition.enableContactEvents);
  b2Shape_EnableHitEvents(made.shape, definition.enableHitEvents);
  b2Shape_EnablePreSolveEvents(made.shape, definition.enablePreSolveEvents);
  return made;
}

template <class Segment>
SegmentShape makeSegment(b2BodyId body, const b2ShapeDef& definition, const Segment& segment) {
  if constexpr (kLooseSegments<Segment>) {
    return {b2CreateChainSegmentShape(body, &definition, &segment), b2_nullChainId};
  } else {
    return makeChain(b2DefaultChainDef(), body, definition, segment);
  }
}

inline void destroySegment(const SegmentShape& made) {
  if (B2_IS_NON_NULL(made.chain)) {
    b2DestroyChain(made.chain);
  } else {
    b2DestroyShape(made.shape, false);
  }
}

/// Gives a segment other ghosts.
template <class Segment>
void changeSegment(SegmentShape& made, b2BodyId body, const b2ShapeDef& definition, const Segment& segment) {
  if constexpr (kLooseSegments<Segment>) {
    b2Shape_SetChainSegment(made.shape, &segment);
  } else {
    destroySegment(made);
    made = makeSegment(body, definition, segment);
  }
}

/// Calls a function for each shape whose box overlaps `box`, which is relative to `corner`.
template <class Corner>
void overlapBox(b2WorldId physics, Corner corner, b2AABB box, b2QueryFilter filter, b2OverlapResultFcn* call,
                void* context) {
  if constexpr (requires { b2World_OverlapAABB(physics, corner, box, filter, call, context); }) {
    b2World_OverlapAABB(physics, corner, box, filter, call, context);
  } else {
    b2World_OverlapAABB(physics, {b2Add(corner, box.lowerBound), b2Add(corner, box.upperBound)}, filter, call, context);
  }
}

/// Calls a function for each shape that overlaps another one, whose points are relative to `corner`.
template <class Corner, class Proxy>
void overlapShape(b2WorldId physics, Corner corner, Proxy over, b2QueryFilter filter, b2OverlapResultFcn* call,
                  void* context) {
  if constexpr (requires { b2World_OverlapShape(physics, corner, &over, filter, call, context); }) {
    b2World_OverlapShape(physics, corner, &over, filter, call, context);
  } else {
    for (int k = 0; k < over.count; ++k) over.points[k] = b2Add(over.points[k], corner);
    b2World_OverlapShape(physics, &over, filter, call, context);
  }
}

}  // namespace lgs::box2d
