// What the terrain calls the things of Box2D 2.4, and what a block is like there.
#pragma once

#include <box2d/box2d.h>

namespace lgs::box2d {

using Physics = b2World&;               ///< the physics world
using BodyArgument = const b2Body&;     ///< a body, as an argument
using BodyHandle = b2Body*;             ///< a body that the terrain names
using ConstBodyHandle = const b2Body*;  ///< a body that is only read
using Shape = b2Fixture;                ///< a shape, as an argument
using ShapeHandle = b2Fixture*;         ///< a shape that the terrain names
using SegmentShape = b2Fixture*;        ///< a segment in Box2D
using Position = b2Vec2;                ///< a place in the physics world

/// What a block is like. The defaults are Box2D's.
struct Material {
  float friction = 0.2F;                                       ///< 0 or more
  float restitution = 0;                                       ///< 0 … 1
  float restitutionThreshold = 1.0F * b2_lengthUnitsPerMeter;  ///< metres a second; slower bodies do not bounce
  b2Filter filter = {};                                        ///< what it collides with
  bool isPassable = false;  ///< bodies may be inside, as in a one-way platform: new ground of it overlaps no body
  friend bool operator==(const Material& a, const Material& b);
};

/// Box2D's defaults for a fixture, but for what the material has. `isPassable` is the terrain's alone.
inline b2FixtureDef definitionOf(const Material& material) {
  b2FixtureDef definition;
  definition.friction = material.friction;
  definition.restitution = material.restitution;
  definition.restitutionThreshold = material.restitutionThreshold;
  definition.filter = material.filter;
  return definition;
}

}  // namespace lgs::box2d
