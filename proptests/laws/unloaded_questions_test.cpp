// Chunks that are unloaded, by hand: questions that would have to look there.
#include "oracle/calls/random.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "unloaded.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace lgs::test {
namespace {

TEST(UnloadedByHand, QuestionsSayWhereTheyWouldHaveToLook) {
  World world = rowOfChunks(3);
  EXPECT_EQ(world.unload(chunkAt(1, 0), {}), 1U);
  world.commit();
  const auto at = [](double x, double y) { return latticePoint({x, y}); };
  EXPECT_EQ(world.at(at(31.5, 3.5)).where, Spot::Where::inside);
  EXPECT_EQ(world.at(at(32, 3.5)).where, Spot::Where::unloaded);
  EXPECT_EQ(world.at(at(40.5, 3.5)).where, Spot::Where::unloaded);
  EXPECT_EQ(world.at(at(40.5, 3.5)).cell, (Cell{40, 3}));
  EXPECT_EQ(world.at(at(40.5, 32)).where, Spot::Where::unloaded);
  EXPECT_EQ(world.at(at(40.5, 32.5)).where, Spot::Where::outside);
  EXPECT_EQ(world.save([](std::span<const std::byte>) {}).error().code, ErrorCode::unloaded);
  // From above: what is loaded is hit, unless the way there leads through what is not.
  EXPECT_TRUE(must(world.rayCast(at(10, 40), at(10, 20))).segment);
  EXPECT_EQ(world.rayCast(at(40, 40), at(40, 20)).error().cell, (Cell{39, 31}));
  EXPECT_FALSE(must(world.rayCast(at(40, 40), at(40, 33))).segment);
  EXPECT_EQ(world.rayCast(at(30, 34), at(40, 24)).error().code, ErrorCode::unloaded) << "it meets both at (32, 32)";
  EXPECT_EQ(world.rayCast(at(29, 40), at(39, 20)).error().code, ErrorCode::unloaded);
  EXPECT_TRUE(world.rayCast(at(20, 40), at(60, 20)).error().code == ErrorCode::unloaded);
  EXPECT_TRUE(world.rayCast(at(28, 33), at(36, 31)).error().code == ErrorCode::unloaded) << "it meets both at once";
  EXPECT_TRUE(must(world.rayCast(at(27, 33), at(35, 31))).segment) << "it is hit at (31, 32), and would go on";
  EXPECT_TRUE(world.rayCast(Point{63 * U, 33 * U}, Point{65 * U, 31 * U + 1})) << "half a unit beside the corner";
  EXPECT_TRUE(must(world.rayCast(at(31.4, 33), at(32.4, 31))).segment) << "it is hit, and in that row would go on";
  // The nearest segment, unless an unknown one may be as near.
  EXPECT_TRUE(must(world.nearest(at(10, 35), 10)).segment);
  EXPECT_EQ(must(world.nearest(at(30, 35), 10)).distance, 3.0);
  EXPECT_EQ(world.nearest(at(32, 35), 10).error().code, ErrorCode::unloaded);
  EXPECT_EQ(world.nearest(at(48, 35), 10).error().cell, (Cell{48, 31}));
  EXPECT_FALSE(must(world.nearest(at(48, 35), 2.5)).segment);
  EXPECT_EQ(must(world.nearest(at(200, 16), 200)).distance, 104.0) << "the nearer one is loaded";
}

TEST(UnloadedByHand, OfPlacesThatMayBeNearestTheFirstByRowsIsNamed) {
  std::vector<Cell> beside;
  for (std::int32_t j = -1; j <= 1; ++j)
    for (std::int32_t i = -1; i <= 1; ++i)
      if (i != 0 || j != 0) beside.push_back({i, j});
  const auto nearestCell = [](Cell chunk) {
    const auto along = [](std::int32_t c) { return c == 0 ? 16 : c < 0 ? -1 : 32; };
    return Cell{along(chunk.i), along(chunk.j)};
  };
  for (const Cell first : beside) {
    for (const Cell second : beside) {
      if (first == second) continue;
      World world;
      for (const Cell chunk : {first, second}) {
        fill(world, chunkAt(chunk.i, chunk.j));
        EXPECT_EQ(world.unload(chunkAt(chunk.i, chunk.j), {}), 1U);
      }
      world.commit();
      const Cell a = nearestCell(first), b = nearestCell(second);
      EXPECT_EQ(world.nearest({16 * U + 1, 16 * U + 1}, 30).error().cell,
                std::pair(a.j, a.i) < std::pair(b.j, b.i) ? a : b);
    }
  }
}

/// Near each other, in one row, or anywhere.
LGS_LAW(UnloadedFirst, IsTheFirstOfAllByRows, 300, (std::uint64_t seed)) {
  oracle::Random random(seed);
  const std::int32_t wide = std::array{2, 9, 200, 1 << 24}[random.below(std::size_t{4})];
  const std::int32_t high = std::array{1, 9, 200, 1 << 24}[random.below(std::size_t{4})];
  const auto chunk = [&] { return Cell{random.below(2 * wide + 1) - wide, random.below(2 * high + 1) - high}; };
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  std::set<std::pair<std::int32_t, std::int32_t>> away;  // by rows
  for (int k = random.below(60); k > 0; --k) {
    const auto [i, j] = chunk();
    if (world.firstUnloaded(chunkAt(i, j))) {
      if (random.chance(30) && world.reloadEmpty(chunkAt(i, j))) away.erase({j, i});
    } else if (world.add({32 * i + random.below(32), 32 * j}, square, 1) && world.unload(chunkAt(i, j), {})) {
      away.emplace(j, i);
    }
  }
  for (int k = 0; k < 20; ++k) {
    const Cell a = chunk(), b = chunk();
    const std::int32_t in = random.below(32);
    const CellRect cells{{32 * std::min(a.i, b.i) + in, 32 * std::min(a.j, b.j) + in},
                         {32 * std::max(a.i, b.i) + 31, 32 * std::max(a.j, b.j) + 31}};
    std::optional<Cell> first;
    for (const auto& [j, i] : away)
      if (!first && 32 * i + 31 >= cells.min.i && 32 * i <= cells.max.i && 32 * j + 31 >= cells.min.j &&
          32 * j <= cells.max.j)
        first = Cell{std::max(32 * i, cells.min.i), std::max(32 * j, cells.min.j)};
    EXPECT_EQ(world.firstUnloaded(cells), first);
  }
}

}  // namespace
}  // namespace lgs::test
