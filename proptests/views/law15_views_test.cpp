// Law 15: the views of loops, islands, pieces and hashes are, after each commit and after a roll-back or redo, what a
// look at the whole world gives; and what they say has changed is what differs. One that missed something says so.
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <lgs/hashes.h>
#include <lgs/islands.h>
#include <lgs/pieces.h>

#include <gtest/gtest.h>

#include <array>

namespace lgs::test {
namespace {

LGS_LAW(Views, AreTheirRecompute, 600, (const AnyTrace& trace)) {
  expectNoMismatch(trace, {.naive = false, .cgal = false, .views = true});
}

/// One of each.
struct AllViews {
  explicit AllViews(const World& world) : loops(world), islands(world), pieces(world), hashes(world) {}
  /// Which of them take it.
  std::array<bool, 4> update(const World& world, const Changes& changes) {
    return {loops.update(world, changes), islands.update(world, changes), pieces.update(world, changes),
            hashes.update(world, changes)};
  }
  Loops loops;
  Islands islands;
  Pieces pieces;
  GroundHashes hashes;
};

/// Inside the ground a polygon gets another block: no segment changes, and the ground does.
TEST(ViewsByHand, SayThatTheyMissedWhatChangedNoSegment) {
  World world;
  EXPECT_TRUE(world.fill({{0, 0}, {2, 2}}, world.shape(kUnitSquare).value(), 1));
  world.commit();
  EXPECT_TRUE(world.followCells(true));
  AllViews views(world);
  EXPECT_TRUE(world.setBlock(world.polygons({1, 1}).front().handle, 2));
  EXPECT_EQ(oracle::copyOf(world.commit()), oracle::ChangeLists()) << "which the views miss";
  EXPECT_TRUE(world.clear(Cell{0, 0}));
  EXPECT_EQ(views.update(world, world.commit()), (std::array{false, false, false, false}));
}

}  // namespace
}  // namespace lgs::test
