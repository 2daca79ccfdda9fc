// The terrain in a live Box2D world: fixtures follow the world's segments through each edit, bodies notice changes, and
// a fixture knows what it stands for.
#include "oracle/calls/random.h"
#include "oracle/trace/player.h"

#include "either.h"
#include "played.h"

#include <fmt/format.h>
#include <lgs/box2d/terrain.h>
#include <cmath>
#include <tuple>

namespace lgs::box2d_test {
namespace {

using box2d::EdgeId;
using box2d::Terrain;
using box2d::TerrainOptions;

b2Body& addBall(b2World& physics, b2Vec2 at, float radius = 0.35F, float friction = 0.5F) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = at;
  b2Body& body = *physics.CreateBody(&definition);
  b2CircleShape circle;
  circle.m_radius = radius;
  body.CreateFixture(&circle, 1)->SetFriction(friction);
  return body;
}

// If nothing is merged and nothing too short, the edges are the segments.
void expectSegments(const World& world, const Terrain& terrain) {
  const std::vector<SegmentId> segments = world.segments();
  EXPECT_EQ(terrain.edges().edges().size(), segments.size());
  for (const SegmentId id : segments) {
    const Segment s = *world.segment(id);
    const box2d::Edge& e = terrain.edges().edge(terrain.edges().edgeOf(id));
    EXPECT_EQ(std::tie(e.start, e.end), std::tie(s.start, s.end));
    EXPECT_EQ(e.ghost1, std::optional(s.ghost1));
    EXPECT_EQ(e.ghost2, std::optional(s.ghost2));
  }
}

using Box2dTerrain = EitherBox2d;

TEST_F(Box2dTerrain, FixturesFollowRandomEdits) {
  forAllEdits(40, [](const Trace& trace, Chance random) {
    oracle::Player player(trace.preserve);
    TerrainOptions options{.cellSize = random.chance(50) ? 1 : 0.02, .chunkCells = 1 + random.below(8)};
    options.merge = random.chance(50);
    SCOPED_TRACE(fmt::format("cells of {} m, chunks of {} cells, merge {}", options.cellSize, options.chunkCells,
                             options.merge));
    b2World empty({0, -10});
    {
      Terrain terrain(empty, player.world(), options);
      playAll(trace, player, [&] {
        terrain.sync(player.commit());
        expectFixtures(empty, terrain, options);
      });
      // A terrain made now is the same.
      b2World other({0, -10});
      const Terrain anew(other, player.world(), options);
      EXPECT_EQ(anew.edges().counts(), terrain.edges().counts());
      EXPECT_EQ(anew.bodyCount(), terrain.bodyCount());
      EXPECT_EQ(static_cast<std::size_t>(empty.GetBodyCount()), terrain.bodyCount());
    }
    EXPECT_EQ(empty.GetBodyCount(), 0);
  });
}

TEST_F(Box2dTerrain, ARestingBodyFallsWhenItsCellIsDugAway) {
  field.addFloor(0, 8);
  for (std::int32_t i = 0; i <= 8; ++i) field.add({i, -3}, kSquare);
  field.world.commit();
  Terrain terrain(physics, field.world);
  b2Body& ball = addBall(physics, {4.5F, 0.4F});
  step(120);
  ASSERT_FALSE(ball.IsAwake());
  const b2Vec2 rest = ball.GetPosition();

  // The ball is far from the change and sleeps on.
  ASSERT_TRUE(field.world.remove(field.world.polygons({0, -1})[0].handle));
  terrain.sync(field.world.commit());
  EXPECT_FALSE(ball.IsAwake());
  step(10);
  EXPECT_EQ(ball.GetPosition(), rest);

  ASSERT_TRUE(field.world.remove(field.world.polygons({4, -1})[0].handle));
  terrain.sync(field.world.commit());
  EXPECT_TRUE(ball.IsAwake());
  step(120);
  EXPECT_NEAR(ball.GetPosition().y, -2 + 0.35F, 0.02F);
}

TEST_F(Box2dTerrain, ABodyWakesWhereGroundAppearsOrIsRelinked) {
  field.addFloor(0, 8);
  field.world.commit();
  Terrain terrain(physics, field.world);
  b2Body& ball = addBall(physics, {4.5F, 0.4F});
  step(120);
  ASSERT_FALSE(ball.IsAwake());
  field.add({5, 0}, kSquare);  // beside the ball: the edge below the ball gets another ghost
  const Changes& changes = field.world.commit();
  EXPECT_FALSE(changes.relinked.empty());
  terrain.sync(changes);
  EXPECT_TRUE(ball.IsAwake());
  expectFixtures(physics, terrain, {});
}

TEST_F(Box2dTerrain, ABallRollsOnOverAGapFilledAheadOfIt) {
  field.addFloor(-2, 40);
  ASSERT_TRUE(field.world.remove(field.world.polygons({20, -1})[0].handle));
  field.world.commit();
  Terrain terrain(physics, field.world, {.material = [](Block) { return box2d::Material{.friction = 0}; }});
  b2Body& ball = addBall(physics, {0, 0.36F}, 0.35F, 0);
  step(60);
  ball.SetLinearVelocity({6, 0});
  bool filled = false;
  float unrest = 0;
  while (ball.GetPosition().x < 38) {
    if (!filled && ball.GetPosition().x > 19.4F) {
      field.add({20, -1}, kSquare);
      terrain.sync(field.world.commit());
      filled = true;
    }
    step(1);
    unrest = std::max({unrest, std::abs(ball.GetLinearVelocity().y), std::abs(ball.GetLinearVelocity().x - 6)});
    ASSERT_GT(ball.GetPosition().y, 0.3F);
  }
  EXPECT_TRUE(filled);
  EXPECT_LT(unrest, 1e-4F);
}

TEST_F(Box2dTerrain, DiggingAndRefillingBesideABallForThousandsOfSteps) {
  constexpr int kSteps = 4'000;
  field.addFloor(0, 39);
  for (std::int32_t i = 0; i < 40; ++i) field.add({i, -2}, kSquare);
  for (const std::int32_t i : {0, 39}) field.add({i, 0}, kSquare);
  field.world.commit();
  const TerrainOptions options{.chunkCells = 8};
  Terrain terrain(physics, field.world, options);
  b2Body& ball = addBall(physics, {20, 0.4F});
  oracle::Random random(1);
  const std::vector<Polygon> shapes{kSquare, below(8, 4), below(4, 8), below(0, 8), above(4, 4)};
  std::vector<PolygonHandle> dug;
  for (int k = 0; k < kSteps; ++k) {
    ball.SetLinearVelocity({(k / 300) % 2 == 0 ? 3.0F : -3.0F, ball.GetLinearVelocity().y});
    ball.SetAwake(true);
    // A cell before or behind the ball, be it solid or not; then the next cell.
    const Cell at = terrain.cellAt(ball.GetPosition());
    const Cell cell{at.i + random.pick(std::vector<std::int32_t>{-2, -1, 1, 2}), -1};
    if (cell.i > 0 && cell.i < 39) {
      const auto here = field.world.polygons(cell);
      if (here.empty()) {
        ASSERT_TRUE(field.world.add(cell, std::span<const LocalPoint>(random.pick(shapes)), 1));
      } else {
        ASSERT_TRUE(field.world.remove(here[0].handle));
      }
      terrain.sync(field.world.commit());
    }
    expectSegments(field.world, terrain);
    expectFixtures(physics, terrain, options);
    if (HasFailure()) return;
    step(1);
    ASSERT_GT(ball.GetPosition().y, -1.2F);
  }
}

TEST_F(Box2dTerrain, MaterialsByBlock) {
  field.add({0, 0}, kSquare, 1);
  field.add({1, 0}, kSquare, 2);
  field.add({2, 0}, kSquare, 3);  // the same material as block 2
  field.world.commit();
  int asked = 0;
  TerrainOptions options{.merge = true};
  options.material = [&asked](Block block) {
    ++asked;
    box2d::Material material;
    material.friction = block == 1 ? 0.9F : 0.1F;
    material.restitution = 0.5F;
    material.filter.categoryBits = block == 1 ? 2 : 4;
    return material;
  };
  const Terrain terrain(physics, field.world, options);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(terrain.edges().counts().edges, 6U);
  for (const EdgeId id : terrain.edges().edges()) {
    const b2Fixture& f = *terrain.fixture(id);
    const bool first = terrain.edges().edge(id).block == 1;
    EXPECT_EQ(f.GetFriction(), first ? 0.9F : 0.1F);
    EXPECT_EQ(f.GetRestitution(), 0.5F);
    EXPECT_EQ(f.GetFilterData().categoryBits, first ? 2 : 4);
  }
}

TEST_F(Box2dTerrain, MaterialsThatDifferInOneThingAreNotMerged) {
  for (const Block block : {1U, 2U, 3U, 4U, 5U, 6U}) {  // each beside a block with the default material
    field.add({2 * static_cast<std::int32_t>(block), 0}, kSquare, 0);
    field.add({2 * static_cast<std::int32_t>(block) + 1, 0}, kSquare, block);
  }
  field.world.commit();
  TerrainOptions options{.chunkCells = 64, .merge = true};
  options.material = [](Block block) {
    box2d::Material material;
    if (block == 1) material.friction += 0.5F;
    if (block == 2) material.restitution += 0.5F;
    if (block == 3) material.restitutionThreshold += 0.5F;
    if (block == 4) material.filter.categoryBits ^= 2;
    if (block == 5) material.filter.maskBits ^= 2;
    if (block == 6) material.filter.groupIndex += 1;
    return material;
  };
  const Terrain terrain(physics, field.world, options);
  EXPECT_EQ(terrain.edges().counts().edges, 2U * 12 + 2);
}

TEST_F(Box2dTerrain, ShortSegmentsAreCountedAndHarmless) {
  field.addFloor(0, 9);
  // A step of a thousandth of a cell is less than Box2D's slop.
  field.add({5, 0}, {{0, 0}, {U, 0}, {U, 65}, {0, 65}});
  field.world.commit();
  Terrain terrain(physics, field.world);
  EXPECT_EQ(terrain.edges().counts().leftOut, 2U);
  b2Body& ball = addBall(physics, {1, 0.36F}, 0.35F, 0);
  ball.GetFixtureList()->SetFriction(0);
  step(60);
  ball.SetLinearVelocity({4, 0});
  step(100);
  EXPECT_NEAR(ball.GetLinearVelocity().x, 4, 0.1F);
}

TEST_F(Box2dTerrain, FarAwayIsAsNear) {
  constexpr Cell kFar{1 << 29, -(1 << 29)};
  for (std::int32_t i = 0; i < 10; ++i) field.add({kFar.i + i, kFar.j}, kSquare);
  field.world.commit();
  Terrain terrain(physics, field.world, {.origin = kFar});
  b2Body& ball = addBall(physics, {4.25F, 1.4F});
  step(120);
  EXPECT_NEAR(ball.GetPosition().y, 1.35F, 0.01F);
  EXPECT_EQ(terrain.cellAt({4.25F, 0.5F}), (Cell{kFar.i + 4, kFar.j}));
}

}  // namespace
}  // namespace lgs::box2d_test
