// Law 5, locality: a commit changes only segments that lie in, or end on the rim of, an edited cell, and links at that
// rim's vertices.
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

TEST(Locality, AnEditInABigWorldChangesAFewSegments) {
  World world;
  ASSERT_TRUE(world.fill({{0, 0}, {199, 199}}, shapeOf(world, {unitSquare()}), 1));
  world.commit();
  const Snapshot before = snapshotOf(world, {});
  removeAll(world, {100, 100});
  EXPECT_EQ(copyOf(world.commit()).added.size(), 4U);
  place(world, {100, 100}, unitSquare());
  const Changes& changes = world.commit();
  EXPECT_EQ(changes.removed.size(), 4U);
  EXPECT_TRUE(changes.added.empty() && changes.relinked.empty());
  EXPECT_EQ(snapshotOf(world, {}).segments, before.segments);
}

}  // namespace
}  // namespace lgs::test
