// What hashes of the ground cost: an edit costs what it changes, however large the world is.
#include "ground.h"

#include <lgs/hashes.h>

#include <gtest/gtest.h>

namespace lgs::cost_test {
namespace {

TEST(Cost, OfHashesAfterACommitIsNoMoreInALargerWorld) {
  const auto costs = [](std::int32_t side) {
    Ground ground(side);
    ground.world.commit();
    EXPECT_TRUE(ground.world.followCells(true));
    GroundHashes hashes(ground.world);
    return costsOf(ground, [&](const Changes& changes) { EXPECT_TRUE(hashes.update(ground.world, changes)); });
  };
  expectNoMore(costs, kSmall, kLarge);
}

TEST(Cost, OfDifferencesIsThatOfTheChunksThatDiffer) {
  const auto cost = [](std::int32_t side) {
    Ground ground(side);
    ground.world.commit();
    const GroundHashes before(ground.world);
    EXPECT_TRUE(ground.world.clear(Ground::kPlace));
    const GroundHashes after(ground.world);
    return Costs{{"differences", visitsOf([&] { EXPECT_EQ(differences(before, after).size(), 1U); })}};
  };
  expectNoMore(cost, kSmall, kLarge);
}

}  // namespace
}  // namespace lgs::cost_test
