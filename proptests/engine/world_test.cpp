// What no law of calls can see: where a cell is looked for, what outlives what, values that
// answers are made of.
#include "proptests/support/must.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>
#include <lgs/version.h>

#include <array>
#include <cmath>
#include <limits>

namespace lgs::test {
namespace {

TEST(World, FindsACellWhateverCellWasEditedBefore) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  std::vector<std::int32_t> places{0};
  for (std::int32_t far = kMaxCell; far > 0; far /= 2) places.insert(places.end(), {-far, far});
  const auto expectPlaced = [&](Cell cell) {
    const auto handle = must(world.add(cell, square, 1));
    EXPECT_EQ(*world.cellOf(handle), cell);
    EXPECT_EQ(world.polygons(cell).size(), 1U);
  };
  for (const std::int32_t a : places) {
    for (const std::int32_t b : places) {
      const std::array<std::array<Cell, 2>, 2> pairs{{{Cell{a, 7}, Cell{b, 7}}, {Cell{7, a}, Cell{7, b}}}};
      for (const auto& [before, cell] : pairs) {
        expectPlaced(before);
        if (cell != before) expectPlaced(cell);
        removeAll(world, before);
        removeAll(world, cell);
      }
      ASSERT_FALSE(HasFailure()) << "cell " << b << " after cell " << a;
    }
  }
}

TEST(World, AShapeOutlivesWhatIsMadeOfIt) {
  World world;
  const ShapeId shape = shapeOf(world, {ramp()});
  // Enough contents come and go for the unused ones to be forgotten; those of two polygons are more than the polygons.
  const LocalPolygon above = eighths({{0, 4}, {8, 4}, {0, 8}});
  // A polygon that stays, as a part of a shape, while its content as the only one in a cell goes.
  const std::vector<LocalPolygon> halves = shapeNamed("two halves");
  const ShapeId both = shapeOf(world, halves);
  ASSERT_TRUE(world.remove(place(world, {3, 3}, halves[1])));
  for (std::int32_t k = 0; k < 5000; ++k) {
    const PolygonHandle other = place(world, {k % 7, 0}, above);
    ASSERT_TRUE(world.remove(place(world, {k % 7, 0}, {{0, 0}, {k + 2, 0}, {0, 5}})));
    ASSERT_TRUE(world.remove(other));
    ASSERT_EQ(place(world, {0, 7}, {{0, 0}, {k + 2, 0}, {0, 5}}).serial, static_cast<std::uint32_t>(k + 1));
    removeAll(world, {0, 7});
    if (k % 64 == 0) world.commit();
  }
  EXPECT_LT(world.stats().contents, 10'000U) << "nothing was forgotten";
  const PolygonHandle handle = world.add({3, 3}, shape, 1).value();
  EXPECT_EQ(world.polygon(handle)->vertices[2], (LocalPoint{U, U}));
  const PolygonHandle half = place(world, {5, 3}, halves[1]);
  EXPECT_EQ(world.polygon(half)->vertices[0], halves[1][0]);
  EXPECT_TRUE(world.add({7, 3}, both, 1));
  world.commit();
  EXPECT_EQ(world.stats().segments, 3U + 4U + 6U);
}

TEST(World, CanBeMoved) {
  World world;
  const PolygonHandle handle = place(world, {}, ramp());
  World other = std::move(world);
  other.commit();
  EXPECT_EQ(other.segments().size(), 3U);
  world = std::move(other);
  ASSERT_TRUE(world.remove(handle));
  EXPECT_EQ(world.commit().removed.size(), 3U);
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

}  // namespace
}  // namespace lgs::test
