// The shapes of a terrain in Box2D 3 must agree with its edges.
#pragma once

#include <gtest/gtest.h>
#include <lgs/box2d/terrain.h>
#include <optional>
#include <utility>
#include <vector>

namespace lgs::box2d_test {

inline void expectNear(b2Vec2 a, box2d::Metres b) {
  EXPECT_NEAR(a.x, b.x, 1e-5F);
  EXPECT_NEAR(a.y, b.y, 1e-5F);
}

// A ghost that is missing, or too close for Box2D, is straight on.
inline void expectGhost(b2Vec2 actual, const std::optional<Point>& p, b2Vec2 near, b2Vec2 far,
                        const box2d::Frame& frame, box2d::Chunk chunk) {
  if (p) {
    const box2d::Metres m = frame.local(*p, chunk);
    if (b2Distance({m.x, m.y}, near) > 0.005F) {  // its direction counts, and no more
      const b2Vec2 is = b2Normalize(b2Sub(actual, near)), shall = b2Normalize({m.x - near.x, m.y - near.y});
      return expectNear(is, {shall.x, shall.y});
    }
  }
  expectNear(actual, {2 * near.x - far.x, 2 * near.y - far.y});
}

/// Expects each shape where its edge is.
inline void expectShapes(b2WorldId physics, const box2d::Terrain& terrain, const box2d::TerrainOptions& options) {
  const box2d::Frame frame{options.cellSize, options.origin, options.chunkCells};
  const std::vector<box2d::EdgeId> edges = terrain.edges().edges();
  // The world may hold balls, too.
  EXPECT_GE(static_cast<std::size_t>(b2World_GetCounters(physics).shapeCount), edges.size());
  for (const box2d::EdgeId id : edges) {
    const box2d::Edge& e = terrain.edges().edge(id);
    const box2d::Chunk chunk = terrain.edges().chunk(e.chunk);
    ASSERT_TRUE(b2Shape_IsValid(terrain.shape(id)));
    const b2ChainSegment s = b2Shape_GetChainSegment(terrain.shape(id));
    expectNear(s.segment.point1, frame.local(e.start, chunk));
    expectNear(s.segment.point2, frame.local(e.end, chunk));
    expectGhost(s.ghost1, e.ghost1, s.segment.point1, s.segment.point2, frame, chunk);
    expectGhost(s.ghost2, e.ghost2, s.segment.point2, s.segment.point1, frame, chunk);
    EXPECT_TRUE(terrain.hit(terrain.shape(id)));
    const auto body = b2Body_GetPosition(b2Shape_GetBody(terrain.shape(id)));
    const box2d::Position corner = terrain.position(frame.cornerOf(chunk));
    EXPECT_EQ(std::pair(body.x, body.y), std::pair(corner.x, corner.y));
  }
}

}  // namespace lgs::box2d_test
