// A world of Box2D 2.4, as terrain_costs.cpp needs it.
#pragma once

#include <box2d/box2d.h>

namespace lgs::bench {

class Physics {
 public:
  b2World& world() { return world_; }
  void addBody() {
    b2BodyDef body;
    body.type = b2_dynamicBody;
    world_.CreateBody(&body);
  }
  void step() { world_.Step(1.0F / 60, 8, 3); }

 private:
  b2World world_{{0, -10}};
};

}  // namespace lgs::bench
