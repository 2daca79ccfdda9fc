// The fixtures of a terrain must agree with its edges.
#pragma once

#include <box2d/box2d.h>
#include <gtest/gtest.h>
#include <lgs/box2d/terrain.h>
#include <vector>

namespace lgs::box2d_test {

inline std::size_t edgesIn(const b2World& physics) {
  std::size_t edges = 0;
  for (const b2Body* body = physics.GetBodyList(); body != nullptr; body = body->GetNext()) {
    for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
      edges += f->GetType() == b2Shape::e_edge ? 1 : 0;
    }
  }
  return edges;
}

/// Expects each fixture where its edge is, and no other fixtures.
inline void expectFixtures(const b2World& physics, const box2d::Terrain& terrain,
                           const box2d::TerrainOptions& options) {
  const box2d::Frame frame{options.cellSize, options.origin, options.chunkCells};
  const std::vector<box2d::EdgeId> edges = terrain.edges().edges();
  EXPECT_EQ(edgesIn(physics), edges.size());
  for (const box2d::EdgeId id : edges) {
    const box2d::Edge& e = terrain.edges().edge(id);
    const box2d::Chunk chunk = terrain.edges().chunk(e.chunk);
    const auto at = [&](Point p) {
      const box2d::Metres m = frame.local(p, chunk);
      return b2Vec2(m.x, m.y);
    };
    b2Fixture* fixture = terrain.fixture(id);
    ASSERT_NE(fixture, nullptr);
    const auto& shape = static_cast<const b2EdgeShape&>(*fixture->GetShape());
    EXPECT_TRUE(shape.m_oneSided);
    EXPECT_EQ(shape.m_vertex1, at(e.start));
    EXPECT_EQ(shape.m_vertex2, at(e.end));
    // A ghost that is missing, or too close for Box2D, is straight on.
    const auto ghost = [&](const std::optional<Point>& p, b2Vec2 near, b2Vec2 far) {
      return p && b2Distance(at(*p), near) > b2_linearSlop ? at(*p) : near + (near - far);
    };
    const auto direction = [](b2Vec2 from, b2Vec2 to) {  // of a ghost it counts, and no more
      b2Vec2 way = to - from;
      way.Normalize();
      return way;
    };
    const b2Vec2 start = at(e.start), end = at(e.end);
    EXPECT_LT(b2Distance(direction(start, shape.m_vertex0), direction(start, ghost(e.ghost1, start, end))), 1e-4F);
    EXPECT_LT(b2Distance(direction(end, shape.m_vertex3), direction(end, ghost(e.ghost2, end, start))), 1e-4F);
    EXPECT_EQ(fixture->GetBody()->GetPosition(), terrain.position(frame.cornerOf(chunk)));
  }
}

}  // namespace lgs::box2d_test
