// Cost in proportion to the edit: the same edit in the same surroundings costs the same, however large the world is.
#include "ground.h"

#include <gtest/gtest.h>

namespace lgs::cost_test {
namespace {

TEST(Cost, OfAnEditAndItsCommitIsTheSameInALargerWorld) {
  const auto costs = [](std::int32_t side) {
    Ground ground(side);
    return costsOf(ground, [](const Changes&) {});
  };
  const Costs small = costs(kSmall);
  for (const auto& [what, cost] : small) EXPECT_TRUE(cost > 0 || what.starts_with("sync")) << what;
  expectSame(small, costs(kLarge));
}

}  // namespace
}  // namespace lgs::cost_test
