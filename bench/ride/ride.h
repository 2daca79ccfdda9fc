// A body rides over a ground in a Box2D world of its own; what happened, step by step.
#pragma once

#include "bench/ride/ground.h"

#include <functional>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

namespace lgs::oracle {

enum class Rider { circle, box, capsule, polygon };
std::string_view name(Rider rider);

struct RideOptions {
  Rider rider = Rider::circle;
  double size = 0.7;         ///< metres from side to side, about
  b2Vec2 start = {0, 0};     ///< of the body's centre, metres
  b2Vec2 velocity = {4, 0};  ///< at the start, metres a second
  double drive = 0;          ///< a force that pushes to this speed to the right, at most 1 g; 0: none
  float friction = 0;        ///< of the rider
  float density = 1;
  b2Vec2 gravity = {0, -10};
  int steps = 600;  ///< of 1/60 s
  bool fixedRotation = false;
  box2d::TerrainOptions terrain = {};                                ///< cell size, origin, materials
  std::function<bool(int, const b2Body&, Ground&)> beforeStep = {};  ///< e.g. edits; false ends the ride
};

/// The ends of an edge, in millimetres.
using TouchedEdge = std::tuple<long, long, long, long>;

struct Sample {
  b2Vec2 position;
  b2Vec2 velocity;
  float angle = 0;
  std::set<TouchedEdge> touched;  ///< for grounds of edges
};

/// A push in a direction that the surface does not have (surface.h). One kick lasts as long as it goes on step by step.
struct Kick {
  std::size_t step = 0;
  b2Vec2 position;     ///< where the body was pushed
  float strength = 0;  ///< metres a second; the strongest of its steps
};

struct Track {
  std::vector<Sample> samples;  ///< after each step
  std::vector<Kick> kicks;      ///< those of at least kLeastKick
  double length = 0;            ///< of the path, in metres
  double strongest() const;
};
inline constexpr float kLeastKick = 0.01F;  // metres a second

Track ride(const World& world, const Scene& scene, Way way, const RideOptions& options);

/// How two rides differ: how far they are apart at most, and in how many steps they touch other edges.
struct Deviation {
  float position = 0;
  float velocity = 0;
  std::size_t contacts = 0;
};
Deviation deviation(const Track& a, const Track& b);

}  // namespace lgs::oracle
