// fill() and clear(): the same as single edits, all or nothing, across chunks, at negative cells and the range's ends.
#include "oracle/generate/random.h"
#include "oracle/trace/dump.h"
#include "scale.h"
#include "support.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace lgs::engine_test {
namespace {

using oracle::outlineOf;
using oracle::Random;

TEST(Fill, CountsCellsAndClearCountsPolygons) {
  World world;
  const ShapeId halves = shapeOf(world, shapeNamed("two halves"));
  EXPECT_EQ(world.fill({{-40, -33}, {35, 2}}, halves, 3).value(), 76U * 36U);
  EXPECT_EQ(world.stats().polygons, 2U * 76U * 36U);
  EXPECT_EQ(world.stats().cells, 76U * 36U);
  world.commit();
  EXPECT_EQ(world.loops(Collinear::merge).size(), 1U);
  EXPECT_EQ(world.clear({{-1000, -1}, {1000, 0}}).value(), 2U * 2U * 76U);
  EXPECT_EQ(world.clear({{-1000, -1}, {1000, 0}}).value(), 0U);
  world.commit();
  EXPECT_EQ(world.loops(Collinear::merge).size(), 2U);
  EXPECT_EQ(world.clear({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}).value(), 2U * 34U * 76U);
  world.commit();
  EXPECT_TRUE(world.segments().empty());
  EXPECT_EQ(world.stats().polygons, 0U);
}

TEST(Fill, OfNothingIsFine) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_EQ(world.fill({{1, 0}, {0, 5}}, square, 1).value(), 0U);
  EXPECT_EQ(world.fill({{0, 5}, {9, 4}}, ShapeId{}, 1).value(), 0U);
  EXPECT_EQ(world.clear({{1, 0}, {0, 5}}).value(), 0U);
  EXPECT_EQ(world.clear({{-5, -5}, {5, 5}}).value(), 0U);
  EXPECT_EQ(world.stats().chunks, 0U);
}

TEST(Fill, IsRefusedForTheFirstCellByRows) {
  std::vector<Cell> cells{{-40, 5}, {0, 40}, {39, 3}, {40, 3}};
  do {  // in every order, which is that in which chunks are made and may be looked at
    World world;
    const ShapeId square = shapeOf(world, {unitSquare()});
    for (const Cell cell : cells) place(world, cell, ramp());
    const Snapshot before = snapshotOf(world, cellsOf({{-45, 0}, {45, 45}}));
    const auto refused = world.fill({{-45, 0}, {45, 45}}, square, 1);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::overlap);
    EXPECT_EQ(refused.error().cell, (Cell{39, 3}));
    EXPECT_EQ(refused.error().other, world.polygons({39, 3})[0].handle);
    EXPECT_EQ(snapshotOf(world, cellsOf({{-45, 0}, {45, 45}})), before);
  } while (std::next_permutation(cells.begin(), cells.end()));
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

TEST(Fill, ReachesTheEndsOfTheRange) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_EQ(world.fill({{kMaxCell - 2, -kMaxCell}, {kMaxCell, -kMaxCell + 1}}, square, 1).value(), 6U);
  EXPECT_EQ(world.fill({{-kMaxCell, kMaxCell - 1}, {-kMaxCell + 2, kMaxCell}}, square, 1).value(), 6U);
  world.commit();
  EXPECT_EQ(world.stats().segments, 20U);
  EXPECT_EQ(world.loops(Collinear::merge).size(), 2U);
  EXPECT_EQ(world.clear({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}).value(), 12U);
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

TEST(Fill, AddsToCellsThatHoldOthersAlready) {
  World world;
  const auto halves = shapeNamed("two halves");
  place(world, {3, 3}, halves[0], 5);
  ASSERT_TRUE(world.fill({{2, 2}, {4, 4}}, shapeOf(world, {halves[1]}), 6));
  world.commit();
  EXPECT_EQ(world.polygons({3, 3}).size(), 2U);
  EXPECT_EQ(world.polygons({3, 3})[1].block, 6U);
  EXPECT_EQ(world.polygons({2, 2}).size(), 1U);
}

// Rectangles filled and cleared, in one world as a whole, in the other cell by cell.
RC_GTEST_PROP(Fill, IsTheSameAsSingleEdits, ()) {
  const auto seed = *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
  const int steps = static_cast<int>(scaled(*rc::gen::inRange(1, 12)));
  Random random(seed);
  const auto keeps = [](Block a, Block b) { return a != b && b != 2; };
  const PreserveRelation relation = random.chance(50) ? PreserveRelation(keeps) : PreserveRelation();
  World whole(relation), single(relation);
  const std::vector<std::int32_t> origins{0, -4, 28, -36, kMaxCell - 9, -kMaxCell};
  const std::int32_t oi = random.pick(origins);
  const std::int32_t oj = random.pick(origins);
  const CellRect all{{oi, oj}, {oi + 9, oj + 9}};
  for (int step = 0; step < steps; ++step) {
    CellRect rect;
    rect.min.i = oi + random.below(10);
    rect.min.j = oj + random.below(10);
    rect.max.i = std::min(all.max.i, rect.min.i + random.below(6));
    rect.max.j = std::min(all.max.j, rect.min.j + random.below(6));
    if (random.chance(35)) {
      std::uint64_t count = 0;
      for (const Cell& cell : cellsOf(rect)) {
        count += single.polygons(cell).size();
        removeAll(single, cell);
      }
      RC_ASSERT(whole.clear(rect).value() == count);
    } else {
      const std::vector<LocalPolygon>& polygons = random.pick(oracle::degenerateShapes()).polygons;
      const ShapeId a = shapeOf(whole, polygons), b = shapeOf(single, polygons);
      const Block block = random.below(4U);
      const auto filled = whole.fill(rect, a, block);
      std::vector<PolygonHandle> made(polygons.size()), done;
      bool refused = false;
      for (const Cell& cell : cellsOf(rect)) {
        const auto added = single.add(cell, b, block, made);
        refused = !added;
        if (refused) {
          RC_ASSERT(!filled);
          RC_ASSERT(filled.error().cell == cell);
          RC_ASSERT(filled.error().code == added.error().code);
          break;
        }
        done.insert(done.end(), made.begin(), made.end());
      }
      RC_ASSERT(refused == !filled);
      if (refused)
        for (const PolygonHandle handle : done) RC_ASSERT(single.remove(handle).has_value());
      else
        RC_ASSERT(*filled == cellsOf(rect).size());
    }
    if (random.chance(60)) {
      whole.commit();
      single.commit();
      RC_ASSERT(outlineOf(whole) == outlineOf(single));
    }
    for (const Cell& cell : cellsOf(all)) RC_ASSERT(whole.polygons(cell).size() == single.polygons(cell).size());
  }
}

// Once read past the end of a page of records: a cell that lists its polygons and has no segments, looked at from a side
// with rim points. Only the address sanitizer can see it.
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
}  // namespace lgs::engine_test
