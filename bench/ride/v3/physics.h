// A world of Box2D 3, as terrain_costs.cpp needs it.
#pragma once

#include <box2d/box2d.h>

namespace lgs::bench {

class Physics {
 public:
  Physics() {
    const b2WorldDef definition = b2DefaultWorldDef();
    world_ = b2CreateWorld(&definition);
  }
  ~Physics() { b2DestroyWorld(world_); }
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  b2WorldId world() const { return world_; }
  void addBody() {
    b2BodyDef body = b2DefaultBodyDef();
    body.type = b2_dynamicBody;
    b2CreateBody(world_, &body);
  }
  void step() { b2World_Step(world_, 1.0F / 60, 4); }

 private:
  b2WorldId world_;
};

}  // namespace lgs::bench
