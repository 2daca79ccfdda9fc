// The recipes of docs/box2d.md, for Box2D 2.4.
#include "examples/box2d_2_recipes.h"

#include "field.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>

namespace lgs::box2d_test {
namespace {

using box2d::Terrain;

class Box2dRecipes : public testing::Test {
 protected:
  Box2dRecipes() : world(recipes::keepsWalls), square(*world.shape(kUnitSquare)) {}

  void TearDown() override { physics.SetContactListener(nullptr); }  // the terrain ends contacts when it goes

  void fill(const CellRect& cells, Block block) { ASSERT_TRUE(world.fill(cells, square, block)); }

  Terrain& ground(double cellSize = 1) {
    world.commit();
    terrain.emplace(physics, world,
                    box2d::TerrainOptions{.cellSize = cellSize, .chunkCells = 4, .material = recipes::materialOf});
    return *terrain;
  }

  b2Body& addBody(b2Vec2 at, const b2Shape& shape, float friction = 0) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = at;
    definition.fixedRotation = true;
    b2Body& body = *physics.CreateBody(&definition);
    body.CreateFixture(&shape, 1)->SetFriction(friction);
    return body;
  }
  b2Body& addBall(b2Vec2 at, float friction = 0) {
    b2CircleShape circle;
    circle.m_radius = 0.35F;
    return addBody(at, circle, friction);
  }
  b2Body& addBox(b2Vec2 at, float friction = 0) {
    b2PolygonShape box;
    box.SetAsBox(0.35F, 0.35F);
    return addBody(at, box, friction);
  }

  void step(
      int times, const std::function<void()>& after = [] {}) {
    for (int k = 0; k < times; ++k) {
      physics.Step(1.0F / 60, 8, 3);
      after();
    }
  }

  b2World physics{{0, -10}};
  World world;
  ShapeId square;
  std::optional<Terrain> terrain;
};

// A platform in the air, over four chunks. What jumps comes through it anywhere, at seams of cells and chunks too, and
// lands on it.
TEST_F(Box2dRecipes, APlatformIsPassedFromBelowAndHoldsFromAbove) {
  fill({{0, -1}, {15, -1}}, recipes::kStone);
  for (std::int32_t i = 0; i < 16; ++i)
    ASSERT_TRUE(world.add({i, 1}, {{0, U / 2}, {U, U / 2}, {U, U}, {0, U}}, recipes::kPlatform));
  recipes::Ground listener(ground());
  physics.SetContactListener(&listener);
  for (const bool box : {false, true}) {
    for (const float x : {5.5F, 6.0F, 7.9F, 8.0F, 8.2F}) {
      for (const float aside : {-1.5F, 0.0F, 1.5F}) {
        SCOPED_TRACE(testing::Message() << (box ? "box" : "ball") << " at " << x << ", aside " << aside);
        b2Body& body = box ? addBox({x, 0.4F}) : addBall({x, 0.4F});
        body.SetLinearVelocity({aside, 9});
        float highest = 0;
        step(40, [&] {
          highest = std::max(highest, body.GetPosition().y);
          EXPECT_NEAR(body.GetLinearVelocity().x, aside, 1e-4F) << "it was kicked at y = " << body.GetPosition().y;
        });
        EXPECT_GT(highest, 4);  // as high as without a platform
        step(100);
        EXPECT_NEAR(body.GetPosition().y, 2.35F, 0.02F);
        physics.DestroyBody(&body);
      }
    }
  }
}

// It does not come as high as the platform is thick, and falls back.
TEST_F(Box2dRecipes, AJumpThatIsTooLowFallsBack) {
  fill({{0, -1}, {15, -1}}, recipes::kStone);
  fill({{4, 1}, {11, 1}}, recipes::kPlatform);
  recipes::Ground listener(ground());
  physics.SetContactListener(&listener);
  for (const float speed : {4.0F, 5.0F, 5.8F, 6.0F, 6.2F, 6.4F, 6.6F}) {
    b2Body& body = addBox({7.9F, 0.4F});
    body.SetLinearVelocity({0, speed});
    float highest = 0;
    step(150, [&] { highest = std::max(highest, body.GetPosition().y); });
    EXPECT_LT(highest, 0.41F + speed * speed / 20);  // nothing pushes it up
    EXPECT_NEAR(body.GetPosition().y, highest > 2.36F ? 2.35F : 0.35F, 0.03F) << speed;
    physics.DestroyBody(&body);
  }
}

// Nor where the platform ends and stone begins.
TEST_F(Box2dRecipes, OnAPlatformNothingBumps) {
  fill({{0, 1}, {9, 1}}, recipes::kPlatform);
  fill({{10, 1}, {15, 1}}, recipes::kStone);
  recipes::Ground listener(ground());
  physics.SetContactListener(&listener);
  for (const bool box : {false, true}) {
    b2Body& body = box ? addBox({1, 2.36F}) : addBall({1, 2.36F});
    step(30);
    const float height = body.GetPosition().y;
    body.SetLinearVelocity({5, 0});
    step(150, [&] {
      EXPECT_NEAR(body.GetLinearVelocity().x, 5, 1e-4F);
      EXPECT_NEAR(body.GetPosition().y, height, 1e-3F);
    });
    EXPECT_GT(body.GetPosition().x, 13);
    physics.DestroyBody(&body);
  }
}

// Without the preserve relation the wall would have a hole there.
TEST_F(Box2dRecipes, InAPlatformTheWallBesideItHolds) {
  fill({{0, -1}, {15, -1}}, recipes::kStone);
  fill({{8, 0}, {8, 6}}, recipes::kStone);
  fill({{4, 1}, {7, 1}}, recipes::kPlatform);
  recipes::Ground listener(ground());
  physics.SetContactListener(&listener);
  b2Body& ball = addBall({6.5F, 0.4F});
  ball.SetLinearVelocity({5, 8});
  step(200, [&] { EXPECT_LT(ball.GetPosition().x, 7.7F); });
  EXPECT_NEAR(ball.GetPosition().y, 2.35F, 0.02F);
}

// From stone to a conveyor, over ice, and onto stone again.
TEST_F(Box2dRecipes, SeamsOfConveyorsAndIceDoNotKick) {
  fill({{0, -1}, {5, -1}}, recipes::kStone);
  fill({{6, -1}, {13, -1}}, recipes::kConveyor);
  fill({{14, -1}, {25, -1}}, recipes::kIce);
  fill({{26, -1}, {40, -1}}, recipes::kStone);
  recipes::Ground listener(ground());
  physics.SetContactListener(&listener);
  b2Body& box = addBox({4, 0.37F}, 0.8F);
  step(30);
  box.SetLinearVelocity({8, 0});
  const float height = box.GetPosition().y;
  float onBelt = 0, onIce = 0;
  step(1'200, [&] {
    EXPECT_NEAR(box.GetPosition().y, height, 2e-3F);
    EXPECT_NEAR(box.GetLinearVelocity().y, 0, 0.01F);
    if (std::abs(box.GetPosition().x - 12.5F) < 0.1F) onBelt = box.GetLinearVelocity().x;
    if (std::abs(box.GetPosition().x - 24) < 0.1F) onIce = box.GetLinearVelocity().x;
  });
  EXPECT_NEAR(onBelt, 2, 0.01F);  // carried
  EXPECT_NEAR(onIce, 2, 0.01F);   // gliding
  EXPECT_GT(box.GetPosition().x, 25.65F);
  EXPECT_EQ(box.GetLinearVelocity().x, 0);  // braked
}

TEST_F(Box2dRecipes, AFootStandsAlsoWhileTheGroundChanges) {
  fill({{0, -2}, {9, -1}}, recipes::kStone);
  fill({{8, 0}, {8, 3}}, recipes::kStone);
  ground();
  b2Body& body = addBox({4.5F, 0.36F});
  b2PolygonShape sole;
  sole.SetAsBox(0.36F, 0.05F, {0, -0.37F}, 0);
  b2FixtureDef definition;
  definition.shape = &sole;
  definition.isSensor = true;
  b2Fixture& foot = *body.CreateFixture(&definition);
  step(30);
  EXPECT_TRUE(recipes::stands(foot, *terrain));
  // Another block below it: its edge is another one, of a moment ago.
  ASSERT_TRUE(world.setBlock(world.polygons({4, -1})[0].handle, recipes::kIce));
  ASSERT_TRUE(terrain->commit(world));
  step(2);
  EXPECT_TRUE(recipes::stands(foot, *terrain));
  ASSERT_TRUE(recipes::dig(world, *terrain, {{4, -1}, {4, -1}}));
  step(10);
  EXPECT_FALSE(recipes::stands(foot, *terrain));
  step(60);
  EXPECT_TRUE(recipes::stands(foot, *terrain));
  body.SetTransform({7.66F, 2}, 0);  // at the wall, in the air
  body.SetAwake(true);
  step(2);
  EXPECT_FALSE(recipes::stands(foot, *terrain));
}

TEST_F(Box2dRecipes, ABlockOnABody) {
  fill({{0, -1}, {9, -1}}, recipes::kStone);
  ground();
  b2Body& ball = addBall({4.5F, 0.4F});
  step(60);
  EXPECT_FALSE(recipes::placeIfFree(world, *terrain, {4, 0}, square, recipes::kStone));
  EXPECT_TRUE(recipes::placeIfFree(world, *terrain, {5, 0}, square, recipes::kStone));
  EXPECT_TRUE(recipes::placeBelow(world, *terrain, {4, 0}, square, recipes::kStone));
  step(60);
  EXPECT_NEAR(ball.GetPosition().y, 1.35F, 0.02F);
}

// Why to ask: edges are one-sided.
TEST_F(Box2dRecipes, WhoDoesNotAskLosesABody) {
  fill({{0, -1}, {9, -1}}, recipes::kStone);
  ground();
  b2Body& ball = addBall({4.5F, 0.4F});
  step(60);
  ASSERT_TRUE(world.add({4, 0}, square, recipes::kStone));
  ASSERT_TRUE(terrain->commit(world));
  step(120);
  EXPECT_LT(ball.GetPosition().y, -1);
}

TEST_F(Box2dRecipes, DiggingUnderASleepingStack) {
  fill({{0, -4}, {20, -1}}, recipes::kStone);
  ground();
  std::vector<b2Body*> stack;
  for (int k = 0; k < 5; ++k) stack.push_back(&addBox({10.5F, 0.36F + 0.72F * static_cast<float>(k)}, 0.5F));
  b2Body& far = addBox({3.5F, 0.36F});
  step(300);
  for (const b2Body* body : stack) ASSERT_FALSE(body->IsAwake());
  ASSERT_TRUE(recipes::dig(world, *terrain, {{10, -3}, {10, -1}}));
  step(2);
  for (const b2Body* body : stack) EXPECT_TRUE(body->IsAwake());
  EXPECT_FALSE(far.IsAwake());
  step(300);
  for (std::size_t k = 0; k < stack.size(); ++k)
    EXPECT_NEAR(stack[k]->GetPosition().y, -3 + 0.35F + 0.7F * static_cast<float>(k), 0.1F) << k;
}

// Ten thousand cells; the origin moves nine times.
TEST_F(Box2dRecipes, AWorldThatMovesItsOrigin) {
  constexpr std::int32_t kCells = 10'000;
  fill({{-5, -1}, {kCells, -1}}, recipes::kIce);
  fill({{600, 3}, {602, 3}}, recipes::kStone);  // a ledge
  ground(0.5);
  b2Body& ball = addBall({0, 0.36F});
  b2Body& sleeper = addBox({300.75F, 2.36F}, 0.8F);
  step(120);
  ASSERT_FALSE(sleeper.IsAwake());
  ball.SetLinearVelocity({40, 0});
  Cell origin;
  int moves = 0;
  const float height = ball.GetPosition().y;
  while (terrain->cellAt(ball.GetPosition()).i < kCells - 200) {
    const Cell before = origin;
    const Cell at = terrain->cellAt(ball.GetPosition());
    recipes::follow(physics, *terrain, origin, ball);
    moves += before == origin ? 0 : 1;
    ASSERT_EQ(terrain->cellAt(ball.GetPosition()), at);
    ASSERT_LT(std::abs(ball.GetPosition().x), 600);
    step(1);
    ASSERT_NEAR(ball.GetLinearVelocity().x, 40, 1e-3F);
    ASSERT_NEAR(ball.GetPosition().y, height, 1e-3F);
  }
  EXPECT_EQ(moves, 9);
  EXPECT_FALSE(sleeper.IsAwake());
  EXPECT_EQ(terrain->cellAt(sleeper.GetPosition()), (Cell{601, 4}));
}

}  // namespace
}  // namespace lgs::box2d_test
