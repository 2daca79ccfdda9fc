// The terrain in Box2D 3. It is built if that is the Box2D that was found.
#include "oracle/trace/player.h"

#include "physics3.h"
#include "played.h"
#include "shapes3.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace lgs::box2d_test {
namespace {

using box2d::EdgeId;
using box2d::Terrain;
using box2d::TerrainOptions;

class Box2d3Terrain : public Physics3 {};

TEST_F(Box2d3Terrain, ShapesFollowRandomEdits) {
  forAllEdits(40, [&](const Trace& trace, Chance random) {
    oracle::Player player(trace.preserve);
    TerrainOptions options;
    options.chunkCells = 1 + random.below(7);
    options.merge = random.chance(50);
    options.origin = firstCell(trace);
    SCOPED_TRACE(fmt::format("chunks of {} cells, merge {}", options.chunkCells, options.merge));
    {
      Terrain terrain(physics, player.world(), options);
      playAll(trace, player, [&] {
        terrain.sync(player.commit());
        expectShapes(physics, terrain, options);
        step(1);
      });
    }
    EXPECT_EQ(b2World_GetCounters(physics).bodyCount, 0);
  });
}

// As in a game whose destructor destroys it, and whose members go after that.
TEST_F(Box2d3Terrain, ThePhysicsWorldMayGoFirst) {
  field.addFloor(0, 3);
  field.world.commit();
  const b2WorldDef definition = b2DefaultWorldDef();
  const b2WorldId gone = b2CreateWorld(&definition);
  const Terrain terrain(gone, field.world);
  b2DestroyWorld(gone);
  const b2WorldId other = b2CreateWorld(&definition);  // in its place
  EXPECT_FALSE(b2World_IsValid(gone));
  b2DestroyWorld(other);
}

// Box2D's own way to say it: an open chain of the same four vertices.
TEST_F(Box2d3Terrain, AShapeIsWhatBox2dMakesOfAnOpenChain) {
  field.add({0, 0}, below(3, 8));
  field.add({1, 0}, kSquare);
  field.add({2, 0}, below(8, 2));
  field.add({0, 1}, above(5, 1));
  field.world.commit();
  const Terrain terrain(physics, field.world);
  b2BodyDef definition = b2DefaultBodyDef();
  const b2BodyId body = b2CreateBody(physics, &definition);
  for (const EdgeId id : terrain.edges().edges()) {
    const b2ChainSegment own = b2Shape_GetChainSegment(terrain.shape(id));
    b2ChainDef chain = b2DefaultChainDef();
    const std::vector<b2Vec2> points{own.ghost1, own.segment.point1, own.segment.point2, own.ghost2};
    setPoints(chain, points, false);
    b2ShapeId shape;
    ASSERT_EQ(b2Chain_GetSegments(b2CreateChain(body, &chain), &shape, 1), 1);
    const b2ChainSegment theirs = b2Shape_GetChainSegment(shape);
    EXPECT_EQ(b2Distance(own.ghost1, theirs.ghost1), 0);
    EXPECT_EQ(b2Distance(own.segment.point1, theirs.segment.point1), 0);
    EXPECT_EQ(b2Distance(own.segment.point2, theirs.segment.point2), 0);
    EXPECT_EQ(b2Distance(own.ghost2, theirs.ghost2), 0);
  }
}

TEST_F(Box2d3Terrain, ARestingBodyFallsWhenItsCellIsDugAway) {
  field.addFloor(0, 8);
  for (std::int32_t i = 0; i <= 8; ++i) field.add({i, -3}, kSquare);
  field.world.commit();
  Terrain terrain(physics, field.world);
  const b2BodyId ball = addBall({4.5F, 0.4F}, 0.5F);
  step(200);
  ASSERT_FALSE(b2Body_IsAwake(ball));
  ASSERT_TRUE(field.world.remove(field.world.polygons({4, -1})[0].handle));
  terrain.sync(field.world.commit());
  EXPECT_TRUE(b2Body_IsAwake(ball));
  step(120);
  EXPECT_NEAR(heightOf(ball), -2 + 0.35F, 0.02F);
}

TEST_F(Box2d3Terrain, ABodyOfAnotherCategoryWakesWhereGroundAppearsOrIsRelinked) {
  constexpr std::uint64_t kGround = 2;
  constexpr std::uint64_t kBalls = 4;
  field.addFloor(0, 8);
  field.world.commit();
  TerrainOptions options;
  options.material = [](Block) {
    box2d::Material material;
    material.filter.categoryBits = kGround;
    material.filter.maskBits = kBalls;
    return material;
  };
  Terrain terrain(physics, field.world, options);
  const b2BodyId ball = addBall({4.5F, 0.4F}, 0.5F);
  b2ShapeId shape;
  b2Body_GetShapes(ball, &shape, 1);
  b2Filter filter = b2DefaultFilter();
  filter.categoryBits = kBalls;
  filter.maskBits = kGround;
  b2Shape_SetFilter(shape, filter);
  step(200);
  ASSERT_FALSE(b2Body_IsAwake(ball));
  EXPECT_NEAR(heightOf(ball), 0.35F, 0.01F);
  field.add({5, 0}, kSquare);  // beside the ball: the edge below the ball gets another ghost
  const Changes& relinked = field.world.commit();
  EXPECT_FALSE(relinked.relinked.empty());
  terrain.sync(relinked);
  EXPECT_TRUE(b2Body_IsAwake(ball));
  step(200);
  ASSERT_FALSE(b2Body_IsAwake(ball));
  field.add({4, 1}, kSquare);  // above the ball, which does not touch it
  terrain.sync(field.world.commit());
  EXPECT_TRUE(b2Body_IsAwake(ball));
}

TEST_F(Box2d3Terrain, AFrictionlessBallOverCellsAndAGapFilledAheadOfIt) {
  field.addFloor(-2, 60);
  ASSERT_TRUE(field.world.remove(field.world.polygons({30, -1})[0].handle));
  field.world.commit();
  TerrainOptions options;
  options.chunkCells = 5;
  Terrain terrain(physics, field.world, options);
  const b2BodyId ball = addBall({0, 0.36F}, 0);
  step(60);
  b2Body_SetLinearVelocity(ball, {4, 0});
  float unrest = 0;
  bool filled = false;
  for (int k = 0; k < 14 * 60; ++k) {
    if (!filled && b2Body_GetPosition(ball).x > 29.4F) {
      field.add({30, -1}, kSquare);
      terrain.sync(field.world.commit());
      expectShapes(physics, terrain, options);
      filled = true;
    }
    step(1);
    const b2Vec2 v = b2Body_GetLinearVelocity(ball);
    unrest = std::max({unrest, std::abs(v.x - 4), std::abs(v.y)});
  }
  EXPECT_TRUE(filled);
  EXPECT_LT(unrest, 1e-3F);
  EXPECT_GT(b2Body_GetPosition(ball).x, 50);
}

TEST_F(Box2d3Terrain, BeforeTheSyncWhatIsGoneIsNotHit) {
  field.addFloor(0, 9);
  field.world.commit();
  for (const bool merge : {false, true}) {
    SCOPED_TRACE(merge);
    TerrainOptions options;
    options.merge = merge;
    Terrain terrain(physics, field.world, options);
    const std::vector<SegmentId> all = field.world.segments();
    ASSERT_TRUE(field.world.remove(field.world.polygons({4, -1})[0].handle));
    const Changes changes = field.world.commit();
    ASSERT_FALSE(changes.removed.empty());
    for (const SegmentId id : all) {
      const EdgeId edge = terrain.edges().edgeOf(id);
      const bool gone = std::any_of(changes.removed.begin(), changes.removed.end(),
                                    [&](SegmentId other) { return terrain.edges().edgeOf(other) == edge; });
      EXPECT_EQ(terrain.hit(terrain.shape(id), {4.5F, 0}).has_value(), !gone);
      EXPECT_TRUE(merge || terrain.hit(terrain.shape(id)).has_value() == !gone);
    }
    terrain.sync(changes);
    for (const EdgeId id : terrain.edges().edges()) EXPECT_TRUE(terrain.hit(terrain.shape(id), {0, 0}));
    field.add({4, -1}, kSquare);
    terrain.sync(field.world.commit());
  }
}

}  // namespace
}  // namespace lgs::box2d_test
