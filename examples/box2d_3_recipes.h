// Recipes for the terrain in Box2D 3. docs/box2d.md says why they are as they are; addons/box2d/tests/recipes_test.cpp
// tries them.
#pragma once

#include "box2d_recipes.h"

#include <box2d/box2d.h>
#include <lgs/box2d/terrain.h>
#include <lgs/world.h>

#include <cstddef>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

namespace recipes {

enum : lgs::Block { kStone = 1, kIce = 2, kConveyor = 3, kPlatform = 4 };

/// For the world: walls beside a platform stay, as a body can be inside a platform.
inline bool keepsWalls(lgs::Block a, lgs::Block b) { return (a == kPlatform) != (b == kPlatform); }

/// For the terrain: ice is slippery, conveyors carry to the right, and platforms ask before they hold:
/// bodies may be inside.
inline lgs::box2d::Material materialOf(lgs::Block block) {
  lgs::box2d::Material material;
  material.surface.friction = block == kIce ? 0.0F : 0.8F;
  material.surface.tangentSpeed = block == kConveyor ? 2.0F : 0.0F;
  material.enablePreSolveEvents = block == kPlatform;
  material.isPassable = block == kPlatform;
  return material;
}

/// One-way platforms: they hold from above only. What comes from above is hardly deeper in a platform than it falls in
/// a step. What comes from below is deep in it when Box2D notices the contact: not before its middle is above the top.
/// Box2D can call this from several threads at a time. In 3.1 the result is whether there is a contact; later it is
/// void.
template <class Result>
Result holdFromAbove(b2ShapeId platform, b2ShapeId other, b2Manifold* manifold, void* terrain) {
  const auto hit = static_cast<const lgs::box2d::Terrain*>(terrain)->hit(platform);
  const float falls = -b2Body_GetLinearVelocity(b2Shape_GetBody(other)).y / 60;  // in a step
  const float depth = -manifold->points[0].separation;
  const bool isOnTop = manifold->normal.y > 0.5F && depth < 0.05F + b2MaxFloat(falls, 0);
  if (hit && !isOnTop) manifold->pointCount = 0;
  return static_cast<Result>(manifold->pointCount != 0);
}

/// A template, as versions of Box2D differ. A game writes what its Box2D wants.
template <class WorldId>
void makePlatformsOneWay(WorldId physics, lgs::box2d::Terrain& terrain) {
  if constexpr (requires { b2World_SetPreSolveCallback(physics, nullptr, nullptr, &terrain); }) {
    b2World_SetPreSolveCallback(physics, &holdFromAbove<void>, nullptr, &terrain);
  } else {
    b2World_SetPreSolveCallback(physics, &holdFromAbove<bool>, &terrain);
  }
}

/// Whether a body stands on the ground. Sensors are no contacts, so this asks for those of the body itself.
inline bool stands(b2BodyId body, const lgs::box2d::Terrain& terrain) {
  std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(body)));
  const int count = b2Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size()));
  for (const b2ContactData& contact : std::span(contacts).first(static_cast<std::size_t>(count)))
    if (const auto touch = terrain.hit(contact); touch && touch->normal.y > 0.7F) return true;
  return false;
}

/// What was saved: a world, and where the bodies were. The type of a transform depends on Box2D's precision.
using Transform = decltype(b2Body_GetTransform(b2_nullBodyId));
struct Saved {
  std::vector<std::byte> world;
  std::vector<std::pair<b2BodyId, Transform>> bodies;
};

/// Loads. Bodies go back before the next step: a body of now could be inside a block of then.
inline bool load(lgs::World& world, lgs::box2d::Terrain& terrain, const Saved& saved) {
  tl::expected<lgs::World, lgs::SnapshotError> loaded = lgs::World::load(saved.world, keepsWalls);
  if (!loaded) return false;
  world = std::move(*loaded);
  for (const auto& [body, at] : saved.bodies) {
    b2Body_SetTransform(body, at.p, at.q);
    b2Body_SetAwake(body, true);
  }
  terrain.resync();
  return true;
}

/// Keeps the origin near the first of these bodies, which are all that move. Steps of 1,024 cells: so the bodies move
/// by a float, to the last bit, if the cells' size is one that floats have, like 1, 0.5 or 0.75.
inline void follow(lgs::box2d::Terrain& terrain, lgs::Cell& origin, std::span<const b2BodyId> bodies) {
  constexpr std::int32_t kFar = 1'024;
  const lgs::Cell cell = terrain.cellAt(b2Body_GetPosition(bodies.front()));
  if (std::abs(cell.i - origin.i) < kFar && std::abs(cell.j - origin.j) < kFar) return;
  origin = {cell.i - cell.i % kFar, cell.j - cell.j % kFar};
  const lgs::box2d::Position by = terrain.position(lgs::toWorld(origin, {}));
  for (const b2BodyId body : bodies) {
    const lgs::box2d::Position at = b2Body_GetPosition(body);
    b2Body_SetTransform(body, {at.x - by.x, at.y - by.y}, b2Body_GetRotation(body));
  }
  terrain.moveOrigin(origin);
}

}  // namespace recipes
