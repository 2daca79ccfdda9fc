// Law 6, exact changes: a commit lists the ids removed, added and relinked. Applied to a copy of the old output the
// lists give the new one; a segment that kept its ends, owner and ghosts is in none of them and keeps its id.
#include "oracle/trace/mirror.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test {
namespace {

using oracle::Random;

// The random cases' commits are small; here each adds, removes and relinks thousands of segments.
TEST(Invariants, ChangesOfBigCommitsAreExact) {
  Random random(7);
  World world;
  oracle::Mirror mirror;
  const std::vector<ShapeId> shapes = turnedShapes(world, random);
  for (int round = 0; round < 6; ++round) {
    for (const Cell& cell : cellsOf({{-40, -30}, {39, 29}})) {
      if (!random.chance(30)) continue;
      removeAll(world, cell);
      ASSERT_TRUE(!random.chance(80) || world.add(cell, random.pick(shapes), 1));
    }
    const Changes& changes = world.commit();
    const auto problem = mirror.update(world, changes);
    ASSERT_FALSE(problem) << *problem;
    if (round != 0) {
      EXPECT_GT(std::min({changes.removed.size(), changes.added.size(), changes.relinked.size()}), 1000U);
    }
  }
}

}  // namespace
}  // namespace lgs::test
