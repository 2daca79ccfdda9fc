// A world of Box2D 2.4, as terrain_costs.cpp needs it.
#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <vector>

namespace lgs::bench {

class Physics {
 public:
  b2World& world() { return world_; }
  void addBody() {
    b2BodyDef body;
    body.type = b2_dynamicBody;
    world_.CreateBody(&body);
  }
  void addBox(b2Vec2 at, float half) {
    b2BodyDef body;
    body.type = b2_dynamicBody;
    body.position = at;
    b2PolygonShape box;
    box.SetAsBox(half, half);
    bodies_.push_back(world_.CreateBody(&body));
    bodies_.back()->CreateFixture(&box, 1);
  }
  b2Vec2 placeOf(std::size_t box) const { return bodies_[box]->GetPosition(); }
  void step() { world_.Step(1.0F / 60, 8, 3); }

 private:
  b2World world_{{0, -10}};
  std::vector<b2Body*> bodies_;
};

/// Edges that Box2D makes and destroys by itself, on one body.
class BareEdges {
 public:
  explicit BareEdges(Physics& physics) {
    b2BodyDef body;
    body_ = physics.world().CreateBody(&body);
  }
  std::size_t size() const { return fixtures_.size(); }
  void make() {
    b2EdgeShape edge;
    edge.SetOneSided({-1, 0}, {0, 0}, {1, 0}, {2, 0});
    fixtures_.push_back(body_->CreateFixture(&edge, 0));
  }
  void destroy() {
    body_->DestroyFixture(fixtures_.back());
    fixtures_.pop_back();
  }

 private:
  b2Body* body_;
  std::vector<b2Fixture*> fixtures_;
};

}  // namespace lgs::bench
