// The edges for Box2D follow a commit at a cost in proportion to what it changed.
#include "ground.h"

#include <gtest/gtest.h>
#include <lgs/box2d/edges.h>

namespace lgs::cost_test {
namespace {

Costs costsOfEdges(std::int32_t side, bool merge) {
  Ground ground(side);
  box2d::EdgeSet edges({.chunkCells = 8, .shortest = kUnitsPerCell / 16, .merge = merge});
  edges.load(ground.world);
  return costsOf(ground, [&](const Changes& changes) { edges.update(ground.world, changes); });
}

TEST(Cost, OfAnUpdateOfEdgesIsNoMoreInALargerWorld) {
  for (const bool merge : {false, true}) {
    SCOPED_TRACE(merge ? "merged" : "not merged");
    for (const auto& [what, cost] : costsOfEdges(kSmall, merge)) EXPECT_GT(cost, 0U) << what;
    expectNoMore([merge](std::int32_t side) { return costsOfEdges(side, merge); }, kSmall, kLarge);
  }
}

}  // namespace
}  // namespace lgs::cost_test
