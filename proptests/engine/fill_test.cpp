// fill() and clear() of more cells than the laws of calls reach.
#include "oracle/trace/dump.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <array>

namespace lgs::test {
namespace {

using oracle::outlineOf;

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

// A commit passes over what is buried, so it must know what no longer is.
TEST(Fill, OfOtherShapesWhereItWasSolid) {
  World world, fresh;
  const CellRect all{{-20, -20}, {20, 20}}, inner{{-12, -9}, {11, 8}};
  const auto squareIn = [](World& w) { return shapeOf(w, {unitSquare()}); };
  const auto diamondIn = [](World& w) { return shapeOf(w, shapeNamed("diamond")); };
  ASSERT_TRUE(world.fill(all, squareIn(world), 1));
  world.commit();
  ASSERT_TRUE(world.clear(inner));
  ASSERT_TRUE(world.fill(inner, diamondIn(world), 2));
  world.commit();
  ASSERT_TRUE(fresh.fill(inner, diamondIn(fresh), 2));
  for (const Cell& cell : cellsOf(all))
    if (!contains(inner, cell)) place(fresh, cell, unitSquare(), 1);
  fresh.commit();
  EXPECT_EQ(outlineOf(world), outlineOf(fresh));
  ASSERT_TRUE(world.clear(inner));
  ASSERT_TRUE(world.fill(inner, squareIn(world), 1));
  EXPECT_TRUE(world.commit().added.empty());
  EXPECT_EQ(world.stats().segments, 4U * 41U);
}

// Once read past the end of a page of records: a cell that lists its polygons and has no segments, looked at from a
// side with rim points. Only the address sanitizer can see it.
TEST(Fill, BuriesCellsThatListTheirPolygons) {
  World world;
  const ShapeId halves = shapeOf(world, shapeNamed("two halves"));
  std::array<PolygonHandle, 2> handles;
  ASSERT_TRUE(world.add({-500, -500}, halves, 1, handles));
  ASSERT_TRUE(world.remove(handles[1]));
  ASSERT_TRUE(world.fill({{0, 0}, {127, 127}}, halves, 1));
  EXPECT_EQ(world.commit().added.size(), 4U + 2 * 128 + 4 * 128);
}

}  // namespace
}  // namespace lgs::test
