// Cost in proportion to the edit: the same edit in the same surroundings costs no more in a larger world.
#include "ground.h"

#include <gtest/gtest.h>

namespace lgs::cost_test {
namespace {

TEST(Cost, OfAnEditAndItsCommitIsNoMoreInALargerWorld) {
  const auto costs = [](std::int32_t side) {
    Ground ground(side);
    return costsOf(ground, [](const Changes&) {});
  };
  for (const auto& [what, cost] : costs(kSmall)) EXPECT_TRUE(cost > 0 || what.starts_with("sync")) << what;
  expectNoMore(costs, kSmall, kLarge);
}

}  // namespace
}  // namespace lgs::cost_test
