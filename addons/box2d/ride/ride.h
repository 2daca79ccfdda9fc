// A body rides over a ground in a Box2D world of its own. The result is what happened, step by step.
#pragma once

#include "addons/box2d/ride/ground.h"

#include <functional>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

namespace lgs::bench {

enum class Rider { circle, box, capsule, polygon };
std::string_view name(Rider rider);

struct RideOptions {
  Rider rider = Rider::circle;
  double size = 0.7;         ///< about how wide it is, in metres
  b2Vec2 start = {0, 0};     ///< where its centre starts, in metres
  b2Vec2 velocity = {4, 0};  ///< at the start, in metres a second
  double drive = 0;          ///< a force of at most 1 g pushes it to this speed to the right; 0 is no force
  float friction = 0;        ///< of the rider
  float density = 1;
  b2Vec2 gravity = {0, -10};
  int steps = 600;  ///< at most; each is 1/60 s
  bool fixedRotation = false;
  box2d::TerrainOptions terrain = {};                                ///< cell size, origin, materials
  std::function<bool(int, const b2Body&, Ground&)> beforeStep = {};  ///< may edit the world; false ends the ride
};

/// The ends of an edge, in millimetres.
using TouchedEdge = std::tuple<long, long, long, long>;

/// The state of the body after a step.
struct Sample {
  b2Vec2 position;
  b2Vec2 velocity;
  float angle = 0;
  std::set<TouchedEdge> touched;  ///< empty where the ground is polygons
};

/// A push in a direction that the surface does not have (surface.h). Pushes in several steps in a row are one kick.
struct Kick {
  std::size_t step = 0;
  b2Vec2 position;     ///< where the body was pushed
  float strength = 0;  ///< metres a second; the strongest of its steps
};

struct Track {
  std::vector<Sample> samples;  ///< one for each step
  std::vector<Kick> kicks;      ///< those of at least kLeastKick
  double length = 0;            ///< of the path, in metres
  double strongest() const;
};
inline constexpr float kLeastKick = 0.01F;  // metres a second

Track ride(const World& world, const oracle::Scene& scene, Way way, const RideOptions& options);

/// How two rides differ: how far apart they are at most, and in how many steps they touch different edges.
struct Deviation {
  float position = 0;
  float velocity = 0;
  std::size_t contacts = 0;
};
Deviation deviation(const Track& a, const Track& b);

}  // namespace lgs::bench
