// The recipes of docs/box2d.md, for whichever Box2D there is.
#include "recipes.h"
#include "either.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace lgs::box2d_test {
namespace {

class Box2dRecipes : public Recipes {
 protected:
  Box2dRecipes() : square(*world.shape(kUnitSquare)) {}

  void fill(const CellRect& cells, Block block) { ASSERT_TRUE(world.fill(cells, square, block)); }

  void step(
      int times, const std::function<void()>& after = [] {}) {
    for (int k = 0; k < times; ++k) {
      EitherBox2d::step(1);
      after();
    }
  }

  void rideOver() {
    ground();
    for (const Form form : {Form::ball, Form::box}) {
      const Body body = addBody({1, 2.36F}, form, 0);
      step(30);
      const double height = positionOf(body).y;
      setVelocity(body, {5, 0});
      step(150, [&] {
        EXPECT_NEAR(velocityOf(body).x, 5, 1e-3F);
        EXPECT_NEAR(positionOf(body).y, height, 1e-3F);
      });
      EXPECT_GT(positionOf(body).x, 13);
      destroy(body);
    }
  }

  ShapeId square;
};

// A platform in the air, over four chunks. What jumps comes through it anywhere, at seams of cells and chunks too, and
// lands on it.
TEST_F(Box2dRecipes, APlatformIsPassedFromBelowAndHoldsFromAbove) {
  fill({{0, -1}, {15, -1}}, recipes::kStone);
  for (std::int32_t i = 0; i < 16; ++i)
    ASSERT_TRUE(world.add({i, 1}, {{0, U / 2}, {U, U / 2}, {U, U}, {0, U}}, recipes::kPlatform));
  ground();
  for (const Form form : {Form::ball, Form::box}) {
    for (const float x : {5.5F, 6.0F, 7.9F, 8.0F, 8.2F}) {
      for (const float aside : {-1.5F, 0.0F, 1.5F}) {
        SCOPED_TRACE(testing::Message() << (form == Form::box ? "box" : "ball") << " at " << x << ", aside " << aside);
        const Body body = addBody({x, 0.4F}, form, 0);
        setVelocity(body, {aside, 9});
        double highest = 0;
        step(40, [&] {
          highest = std::max(highest, double{positionOf(body).y});
          EXPECT_NEAR(velocityOf(body).x, aside, 1e-4F) << "it was kicked at y = " << positionOf(body).y;
        });
        EXPECT_GT(highest, 4);  // as high as without a platform
        step(100);
        EXPECT_NEAR(positionOf(body).y, 2.35F, 0.02F);
        destroy(body);
      }
    }
  }
}

// It does not come as high as the platform is thick, and falls back.
TEST_F(Box2dRecipes, AJumpThatIsTooLowFallsBack) {
  fill({{0, -1}, {15, -1}}, recipes::kStone);
  fill({{4, 1}, {11, 1}}, recipes::kPlatform);
  ground();
  for (const float speed : {4.0F, 5.0F, 5.8F, 6.0F, 6.4F, 6.6F}) {
    const Body body = addBody({7.9F, 0.4F}, Form::box, 0);
    setVelocity(body, {0, speed});
    double highest = 0;
    step(150, [&] { highest = std::max(highest, double{positionOf(body).y}); });
    EXPECT_LT(highest, 0.41F + speed * speed / 20);  // nothing pushes it up
    EXPECT_NEAR(positionOf(body).y, highest > 2.36F ? 2.35F : 0.35F, 0.03F) << speed;
    destroy(body);
  }
}

TEST_F(Box2dRecipes, OnAPlatformNothingBumps) {
  fill({{0, 1}, {15, 1}}, recipes::kPlatform);
  rideOver();
}

#ifndef B2_IS_NULL  // Box2D 3 looks ahead, and bumps a ball into the corner of the wall that the relation keeps
TEST_F(Box2dRecipes, NothingBumpsWhereAPlatformMeetsStone) {
  fill({{0, 1}, {9, 1}}, recipes::kPlatform);
  fill({{10, 1}, {15, 1}}, recipes::kStone);
  rideOver();
}
#endif

// Without the preserve relation the wall would have a hole there.
TEST_F(Box2dRecipes, InAPlatformTheWallBesideItHolds) {
  fill({{0, -1}, {15, -1}}, recipes::kStone);
  fill({{8, 0}, {8, 6}}, recipes::kStone);
  fill({{4, 1}, {7, 1}}, recipes::kPlatform);
  ground();
  const Body ball = addBody({6.5F, 0.4F}, Form::ball, 0);
  setVelocity(ball, {5, 8});
  step(200, [&] { EXPECT_LT(positionOf(ball).x, 7.7F); });
  EXPECT_NEAR(positionOf(ball).y, 2.35F, 0.02F);
}

// From stone to a conveyor, over ice, and onto stone again.
TEST_F(Box2dRecipes, SeamsOfConveyorsAndIceDoNotKick) {
  fill({{0, -1}, {5, -1}}, recipes::kStone);
  fill({{6, -1}, {13, -1}}, recipes::kConveyor);
  fill({{14, -1}, {25, -1}}, recipes::kIce);
  fill({{26, -1}, {40, -1}}, recipes::kStone);
  ground();
  const Body box = addBody({4, 0.37F}, Form::box, 0.8F);
  step(30);
  setVelocity(box, {8, 0});
  const double height = positionOf(box).y;
  float onBelt = 0, onIce = 0;
  step(1'200, [&] {
    EXPECT_NEAR(positionOf(box).y, height, 2e-3F);
    EXPECT_NEAR(velocityOf(box).y, 0, 0.01F);
    if (std::abs(positionOf(box).x - 12.5F) < 0.1F) onBelt = velocityOf(box).x;
    if (std::abs(positionOf(box).x - 24) < 0.1F) onIce = velocityOf(box).x;
  });
  EXPECT_NEAR(onBelt, 2, 0.01F);  // carried
  EXPECT_NEAR(onIce, 2, 0.01F);   // gliding
  EXPECT_GT(positionOf(box).x, 25.65F);
  EXPECT_EQ(velocityOf(box).x, 0);  // braked
}

TEST_F(Box2dRecipes, AFootStandsAlsoWhileTheGroundChanges) {
  fill({{0, -2}, {9, -1}}, recipes::kStone);
  fill({{8, 0}, {8, 3}}, recipes::kStone);
  ground();
  const Body body = addBody({4.5F, 0.36F}, Form::box, 0);
  addFoot(body);
  step(30);
  EXPECT_TRUE(stands(body));
  // Another block below it: its edge is another one, of a moment ago.
  ASSERT_TRUE(world.setBlock(world.polygons({4, -1})[0].handle, recipes::kIce));
  ASSERT_TRUE(terrain->commit(world));
  step(2);
  EXPECT_TRUE(stands(body));
  ASSERT_TRUE(recipes::dig(world, *terrain, {{4, -1}, {4, -1}}));
  step(10);
  EXPECT_FALSE(stands(body));
  step(60);
  EXPECT_TRUE(stands(body));
  moveTo(body, {7.66F, 2});  // at the wall, in the air
  step(2);
  EXPECT_FALSE(stands(body));
}

TEST_F(Box2dRecipes, ABlockOnABody) {
  fill({{0, -1}, {9, -1}}, recipes::kStone);
  ground();
  const Body ball = addBody({4.5F, 0.4F}, Form::ball, 0);
  step(60);
  EXPECT_FALSE(recipes::placeIfFree(world, *terrain, {4, 0}, square, recipes::kStone));
  EXPECT_TRUE(recipes::placeIfFree(world, *terrain, {5, 0}, square, recipes::kStone));
  EXPECT_TRUE(terrain->isCurrent());
  EXPECT_TRUE(world.isEmpty({4, 0}));
  EXPECT_NEAR(positionOf(ball).y, 0.35F, 0.02F);
}

TEST_F(Box2dRecipes, WhoDoesNotAskPushesTheBodyOut) {
  fill({{0, -1}, {9, -1}}, recipes::kStone);
  ground();
  const Body ball = addBody({4.5F, 0.4F}, Form::ball, 0);
  step(60);
  ASSERT_TRUE(world.add({4, 0}, square, recipes::kStone));
  ASSERT_TRUE(terrain->commit(world));
  step(120);
  EXPECT_GT(positionOf(ball).y, 0.3F);
}

TEST_F(Box2dRecipes, DiggingUnderASleepingStack) {
  fill({{0, -4}, {20, -1}}, recipes::kStone);
  ground();
  std::vector<Body> stack;
  stack.reserve(5);
  for (int k = 0; k < 5; ++k) stack.push_back(addBody({10.5F, 0.36F + 0.72F * static_cast<float>(k)}, Form::box, 0.5F));
  const Body far = addBody({3.5F, 0.36F}, Form::box, 0);
  step(300);
  for (const Body body : stack) ASSERT_FALSE(isAwake(body));
  ASSERT_TRUE(recipes::dig(world, *terrain, {{10, -3}, {10, -1}}));
  step(2);
  for (const Body body : stack) EXPECT_TRUE(isAwake(body));
  EXPECT_FALSE(isAwake(far));
  step(300);
  for (std::size_t k = 0; k < stack.size(); ++k)
    EXPECT_NEAR(positionOf(stack[k]).y, -3 + 0.35F + 0.7F * static_cast<float>(k), 0.1F) << k;
}

TEST_F(Box2dRecipes, UndoingADigTakesTheBodyOutOfTheHole) {
  fill({{0, -4}, {9, -1}}, recipes::kStone);
  ground();
  const Mark first = world.mark();
  ASSERT_TRUE(recipes::dig(world, *terrain, {{4, -1}, {4, -1}}));
  const Mark second = world.mark();
  ASSERT_TRUE(recipes::dig(world, *terrain, {{7, -1}, {7, -1}}));
  ASSERT_TRUE(recipes::placeIfFree(world, *terrain, {8, 0}, square, recipes::kStone));
  const Body ball = addBody({4.5F, 0.4F}, Form::ball, 0);
  step(120);
  EXPECT_NEAR(positionOf(ball).y, -0.65F, 0.02F);  // in the hole
  EXPECT_TRUE(recipes::undo(world, *terrain, second));
  EXPECT_TRUE(terrain->isCurrent());
  EXPECT_TRUE(terrain->overlaps().empty());
  EXPECT_TRUE(recipes::undo(world, *terrain, first));
  EXPECT_TRUE(terrain->isCurrent());
  EXPECT_EQ(terrain->overlaps().size(), 1U);
  EXPECT_EQ(terrain->edges().counts().edges, 28U);  // around 10 × 4 cells
  step(60);
  EXPECT_NEAR(positionOf(ball).y, 0.35F, 0.02F);
}

TEST_F(Box2dRecipes, ALoadPutsBodiesWhereTheyWere) {
  fill({{0, -4}, {9, -1}}, recipes::kStone);
  ground();
  const Body ball = addBody({4.5F, 0.4F}, Form::ball, 0.5F);
  const Body far = addBody({8.5F, 0.4F}, Form::ball, 0.5F);
  step(120);
  const recipes::Saved saved = save(std::vector{ball, far});
  ASSERT_TRUE(recipes::dig(world, *terrain, {{4, -2}, {4, -1}}));
  step(120);
  ASSERT_NEAR(positionOf(ball).y, -1.65F, 0.02F);
  ASSERT_TRUE(recipes::load(world, *terrain, saved));
  EXPECT_TRUE(terrain->isCurrent());
  EXPECT_FALSE(world.isEmpty({4, -1}));
  step(120);
  for (const Body body : {ball, far}) EXPECT_NEAR(positionOf(body).y, 0.35F, 0.02F);
  recipes::Saved cut = saved;
  cut.world.pop_back();
  EXPECT_FALSE(recipes::load(world, *terrain, cut));
  EXPECT_TRUE(terrain->isCurrent());
}

// Ten thousand cells; the origin moves nine times.
TEST_F(Box2dRecipes, AWorldThatMovesItsOrigin) {
  constexpr std::int32_t kCells = 10'000;
  fill({{-5, -1}, {kCells, -1}}, recipes::kIce);
  fill({{600, 3}, {602, 3}}, recipes::kStone);  // a ledge
  ground(0.5);
  const Body ball = addBody({0, 0.36F}, Form::ball, 0);
  const Body sleeper = addBody({300.75F, 2.36F}, Form::box, 0.8F);
  step(120);
  ASSERT_FALSE(isAwake(sleeper));
  setVelocity(ball, {40, 0});
  Cell origin;
  int moves = 0;
  const double height = positionOf(ball).y;
  while (terrain->cellAt(positionOf(ball)).i < kCells - 200) {
    const Cell before = origin;
    const Cell at = terrain->cellAt(positionOf(ball));
    follow(origin, ball, sleeper);
    moves += before == origin ? 0 : 1;
    ASSERT_EQ(terrain->cellAt(positionOf(ball)), at);
    ASSERT_LT(std::abs(positionOf(ball).x), 600);
    step(1);
    ASSERT_NEAR(velocityOf(ball).x, 40, 1e-3F);
    ASSERT_NEAR(positionOf(ball).y, height, 1e-3F);
  }
  EXPECT_EQ(moves, 9);
  EXPECT_FALSE(isAwake(sleeper));
  EXPECT_EQ(terrain->cellAt(positionOf(sleeper)), (Cell{601, 4}));
}

}  // namespace
}  // namespace lgs::box2d_test
