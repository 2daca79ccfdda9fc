// What differs between the recipes for the two generations of Box2D.
#pragma once

#include "either.h"

#ifndef B2_IS_NULL  // Box2D 2.4
#include "examples/box2d_2_recipes.h"
#else  // Box2D 3
#include "examples/box2d_3_recipes.h"
#endif

#include <lgs/box2d/terrain.h>
#include <optional>

namespace lgs::box2d_test {

class Recipes : public EitherBox2d {
 protected:
  /// Makes the terrain of what the world holds.
  void ground(double cellSize = 1) {
    world.commit();
    box2d::TerrainOptions options{.cellSize = cellSize, .chunkCells = 4};
    options.material = recipes::materialOf;
    terrain.emplace(physics, world, options);
    listen();
  }

#ifndef B2_IS_NULL
  void TearDown() override { physics.SetContactListener(nullptr); }  // the terrain ends contacts when it goes
  void listen() {
    listener.emplace(*terrain);
    physics.SetContactListener(&*listener);
  }
  void addFoot(Body body) {
    b2PolygonShape sole;
    sole.SetAsBox(0.36F, 0.05F, {0, -0.37F}, 0);
    b2FixtureDef definition;
    definition.shape = &sole;
    definition.isSensor = true;
    foot = body->CreateFixture(&definition);
  }
  bool stands(Body /*body*/) { return recipes::stands(*foot, *terrain); }
  void follow(Cell& origin, Body body, Body /*other*/) { recipes::follow(physics, *terrain, origin, *body); }
  std::optional<recipes::Ground> listener;
  b2Fixture* foot = nullptr;
#else
  void listen() { recipes::makePlatformsOneWay(physics, *terrain); }
  void addFoot(Body /*body*/) {}
  bool stands(Body body) { return recipes::stands(body, *terrain); }
  void follow(Cell& origin, Body body, Body other) {
    const Body all[] = {body, other};
    recipes::follow(*terrain, origin, all);
  }
#endif

  recipes::Saved save(std::span<const Body> bodies) const {
    recipes::Saved saved;
    EXPECT_TRUE(world.save([&](auto bytes) { saved.world.insert(saved.world.end(), bytes.begin(), bytes.end()); }));
    for (const Body body : bodies) saved.bodies.emplace_back(body, transformOf(body));
    return saved;
  }

  World world{recipes::keepsWalls};
  std::optional<box2d::Terrain> terrain;
};

}  // namespace lgs::box2d_test
