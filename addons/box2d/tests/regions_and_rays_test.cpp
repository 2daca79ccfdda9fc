// Rays through the exact ground, what a welded edge is, bodies in a region, and materials that change: for whichever
// Box2D there is.
#include "crowd.h"
#include "either.h"
#include "played.h"
#include "proptests/support/must.h"

#include <lgs/box2d/bodies_in.h>
#include <limits>

namespace lgs::box2d_test {
namespace {

using box2d::EdgeId;
using box2d::GroundRayHit;
using box2d::Hit;
using box2d::Terrain;

class Box2dGround : public EitherBox2d {
 protected:
#ifndef B2_IS_NULL
  static std::optional<Hit> hitOf(const Terrain& terrain, EdgeId id, Position at) {
    return terrain.hit(*terrain.fixture(id), at);
  }
#else
  static std::optional<Hit> hitOf(const Terrain& terrain, EdgeId id, Position at) {
    return terrain.hit(terrain.shape(id), at);
  }
#endif
};

// The chamfer is 2.3 mm long: too short for Box2D, whose rays leak there.
TEST_F(Box2dGround, ARayHitsWhatIsTooShortForAnEdge) {
  constexpr std::int32_t kShort = 107;
  const PolygonHandle block = field.add({5, 5}, {{0, 0}, {U, 0}, {U, U - kShort}, {U - kShort, U}, {0, U}}, 7);
  field.world.commit();
  const Terrain terrain(physics, field.world, {.cellSize = 1, .origin = {4, 4}});
  ASSERT_EQ(terrain.edges().counts().leftOut, 1U);
  const float corner = 2 - kShort / 2.0F / U;
  const GroundRayHit hit = test::must(terrain.rayCast({2.5F, 2.5F}, {1.5F, 1.5F}));
  EXPECT_EQ(terrain.edges().edgeOf(hit.hit.segment), EdgeId{});
  EXPECT_EQ(hit.hit.polygon, block);
  EXPECT_EQ(hit.hit.block, 7U);
  EXPECT_EQ(hit.hit.cell, (Cell{5, 5}));
  EXPECT_NEAR(hit.point.x, corner, 1e-4F);
  EXPECT_NEAR(hit.point.y, corner, 1e-4F);
  EXPECT_NEAR(hit.fraction, 2.5F - corner, 1e-4F);
  EXPECT_NEAR(hit.normal.x, std::sqrt(0.5F), 1e-5F);
  EXPECT_NEAR(hit.normal.y, std::sqrt(0.5F), 1e-5F);
  EXPECT_FALSE(terrain.rayCast({1.5F, 1.5F}, {2.5F, 2.5F})) << "out of the solid";
  EXPECT_FALSE(terrain.rayCast({2.5F, 2.5F}, {2.1F, 2.1F})) << "too short";
}

TEST_F(Box2dGround, WhatIsFarOrNoNumberIsRefused) {
  field.addFloor(0, 3);
  field.world.commit();
  const Terrain terrain(physics, field.world, {.cellSize = 0.5});
  using Real = decltype(Position::x);
  const Real none = std::numeric_limits<Real>::quiet_NaN(), endless = std::numeric_limits<Real>::infinity();
  for (const Real far : {none, endless, -endless, Real{3e9F}, Real{-3e9F}, Real{1e30F}}) {
    EXPECT_FALSE(terrain.rayCast({1, 1}, {far, -5}));
    EXPECT_FALSE(terrain.rayCast({1, far}, {1, -5}));
    EXPECT_FALSE(terrain.nearest({far, 0}, 1));
    EXPECT_FALSE(inRange(terrain.cellAt({far, 0})));
    EXPECT_FALSE(inRange(terrain.cellAt({0, far})));
    EXPECT_FALSE(inRange(terrain.latticePoint({far, 0})));
  }
  EXPECT_FALSE(terrain.rayCast({1, 9'000}, {1, -5})) << "too long";
  EXPECT_TRUE(terrain.rayCast({1, 5}, {1, -5}));
  EXPECT_EQ(terrain.cellAt({-0.1F, 0.6F}), (Cell{-1, 1}));
  EXPECT_FALSE(std::isnan(terrain.position({INT64_MIN, INT64_MAX}).x));
}

// With cells of 2 cm nearly all is welded.
TEST_F(Box2dGround, AWeldedEdgeIsHitWhereItsMaterialIs) {
  forAllEdits(200, [](const Trace& trace, Chance random) {
    box2d::TerrainOptions options{.cellSize = 0.02, .merge = random.chance(50)};
    options.material = [](Block block) { return withFriction(static_cast<float>(block % 3)); };
    options.origin = firstCell(trace);
    oracle::Player player(trace.preserve);
    Crowd crowd;
    Terrain terrain(crowd.physics, player.world(), options);
    playAll(trace, player, [&] {
      terrain.sync(player.commit());
      for (const SegmentId id : player.world().segments()) {
        const EdgeId edge = terrain.edges().edgeOf(id);
        if (!edge) continue;
        const Segment s = *player.world().segment(id);
        const auto hit =
            test::must(hitOf(terrain, edge, terrain.position({(s.start.x + s.end.x) / 2, (s.start.y + s.end.y) / 2})));
        EXPECT_EQ(static_cast<float>(hit.block % 3), frictionOf(terrain, edge));
      }
    });
  });
}

TEST_F(Box2dGround, BodiesInARegion) {
  field.addFloor(-8, 8);
  field.world.commit();
  Terrain terrain(physics, field.world, {.cellSize = 0.5});
  addBody({1, 1}, Form::ball, 0);
  addBody({3, 1}, Form::box, 0);
  const auto count = [&](std::int64_t x, std::int64_t y, std::int64_t radius) {
    return bodiesIn(terrain, circle({x * (U / 8), y * (U / 8)}, radius * (U / 8), 64)).size();
  };
  EXPECT_EQ(count(16, 16, 1), 1U) << "in the middle of the ball, 5.6 eighths of a cell large";
  EXPECT_EQ(count(24, 16, 2), 0U) << "beside it";
  EXPECT_EQ(count(24, 16, 3), 1U);
  EXPECT_EQ(count(9, 9, 3), 0U) << "in the box around it alone";
  EXPECT_EQ(count(48, 16, 2), 1U);
  EXPECT_EQ(count(32, 16, 40), 2U);
  EXPECT_TRUE(bodiesIn(terrain, Region{}).empty());
  const Region hole{{circle({16 * (U / 8), 16 * (U / 8)}, U, 32).rings[0], circle({2 * U, 2 * U}, 4 * U, 32).rings[0]},
                    FillRule::evenOdd};
  EXPECT_EQ(bodiesIn(terrain, hole).size(), 1U) << "the ball is in the hole";
  EXPECT_EQ(terrain.bodiesIn({2, 2}).size(), 1U) << "a cell, not a rectangle";
  EXPECT_EQ(terrain.bodiesIn({{0, 0}, {6, 2}}).size(), 2U);
}

TEST_F(Box2dGround, AMaterialThatChangesReachesItsShapesAndNoOthers) {
  field.addFloor(0, 3);
  field.add({6, -1}, kSquare, 2);
  field.world.commit();
  float frictionOfTwo = 0.5F;
  box2d::TerrainOptions options{.merge = true};
  options.material = [&](Block block) { return withFriction(block == 2 ? frictionOfTwo : 0.25F); };
  Terrain terrain(physics, field.world, options);
  const Body ball = addBody({1.5F, 0.36F}, Form::ball, 0), box = addBody({6.5F, 0.36F}, Form::box, 0);
  step(120);
  ASSERT_FALSE(isAwake(ball) || isAwake(box));
  const EdgeId one = terrain.edges().edgeOf(field.world.nearest({U, 1}, 1)->segment);
  const EdgeId two = terrain.edges().edgeOf(field.world.nearest({6 * U + 9, 1}, 1)->segment);
  frictionOfTwo = 0.75F;
  EXPECT_EQ(frictionOf(terrain, two), 0.5F);
  terrain.materialsChanged();
  EXPECT_EQ(frictionOf(terrain, one), 0.25F);
  EXPECT_EQ(frictionOf(terrain, two), 0.75F);
  EXPECT_FALSE(isAwake(ball));
  EXPECT_TRUE(isAwake(box));
  expectEdges(terrain, options);
  step(60);
  EXPECT_GT(positionOf(box).y, 0.3F);
}

// A row of tiles that grows at its end moves the ghost of the edge before its end along its own line.
TEST_F(Box2dGround, WhatRestsBesideAGhostThatOnlyGetsLongerSleepsOn) {
  field.addFloor(0, 3);
  field.world.commit();
  box2d::TerrainOptions options{.chunkCells = 4, .merge = true};
  Terrain terrain(physics, field.world, options);
  const Body box = addBody({2.5F, 0.36F}, Form::box, 0.5F);
  field.add({4, -1}, kSquare);
  ASSERT_TRUE(terrain.commit(field.world));
  step(120);
  ASSERT_FALSE(isAwake(box));
  for (std::int32_t i = 5; i < 8; ++i) {
    field.add({i, -1}, kSquare);
    ASSERT_TRUE(terrain.commit(field.world));
    EXPECT_FALSE(isAwake(box)) << "its edge ends with the chunk, and so does not change but for its ghost";
    expectEdges(terrain, options);
  }
}

}  // namespace
}  // namespace lgs::box2d_test
