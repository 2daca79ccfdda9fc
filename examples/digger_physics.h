// The physics of digger.cpp: Box2D 2.4 or 3, with some balls.
#pragma once

#include <lgs/box2d/frame.h>
#include <lgs/box2d/physics.h>

#include <ctime>
#include <vector>

/// What this process has taken so far. Time by the clock on the wall would count what other processes take.
inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Physics {
 public:
#ifndef B2_IS_NULL  // Box2D 2.4
  b2World& world() { return world_; }
  void addBall(lgs::box2d::Place at) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = {static_cast<float>(at.x), static_cast<float>(at.y)};
    b2CircleShape circle;
    circle.m_radius = 0.2F;
    balls_.push_back(world_.CreateBody(&definition));
    balls_.back()->CreateFixture(&circle, 1);
  }
  static b2Vec2 placeOf(const b2Body* ball) { return ball->GetPosition(); }

 private:
  void doStep() { world_.Step(1.0F / 60, 8, 3); }
  b2World world_{{0, -10}};
#else  // Box2D 3
  Physics() {
    b2WorldDef definition = b2DefaultWorldDef();
    definition.gravity = {0, -10};
    world_ = b2CreateWorld(&definition);
  }
  ~Physics() { b2DestroyWorld(world_); }
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  b2WorldId world() { return world_; }
  void addBall(lgs::box2d::Place at) {
    b2BodyDef definition = b2DefaultBodyDef();
    definition.type = b2_dynamicBody;
    definition.position.x = static_cast<decltype(definition.position.x)>(at.x);
    definition.position.y = static_cast<decltype(definition.position.y)>(at.y);
    const b2ShapeDef shape = b2DefaultShapeDef();
    const b2Circle circle{{0, 0}, 0.2F};
    balls_.push_back(b2CreateBody(world_, &definition));
    b2CreateCircleShape(balls_.back(), &shape, &circle);
  }
  static lgs::box2d::Position placeOf(b2BodyId ball) { return b2Body_GetPosition(ball); }

 private:
  void doStep() { b2World_Step(world_, 1.0F / 60, 4); }
  b2WorldId world_ = b2_nullWorldId;
#endif

 public:
  /// A step of 1/60 s, and how long the last one took.
  void step() {
    const double begin = processorSeconds();
    doStep();
    seconds_ = processorSeconds() - begin;
  }
  double seconds() const { return seconds_; }

  const std::vector<lgs::box2d::BodyHandle>& balls() const { return balls_; }

 private:
  std::vector<lgs::box2d::BodyHandle> balls_;
  double seconds_ = 0;
};
