// What the terrain calls the things of Box2D 3, and what a block is like there.
#pragma once

#include <box2d/box2d.h>

namespace lgs::box2d {

using Physics = b2WorldId;         ///< the physics world
using BodyArgument = b2BodyId;     ///< a body, as an argument
using BodyHandle = b2BodyId;       ///< a body that the terrain names
using ConstBodyHandle = b2BodyId;  ///< a body that is only read
using Shape = b2ShapeId;           ///< a shape, as an argument
using ShapeHandle = b2ShapeId;     ///< a shape that the terrain names

/// A segment in Box2D. Before 3.2 it is part of a chain.
struct SegmentShape {
  b2ShapeId shape = b2_nullShapeId;  ///< the chain segment
  b2ChainId chain = b2_nullChainId;  ///< the chain that it is part of; null from 3.2 on
};

/// A place in the physics world: b2Pos, which is b2Vec2 unless Box2D was built with BOX2D_DOUBLE_PRECISION. Before 3.2
/// Box2D has b2Vec2 alone.
using Position = decltype(b2BodyDef::position);

/// What a block is like. The defaults are Box2D's. The flags are those of b2ShapeDef. Sensor events need
/// theirs on both shapes, the others on one of the two. (In 2.4 listeners get every contact without a flag.)
struct Material {
  b2SurfaceMaterial surface = b2DefaultSurfaceMaterial();  ///< friction and the like
  b2Filter filter = b2DefaultFilter();                     ///< what it collides with
  bool enableSensorEvents = false;                         ///< sensors see the block
  bool enableContactEvents = false;                        ///< as in b2ShapeDef
  bool enableHitEvents = false;                            ///< as in b2ShapeDef
  bool enablePreSolveEvents = false;                       ///< as in b2ShapeDef
  bool enableCustomFiltering = false;                      ///< before 3.2 Box2D calls the custom filter for all shapes
  bool isPassable = false;  ///< bodies may be inside, as in a one-way platform: new ground of it overlaps no body
  friend bool operator==(const Material& a, const Material& b);
};

/// Box2D's defaults for a shape, but for what the material has. `isPassable` is the terrain's alone.
inline b2ShapeDef definitionOf(const Material& material) {
  b2ShapeDef definition = b2DefaultShapeDef();
  definition.material = material.surface;
  definition.filter = material.filter;
  definition.enableSensorEvents = material.enableSensorEvents;
  definition.enableContactEvents = material.enableContactEvents;
  definition.enableHitEvents = material.enableHitEvents;
  definition.enablePreSolveEvents = material.enablePreSolveEvents;
  [&](auto& d) {
    if constexpr (requires { d.enableCustomFiltering; }) d.enableCustomFiltering = material.enableCustomFiltering;
  }(definition);
  return definition;
}

}  // namespace lgs::box2d
