// The values that the adapters for Box2D share: when two of them are equal, and the frame from the lattice to metres.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>
#include <lgs/box2d/edges.h>
#include <cmath>

namespace lgs::box2d {
namespace {

using test::U;

TEST(Box2dValues, EveryMemberCounts) {
  const Edge edge{{1}, {2}, 3, 4, {5, 6}, {7, 8}, Point{9, 10}, Point{11, 12}};
  std::vector<Edge> edges(9, edge);
  edges[1].first = {100};
  edges[2].last = {100};
  edges[3].chunk = 100;
  edges[4].block = 100;
  edges[5].start.x = 100;
  edges[6].end.y = 100;
  edges[7].ghost1.reset();
  edges[8].ghost2->x = 100;
  for (const Edge& other : edges) EXPECT_EQ(other == edge, &other == &edges[0]);

  for (std::size_t EdgeCounts::*member : {&EdgeCounts::edges, &EdgeCounts::segments, &EdgeCounts::single,
                                          &EdgeCounts::merged, &EdgeCounts::welded, &EdgeCounts::leftOut}) {
    EdgeCounts other;
    other.*member = 1;
    EXPECT_NE(other, EdgeCounts{});
  }

  const std::vector<Chunk> inOrder{{-1, 7}, {0, -3}, {0, 0}, {0, 5}, {2, -9}};
  for (const Chunk& a : inOrder) {
    for (const Chunk& b : inOrder) {
      EXPECT_EQ(a <=> b, &a <=> &b);
      EXPECT_EQ(a == b, &a == &b);
    }
  }
}

TEST(Box2dFrame, FarAwayIsAsPreciseAsNear) {
  const Frame frame{0.5, {1'000'000'000, -1'000'000'000}, 16};
  const Point p = toWorld({1'000'000'003, -1'000'000'002}, {1, 3});
  EXPECT_EQ(frame.position(p).x, 1.5F + 0.5F / U);
  EXPECT_EQ(frame.position(p).y, -1.0F + 1.5F / U);
  const Chunk chunk = frame.chunkOf({-1, -17});
  EXPECT_EQ(chunk, (Chunk{-1, -2}));
  EXPECT_EQ(frame.local(toWorld({-1, -17}, {}), chunk).x, 7.5F);
  EXPECT_EQ(frame.cellAt({1.75F, -0.25F}), (Cell{1'000'000'003, -1'000'000'001}));
  EXPECT_EQ(frame.unitsOf(0.005), 721);
}

// A Box2D with positions in double gets them unrounded: float would be a quarter of a metre off.
TEST(Box2dFrame, PlacesAreInDouble) {
  const Frame frame{0.3, {}, 16};
  const Place p = frame.position(toWorld({10'000'001, -10'000'001}, {U / 2, U / 2}));
  EXPECT_NEAR(p.x, 3'000'000.45, 1e-8);
  EXPECT_NEAR(p.y, -3'000'000.15, 1e-8);
  EXPECT_EQ(frame.cellAt(p), (Cell{10'000'001, -10'000'001}));
}

#ifndef NDEBUG
TEST(Box2dOptionsDeathTest, WhatIsOutOfRangeIsAsserted) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const std::int32_t cells : {-1, 0, 4'097}) EXPECT_DEATH(EdgeSet({.chunkCells = cells}), "chunkCells");
  EXPECT_DEATH(EdgeSet({.shortest = -1}), "shortest");
  for (const double size : {0.0, -1.0, 1e-6, std::nan(""), HUGE_VAL}) {
    const Frame frame{size, {}, 16};
    EXPECT_DEATH((void)frame.unitsOf(0.005), "cellSize");
  }
  EXPECT_LE((Frame{2e-6, {}, 16}.unitsOf(0.005)), 1 << 28);
}
#endif

}  // namespace
}  // namespace lgs::box2d
