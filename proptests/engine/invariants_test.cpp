// Invariants on big worlds under random edits: where no reference can follow.
#include "invariants.h"
#include "oracle/generate/random.h"
#include "random_traces.h"
#include "scale.h"
#include "support.h"

#include "oracle/trace/mirror.h"
#include "oracle/trace/player.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lgs::engine_test {
namespace {

using oracle::Random;
using oracle::Trace;

using Cycle = std::vector<SegmentId>;

Cycle fromItsLeast(Cycle cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

/// By the definition: from each segment its successors, as long as each says that it comes from the one before.
std::set<Cycle> cyclesOfMutualLinks(const World& world) {
  std::set<Cycle> cycles;
  const std::vector<SegmentId> ids = world.segments();
  for (const SegmentId first : ids) {
    Cycle cycle;
    SegmentId at = first;
    do {
      cycle.push_back(at);
      const SegmentId next = world.segment(at)->successor;
      if (!next || world.segment(next)->predecessor != at) break;
      at = next;
    } while (at != first && cycle.size() <= ids.size());
    if (at == first && world.segment(first)->predecessor == cycle.back()) cycles.insert(fromItsLeast(cycle));
  }
  return cycles;
}

RC_GTEST_PROP(Loops, AreTheCyclesOfMutualLinks, ()) {
  forRandomTraces("loops", 60, {}, [](const Trace& trace, Random) -> std::optional<std::string> {
    oracle::Player player(trace.preserve);
    if (!oracle::play(trace, player)) return "refused";
    player.commit();
    std::set<Cycle> loops;
    for (const Loop& loop : player.world().loops())
      if (!loops.insert(fromItsLeast(loop.segments)).second) return "a loop is there twice";
    if (loops != cyclesOfMutualLinks(player.world())) return "the loops are not the cycles of mutual links";
    return std::nullopt;
  });
}

RC_GTEST_PROP(Invariants, HoldInRandomCases, ()) {
  forRandomTraces("invariants", 15, {.withPreserve = false}, [](const Trace& original, Random) {
    Trace trace = original;
    CellRect cells{{kMaxCell, kMaxCell}, {-kMaxCell, -kMaxCell}};
    for (const oracle::Edit& edit : trace.edits) {
      if (edit.kind != oracle::Edit::Kind::add) continue;
      cells.min = {std::min(cells.min.i, edit.polygon.cell.i), std::min(cells.min.j, edit.polygon.cell.j)};
      cells.max = {std::max(cells.max.i, edit.polygon.cell.i), std::max(cells.max.j, edit.polygon.cell.j)};
    }
    const CellRect moved{{-2, -2}, {cells.max.i - cells.min.i - 2, cells.max.j - cells.min.j - 2}};
    for (oracle::Edit& edit : trace.edits) {  // near the origin, where areas do not overflow
      if (edit.kind != oracle::Edit::Kind::add) continue;
      edit.polygon.cell = {edit.polygon.cell.i - cells.min.i - 2, edit.polygon.cell.j - cells.min.j - 2};
    }
    oracle::Player player({});
    std::optional<std::string> problem;
    const auto played = oracle::play(trace, player, [&](oracle::Player& p, const Changes&) {
      problem = brokenInvariant(p.world(), moved);
      return !problem;
    });
    return played ? problem : message(played.error(), "trace");
  });
}

/// Every degenerate shape, each turned by chance.
std::vector<ShapeId> turnedPalette(World& world, Random& random) {
  std::vector<ShapeId> shapes;
  for (const oracle::NamedShape& shape : oracle::degenerateShapes()) {
    const int symmetry = random.below(8);
    std::vector<LocalPolygon> polygons;
    for (const LocalPolygon& p : shape.polygons) polygons.push_back(oracle::turned(p, symmetry));
    shapes.push_back(shapeOf(world, polygons));
  }
  return shapes;
}

TEST(Invariants, HoldInABigWorldUnderRandomEdits) {
  const auto side = static_cast<std::int32_t>(std::min(1000.0, 1000 * std::sqrt(testScale())));
  RecordProperty("cells_a_side", side);
  const CellRect all{{-side / 2, -side / 3}, {side - side / 2 - 1, side - side / 3 - 1}};
  Random random(2026);
  World world;
  const std::vector<ShapeId> shapes = turnedPalette(world, random);
  const auto randomCell = [&] {
    const std::int32_t i = all.min.i + random.below(side);
    const std::int32_t j = all.min.j + random.below(side);
    return Cell{i, j};
  };
  // Half of it random shapes, half of it solid; then holes, refills and rectangles in both.
  ASSERT_TRUE(world.fill({all.min, {all.max.i, 0}}, shapes[0], 1));
  for (const Cell& cell : cellsOf({{all.min.i, 1}, all.max})) ASSERT_TRUE(world.add(cell, random.pick(shapes), 2));
  world.commit();
  for (int round = 0; round < 4; ++round) {
    for (int k = 0; k < side * 20; ++k) {
      const Cell cell = randomCell();
      if (random.chance(70) || !world.polygons(cell).empty()) removeAll(world, cell);
      if (random.chance(70) && world.polygons(cell).empty()) {
        ASSERT_TRUE(world.add(cell, random.pick(shapes), 3));
      }
      if (random.chance(50)) world.commit();
      if (k % 500 != 0) continue;
      const Cell from = randomCell();
      const CellRect rect{from, {std::min(all.max.i, from.i + 40), std::min(all.max.j, from.j + 7)}};
      ASSERT_TRUE(world.clear(rect));
      if (random.chance(50)) world.commit();
      ASSERT_TRUE(world.fill(rect, random.pick(shapes), 4));
    }
    world.commit();
    const auto problem = brokenInvariant(world, all);
    ASSERT_FALSE(problem) << *problem;
  }
  ASSERT_TRUE(world.clear(all));
  world.commit();
  EXPECT_EQ(world.stats().segments, 0U);
  const auto problem = brokenInvariant(world, all);
  EXPECT_FALSE(problem) << *problem;
}

// The random cases' commits are small; here each adds, removes and relinks thousands of segments.
TEST(Invariants, ChangesOfBigCommitsAreExact) {
  Random random(7);
  World world;
  oracle::Mirror mirror;
  const std::vector<ShapeId> shapes = turnedPalette(world, random);
  for (int round = 0; round < 6; ++round) {
    for (const Cell& cell : cellsOf({{-40, -30}, {39, 29}})) {
      if (!random.chance(30)) continue;
      removeAll(world, cell);
      if (random.chance(80)) {
        ASSERT_TRUE(world.add(cell, random.pick(shapes), 1));
      }
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
}  // namespace lgs::engine_test
