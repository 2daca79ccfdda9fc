// What islands cost: an edit costs what it changes, and a little more in loops that are ten times as long. A commit that
// changes twice as much costs twice as much, and not four times.
#include "ground.h"

#include <lgs/islands.h>

#include <gtest/gtest.h>

#include <cstdint>

namespace lgs::cost_test {
namespace {

constexpr Block kRock = 1, kBedrock = 2;

bool isBedrock(Block block, Cell) { return block == kBedrock; }

TEST(Cost, OfIslandsAfterACommitGrowsAsTheLogarithmOfTheWorld) {
  const auto costs = [](std::int32_t side) {
    Ground ground(side);
    ground.world.commit();
    EXPECT_TRUE(ground.world.followCells(true));
    Islands islands(ground.world, isBedrock);
    return costsOf(ground, [&](const Changes& changes) { EXPECT_TRUE(islands.update(ground.world, changes)); });
  };
  const Costs small = costs(kSmall), large = costs(kLarge);
  ASSERT_EQ(small.size(), large.size());
  for (const auto& [what, count] : small) {
    EXPECT_GT(count, 0U) << what;
    EXPECT_LE(large.at(what), count + count / 2) << what;
  }
}

void fill(World& world, const CellRect& cells, Block block = kRock) {
  EXPECT_TRUE(world.clear(cells));
  EXPECT_TRUE(world.fill(cells, world.shape(kUnitSquare).value(), block));
}

/// Whether something is said of that many islands: edits that came to nothing would cost little.
using Told = std::size_t (*)(const IslandChanges&);

/// Makes so much ground, then so many edits in one commit: what the update costs.
std::uint64_t costOfUpdate(const std::function<void(World&)>& before, const std::function<void(World&)>& edits,
                           std::size_t islandsNamed, Told told) {
  World world;
  before(world);
  world.commit();
  EXPECT_TRUE(world.followCells(true));
  Islands islands(world, isBedrock);
  edits(world);
  const Changes& changes = world.commit();
  const auto cost = visitsOf([&] { EXPECT_TRUE(islands.update(world, changes)); });
  EXPECT_EQ(told(islands.changes()), islandsNamed);
  return cost;
}

/// Numbers are sorted: so it is a little more than twice as much.
void expectTwice(const std::function<std::uint64_t(std::int32_t)>& cost) {
  constexpr std::int32_t kMany = 1'000;
  const std::uint64_t once = cost(kMany), twice = cost(2 * kMany);
  EXPECT_LE(10 * twice, 23 * once) << static_cast<double>(twice) / static_cast<double>(once) << " times as much";
}

TEST(CostOfIslands, WhereAnchorsComeToManyIsInProportionToThem) {
  expectTwice([](std::int32_t n) {
    const auto blocks = [n](World& world, Block block) {
      for (std::int32_t k = 0; k < n; ++k) fill(world, {{2 * k, 0}, {2 * k, 0}}, block);
    };
    return costOfUpdate([&](World& world) { blocks(world, kRock); }, [&](World& world) { blocks(world, kBedrock); },
                        static_cast<std::size_t>(n), [](const IslandChanges& c) { return c.changed.size(); });
  });
}

TEST(CostOfIslands, ThatAllChangePartnersIsInProportionToThem) {
  expectTwice([](std::int32_t n) {
    // Bridges to the east of every second block; after the commit to the west.
    const auto bridges = [n](World& world, std::int32_t first) {
      fill(world, {{0, 0}, {4 * n, 0}});
      for (std::int32_t k = 0; k < n; ++k) EXPECT_TRUE(world.clear(Cell{4 * k + first, 0}));
    };
    return costOfUpdate([&](World& world) { bridges(world, 3); }, [&](World& world) { bridges(world, 1); },
                        static_cast<std::size_t>(n) + 1,
                        [](const IslandChanges& c) { return c.changed.size() + c.cutOff.size(); });
  });
}

TEST(CostOfIslands, OfHolesInARowIsInProportionToThem) {
  expectTwice([](std::int32_t n) {
    return costOfUpdate(
        [&](World& world) {
          fill(world, {{0, 0}, {2 * n, 2}}, kBedrock);
        },
        [&](World& world) {
          for (std::int32_t k = 0; k < n; ++k) EXPECT_TRUE(world.clear(Cell{2 * k + 1, 1}));
        },
        1, [](const IslandChanges& c) { return c.changed.size(); });
  });
}

TEST(CostOfIslands, OfAnchorsBetweenHolesIsInProportionToThem) {
  expectTwice([](std::int32_t n) {
    return costOfUpdate(
        [&](World& world) {
          fill(world, {{0, 0}, {2 * n, 2}});
          for (std::int32_t k = 0; k < n; ++k) EXPECT_TRUE(world.clear(Cell{2 * k + 1, 1}));
        },
        [&](World& world) {
          for (std::int32_t k = n; k > 0; --k) fill(world, {{2 * k, 1}, {2 * k, 1}}, kBedrock);
        },
        1, [](const IslandChanges& c) { return c.changed.size(); });
  });
}

TEST(CostOfIslands, OfAnchorsInAWideRockIsInProportionToThem) {
  expectTwice([](std::int32_t n) {
    return costOfUpdate(
        [&](World& world) {
          fill(world, {{0, 0}, {n + 1, 2}});
        },
        [&](World& world) {
          fill(world, {{1, 1}, {n, 1}}, kBedrock);
        },
        1, [](const IslandChanges& c) { return c.changed.size(); });
  });
}

}  // namespace
}  // namespace lgs::cost_test
