// Placing and reading: blocks, several polygons in a cell, the ends of the range, coordinates that are rounded.
#include "oracle/trace/dump.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <array>
#include <future>
#include <limits>
#include <vector>

namespace lgs::test {
namespace {

TEST(World, IsEmptyAtFirst) {
  World world;
  EXPECT_TRUE(world.segments().empty());
  EXPECT_TRUE(world.segments({{-9, -9}, {9, 9}}).empty());
  EXPECT_TRUE(world.loops().empty());
  EXPECT_TRUE(world.polygons({}).empty());
  EXPECT_EQ(world.maxSegmentId(), 0U);
  const Stats stats = world.stats();
  EXPECT_EQ(stats.polygons + stats.cells + stats.segments + stats.shapes + stats.chunks, 0U);
  EXPECT_TRUE(world.commit().added.empty());
}

TEST(World, KeepsEachBlock) {
  constexpr Block kMost = 0xffff'ffff;
  // The first block in a chunk is 0, or another one; then others follow.
  for (const std::vector<Block>& blocks :
       {std::vector<Block>{0, 0, 1, 0}, {1, 0, 1, kMost}, {kMost, kMost, 0}, {0, kMost}}) {
    World world;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const auto i = static_cast<std::int32_t>(k);
      place(world, {i, 0}, unitSquare(), blocks[k]);
      for (const LocalPolygon& half : shapeNamed("two halves")) place(world, {i, 2}, half, blocks[k] ^ 1U);
    }
    world.commit();
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const auto i = static_cast<std::int32_t>(k);
      EXPECT_EQ(world.polygons({i, 0}).at(0).block, blocks[k]);
      EXPECT_EQ(world.polygons({i, 2}).at(1).block, blocks[k] ^ 1U);
      for (const SegmentId id : world.segments({{i, 0}, {i, 0}})) EXPECT_EQ(world.segment(id)->block, blocks[k]);
      for (const SegmentId id : world.segments({{i, 2}, {i, 2}})) EXPECT_EQ(world.segment(id)->block, blocks[k] ^ 1U);
    }
  }
}

TEST(World, ABlockCanChangeWhenACellIsRefilled) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  ASSERT_TRUE(world.fill({{0, 0}, {40, 3}}, square, 0));
  world.commit();
  ASSERT_TRUE(world.clear({{0, 0}, {40, 3}}));
  ASSERT_TRUE(world.fill({{0, 0}, {40, 3}}, square, 9));
  const ChangeLists changes = copyOf(world.commit());
  EXPECT_EQ(changes.added.size(), changes.removed.size());
  for (const Cell& cell : cellsOf({{0, 0}, {40, 3}})) ASSERT_EQ(world.polygons(cell).at(0).block, 9U);
  for (const SegmentId id : world.segments()) ASSERT_EQ(world.segment(id)->block, 9U);
}

TEST(World, HoldsSeveralPolygonsInACellEachWithItsBlock) {
  World world;
  const std::vector<LocalPolygon> parts = shapeNamed("four around the middle");
  for (std::size_t k = 0; k < parts.size(); ++k) place(world, {-1, -1}, parts[k], static_cast<Block>(k));
  const std::vector<PlacedPolygon> there = world.polygons({-1, -1});
  ASSERT_EQ(there.size(), 4U);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    EXPECT_EQ(there[k].block, k);
    EXPECT_EQ(LocalPolygon(there[k].vertices.begin(), there[k].vertices.end()), parts[k]);
  }
  std::vector<PlacedPolygon> again(9);
  world.polygons({-1, -1}, again);
  EXPECT_EQ(again.size(), 4U);
  world.commit();
  EXPECT_EQ(world.stats().segments, 4U);  // the contacts inside are gone
  EXPECT_EQ(world.stats().cells, 1U);
}

TEST(World, ReachesTheEndsOfTheRange) {
  for (const std::int32_t i : {-kMaxCell, kMaxCell}) {
    for (const std::int32_t j : {-kMaxCell, kMaxCell}) {
      World world;
      const Cell in{i < 0 ? i + 1 : i - 1, j};
      place(world, {i, j}, unitSquare(), 1);
      place(world, in, ramp(), 2);
      world.commit();
      EXPECT_EQ(world.loops().size(), 1U);
      // A ramp's wall is on its right, so it is cancelled only where the square stands there.
      const std::size_t count = world.segments().size();
      EXPECT_EQ(count, i < 0 ? 4U + 3U : 2U + 3U);
      for (const SegmentId id : world.segments({{i, j}, {i, j}})) EXPECT_EQ(world.segment(id)->cell, (Cell{i, j}));
      EXPECT_EQ(world.segments({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}).size(), count);
      EXPECT_EQ(world.loops()[0].vertices[0].x, std::min(toWorld({i, j}, {}).x, toWorld(in, {}).x));
    }
  }
}

TEST(World, FindsACellWhateverCellWasEditedBefore) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  std::vector<std::int32_t> places{0};
  for (std::int32_t far = kMaxCell; far > 0; far /= 2) places.insert(places.end(), {-far, far});
  const auto expectPlaced = [&](Cell cell) {
    const auto handle = world.add(cell, square, 1);
    ASSERT_TRUE(handle);
    EXPECT_EQ(*world.cellOf(*handle), cell);
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

TEST(World, IsFineWithCellsOutOfRangeInQuestions) {
  World world;
  place(world, {0, 0}, unitSquare());
  world.commit();
  constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min(),
                         kMax = std::numeric_limits<std::int32_t>::max();
  EXPECT_TRUE(world.polygons({kMin, kMax}).empty());
  EXPECT_EQ(world.segments({{kMin, kMin}, {kMax, kMax}}).size(), 4U);
  EXPECT_TRUE(world.segments({{1, 0}, {0, 0}}).empty());
}

TEST(World, RoundsHalvesAwayFromZero) {
  World world;
  const double unit = 1.0 / U;
  const std::vector<DoublePoint> doubles{{-0.0, -0.49 * unit}, {1 + 0.49 * unit, 0.5 * unit}, {2.5 * unit, 0.75}};
  const auto a = world.add({}, std::span<const DoublePoint>(doubles), 1);
  ASSERT_TRUE(a) << message(a.error());
  const auto v = world.polygon(*a)->vertices;
  EXPECT_EQ(LocalPolygon(v.begin(), v.end()), (LocalPolygon{{0, 0}, {U, 1}, {3, 49'152}}));
  const std::vector<FloatPoint> floats{{-0.0F, 0.0F}, {1.0F, 0.1F}, {0.3F, 1.0F}};
  const auto b = world.add({4, 4}, std::span<const FloatPoint>(floats), 1);
  ASSERT_TRUE(b);
  const auto w = world.polygon(*b)->vertices;
  EXPECT_EQ(LocalPolygon(w.begin(), w.end()), (LocalPolygon{{0, 0}, {U, 6554}, {19'661, U}}));
}

TEST(World, EveryLatticePointSurvivesTheWayThroughReals) {
  World world;
  for (std::int32_t k = 1; k < U; k += 257) {
    const float f = static_cast<float>(k) / static_cast<float>(U);
    const double d = static_cast<double>(k) / U;
    const std::vector<FloatPoint> floats{{0, 0}, {f, 0}, {f, f}};
    const std::vector<DoublePoint> doubles{{0, 0}, {d, 0}, {d, d}};
    const auto a = world.add({0, 0}, std::span<const FloatPoint>(floats), 1);
    const auto b = world.add({1, 0}, std::span<const DoublePoint>(doubles), 1);
    for (const auto& handle : {a, b}) {
      ASSERT_TRUE(handle);
      ASSERT_EQ(world.polygon(*handle)->vertices[2], (LocalPoint{k, k}));
      ASSERT_TRUE(world.remove(*handle));
    }
  }
}

TEST(World, ShapesAreInternedOnce) {
  World world;
  const ShapeId a = shapeOf(world, {ramp()});
  EXPECT_EQ(world.shape(ramp()).value(), a);
  EXPECT_EQ(shapeOf(world, {ramp()}), a);
  EXPECT_NE(world.shape(unitSquare()).value(), a);
  std::vector<LocalPolygon> halves = shapeNamed("two halves");
  const ShapeId both = shapeOf(world, halves);
  std::swap(halves[0], halves[1]);
  EXPECT_NE(shapeOf(world, halves), both);  // handles come in another order
  EXPECT_EQ(world.stats().shapes, 4U);
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

// "const calls are safe beside each other": for the thread sanitizer, and for luck without.
TEST(World, CanBeReadByTwoThreads) {
  World world;
  ASSERT_TRUE(world.fill({{0, 0}, {127, 127}}, shapeOf(world, {ramp()}), 1));
  world.commit();
  const auto count = [&world](std::int32_t step) {
    std::size_t right = 0;
    std::vector<PlacedPolygon> there;
    for (std::int32_t k = 0; k < 200'000; ++k) {
      const Cell cell{k * step % 128, k * (step + 2) % 128};
      world.polygons(cell, there);
      right += there.size() == 1 && world.cellOf(there[0].handle) == cell;
    }
    return right;
  };
  auto other = std::async(std::launch::async, count, 37);
  EXPECT_EQ(count(61), 200'000U);
  EXPECT_EQ(other.get(), 200'000U);
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

TEST(World, TheSameEditsGiveTheSameIds) {
  const auto run = [] {
    World world;
    std::vector<ChangeLists> lists;
    const auto& shapes = oracle::degenerateShapes();
    for (std::size_t k = 0; k < 400; ++k) {
      const Cell cell{static_cast<std::int32_t>(k * 7 % 11) - 5, static_cast<std::int32_t>(k * 5 % 9) - 4};
      removeAll(world, cell);
      if (k % 3 != 0) {
        EXPECT_TRUE(world.add(cell, shapeOf(world, shapes[k % shapes.size()].polygons), k % 4));
      }
      if (k % 2 == 0) lists.push_back(copyOf(world.commit()));
    }
    return std::pair(lists, snapshotOf(world, cellsOf({{-5, -4}, {5, 4}})));
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace lgs::test
