// The view of islands by example: what is cut off and foreseen. law15_views_test.cpp has the law.
#include "oracle/calls/draw.h"
#include "oracle/views/island_check.h"
#include "proptests/laws/unloaded.h"
#include "proptests/support/worlds.h"

#include <lgs/islands.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lgs::test {
namespace {

constexpr Block kRock = 1, kBedrock = 2;

bool isBedrock(Block block, Cell) { return block == kBedrock; }

/// A world of whole cells, drawn in rows, the upper one first: '#' is rock, 'B' bedrock. A view follows it, and is
/// checked after each commit.
class Drawn {
 public:
  explicit Drawn(const std::vector<std::string>& rows, Cell corner = {}) : corner_(corner) {
    draw(rows);
    world.commit();
    EXPECT_TRUE(world.followCells(true));
    islands = Islands(world, isBedrock);
    EXPECT_EQ(check_.begin(world, islands), std::nullopt);
  }

  /// Makes the world look like this, and commits.
  void become(const std::vector<std::string>& rows) {
    draw(rows);
    commit();
  }
  void commit() {
    ASSERT_TRUE(islands.update(world, world.commit()));
    EXPECT_EQ(check_.update(world, islands), std::nullopt);
  }

  /// The island of a cell.
  IslandId at(Cell cell) const {
    const auto polygons = world.polygons({corner_.i + cell.i, corner_.j + cell.j});
    return polygons.empty() ? IslandId() : islands.of(world, polygons.front().handle);
  }
  std::uint64_t anchors(Cell cell) const { return islands.island(at(cell))->anchors; }
  const IslandChanges& changes() const { return islands.changes(); }

  World world;
  Islands islands{world};

 private:
  void draw(const std::vector<std::string>& rows) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t c = 0; c < rows[r].size(); ++c) {
        const Cell cell{corner_.i + static_cast<std::int32_t>(c),
                        corner_.j + static_cast<std::int32_t>(rows.size() - 1 - r)};
        const Block block = rows[r][c] == '#' ? kRock : rows[r][c] == 'B' ? kBedrock : 0;
        const auto held = world.polygons(cell);
        if (held.empty() && block != 0) place(world, cell, unitSquare(), block);
        if (!held.empty() && block == 0) removeAll(world, cell);
        if (held.empty() || block == 0 || held.front().block == block) continue;
        EXPECT_TRUE(world.setBlock(held.front().handle, block));
      }
    }
  }

  Cell corner_;
  oracle::IslandCheck check_{isBedrock};
};

TEST(IslandViewByHand, ABridgeThatIsCutLetsItsEndFall) {
  Drawn d({"B#####"});
  const IslandId whole = d.at({0, 0});
  EXPECT_EQ(d.anchors({0, 0}), 1U);
  d.become({"B#.###"});
  EXPECT_EQ(d.changes().cutOff, (std::vector{IslandPair{whole, d.at({0, 0})}})) << "the larger part keeps the id";
  EXPECT_EQ(d.at({4, 0}), whole);
  EXPECT_EQ(d.anchors({0, 0}), 1U);
  EXPECT_EQ(d.anchors({4, 0}), 0U);
  EXPECT_EQ(d.islands.loose(), std::vector{whole}) << "it is the larger part that falls";
  d.become({"B#####"});
  EXPECT_EQ(d.changes().joined.size(), 1U);
  EXPECT_EQ(d.anchors({4, 0}), 1U);
  EXPECT_TRUE(d.islands.loose().empty());
}

TEST(IslandViewByHand, WhatIsOnlyWalkedThroughIsTheSmallerPart) {
  Drawn d({std::string(100, '#')});
  const std::uint64_t before = d.islands.walked();
  std::string cut(100, '#');
  cut[3] = '.';
  d.become({cut});
  EXPECT_EQ(d.islands.walked() - before, 3U);
}

TEST(IslandViewByHand, AMoatCutsOffWhatItRunsAround) {
  Drawn d({"#######", "#######", "#######", "###B###", "#######", "#######", "#######"});
  const IslandId rock = d.at({0, 0});
  d.become({"#######", "#.....#", "#.###.#", "#.#B#.#", "#.###.#", "#.....#", "#######"});
  EXPECT_EQ(d.changes().cutOff, (std::vector{IslandPair{rock, d.at({3, 3})}}));
  EXPECT_EQ(d.at({0, 0}), rock);
  EXPECT_EQ(d.anchors({0, 0}), 0U);
  EXPECT_EQ(d.anchors({3, 3}), 1U);
}

TEST(IslandViewByHand, ThatAnEditWouldCutSomethingOffIsKnownBeforeIt) {
  Drawn d({"B####"});
  const auto cut = [&](World& world) { return world.clear(Cell{2, 0}).has_value(); };
  const Foreseen would = foresee(d.world, d.islands, cut);
  ASSERT_EQ(would.changes.cutOff.size(), 1U);
  ASSERT_EQ(would.after.size(), 2U);
  EXPECT_EQ(std::ranges::count(would.after, 0U, &IslandFacts::anchors), 1);
  EXPECT_EQ(d.islands.all().size(), 1U);
  EXPECT_EQ(d.anchors({4, 0}), 1U);
  EXPECT_FALSE(d.world.isEmpty({2, 0}));
  const Foreseen nothing = foresee(d.world, d.islands, [](World& world) {
    return world.clear(Cell{1, 0}).has_value() && world.remove({}).has_value();
  });
  EXPECT_TRUE(nothing.changes.cutOff.empty());
  EXPECT_FALSE(d.world.isEmpty({1, 0})) << "what was edited before the refusal is undone as well";
  d.commit();
}

/// By rational numbers of 128 bits, which are enough for a few cells.
TEST(Bodies, HaveMomentsThatAreRoundedOnce) {
  oracle::Random choices(7);
  for (int round = 0; round < 2'000; ++round) {
    std::vector<BodyPolygon> polygons;
    World world;
    for (int k = choices.between(1, 3); k > 0; --k) {
      const LocalPolygon p = oracle::drawPolygon(choices);
      if (!world.shape(p)) continue;  // it runs clockwise, or has no area
      polygons.push_back({{choices.between(-3, 3), choices.between(-3, 3)}, 1, p});
    }
    using oracle::Wide;
    Wide a = 0, mx = 0, my = 0, polar = 0;
    for (const BodyPolygon& p : polygons) {
      for (std::size_t k = 1; k + 1 < p.vertices.size(); ++k) {  // a fan of triangles
        const Point o = toWorld(p.cell, p.vertices[0]), u = toWorld(p.cell, p.vertices[k]),
                    v = toWorld(p.cell, p.vertices[k + 1]);
        const Wide twice = Wide{u.x - o.x} * (v.y - o.y) - Wide{u.y - o.y} * (v.x - o.x);
        a += twice;
        mx += twice * (o.x + u.x + v.x);
        my += twice * (o.y + u.y + v.y);
        for (const auto& [p0, p1, p2] : {std::array{o.x, u.x, v.x}, std::array{o.y, u.y, v.y}})
          polar +=
              twice * (Wide{p0} * p0 + Wide{p1} * p1 + Wide{p2} * p2 + Wide{p0} * p1 + Wide{p1} * p2 + Wide{p2} * p0);
      }
    }
    if (polygons.empty()) continue;
    const MassOfPolygons mass = massOf(polygons);
    const auto near = [](double value, long double exact) {
      const auto rounded = static_cast<double>(exact);
      return value >= std::nextafter(rounded, -HUGE_VAL) && value <= std::nextafter(rounded, HUGE_VAL);
    };
    const auto real = [](Wide v) { return static_cast<long double>(v); };
    constexpr long double U1 = kUnitsPerCell;
    EXPECT_TRUE(near(mass.area, real(a) / 2 / U1 / U1));
    EXPECT_TRUE(near(mass.centroid.x, real(mx) / (3 * real(a)) / U1));
    EXPECT_TRUE(near(mass.centroid.y, real(my) / (3 * real(a)) / U1));
    // Both terms have less than 2^126; their difference is exact.
    const Wide central = 3 * polar * a - 2 * (mx * mx + my * my);
    EXPECT_TRUE(near(mass.secondMoment, real(central) / (36 * real(a)) / U1 / U1 / U1 / U1)) << round;
  }
}

// Two squares of two chunks touch in a corner. One goes and comes back, then the other one goes, and all of it is undone:
// the ids are those of the mark, and nothing is beyond.
TEST(IslandViewByHand, AChainThatClosesWithOtherIdsWasBeyond) {
  World world;
  ASSERT_TRUE(world.followCells(true));
  Islands islands(world);
  Shelf shelf;
  const auto commit = [&] { ASSERT_TRUE(islands.update(world, world.commit())); };
  const PolygonHandle square = place(world, {-1, 1}, unitSquare());
  commit();
  const Mark mark = world.mark();
  place(world, {0, 2}, unitSquare());
  commit();
  ASSERT_TRUE(world.unload({{-32, 0}, {-1, 31}}, shelf.sink()));
  commit();
  ASSERT_TRUE(shelf.reload(world, {-32, 0}));
  commit();
  ASSERT_TRUE(world.unload({{0, 0}, {31, 31}}, shelf.sink()));
  commit();
  ASSERT_EQ(islands.of(world, square), kBeyond);
  ASSERT_TRUE(world.rollBack(mark));
  ASSERT_TRUE(islands.update(world, world.changesOfRollBack()));
  EXPECT_EQ(islands.changes().cutOff, (std::vector{IslandPair{kBeyond, islands.of(world, square)}}));
  EXPECT_TRUE(islands.changes().added.empty());
}

}  // namespace
}  // namespace lgs::test
