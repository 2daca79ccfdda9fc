#include "addons/box2d/ride/ride.h"

#include "addons/box2d/ride/surface.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lgs::bench {
namespace {

constexpr float kStep = 1.0F / 60;

void addShape(b2Body& body, const b2Shape& shape, const RideOptions& options) {
  b2FixtureDef definition;
  definition.shape = &shape;
  definition.friction = options.friction;
  definition.density = options.density;
  body.CreateFixture(&definition);
}

void addRider(b2Body& body, const RideOptions& options) {
  const auto half = static_cast<float>(options.size / 2);
  b2CircleShape circle;
  b2PolygonShape polygon;
  switch (options.rider) {
    case Rider::circle:
      circle.m_radius = half;
      addShape(body, circle, options);
      break;
    case Rider::box:
      polygon.SetAsBox(half, half);
      addShape(body, polygon, options);
      break;
    case Rider::capsule:  // a box between two circles, upright
      circle.m_radius = half * 0.6F;
      circle.m_p = {0, -half * 0.4F};
      addShape(body, circle, options);
      circle.m_p = {0, half * 0.4F};
      addShape(body, circle, options);
      polygon.SetAsBox(half * 0.6F, half * 0.4F);
      addShape(body, polygon, options);
      break;
    case Rider::polygon: {  // odd on purpose
      const b2Vec2 vertices[] = {{-0.6F * half, -half},      {0.5F * half, -half}, {half, -0.5F * half},
                                 {0.9F * half, 0.7F * half}, {-0.1F * half, half}, {-half, 0.3F * half}};
      polygon.Set(vertices, static_cast<int32>(std::size(vertices)));
      addShape(body, polygon, options);
      break;
    }
  }
}

// Measures the pushes of a step. Where a contact pushes is known before the solver moves the bodies; how hard it pushes
// is known afterwards.
class Listener : public b2ContactListener {
 public:
  Listener(const Surface& surface, const b2Body& rider) : surface_(surface), rider_(rider) {}

  void PreSolve(b2Contact* contact, const b2Manifold* /*old*/) override {
    b2WorldManifold& manifold = manifolds_[contact];
    contact->GetWorldManifold(&manifold);
    if (contact->GetFixtureA()->GetBody() == &rider_) manifold.normal = -manifold.normal;
  }

  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
    const b2WorldManifold& manifold = manifolds_.at(contact);
    for (int32 k = 0; k < impulse->count; ++k) {
      const float push = impulse->normalImpulses[k] / rider_.GetMass();
      if (push > strongest_ && !surface_.faces(manifold.points[k], manifold.normal)) {
        strongest_ = push;
        where_ = manifold.points[k];
      }
    }
  }

  void beginStep() {
    manifolds_.clear();
    strongest_ = 0;
  }
  float strongest() const { return strongest_; }
  b2Vec2 where() const { return where_; }

 private:
  const Surface& surface_;
  const b2Body& rider_;
  std::map<const b2Contact*, b2WorldManifold> manifolds_;
  float strongest_ = 0;
  b2Vec2 where_ = {0, 0};
};

std::set<TouchedEdge> touchedBy(const b2Body& body) {
  std::set<TouchedEdge> touched;
  for (const b2ContactEdge* c = body.GetContactList(); c != nullptr; c = c->next) {
    if (!c->contact->IsTouching()) continue;
    const bool isA = c->contact->GetFixtureA()->GetBody() != &body;
    const b2Fixture& fixture = isA ? *c->contact->GetFixtureA() : *c->contact->GetFixtureB();
    b2EdgeShape edge;
    if (fixture.GetType() == b2Shape::e_chain) {
      const int32 child = isA ? c->contact->GetChildIndexA() : c->contact->GetChildIndexB();
      static_cast<const b2ChainShape*>(fixture.GetShape())->GetChildEdge(&edge, child);
    } else if (fixture.GetType() == b2Shape::e_edge) {
      edge = static_cast<const b2EdgeShape&>(*fixture.GetShape());
    } else {
      continue;
    }
    const b2Vec2 a = fixture.GetBody()->GetWorldPoint(edge.m_vertex1);
    const b2Vec2 b = fixture.GetBody()->GetWorldPoint(edge.m_vertex2);
    touched.emplace(std::lround(a.x * 1000), std::lround(a.y * 1000), std::lround(b.x * 1000), std::lround(b.y * 1000));
  }
  return touched;
}

void drive(b2Body& body, double speed) {
  const float mass = body.GetMass();
  const float missing = (static_cast<float>(speed) - body.GetLinearVelocity().x) / kStep;
  body.ApplyForceToCenter({mass * std::clamp(missing, -10.0F, 10.0F), 0}, true);
}

}  // namespace

std::string_view name(Rider rider) {
  constexpr std::string_view kNames[] = {"circle", "box", "capsule", "polygon"};
  return kNames[static_cast<std::size_t>(rider)];
}

double Track::strongest() const {
  double most = 0;
  for (const Kick& kick : kicks) most = std::max(most, static_cast<double>(kick.strength));
  return most;
}

Track ride(const World& world, const oracle::Scene& scene, Way way, const RideOptions& options) {
  b2World physics(options.gravity);
  Ground ground(physics, world, scene, way, options.terrain);
  const box2d::Frame frame{options.terrain.cellSize, options.terrain.origin, options.terrain.chunkCells};
  // This is the surface before any edits. In a ride with edits the kicks mean nothing, only the samples do.
  const Surface surface(world, frame);

  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = options.start;
  definition.linearVelocity = options.velocity;
  definition.fixedRotation = options.fixedRotation;
  definition.allowSleep = false;
  b2Body& body = *physics.CreateBody(&definition);
  addRider(body, options);

  Listener listener(surface, body);
  physics.SetContactListener(&listener);
  Track track;
  bool kicked = false;
  for (int step = 0; step < options.steps; ++step) {
    if (options.beforeStep && !options.beforeStep(step, body, ground)) break;
    if (options.drive != 0) drive(body, options.drive);
    const b2Vec2 before = body.GetPosition();
    listener.beginStep();
    physics.Step(kStep, 8, 3);
    track.length += b2Distance(before, body.GetPosition());
    if (listener.strongest() >= kLeastKick) {
      if (!kicked) track.kicks.push_back({track.samples.size(), listener.where(), 0});
      track.kicks.back().strength = std::max(track.kicks.back().strength, listener.strongest());
    }
    kicked = listener.strongest() >= kLeastKick;
    track.samples.push_back({body.GetPosition(), body.GetLinearVelocity(), body.GetAngle(), touchedBy(body)});
  }
  physics.SetContactListener(nullptr);
  return track;
}

Deviation deviation(const Track& a, const Track& b) {
  Deviation most;
  for (std::size_t k = 0; k < std::min(a.samples.size(), b.samples.size()); ++k) {
    most.position = std::max(most.position, b2Distance(a.samples[k].position, b.samples[k].position));
    most.velocity = std::max(most.velocity, b2Distance(a.samples[k].velocity, b.samples[k].velocity));
    most.contacts += a.samples[k].touched != b.samples[k].touched;
  }
  return most;
}

}  // namespace lgs::bench
