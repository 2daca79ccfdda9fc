// Places in Box2D 3. Where its positions are `double` (BOX2D_DOUBLE_PRECISION) the ground far away is as good as near.
#include "physics3.h"
#include "proptests/support/must.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace lgs::box2d_test {
namespace {

using box2d::Position;
using box2d::Terrain;
using box2d::TerrainOptions;

// In float a body at 3·10^7 m moves in steps of 2 m; at 30 m in steps of 2 µm.
constexpr std::int32_t kFar = std::is_same_v<decltype(Position::x), double> ? 100'000'000 : 100;

class Box2d3Places : public Physics3 {
 protected:
  Box2d3Places() {
    for (std::int32_t i = -4; i < 60; ++i) field.add({kFar + i, kFar - 1}, kSquare);
    field.world.commit();
    options.cellSize = 0.3;
    options.chunkCells = 5;
  }
  Position at(double column, double metresUp) const {
    using Real = decltype(Position::x);
    return {static_cast<Real>((kFar + column) * 0.3), static_cast<Real>(kFar * 0.3 + metresUp)};
  }
  double heightOf(b2BodyId ball) const { return static_cast<double>(b2Body_GetPosition(ball).y) - kFar * 0.3; }

  TerrainOptions options;
};

TEST_F(Box2d3Places, ABallRollsSmoothlyFarFromTheOrigin) {
  const Terrain terrain(physics, field.world, options);
  const b2BodyId ball = addBall(at(0.5, 0.36), 0);
  step(60);
  b2Body_SetLinearVelocity(ball, {3, 0});
  float unrest = 0;
  for (int k = 0; k < 300; ++k) {
    step(1);
    const b2Vec2 v = b2Body_GetLinearVelocity(ball);
    unrest = std::max({unrest, std::abs(v.x - 3), std::abs(v.y)});
  }
  EXPECT_LT(unrest, 2e-3F);
  EXPECT_NEAR(heightOf(ball), 0.35, 0.01);
  EXPECT_GT(b2Body_GetPosition(ball).x, at(45, 0).x);
}

TEST_F(Box2d3Places, TheCellIsFoundFarFromTheOrigin) {
  options.merge = true;
  options.chunkCells = 100;
  const Terrain terrain(physics, field.world, options);
  EXPECT_LE(terrain.edges().counts().edges, 6U);
  for (const SegmentId id : field.world.segments()) {
    const Segment segment = *field.world.segment(id);
    const Position middle =
        terrain.position({(segment.start.x + segment.end.x) / 2, (segment.start.y + segment.end.y) / 2});
    const auto hit = test::must(terrain.hit(terrain.shape(id), middle));
    EXPECT_EQ(hit.segment, id);
    EXPECT_EQ(terrain.cellAt(terrain.position(toWorld(segment.cell, {U / 2, U / 2}))), segment.cell);
  }
  const Position corner = terrain.position(toWorld({kFar + 1, kFar}, {}));
  EXPECT_NEAR(corner.x, at(1, 0).x, 1e-8);
}

TEST_F(Box2d3Places, ARestingBodyWakesFarFromTheOrigin) {
  Terrain terrain(physics, field.world, options);
  const b2BodyId ball = addBall(at(7.5, 0.36), 0.5F);
  step(200);
  ASSERT_FALSE(b2Body_IsAwake(ball));
  field.add({kFar + 9, kFar}, kSquare);
  terrain.sync(field.world.commit());
  EXPECT_TRUE(b2Body_IsAwake(ball));
}

}  // namespace
}  // namespace lgs::box2d_test
