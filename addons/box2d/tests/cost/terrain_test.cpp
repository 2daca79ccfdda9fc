// The terrain in Box2D 2.4 follows a commit at a cost in proportion to what it changed. What Box2D does is not counted.
#include "ground.h"

#include <box2d/box2d.h>
#include <gtest/gtest.h>
#include <lgs/box2d/terrain.h>

namespace lgs::cost_test {
namespace {

Costs costsOfTerrain(std::int32_t side) {
  Ground ground(side);
  b2World physics({0, -10});
  box2d::Terrain terrain(physics, ground.world, {.chunkCells = 8, .merge = true});
  b2BodyDef ball;
  ball.type = b2_dynamicBody;
  physics.CreateBody(&ball);  // so that a commit looks for what it has to wake
  return costsOf(ground, [&](const Changes& changes) { terrain.sync(changes); });
}

// Smaller than the others: it takes Box2D long to make fixtures.
TEST(Cost, OfASyncOfTheTerrainIsNoMoreInALargerWorld) { expectNoMore(costsOfTerrain, 64, 140); }

}  // namespace
}  // namespace lgs::cost_test
