// A world of Box2D 3 for tests, and what its versions have different names for (addons/box2d/v3/src/segment_shape.h).
#pragma once

#include "field.h"

#include <gtest/gtest.h>
#include <lgs/box2d/terrain.h>
#include <vector>

namespace lgs::box2d_test {

class Physics3 : public testing::Test {
 protected:
  Physics3() {
    b2WorldDef definition = b2DefaultWorldDef();
    definition.gravity = {0, -10};
    physics = b2CreateWorld(&definition);
  }
  ~Physics3() override { b2DestroyWorld(physics); }
  Physics3(const Physics3&) = delete;
  Physics3& operator=(const Physics3&) = delete;

  b2BodyId addBall(box2d::Position at, float friction, bool sensor = false) const {
    b2BodyDef definition = b2DefaultBodyDef();
    definition.type = b2_dynamicBody;
    definition.position = at;
    const b2BodyId body = b2CreateBody(physics, &definition);
    b2ShapeDef shape = b2DefaultShapeDef();
    shape.material.friction = friction;
    shape.isSensor = sensor;
    shape.enableSensorEvents = sensor;
    const b2Circle circle{{0, 0}, 0.35F};
    b2CreateCircleShape(body, &shape, &circle);
    return body;
  }
  void step(int times) const {
    for (int k = 0; k < times; ++k) b2World_Step(physics, 1.0F / 60, 4);
  }
  float heightOf(b2BodyId body) const { return static_cast<float>(b2Body_GetPosition(body).y); }

  b2WorldId physics = b2_nullWorldId;
  Field field;
};

/// A chain through these points. An open one begins and ends with a ghost. Box2D's #1107 gave these names of their own.
template <class ChainDef>
void setPoints(ChainDef& chain, const std::vector<b2Vec2>& points, bool loop) {
  const int count = static_cast<int>(points.size());
  chain.isLoop = loop;
  chain.points = points.data();
  if constexpr (requires { chain.pointCount; }) {
    chain.pointCount = count;
    if (loop) return;
    chain.points = points.data() + 1;
    chain.pointCount = count - 2;
    chain.ghostBegin = points.front();
    chain.ghostEnd = points.back();
  } else {
    chain.count = count;
  }
}

}  // namespace lgs::box2d_test
