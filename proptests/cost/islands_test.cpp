// What islands cost: an edit costs what it changes, and a little more in loops that are ten times as long.
#include "ground.h"

#include <lgs/islands.h>

#include <gtest/gtest.h>

namespace lgs::cost_test {
namespace {

TEST(Cost, OfIslandsAfterACommitGrowsAsTheLogarithmOfTheWorld) {
  const auto costs = [](std::int32_t side) {
    Ground ground(side);
    ground.world.commit();
    EXPECT_TRUE(ground.world.followCells(true));
    Islands islands(ground.world, [](Block block, Cell) { return block == 2; });
    return costsOf(ground, [&](const Changes& changes) { EXPECT_TRUE(islands.update(ground.world, changes)); });
  };
  const Costs small = costs(kSmall), large = costs(kLarge);
  ASSERT_EQ(small.size(), large.size());
  for (const auto& [what, count] : small) {
    EXPECT_GT(count, 0U) << what;
    EXPECT_LE(large.at(what), count + count / 2) << what;
  }
}

}  // namespace
}  // namespace lgs::cost_test
