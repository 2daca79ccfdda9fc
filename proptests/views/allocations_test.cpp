// What updates of views allocate once world and view have reached their size.
#include "proptests/laws/allocations.h"
#include "proptests/support/worlds.h"

#include <lgs/islands.h>

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

/// Cuts a bar in two and joins it again, a few times; what the last updates allocate.
template <class View>
std::uint64_t allocationsOf() {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_TRUE(world.fill({{0, 0}, {99, 9}}, square, 1));
  world.commit();
  EXPECT_TRUE(world.followCells(true));
  View view(world);
  std::uint64_t count = 0;
  for (int round = 0; round < 4; ++round) {
    count = 0;
    for (const bool isCut : {true, false}) {
      const CellRect cells{{50, 0}, {50, 9}};
      EXPECT_TRUE(isCut ? world.clear(cells).has_value() : world.fill(cells, square, 1).has_value());
      const Changes& changes = world.commit();
      const std::uint64_t before = allocations().count;
      const bool done = view.update(world, changes);
      count += allocations().count - before;
      EXPECT_TRUE(done);
    }
  }
  return count;
}

TEST(ViewAllocations, LoopsAllocateNothing) { EXPECT_EQ(allocationsOf<Loops>(), 0U); }

// Which islands are kin is worked out in lists that live as long as the update. They do not grow with the world.
TEST(ViewAllocations, IslandsAllocateForWhatChanged) {
  const std::uint64_t count = allocationsOf<Islands>();
  EXPECT_GT(count, 0U);
  EXPECT_LT(count, 200U) << "for the ten cells of a cut, and ten of a join";
}

}  // namespace
}  // namespace lgs::test
