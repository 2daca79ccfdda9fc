// What tests of the terrain need of whichever Box2D there is.
#pragma once

#include "field.h"

#include <gtest/gtest.h>
#include <lgs/box2d/terrain.h>

#if __has_include(<box2d/b2_world.h>)  // 2.4

#include "fixtures.h"

namespace lgs::box2d_test {

using Position = b2Vec2;
using Body = b2Body*;

class EitherBox2d : public testing::Test {
 protected:
  Body addBall(Position at) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = at;
    const Body body = physics.CreateBody(&definition);
    b2CircleShape circle;
    circle.m_radius = 0.35F;
    body->CreateFixture(&circle, 1);
    return body;
  }
  void step(int times) {
    for (int k = 0; k < times; ++k) physics.Step(1.0F / 60, 8, 3);
  }
  static bool isAwake(Body body) { return body->IsAwake(); }
  std::size_t bodyCount() const { return static_cast<std::size_t>(physics.GetBodyCount()); }
  void expectEdges(const box2d::Terrain& terrain, const box2d::TerrainOptions& options) {
    expectFixtures(physics, terrain, options);
  }
  static box2d::Material withFriction(float friction) { return {.friction = friction}; }
  static float frictionOf(const box2d::Terrain& terrain, box2d::EdgeId id) {
    return terrain.fixture(id)->GetFriction();
  }

  b2World physics{{0, -10}};
  Field field;
};

}  // namespace lgs::box2d_test

#else

#include "physics3.h"
#include "shapes3.h"

namespace lgs::box2d_test {

using box2d::Position;
using Body = b2BodyId;

class EitherBox2d : public Physics3 {
 protected:
  Body addBall(Position at) { return Physics3::addBall(at, 0.5F); }
  static bool isAwake(Body body) { return b2Body_IsAwake(body); }
  std::size_t bodyCount() const { return static_cast<std::size_t>(b2World_GetCounters(physics).bodyCount); }
  void expectEdges(const box2d::Terrain& terrain, const box2d::TerrainOptions& options) {
    expectShapes(physics, terrain, options);
  }
  static box2d::Material withFriction(float friction) {
    box2d::Material material;
    material.surface.friction = friction;
    return material;
  }
  static float frictionOf(const box2d::Terrain& terrain, box2d::EdgeId id) {
    return b2Shape_GetFriction(terrain.shape(id));
  }
};

}  // namespace lgs::box2d_test

#endif
