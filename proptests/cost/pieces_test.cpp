// What pieces cost: an edit costs what it changes, however large the world is; a content little more than its vertices.
#include "ground.h"

#include <lgs/pieces.h>

#include <gtest/gtest.h>

namespace lgs::cost_test {
namespace {

TEST(Cost, OfPiecesAfterACommitIsNoMoreInALargerWorld) {
  const auto costs = [](std::int32_t side) {
    Ground ground(side);
    ground.world.commit();
    EXPECT_TRUE(ground.world.followCells(true));
    Pieces pieces(ground.world);
    return costsOf(ground, [&](const Changes& changes) {
      const std::uint64_t workedOut = pieces.stats().workedOut;
      EXPECT_TRUE(pieces.update(ground.world, changes));
      EXPECT_LE(pieces.stats().workedOut - workedOut, ground.world.cellChanges().size())
          << "one content for each cell, at most";
    });
  };
  expectNoMore(costs, kSmall, kLarge);
}

/// Of the pieces of a comb.
std::uint64_t costOfPieces(std::int32_t teeth) {
  World world;
  EXPECT_TRUE(world.add({0, 0}, comb(teeth), 1));
  return visitsOf([&] { EXPECT_FALSE(Pieces(world).solidPieces({0, 0}).empty()); });
}

TEST(Cost, OfPiecesGrowsHardlyFasterThanTheVertices) {
  constexpr std::int32_t kFew = 60, kMany = 16 * kFew;
  // Sorting n vertices takes n log n, 1.7 times as much for each of them here. The few ones take less since a walk over the
  // world passes empty cells at once: it was 1.93 times, and is 2.07.
  EXPECT_LT(10 * costOfPieces(kMany), 16 * 21 * costOfPieces(kFew));
}

}  // namespace
}  // namespace lgs::cost_test
