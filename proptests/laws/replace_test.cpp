// replace(), setBlock() and clear() of a cell come to what their parts come to; and all edits to what the laws make of
// the polygons.
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"
#include "twins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace lgs::test {
namespace {

using Kind = AnyEdit::Kind;

/// A random edit of one kind.
AnyEdit editOf(Kind kind, const World& world, Chance& chance) {
  for (;;)
    if (AnyEdit edit = randomEdit(world, chance); edit.kind == kind) return edit;
}

LGS_LAW(AnyEdits, ComeToTheOutlineOfTheLaws, 1'000, (const Seeds& seeds, bool preserves)) {
  World world = grown(preserves, seeds);
  world.commit();
  EXPECT_EQ(oracle::outlineOf(world), outlineByLaws(world, preserves));
}

LGS_LAW(Replace, IsClearingAndAddingAtOnce, 1'000, (const Seeds& seeds, bool preserves, Chance chance)) {
  World world = grown(preserves, seeds);
  world.commit();
  World other = world;
  const AnyEdit edit = editOf(Kind::replace, world, chance);
  const std::vector<std::byte> before = saved(world);
  const auto replaced = world.replace(edit.cell, edit.shape, edit.block);
  ASSERT_TRUE(other.clear(edit.cell));
  const auto added = other.add(edit.cell, edit.shape, edit.block);
  ASSERT_EQ(replaced.has_value(), added.has_value());
  if (!replaced) {
    EXPECT_EQ(replaced.error().code, added.error().code);
    EXPECT_EQ(replaced.error().cell, edit.cell);
    EXPECT_TRUE(saved(world) == before) << "the refusal changed the world";
    return;
  }
  EXPECT_EQ(*replaced, *added);
  EXPECT_EQ(polygonsIn(world, edit.cell), polygonsIn(other, edit.cell));
  EXPECT_EQ(copyOf(world.commit()), copyOf(other.commit()));
  EXPECT_TRUE(samePolygons(world, other));
  EXPECT_EQ(oracle::outlineOf(world), outlineByLaws(world, preserves));
}

LGS_LAW(SetBlock, ChangesTheBlockAlone, 1'000, (const Seeds& seeds, bool preserves, Chance chance)) {
  World world = grown(preserves, seeds);
  world.commit();
  const AnyEdit edit = editOf(Kind::setBlock, world, chance);
  const auto cell = world.cellOf(edit.polygon);
  const World untouched = world;
  if (!world.setBlock(edit.polygon, edit.block)) {
    EXPECT_FALSE(cell);
    return;
  }
  ASSERT_TRUE(cell);
  bool changed = false;
  std::vector<PolygonFields> expected = polygonsIn(untouched, *cell);
  for (PolygonFields& p : expected) {
    if (p.handle != edit.polygon) continue;
    changed = p.block != edit.block;
    p.block = edit.block;
  }
  EXPECT_EQ(polygonsIn(world, *cell), expected);
  EXPECT_EQ(samePolygons(world, untouched), !changed);
  EXPECT_EQ(samePolygons(untouched, world), !changed);
  const Changes& changes = world.commit();
  EXPECT_EQ(oracle::outlineOf(world), outlineByLaws(world, preserves));
  if (preserves) return;
  EXPECT_EQ(changes.removed.size(), changes.added.size());
  for (const SegmentId id : changes.removed) EXPECT_EQ(untouched.segment(id)->polygon, edit.polygon);
  for (const SegmentId id : changes.added) EXPECT_EQ(world.segment(id)->polygon, edit.polygon);
}

LGS_LAW(SamePolygons, DoNotDependOnHowTheyCame, 500, (const Seeds& seeds, bool preserves, Chance chance)) {
  const World world = grown(preserves, seeds);
  World other;
  std::vector<std::pair<Cell, PolygonFields>> all;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    all.push_back({cell, {p.handle, p.block, LocalPolygon(p.vertices.begin(), p.vertices.end())}});
  });
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
