// A world of Box2D 3, as terrain_costs.cpp needs it.
#pragma once

#include <lgs/box2d/physics.h>

#include <cstddef>
#include <vector>

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
  void addBox(box2d::Position at, float half) {
    b2BodyDef body = b2DefaultBodyDef();
    body.type = b2_dynamicBody;
    body.position = at;
    const b2ShapeDef shape = b2DefaultShapeDef();
    const b2Polygon box = b2MakeSquare(half);
    bodies_.push_back(b2CreateBody(world_, &body));
    b2CreatePolygonShape(bodies_.back(), &shape, &box);
  }
  box2d::Position placeOf(std::size_t box) const { return b2Body_GetPosition(bodies_[box]); }
  void step() { b2World_Step(world_, 1.0F / 60, 4); }

 private:
  b2WorldId world_;
  std::vector<b2BodyId> bodies_;
};

}  // namespace lgs::bench
