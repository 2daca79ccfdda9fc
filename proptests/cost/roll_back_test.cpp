// What goes on while an old mark is held costs the same, however much was edited since that mark.
#include "visits.h"

#include <lgs/world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lgs::cost_test {
namespace {

struct HeldCosts {
  std::uint64_t trial = 0;  ///< a mark, an edit, a roll-back, the mark is let go
  std::uint64_t edit = 0;   ///< an edit and its commit
  std::uint64_t group = 0;  ///< a group of one edit that is kept, and a commit
};

/// Of cells in a world of full blocks, after side × side cells were edited since an old mark. They are counted twice, as
/// the first time lists may grow.
HeldCosts costsAfter(std::int32_t side, bool isCommittedBetween) {
  World world;
  const ShapeId square = world.shape(kUnitSquare).value();
  EXPECT_TRUE(world.fill({{0, 0}, {259, 259}}, square, 1));
  world.commit();
  const Mark old = world.mark();
  EXPECT_TRUE(world.clear(CellRect{{0, 0}, {side - 1, side - 1}}));
  world.commit();
  HeldCosts costs;
  for (std::int32_t k = 0; k < 2; ++k) {
    const std::int32_t column = 204 + 2 * k;
    const auto dig = [&](std::int32_t row) { EXPECT_EQ(world.clear(Cell{column, row}).value(), 1U); };
    costs.trial = visitsOf([&] {
      const Mark mark = world.mark();
      dig(210);
      if (isCommittedBetween) world.commit();
      EXPECT_TRUE(world.rollBack(mark));
      EXPECT_TRUE(world.forget(mark));
    });
    costs.edit = visitsOf([&] {
      dig(220);
      world.commit();
    });
    costs.group = visitsOf([&] {
      Transaction group = world.edit();
      dig(230);
      if (isCommittedBetween) world.commit();
      group.keep();
      world.commit();
    });
  }
  EXPECT_TRUE(world.rollBack(old));
  EXPECT_EQ(world.stats().polygons, 260U * 260U);
  return costs;
}

/// In eight worlds, the least of each: hash tables have seeds of their own, so a search may take some steps more in one.
HeldCosts leastAfter(std::int32_t side, bool isCommittedBetween) {
  HeldCosts least = costsAfter(side, isCommittedBetween);
  for (int k = 1; k < 8; ++k) {
    const HeldCosts other = costsAfter(side, isCommittedBetween);
    least = {std::min(least.trial, other.trial), std::min(least.edit, other.edit), std::min(least.group, other.group)};
  }
  return least;
}

TEST(RollBackCost, DoesNotGrowWithWhatWasEditedBefore) {
  for (const bool isCommittedBetween : {false, true}) {
    const HeldCosts few = leastAfter(10, isCommittedBetween), many = leastAfter(200, isCommittedBetween);
    const auto spare = [](std::uint64_t cost) { return cost + cost / 10; };
    EXPECT_LE(many.trial, spare(few.trial)) << "with a commit between: " << isCommittedBetween;
    EXPECT_LE(many.edit, spare(few.edit)) << "with a commit between: " << isCommittedBetween;
    EXPECT_LE(many.group, spare(few.group)) << "with a commit between: " << isCommittedBetween;
  }
}

/// Many edits of the same cells after each of some marks; then all marks but the first go, the last one first or the
/// first one first. That costs O(log n) an edit in all, and what the first mark needs is there.
TEST(RollBackCost, OfMarksThatGoIsThatOfTheirEdits) {
  for (const bool lastFirst : {false, true}) {
    const auto cost = [&](std::int32_t edits) {
      constexpr std::int32_t kWidth = 64;
      World world;
      const ShapeId square = world.shape(kUnitSquare).value();
      std::vector<Mark> marks{world.mark()};
      for (Block block = 0; block < 50; ++block) {
        for (std::int32_t k = 0; k < edits; ++k) EXPECT_TRUE(world.replace({k % kWidth, k / kWidth}, square, block));
        marks.push_back(world.mark());
      }
      const std::uint64_t visits = visitsOf([&] {
        for (std::size_t k = 1; k < marks.size(); ++k)
          EXPECT_TRUE(world.forget(marks[lastFirst ? marks.size() - k : k]));
      });
      EXPECT_TRUE(world.rollBack(marks[0]));
      EXPECT_EQ(world.stats().polygons, 0U);
      return visits;
    };
    EXPECT_LT(cost(2'000), 10 * cost(250)) << "the last one first: " << lastFirst;
  }
}

/// A chunk leaves, after some edits elsewhere were undone that a redo can bring back.
TEST(RollBackCost, OfUnloadingDoesNotGrowWithWhatWasUndone) {
  const auto cost = [](std::int32_t side) {
    World world;
    const ShapeId square = world.shape(kUnitSquare).value();
    EXPECT_TRUE(world.fill({{0, 0}, {259, 259}}, square, 1));
    world.commit();
    const Mark before = world.mark();
    EXPECT_TRUE(world.clear(CellRect{{0, 0}, {side - 1, side - 1}}));
    world.commit();
    const Mark after = world.mark();
    EXPECT_TRUE(world.rollBack(before, Undone::keep));
    const std::uint64_t visits = visitsOf([&] { EXPECT_EQ(world.unload({{224, 224}, {255, 255}}, {}).value(), 1U); });
    EXPECT_TRUE(world.redo(after));
    return visits;
  };
  const std::uint64_t few = cost(10);
  EXPECT_LE(cost(200), few + few / 10);
}

}  // namespace
}  // namespace lgs::cost_test
