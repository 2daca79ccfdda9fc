// Ground that falls, as bodies of Box2D 2.4 or 3. Include <lgs/box2d/falling.h>, and link LocalGridSeg::falling.
//
//   lgs::box2d::FallingGround falling(physics, world, terrain, {.density = [](lgs::Block) { return 2.5F; }});
//   …
//   terrain.sync(changes);
//   if (islands.update(world, changes))                       // islands.h
//     for (const lgs::IslandId id : islands.loose()) falling.takeAsBody(islands, id);
//   const lgs::Changes& gone = world.commit();                // the islands are edits like any other
//   terrain.sync(gone), islands.update(world, gone);
//   falling.afterSync();                                      // now the bodies are there
//   …
//   for (const auto& [body, ground] : falling.bodies()) …     // those that sleep, say
//     if (!body->IsAwake()) falling.settle(body);             // an edit again: it is ground
//
// A body is made after the sync that took its edges away. So it never touches the ground that it was part of.
#pragma once

#include <lgs/box2d/falling_parts.h>
#include <lgs/box2d/terrain.h>
#include <lgs/islands.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace lgs::box2d {

/// How bodies are made.
struct FallingOptions {
  std::function<float(Block)> density;      ///< kg per square metre, 0 or more; empty: 1
  std::function<Material(Block)> material;  ///< what their shapes are like; empty: Box2D's defaults
};

/// A body, and the ground that it is. The body's origin is where the ground's origin was.
struct Falling {
  BodyHandle body{};  ///< null: every part is thinner than Box2D's slop, and there is nothing to see
  Body ground;        ///< what it is made of
};

/// The ground of one world that falls. What it makes is the game's to move; whoever destroys a body calls forget().
class FallingGround {
 public:
  /// All of them must outlive it and stay where they are.
  FallingGround(Physics physics, World& world, Terrain& terrain, FallingOptions options = {})
      : physics_(physics), world_(world), terrain_(terrain), options_(std::move(options)) {}

  /// Takes an island out of the ground. Its body is made by the next afterSync(). Errors and cost as of take().
  Expected<void> takeAsBody(const Islands& islands, IslandId island) {
    auto body = take(world_, islands, island);
    if (!body) return tl::unexpected(body.error());
    waiting_.push_back(std::move(*body));
    return {};
  }

  /// To be called after the sync of the commit that holds what was taken. Makes the bodies, each of convex parts, where
  /// its ground was and at rest; its mass is exact but for one rounding. Returns them; they are the last of bodies().
  /// One that Box2D can make no shape of has a null body, and is not among bodies(). Cost: as of convexParts().
  std::vector<Falling> afterSync() {
    std::vector<Falling> made;
    for (Body& ground : waiting_) {
      const Position at = terrain_.position(toWorld(ground.origin, {}));
      const auto parts = convexParts(ground, 8);  // it was in a world, so it fits into one
      const double size = cellSize();
      const BodyHandle body = makeBody(physics_, at, fallingParts(parts.value(), size, slopOf(physics_)),
                                       fallingMass(ground, options_.density, size), [&](Block block) {
                                         return options_.material ? options_.material(block) : Material{};
                                       });
      made.push_back({body, std::move(ground)});
      if (!isNull(body)) bodies_.push_back(made.back());
    }
    waiting_.clear();
    return made;
  }

  /// All bodies that there are.
  const std::vector<Falling>& bodies() const { return bodies_; }

  /// Puts a body back into the ground, as it lies: an edit, to be committed and synced as any other. Its vertices are
  /// rounded to the lattice. It is let down by the gap that Box2D leaves below what rests and a slop, so that it is one
  /// island with what it rests on; what is ground already stays. Then the body is destroyed. Refused, and nothing is
  /// changed: overlap, where the ground reaches into it by more than two slops; staleHandle, if there is no such body;
  /// and as by putAsItLies(). Cost: as of Terrain::fits() and putAsItLies().
  Expected<void> settle(BodyHandle body) {
    const auto found = find(body);
    if (found == bodies_.end()) return tl::unexpected(Error{.code = ErrorCode::staleHandle});
    const Place down = downOf(physics_);
    const double slop = slopOf(physics_), depth = restingGap(physics_) + slop;
    const b2Vec2 lifted{static_cast<float>(-down.x * slop), static_cast<float>(-down.y * slop)};
    if (!fitsBy(terrain_, body, lifted)) return tl::unexpected(Error{.code = ErrorCode::overlap});
    const Lying lying = lyingOf(body);
    const double scale = std::hypot(lying.cosine, lying.sine), size = cellSize();
    const Point corner = terrain_.latticePoint({0, 0});  // of the cell that is at the origin of the physics
    const auto cells = [&](double metres, double way, std::int64_t from) {
      return (metres + way * depth) / size + static_cast<double>(from) / kUnitsPerCell;
    };
    const Placing placing{{cells(lying.origin.x, down.x, corner.x), cells(lying.origin.y, down.y, corner.y)},
                          lying.cosine / scale,
                          lying.sine / scale};
    if (const auto done = putAsItLies(world_, found->ground, placing); !done) return done;
    bodies_.erase(found);
    destroyBody(physics_, body);
    return {};
  }

  /// For a body that the game destroys itself, or keeps for itself.
  void forget(BodyHandle body) {
    if (const auto found = find(body); found != bodies_.end()) bodies_.erase(found);
  }

 private:
  static bool isNull(BodyHandle body) { return body == BodyHandle{}; }
  typename std::vector<Falling>::iterator find(BodyHandle body) {
    return std::find_if(bodies_.begin(), bodies_.end(), [&](const Falling& f) { return f.body == body; });
  }
  /// The corner of a cell is at the origin of the physics, so nothing is rounded here but the size itself.
  double cellSize() const {
    const Point corner = terrain_.latticePoint({0, 0});
    return static_cast<double>(terrain_.position({corner.x + kUnitsPerCell, corner.y}).x);
  }

  Physics physics_;
  World& world_;
  Terrain& terrain_;
  FallingOptions options_;
  std::vector<Body> waiting_;
  std::vector<Falling> bodies_;
};

}  // namespace lgs::box2d
