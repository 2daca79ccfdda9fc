// What tests of the terrain need of whichever Box2D there is.
#pragma once

#include "field.h"

#include <gtest/gtest.h>
#include <lgs/box2d/terrain.h>
#include <span>
#include <vector>

namespace lgs::box2d_test {
enum class Form { ball, box, point };
}  // namespace lgs::box2d_test

#ifndef B2_IS_NULL  // Box2D 2.4

#include "fixtures.h"

namespace lgs::box2d_test {

using Position = b2Vec2;
using Body = b2Body*;

class EitherBox2d : public testing::Test {
 protected:
  /// It does not turn. Its radius, or half its width, is 0.35.
  Body addBody(Position at, Form form, float friction) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = at;
    definition.fixedRotation = true;
    const Body body = physics.CreateBody(&definition);
    b2CircleShape circle;
    circle.m_radius = form == Form::point ? 0 : 0.35F;
    b2PolygonShape box;
    box.SetAsBox(0.35F, 0.35F);
    const b2Shape& shape = form == Form::box ? static_cast<const b2Shape&>(box) : circle;
    body->CreateFixture(&shape, 1)->SetFriction(friction);
    return body;
  }
  void destroy(Body body) { physics.DestroyBody(body); }
  static Position positionOf(Body body) { return body->GetPosition(); }
  static b2Vec2 velocityOf(Body body) { return body->GetLinearVelocity(); }
  static void setVelocity(Body body, b2Vec2 velocity) { body->SetLinearVelocity(velocity); }
  static void moveTo(Body body, Position at) {
    body->SetTransform(at, 0);
    body->SetAwake(true);
  }
  void step(int times) {
    for (int k = 0; k < times; ++k) physics.Step(1.0F / 60, 8, 3);
  }
  static bool isAwake(Body body) { return body->IsAwake(); }
  static void letSleep(Body body) { body->SetAwake(false); }
  static b2Transform transformOf(Body body) { return body->GetTransform(); }
  /// All contacts of a body, also with what is only near.
  static std::size_t contactCount(Body body) {
    std::size_t count = 0;
    for (const b2ContactEdge* c = body->GetContactList(); c != nullptr; c = c->next) ++count;
    return count;
  }
  static std::vector<Cell> touchedCells(const box2d::Terrain& terrain, Body body) {
    std::vector<Cell> cells;
    for (const b2ContactEdge* c = body->GetContactList(); c != nullptr; c = c->next)
      if (const auto touch = terrain.hit(*c->contact)) cells.push_back(touch->hit.cell);
    return cells;
  }
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

#else  // Box2D 3

#include "physics3.h"
#include "shapes3.h"

namespace lgs::box2d_test {

using box2d::Position;
using Body = b2BodyId;

/// Box2D 3.2 has a lock for each way to move.
template <class BodyDef>
void doNotTurn(BodyDef& definition) {
  if constexpr (requires { definition.fixedRotation; }) {
    definition.fixedRotation = true;
  } else {
    definition.motionLocks.angularZ = true;
  }
}

class EitherBox2d : public Physics3 {
 protected:
  Body addBody(Position at, Form form, float friction) {
    b2BodyDef definition = b2DefaultBodyDef();
    definition.type = b2_dynamicBody;
    definition.position = at;
    doNotTurn(definition);
    const Body body = b2CreateBody(physics, &definition);
    b2ShapeDef shape = b2DefaultShapeDef();
    shape.material.friction = friction;
    const b2Circle circle{{0, 0}, form == Form::point ? 0 : 0.35F};
    const b2Polygon box = b2MakeBox(0.35F, 0.35F);
    if (form != Form::box) {
      b2CreateCircleShape(body, &shape, &circle);
    } else {
      b2CreatePolygonShape(body, &shape, &box);
    }
    return body;
  }
  static void destroy(Body body) { b2DestroyBody(body); }
  static Position positionOf(Body body) { return b2Body_GetPosition(body); }
  static b2Vec2 velocityOf(Body body) { return b2Body_GetLinearVelocity(body); }
  static void setVelocity(Body body, b2Vec2 velocity) { b2Body_SetLinearVelocity(body, velocity); }
  static void moveTo(Body body, Position at) {
    b2Body_SetTransform(body, at, b2Rot_identity);
    b2Body_SetAwake(body, true);
  }
  static bool isAwake(Body body) { return b2Body_IsAwake(body); }
  static void letSleep(Body body) { b2Body_SetAwake(body, false); }
  static auto transformOf(Body body) { return b2Body_GetTransform(body); }
  /// All contacts of a body, also with what is only near.
  static std::size_t contactCount(Body body) { return static_cast<std::size_t>(b2Body_GetContactCapacity(body)); }
  static std::vector<Cell> touchedCells(const box2d::Terrain& terrain, Body body) {
    std::vector<b2ContactData> contacts(contactCount(body));
    const int count = b2Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size()));
    std::vector<Cell> cells;
    for (const b2ContactData& contact : std::span(contacts).first(static_cast<std::size_t>(count)))
      if (const auto touch = terrain.hit(contact)) cells.push_back(touch->hit.cell);
    return cells;
  }
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
