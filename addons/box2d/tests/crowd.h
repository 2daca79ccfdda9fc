// Bodies of all forms in a physics world, for whichever Box2D there is.
#pragma once

#include <lgs/box2d/terrain.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#ifdef B2_IS_NULL
#include "physics3.h"
#endif

namespace lgs::box2d_test {

/// What a body is made of. All are `size` metres long.
enum class Figure { circle, box, capsule, triangle, octagon, stick, cross, count };

/// Corners of the convex figures, for a size of 1. A stick is a tenth as thick as it is long.
inline std::vector<b2Vec2> cornersOf(Figure figure, float size) {
  const float h = size / 2;
  switch (figure) {
    case Figure::triangle:
      return {{-h, -h}, {h, -h}, {-0.3F * h, h}};
    case Figure::octagon: {
      std::vector<b2Vec2> corners;
      for (int k = 0; k < 8; ++k) {
        const float angle = 0.785398F * static_cast<float>(k);
        corners.push_back({h * std::cos(angle), h * std::sin(angle)});
      }
      return corners;
    }
    case Figure::stick:
      return {{-h, -0.1F * h}, {h, -0.1F * h}, {h, 0.1F * h}, {-h, 0.1F * h}};
    default:
      return {{-h, -h}, {h, -h}, {h, h}, {-h, h}};
  }
}

#ifndef B2_IS_NULL  // Box2D 2.4

class Crowd {
 public:
  using Body = b2Body*;
  using Position = b2Vec2;

  Crowd() = default;

  Body add(Figure figure, float size, Position at) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = at;
    const Body body = physics.CreateBody(&definition);
    const float h = size / 2;
    const auto polygon = [&](const std::vector<b2Vec2>& corners) {
      b2PolygonShape shape;
      shape.Set(corners.data(), static_cast<int32>(corners.size()));
      body->CreateFixture(&shape, 1);
    };
    const auto circle = [&](b2Vec2 center, float radius) {
      b2CircleShape shape;
      shape.m_p = center;
      shape.m_radius = radius;
      body->CreateFixture(&shape, 1);
    };
    if (figure == Figure::circle) {
      circle({0, 0}, h);
    } else if (figure == Figure::capsule) {
      circle({-h / 2, 0}, h / 2);
      circle({h / 2, 0}, h / 2);
      polygon({{-h / 2, -h / 2}, {h / 2, -h / 2}, {h / 2, h / 2}, {-h / 2, h / 2}});
    } else if (figure == Figure::cross) {
      polygon({{-h, -0.3F * h}, {h, -0.3F * h}, {h, 0.3F * h}, {-h, 0.3F * h}});
      polygon({{-0.3F * h, -h}, {0.3F * h, -h}, {0.3F * h, h}, {-0.3F * h, h}});
    } else {
      polygon(cornersOf(figure, size));
    }
    bodies.push_back(body);
    return body;
  }

  /// By what the edges of the ground judge on which side a shape is.
  static std::vector<Position> middlesOf(Body body) {
    std::vector<Position> middles;
    for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
      const b2Shape& shape = *f->GetShape();
      middles.push_back(body->GetWorldPoint(shape.GetType() == b2Shape::e_circle
                                                ? static_cast<const b2CircleShape&>(shape).m_p
                                                : static_cast<const b2PolygonShape&>(shape).m_centroid));
    }
    return middles;
  }
  static Position positionOf(Body body) { return body->GetPosition(); }
  static bool areSame(Body a, Body b) { return a == b; }
  static bool isEnabled(Body body) { return body->IsEnabled(); }
  static bool isStatic(Body body) { return body->GetType() == b2_staticBody; }
  static bool isAwake(Body body) { return body->IsAwake(); }
  static bool touchesAnything(Body body) {
    const b2ContactEdge* edge = body->GetContactList();
    while (edge != nullptr && !edge->contact->IsTouching()) edge = edge->next;
    return edge != nullptr;
  }
  static void setEnabled(Body body, bool enabled) { body->SetEnabled(enabled); }
  static void kick(Body body, b2Vec2 velocity) {
    body->SetLinearVelocity(velocity);
    body->SetAwake(true);
  }
  static void put(Body body, Position at) { body->SetTransform(at, body->GetAngle()); }
  static void announce(box2d::Terrain& terrain, Body body) { terrain.moved(*body); }
  /// The next one that is added may well be at the same address.
  void destroy(std::size_t which) {
    physics.DestroyBody(bodies[which]);
    bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(which));
  }
  std::size_t bodyCount() const { return static_cast<std::size_t>(physics.GetBodyCount()); }
  void step() { physics.Step(1.0F / 60, 8, 3); }
  void moveOrigin(box2d::Terrain& terrain, Cell origin) {
    physics.ShiftOrigin(terrain.position(toWorld(origin, {})));
    terrain.moveOrigin(origin);
  }

  b2World physics{{0, -10}};
  std::vector<Body> bodies;
};

#else  // Box2D 3

class Crowd {
 public:
  using Body = b2BodyId;
  using Position = box2d::Position;

  Crowd() {
    b2WorldDef definition = b2DefaultWorldDef();
    definition.gravity = {0, -10};
    physics = b2CreateWorld(&definition);
  }
  ~Crowd() { b2DestroyWorld(physics); }
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  Body add(Figure figure, float size, Position at) {
    b2BodyDef definition = b2DefaultBodyDef();
    definition.type = b2_dynamicBody;
    definition.position = at;
    const Body body = b2CreateBody(physics, &definition);
    const b2ShapeDef shape = b2DefaultShapeDef();
    const float h = size / 2;
    if (figure == Figure::circle) {
      const b2Circle circle{{0, 0}, h};
      b2CreateCircleShape(body, &shape, &circle);
    } else if (figure == Figure::capsule) {
      const b2Capsule capsule{{-h / 2, 0}, {h / 2, 0}, h / 2};
      b2CreateCapsuleShape(body, &shape, &capsule);
    } else if (figure == Figure::cross) {
      const b2Polygon flat = b2MakeBox(h, 0.3F * h), upright = b2MakeBox(0.3F * h, h);
      b2CreatePolygonShape(body, &shape, &flat);
      b2CreatePolygonShape(body, &shape, &upright);
    } else {
      const std::vector<b2Vec2> corners = cornersOf(figure, size);
      const b2Hull hull = b2ComputeHull(corners.data(), static_cast<int>(corners.size()));
      const b2Polygon polygon = b2MakePolygon(&hull, 0);
      b2CreatePolygonShape(body, &shape, &polygon);
    }
    bodies.push_back(body);
    return body;
  }

  /// By what the edges of the ground judge on which side a shape is.
  static std::vector<Position> middlesOf(Body body) {
    std::array<b2ShapeId, 8> shapes;
    const auto count = static_cast<std::size_t>(b2Body_GetShapes(body, shapes.data(), static_cast<int>(shapes.size())));
    std::vector<Position> middles;
    for (std::size_t k = 0; k < count; ++k) middles.push_back(b2Body_GetWorldPoint(body, middleOf(shapes[k])));
    return middles;
  }
  static Position positionOf(Body body) { return b2Body_GetPosition(body); }
  static bool areSame(Body a, Body b) { return B2_ID_EQUALS(a, b); }
  static bool isEnabled(Body body) { return b2Body_IsEnabled(body); }
  static bool isStatic(Body body) { return b2Body_GetType(body) == b2_staticBody; }
  static bool isAwake(Body body) { return b2Body_IsAwake(body); }
  static bool touchesAnything(Body body) {
    std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(body)));
    return b2Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size())) > 0;
  }
  static void setEnabled(Body body, bool enabled) { enabled ? b2Body_Enable(body) : b2Body_Disable(body); }
  static void kick(Body body, b2Vec2 velocity) {
    b2Body_SetLinearVelocity(body, velocity);
    b2Body_SetAwake(body, true);
  }
  static void put(Body body, Position at) { b2Body_SetTransform(body, at, b2Body_GetRotation(body)); }
  static void announce(box2d::Terrain& terrain, Body body) { terrain.moved(body); }
  void destroy(std::size_t which) {
    b2DestroyBody(bodies[which]);
    bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(which));
  }
  std::size_t bodyCount() const { return static_cast<std::size_t>(b2World_GetCounters(physics).bodyCount); }
  void step() { b2World_Step(physics, 1.0F / 60, 4); }
  void moveOrigin(box2d::Terrain& terrain, Cell origin) {
    const Position by = terrain.position(toWorld(origin, {}));
    for (const Body body : bodies) {
      const Position at = b2Body_GetPosition(body);
      put(body, {at.x - by.x, at.y - by.y});
    }
    terrain.moveOrigin(origin);
  }

  b2WorldId physics = b2_nullWorldId;
  std::vector<Body> bodies;

 private:
  static b2Vec2 middleOf(b2ShapeId shape) {
    switch (b2Shape_GetType(shape)) {
      case b2_circleShape:
        return b2Shape_GetCircle(shape).center;
      case b2_capsuleShape: {
        const b2Capsule capsule = b2Shape_GetCapsule(shape);
        return b2Lerp(capsule.center1, capsule.center2, 0.5F);
      }
      default:
        return b2Shape_GetPolygon(shape).centroid;
    }
  }
};

#endif

}  // namespace lgs::box2d_test
