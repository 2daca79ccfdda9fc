// setBlock() changes a block and nothing else; all edits come to what the laws make of the polygons; and worlds with
// the same polygons are told as such.
#include "calls.h"
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test {
namespace {

LGS_LAW(AnyEdits, ComeToTheOutlineOfTheLaws, 1'000, (const AnyCalls& calls, const Setting& setting)) {
  World world = grown(setting, calls).world;
  world.commit();
  EXPECT_EQ(oracle::outlineOf(world), outlineByLaws(world, setting.preserve));
}

LGS_LAW(SetBlock, ChangesTheBlockAlone, 1'000, (const Calls& calls, const Setting& setting, Chance chance)) {
  Caller caller = grown(setting, calls);
  World& world = caller.world;
  world.commit();
  oracle::Random choices(chance.next());
  const Call call = caller.resolved(drawOne(choices, Call::Kind::setBlock));
  const PolygonHandle polygon = call.goes[0].handle;
  const Block block = call.comes[0].block;
  const auto cell = world.cellOf(polygon);
  const World untouched = world;
  if (caller.makeResolved(call).refusal) {
    EXPECT_FALSE(cell);
    return;
  }
  ASSERT_TRUE(cell);
  bool changed = false;
  std::vector<PolygonFields> expected = polygonsIn(untouched, *cell);
  for (PolygonFields& p : expected) {
    if (p.handle != polygon) continue;
    changed = p.block != block;
    p.block = block;
  }
  EXPECT_EQ(polygonsIn(world, *cell), expected);
  EXPECT_EQ(samePolygons(world, untouched), !changed);
  EXPECT_EQ(samePolygons(untouched, world), !changed);
  const Changes& changes = world.commit();
  EXPECT_EQ(oracle::outlineOf(world), outlineByLaws(world, setting.preserve));
  if (!setting.preserve.empty()) return;
  EXPECT_EQ(changes.removed.size(), changes.added.size());
  for (const SegmentId id : changes.removed) EXPECT_EQ(untouched.segment(id)->polygon, polygon);
  for (const SegmentId id : changes.added) EXPECT_EQ(world.segment(id)->polygon, polygon);
}

LGS_LAW(SamePolygons, DoNotDependOnHowTheyCame, 500, (const Calls& calls, const Setting& setting, Chance chance)) {
  const World world = grown(setting, calls).world;
  World other;
  std::vector<std::pair<Cell, PolygonFields>> all;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) { all.emplace_back(cell, fieldsOf(p)); });
  chance.shuffle(all);
  for (auto& [cell, polygon] : all) {
    EXPECT_FALSE(samePolygons(world, other) || samePolygons(other, world)) << "something is still missing";
    std::rotate(polygon.vertices.begin(), polygon.vertices.begin() + chance.below(3), polygon.vertices.end());
    place(other, cell, polygon.vertices, polygon.block);
  }
  EXPECT_TRUE(samePolygons(world, other) && samePolygons(other, world));
}

}  // namespace
}  // namespace lgs::test
