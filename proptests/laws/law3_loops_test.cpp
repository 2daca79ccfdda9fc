// Law 3, by hand (random worlds: oracle/check/laws/): without a preserve relation links are mutual, and following them gives closed loops. Where two solids
// touch in one point the chain turns through the free wedge, from one solid to the other.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test {
namespace {

TEST(Loops, AreTheFacesIncludingHoles) {
  World world;
  ASSERT_TRUE(world.fill({{0, 0}, {2, 2}}, shapeOf(world, {unitSquare()}), 1));
  removeAll(world, {1, 1});
  world.commit();
  const std::vector<Loop> kept = world.loops(), merged = world.loops(Collinear::merge);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].vertices.size(), 12U);
  EXPECT_EQ(kept[0].segments.size(), 12U);
  EXPECT_EQ(kept[1].vertices, (std::vector<Point>{{U, U}, {U, 2 * U}, {2 * U, 2 * U}, {2 * U, U}}));  // clockwise
  for (const Loop& loop : kept)
    for (std::size_t k = 0; k < loop.segments.size(); ++k)
      EXPECT_EQ(world.segment(loop.segments[k])->start, loop.vertices[k]);
  ASSERT_EQ(merged.size(), 2U);
  EXPECT_EQ(merged[0].vertices, (std::vector<Point>{{0, 0}, {3 * U, 0}, {3 * U, 3 * U}, {0, 3 * U}}));
  EXPECT_TRUE(merged[0].segments.empty());
}

TEST(Loops, AreSortedByTheirVertices) {
  World world;
  for (const Cell cell : {Cell{4, 0}, Cell{0, 4}, Cell{-2, 7}, Cell{2, 2}}) place(world, cell, unitSquare());
  world.commit();
  std::vector<std::vector<Point>> vertices;
  for (const Loop& loop : world.loops()) vertices.push_back(loop.vertices);
  EXPECT_EQ(vertices.size(), 4U);
  EXPECT_TRUE(std::is_sorted(vertices.begin(), vertices.end()));
}

TEST(Loops, TurnThroughTheFreeWedge) {
  // Two squares that touch in a corner: one loop around both, which passes that corner twice.
  World world;
  place(world, {0, 0}, unitSquare());
  place(world, {1, 1}, unitSquare());
  world.commit();
  ASSERT_EQ(world.loops().size(), 1U);
  EXPECT_EQ(world.loops(Collinear::merge)[0].vertices,
            (std::vector<Point>{{0, 0}, {U, 0}, {U, U}, {2 * U, U}, {2 * U, 2 * U}, {U, 2 * U}, {U, U}, {0, U}}));
}

TEST(Loops, StartAtTheLeastRotation) {
  // Two triangles that touch with their tips in the loop's least vertex, which it passes twice. Of the two rotations
  // that start there, the one that goes on to the lesser vertex is the least.
  World world;
  place(world, {0, 0}, eighths({{0, 0}, {8, 4}, {0, 2}}));
  place(world, {0, 0}, eighths({{0, 0}, {2, 0}, {8, 2}}));
  world.commit();
  ASSERT_EQ(world.loops().size(), 1U);
  const std::vector<Point> vertices = world.loops()[0].vertices;
  ASSERT_EQ(vertices.size(), 6U);
  EXPECT_EQ(vertices[0], (Point{0, 0}));
  EXPECT_EQ(vertices[1], (Point{U / 4, 0}));
}

TEST(Loops, MergingKeepsAStraightRunsVertexWhereAnotherLoopPasses) {
  World world;
  place(world, {0, 0}, eighths({{0, 0}, {8, 0}, {8, 4}, {0, 4}}));
  place(world, {0, 0}, eighths({{4, 4}, {5, 8}, {3, 8}}));  // stands with its tip on the flat top
  world.commit();
  const std::vector<Loop> merged = world.loops(Collinear::merge);
  ASSERT_EQ(merged.size(), 1U);
  EXPECT_EQ(std::count(merged[0].vertices.begin(), merged[0].vertices.end(), (Point{U / 2, U / 2})), 2);
}

}  // namespace
}  // namespace lgs::test
