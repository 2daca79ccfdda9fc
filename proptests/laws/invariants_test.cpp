// What holds in every world without a preserve relation, whatever led to it (invariants.h); in big worlds too, where no
// reference can follow.
#include "invariants.h"
#include "proptests/support/scale.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lgs::test {
namespace {

using oracle::Random;

TEST(Invariants, HoldInABigWorldUnderRandomEdits) {
  const auto side = static_cast<std::int32_t>(std::min(600.0, 600 * std::sqrt(testScale())));
  RecordProperty("cells_a_side", side);
  const CellRect all{{-side / 2, -side / 3}, {side - side / 2 - 1, side - side / 3 - 1}};
  Random random(2026);
  World world;
  const std::vector<ShapeId> shapes = turnedShapes(world, random);
  const auto randomCell = [&] {
    const std::int32_t i = all.min.i + random.below(side);
    const std::int32_t j = all.min.j + random.below(side);
    return Cell{i, j};
  };
  // Half of it random shapes, half of it solid; then holes, refills and rectangles in both.
  ASSERT_TRUE(world.fill({all.min, {all.max.i, 0}}, shapes[0], 1));
  for (const Cell& cell : cellsOf({{all.min.i, 1}, all.max})) ASSERT_TRUE(world.add(cell, random.pick(shapes), 2));
  world.commit();
  for (int round = 0; round < 4; ++round) {
    for (int k = 0; k < side * 20; ++k) {
      const Cell cell = randomCell();
      if (random.chance(70) || !world.polygons(cell).empty()) removeAll(world, cell);
      const bool adds = random.chance(70) && world.polygons(cell).empty();
      ASSERT_TRUE(!adds || world.add(cell, random.pick(shapes), 3));
      if (random.chance(50)) world.commit();
      if (k % 500 != 0) continue;
      const Cell from = randomCell();
      const CellRect rect{from, {std::min(all.max.i, from.i + 40), std::min(all.max.j, from.j + 7)}};
      ASSERT_TRUE(world.clear(rect));
      if (random.chance(50)) world.commit();
      ASSERT_TRUE(world.fill(rect, random.pick(shapes), 4));
    }
    world.commit();
    const auto problem = brokenInvariant(world, all);
    ASSERT_FALSE(problem) << *problem;
  }
  ASSERT_TRUE(world.clear(all));
  world.commit();
  EXPECT_EQ(world.stats().segments, 0U);
  const auto problem = brokenInvariant(world, all);
  EXPECT_FALSE(problem) << *problem;
}

}  // namespace
}  // namespace lgs::test
