// Short calls, and values that answers are made of.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>
#include <lgs/version.h>

#include <cmath>
#include <limits>
#include <vector>

namespace lgs::test {
namespace {

TEST(Values, AShapeIsTheSameByLatticePointsRealsAndInBraces) {
  World world;
  const ShapeId lattice = shapeOf(world, {ramp()});
  const std::vector<FloatPoint> floats{{0, 0}, {1, 0}, {1, 1}};
  const std::vector<DoublePoint> doubles{{0, 0}, {1, 0}, {1, 1 - 0.4 / U}};
  EXPECT_EQ(world.shape({{0, 0}, {U, 0}, {U, U}}), lattice);
  EXPECT_EQ(world.shape(std::span<const FloatPoint>(floats)), lattice);
  EXPECT_EQ(world.shape(std::span<const DoublePoint>(doubles)), lattice);
  const auto handle = world.add({}, {{0, 0}, {U, 0}, {U, U}}, 3);
  ASSERT_TRUE(handle);
  EXPECT_EQ(polygonsIn(world, {}), (std::vector<PolygonFields>{{*handle, 3, ramp()}}));
}

TEST(Values, VersionsAreThatOfTheHeadersAndAreOrdered) {
  EXPECT_EQ(version(), kVersion);  // packaging/check.py compares it with CMake's
  EXPECT_LT((Version{0, 2, 9}), (Version{0, 10, 0}));
  EXPECT_LT((Version{0, 10, 0}), (Version{1, 0, 0}));
  EXPECT_LT((Version{1, 0, 0}), (Version{1, 0, 1}));
}

TEST(Values, BoxesOfShapes) {
  World world;
  const ShapeId shape = shapeOf(world, {eighths({{1, 2}, {3, 2}, {3, 5}}), eighths({{4, 1}, {7, 1}, {4, 2}})});
  EXPECT_EQ(world.boundingBox(shape), (LocalBox{{U / 8, U / 8}, {U / 8 * 7, U / 8 * 5}}));
  EXPECT_EQ(world.boundingBox(ShapeId{}).error().code, ErrorCode::unknownShape);
}

TEST(Values, NormalAndLengthOfASegment) {
  World world;
  place(world, {-3, 7}, {{0, 0}, {3 * U / 5, 0}, {3 * U / 5, 4 * U / 5}});
  world.commit();
  for (const SegmentId id : world.segments()) {
    const Segment s = *world.segment(id);
    const DoublePoint normal = s.normal();
    const auto dx = static_cast<double>(s.end.x - s.start.x), dy = static_cast<double>(s.end.y - s.start.y);
    EXPECT_DOUBLE_EQ(std::hypot(normal.x, normal.y), 1);
    EXPECT_NEAR(normal.x * dx + normal.y * dy, 0, 1e-9);
    EXPECT_GT(dx * -normal.y + dy * normal.x, 0) << "on the right";
    EXPECT_DOUBLE_EQ(s.length() * U, std::hypot(dx, dy));
  }
}

TEST(Values, LatticePointsOfPositions) {
  EXPECT_EQ(latticePoint({1, -2.5}), (Point{U, -2 * U - U / 2}));
  EXPECT_EQ(latticePoint({0.5 / U, -0.5 / U}), (Point{1, -1})) << "halves away from zero";
  EXPECT_EQ(cellAt(latticePoint({-0.25, 3})), (Cell{-1, 3}));
  const double last = kMaxCell + 1.0;
  EXPECT_EQ(latticePoint({last, -last}), (Point{kMaxCoordinate, -kMaxCoordinate}));
  for (const double beyond : {last + 1, -last - 1, 1e300, -std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(inRange(latticePoint({beyond, 0})));
    EXPECT_FALSE(inRange(latticePoint({0, beyond})));
  }
}

TEST(Values, ClearingACell) {
  World world;
  ASSERT_TRUE(world.fill({{0, 0}, {2, 0}}, shapeOf(world, shapeNamed("two halves")), 1));
  EXPECT_EQ(world.clear(Cell{1, 0}), 2U);
  EXPECT_TRUE(world.isEmpty({1, 0}));
  EXPECT_FALSE(world.isEmpty({0, 0}) || world.isEmpty({2, 0}));
}

}  // namespace
}  // namespace lgs::test
