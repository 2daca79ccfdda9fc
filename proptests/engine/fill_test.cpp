// fill() and clear() of more cells than the laws of calls reach.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <array>

namespace lgs::test {
namespace {

TEST(Fill, TellsHandlesByRows) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()}), halves = shapeOf(world, shapeNamed("two halves"));
  for (const ShapeId shape : {square, halves}) {
    ASSERT_TRUE(world.clear({{-2, -2}, {40, 40}}));
    std::vector<PolygonHandle> handles(42 * 3 + 1);  // across a chunk's border; one too many
    ASSERT_TRUE(world.fill({{-2, 30}, {39, 32}}, shape, 7, handles));
    for (std::int32_t k = 0; k < 42 * 3; ++k) {
      const PolygonHandle first = world.polygons(Cell{k % 42 - 2, 30 + k / 42}).front().handle;
      EXPECT_EQ(handles[static_cast<std::size_t>(k)], first);
    }
    EXPECT_FALSE(handles.back());
    ASSERT_TRUE(world.clear({{-2, -2}, {40, 40}}));
    std::array<PolygonHandle, 2> two;
    ASSERT_TRUE(world.fill({{0, 0}, {5, 5}}, shape, 7, two));
    EXPECT_EQ(world.cellOf(two[1]).value(), (Cell{1, 0}));
    EXPECT_FALSE(world.fill({{0, 0}, {5, 5}}, shape, 7, handles));
  }
}

TEST(Fill, ABracedPairIsACell) {
  World world;
  ASSERT_TRUE(world.fill({{0, 0}, {3, 4}}, shapeOf(world, {unitSquare()}), 1));
  EXPECT_EQ(world.clear({3, 4}).value(), 1U);
  EXPECT_TRUE(world.isEmpty({3, 4}));
  EXPECT_EQ(world.clear({{0, 0}, {3, 4}}).value(), 19U);
}

// Few chunks in a big rectangle are gone through one and all, those beside it too.
TEST(Fill, LooksAtItsOwnCellsOnly) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  const CellRect rect{{-100, -70}, {100, 70}};
  const std::vector<Cell> outside{{-101, 0}, {101, 0}, {0, -71}, {0, 71}, {-500, 3}, {500, -3}, {7, 900}, {7, -900}};
  for (const Cell& cell : outside) place(world, cell, ramp());
  EXPECT_EQ(world.clear(rect).value(), 0U);
  EXPECT_EQ(world.fill(rect, square, 1).value(), 201U * 141U);
  EXPECT_EQ(world.clear(rect).value(), 201U * 141U);
  for (const Cell& cell : outside) EXPECT_EQ(world.polygons(cell).size(), 1U);
  EXPECT_EQ(world.stats().polygons, outside.size());
}

}  // namespace
}  // namespace lgs::test
