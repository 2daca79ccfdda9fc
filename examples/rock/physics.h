// What the example needs of a world of Box2D 2.4 or 3.
#pragma once

#include <lgs/box2d/falling.h>

namespace examples {

#ifndef B2_IS_NULL  // Box2D 2.4

class Physics {
 public:
  b2World& world() { return world_; }
  void step() { world_.Step(1.0F / 60, 8, 3); }
  static bool isAwake(b2Body* body) { return body->IsAwake(); }
  static b2Vec2 placeOf(b2Body* body, b2Vec2 local) { return body->GetWorldPoint(local); }
  static float massOf(b2Body* body) { return body->GetMass(); }

 private:
  b2World world_{{0, -10}};
};

#else  // Box2D 3

class Physics {
 public:
  Physics() : world_(create()) {}
  ~Physics() { b2DestroyWorld(world_); }
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  b2WorldId world() const { return world_; }
  void step() { b2World_Step(world_, 1.0F / 60, 4); }
  static bool isAwake(b2BodyId body) { return b2Body_IsAwake(body); }
  static auto placeOf(b2BodyId body, b2Vec2 local) { return b2Body_GetWorldPoint(body, local); }
  static float massOf(b2BodyId body) { return b2Body_GetMass(body); }

 private:
  static b2WorldId create() {
    b2WorldDef definition = b2DefaultWorldDef();
    definition.gravity = {0, -10};
    return b2CreateWorld(&definition);
  }
  b2WorldId world_;
};

#endif

}  // namespace examples
