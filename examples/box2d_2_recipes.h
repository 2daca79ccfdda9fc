// Recipes for the terrain in Box2D 2.4. docs/box2d.md says why they are as they are; addons/box2d/tests/recipes_test.cpp
// tries them.
#pragma once

#include "box2d_recipes.h"

#include <box2d/box2d.h>
#include <lgs/box2d/terrain.h>
#include <lgs/world.h>

#include <cstddef>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

namespace recipes {

enum : lgs::Block { kStone = 1, kIce = 2, kConveyor = 3, kPlatform = 4 };

/// For the world: walls beside a platform stay, as a body can be inside a platform.
inline bool keepsWalls(lgs::Block a, lgs::Block b) { return (a == kPlatform) != (b == kPlatform); }

/// For the terrain: ice is slippery, and bodies may be inside a platform.
inline lgs::box2d::Material materialOf(lgs::Block block) {
  return {.friction = block == kIce ? 0.0F : 0.8F, .isPassable = block == kPlatform};
}

/// One-way platforms and conveyors. Platforms hold from above only. Conveyors carry to the right.
class Ground : public b2ContactListener {
 public:
  explicit Ground(const lgs::box2d::Terrain& terrain) : terrain_(terrain) {}

  void BeginContact(b2Contact* contact) override {
    if (const auto touch = terrain_.hit(*contact); touch && touch->hit.block == kPlatform && !isOnTop(*contact, *touch))
      passing_.insert(contact);
  }
  void EndContact(b2Contact* contact) override { passing_.erase(contact); }

  void PreSolve(b2Contact* contact, const b2Manifold* /*before*/) override {
    if (passing_.contains(contact)) contact->SetEnabled(false);
    if (const auto touch = terrain_.hit(*contact); touch && touch->hit.block == kConveyor)
      contact->SetTangentSpeed(2 * touch->normal.y);  // under a conveyor to the left
  }

 private:
  // What comes from above touches the top and is hardly deeper than its skin. What comes from below is deep in it when
  // Box2D notices the contact: not before its middle is above the top.
  static bool isOnTop(const b2Contact& contact, const lgs::box2d::Touch& touch) {
    b2WorldManifold manifold;
    contact.GetWorldManifold(&manifold);
    return touch.normal.y > 0.5F && manifold.separations[0] > -0.05F;
  }

  const lgs::box2d::Terrain& terrain_;
  std::set<const b2Contact*> passing_;
};

/// A foot is a sensor below a body. Ask; do not count begins and ends: edges come and go under a foot that stands.
inline bool stands(b2Fixture& foot, const lgs::box2d::Terrain& terrain) {
  for (b2ContactEdge* c = foot.GetBody()->GetContactList(); c != nullptr; c = c->next) {
    if (c->contact->GetFixtureB() != &foot) continue;
    if (const auto touch = terrain.hit(*c->contact); touch && touch->normal.y > 0.7F) return true;
  }
  return false;
}

/// What was saved: a world, and where the bodies were.
struct Saved {
  std::vector<std::byte> world;
  std::vector<std::pair<b2Body*, b2Transform>> bodies;
};

/// Loads. Bodies go back before the next step: a body of now could be inside a block of then.
inline bool load(lgs::World& world, lgs::box2d::Terrain& terrain, const Saved& saved) {
  tl::expected<lgs::World, lgs::SnapshotError> loaded = lgs::World::load(saved.world, keepsWalls);
  if (!loaded) return false;
  world = std::move(*loaded);
  for (const auto& [body, at] : saved.bodies) {
    body->SetTransform(at.p, at.q.GetAngle());
    body->SetAwake(true);
  }
  terrain.resync();
  return true;
}

/// Keeps the origin near a body. Steps of 1,024 cells: so the physics world moves by a float, to the last bit, if the
/// cells' size is one that floats have, like 1, 0.5 or 0.75.
inline void follow(b2World& physics, lgs::box2d::Terrain& terrain, lgs::Cell& origin, const b2Body& body) {
  constexpr std::int32_t kFar = 1'024;
  const lgs::Cell cell = terrain.cellAt(body.GetPosition());
  if (std::abs(cell.i - origin.i) < kFar && std::abs(cell.j - origin.j) < kFar) return;
  origin = {cell.i - cell.i % kFar, cell.j - cell.j % kFar};
  physics.ShiftOrigin(terrain.position(lgs::toWorld(origin, {})));
  terrain.moveOrigin(origin);
}

}  // namespace recipes
