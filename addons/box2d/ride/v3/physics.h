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

/// Segments that Box2D makes and destroys by itself, on one body.
class BareEdges {
 public:
  explicit BareEdges(Physics& physics) {
    const b2BodyDef body = b2DefaultBodyDef();
    body_ = b2CreateBody(physics.world(), &body);
  }
  std::size_t size() const { return shapes_.size(); }
  void make() {
    const b2ShapeDef shape = b2DefaultShapeDef();
    const b2Segment segment{{0, 0}, {1, 0}};
    shapes_.push_back(b2CreateSegmentShape(body_, &shape, &segment));
  }
  void destroy() {
    b2DestroyShape(shapes_.back(), false);
    shapes_.pop_back();
  }

 private:
  b2BodyId body_;
  std::vector<b2ShapeId> shapes_;
};

}  // namespace lgs::bench
