// Calls that take many are the single calls, one after the other, as a group: all happen or none.
#include "bad_edits.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"
#include "twins.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace lgs::test {
namespace {

/// What the single calls come to: the handles up to the first refusal, and that one. An entry is the group of single
/// calls that made, or removed, the other polygon of the error.
struct OneByOne {
  std::vector<PolygonHandle> handles;
  std::optional<Error> refusal;
};

void expectSameError(const Error& many, const OneByOne& singles) {
  Error error = *singles.refusal;
  error.index = static_cast<std::int32_t>(singles.handles.size());
  for (std::size_t k = 0; k < singles.handles.size(); ++k) {
    const PolygonHandle first = singles.handles[k];
    const bool placedIt = first.cellRef == error.other.cellRef && first.serial <= error.other.serial;
    if (error.code == ErrorCode::overlap ? placedIt : first == error.other) error.index2 = static_cast<std::int32_t>(k);
  }
  if (error.code == ErrorCode::overlap && error.index2 >= 0) error.other = {};  // a polygon that is undone
  EXPECT_EQ(message(many), message(error));
  EXPECT_EQ(many.code, error.code);
  EXPECT_EQ(many.other, error.other);
  EXPECT_EQ(many.otherBlock, error.otherBlock);
  EXPECT_EQ(many.index, error.index);
  EXPECT_EQ(many.index2, error.index2);
}

/// Random placements, as a rule good ones.
std::vector<Placement> placementsFor(const World& world, Chance& chance, std::size_t count) {
  std::vector<Placement> out;
  for (std::size_t k = 0; k < count; ++k) {
    const AnyEdit edit = randomEdit(world, chance);
    out.push_back({edit.cell, edit.shape, edit.block});
  }
  return out;
}

OneByOne addOneByOne(World& world, const std::vector<Placement>& placements) {
  OneByOne out;
  Transaction group = world.edit();
  for (const Placement& p : placements) {
    const auto handle = world.add(p.cell, p.shape, p.block);
    if (!handle) {
      out.refusal = handle.error();
      return out;
    }
    out.handles.push_back(*handle);
  }
  group.keep();
  return out;
}

LGS_LAW(Many, AddingIsAddingOneByOne, 1'000,
        (const Seeds& before, const Seeds& after, bool preserves, bool marked, Chance chance)) {
  World world = grown(preserves, before), other = grown(preserves, before);
  if (marked) (void)world.checkpoint();
  const auto placements = placementsFor(world, chance, chance.below(6U));
  const OneByOne singles = addOneByOne(other, placements);
  std::vector<PolygonHandle> handles(placements.size(), PolygonHandle{1, 1});
  const auto done = world.addMany(placements, handles);
  ASSERT_EQ(done.has_value(), !singles.refusal);
  if (done) {
    EXPECT_EQ(handles, singles.handles);
  } else {
    expectSameError(done.error(), singles);
    EXPECT_EQ(handles, std::vector<PolygonHandle>(placements.size())) << "a handle of an edit that was not made";
  }
  expectNoDifference(other, world, after);
}

LGS_LAW(Many, RemovingIsRemovingOneByOne, 1'000,
        (const Seeds& before, const Seeds& after, bool preserves, bool marked, Chance chance)) {
  World world = grown(preserves, before), other = grown(preserves, before);
  if (marked) (void)world.checkpoint();
  std::vector<PolygonHandle> polygons;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) {
    if (chance.chance(60)) polygons.push_back(p.handle);
  });
  chance.shuffle(polygons);
  if (!polygons.empty() && chance.chance(30)) polygons.push_back(chance.pick(polygons));  // twice
  OneByOne singles;
  {
    Transaction group = other.edit();
    for (const PolygonHandle polygon : polygons) {
      if (const auto done = other.remove(polygon); !done) {
        singles.refusal = done.error();
        break;
      }
      singles.handles.push_back(polygon);
    }
    if (!singles.refusal) group.keep();
  }
  const auto done = world.removeMany(polygons);
  ASSERT_EQ(done.has_value(), !singles.refusal);
  if (!done) expectSameError(done.error(), singles);
  expectNoDifference(other, world, after);
}

LGS_LAW(Many, SegmentsAreThoseOfSingleCalls, 300, (const Seeds& seeds, bool preserves, Chance chance)) {
  World world = grown(preserves, seeds);
  world.commit();
  std::vector<SegmentId> ids = world.segments();
  chance.shuffle(ids);
  std::vector<Segment> out(ids.size());
  std::vector<FloatSegment> floats(ids.size());
  std::vector<DoubleSegment> doubles(ids.size());
  const Point origin{30 * U + chance.below(U), -U};
  ASSERT_TRUE(world.segments(ids, out));
  ASSERT_TRUE(world.segments(ids, origin, std::span(floats)));
  ASSERT_TRUE(world.segments(ids, origin, std::span(doubles)));
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Segment one = *world.segment(ids[k]);
    EXPECT_EQ(fieldsOf(out[k]), fieldsOf(one));
    const DoubleSegment& d = doubles[k];
    const FloatSegment& f = floats[k];
    const auto back = [&](DoublePoint p) {  // exact, and so there is a way back
      return Point{static_cast<std::int64_t>(p.x * U) + origin.x, static_cast<std::int64_t>(p.y * U) + origin.y};
    };
    EXPECT_EQ(fieldsOf({d.id, back(d.start), back(d.end), d.predecessor, d.successor, back(d.ghost1), back(d.ghost2),
                        d.block, d.polygon, d.cell}),
              fieldsOf(one));
    const auto rounded = [](FloatPoint near, DoublePoint exact) {
      return near.x == static_cast<float>(exact.x) && near.y == static_cast<float>(exact.y);
    };
    EXPECT_TRUE(rounded(f.start, d.start) && rounded(f.end, d.end) && rounded(f.ghost1, d.ghost1) &&
                rounded(f.ghost2, d.ghost2));
    EXPECT_TRUE(f.id == d.id && f.predecessor == d.predecessor && f.successor == d.successor && f.block == d.block &&
                f.polygon == d.polygon && f.cell == d.cell);
  }
}

TEST(ManySegments, FillAsMuchAsThereIsRoomForAndNameTheUnknownOne) {
  Stage stage = makeStage();
  std::vector<SegmentId> ids = stage.world.segments();
  ASSERT_GT(ids.size(), 3U);
  std::vector<Segment> two(2);
  ASSERT_TRUE(stage.world.segments(ids, two));
  EXPECT_EQ(two[1].id, ids[1]);
  ids[2] = {4711};
  ASSERT_TRUE(stage.world.segments(ids, two)) << "there is no room for the unknown one";
  std::vector<Segment> all(ids.size());
  const auto refused = stage.world.segments(ids, all);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unknownSegment);
  EXPECT_EQ(refused.error().segment, ids[2]);
  EXPECT_EQ(message(refused.error()), "entry 2: segment 4711 is not alive; it was removed, or never existed");
  EXPECT_EQ(all[1].id, ids[1]);
  std::vector<DoubleSegment> reals(ids.size());
  EXPECT_EQ(stage.world.segments(ids, {kMaxCoordinate + 1, 0}, std::span(reals)).error().code, ErrorCode::outOfReach);
  EXPECT_EQ(stage.world.segments(ids, {kMaxCoordinate, 0}, std::span(reals)).error().index, 2);
}

TEST(ManySegments, AreAsExactFarOutAsNearBy) {
  World world;
  const Cell cell{kMaxCell - 1, -kMaxCell};
  place(world, cell, ramp());
  const std::vector<SegmentId> ids = world.commit().added;
  std::vector<FloatSegment> out(ids.size());
  ASSERT_TRUE(world.segments(ids, toWorld(cell, {U / 2, 0}), std::span(out)));
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Point start = world.segment(ids[k])->start, corner = toWorld(cell, {0, 0});
    EXPECT_EQ(out[k].start.x, start.x == corner.x ? -0.5F : 0.5F);
    EXPECT_EQ(out[k].start.y, start.y == corner.y ? 0.0F : 1.0F);
  }
}

TEST(ManyEdits, HaveAnIndexThatFits) {
  static_assert(kMaxEntries == std::numeric_limits<decltype(Error::index)>::max());
  constexpr std::size_t kTooMany = kMaxEntries + 1;
  World world;
  const Placement placement;
  const PolygonHandle handle;
  PolygonHandle kept{1, 1};
  const auto added = world.addMany({&placement, kTooMany}, {&kept, 1}), removed = world.removeMany({&handle, kTooMany});
  ASSERT_TRUE(!added && !removed);
  EXPECT_EQ(kept, (PolygonHandle{1, 1})) << "no entry was looked at";
  const SegmentId id{4711};
  Segment segment;
  DoubleSegment real;
  const auto read = world.segments({&id, kTooMany}, {&segment, kTooMany});
  const auto realRead = world.segments({&id, kTooMany}, {}, std::span(&real, kTooMany));
  ASSERT_TRUE(!read && !realRead);
  for (const Error& error : {added.error(), removed.error(), read.error(), realRead.error()}) {
    EXPECT_EQ(error.code, ErrorCode::capacity);
    EXPECT_EQ(error.index, -1);
  }
}

TEST(ManyEdits, OfOneCellGoTogether) {
  Stage stage = makeStage();
  const Placement twice[] = {{{9, 9}, stage.square, 1}, {{9, 9}, stage.square, 2}};
  std::vector<PolygonHandle> handles(2);
  const auto refused = stage.world.addMany(twice, handles);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().index, 1);
  EXPECT_EQ(refused.error().other, PolygonHandle{}) << "the next polygon of this cell gets that handle";
  EXPECT_EQ(
      message(refused.error()),
      "entry 1, cell (9, 9), polygon 0: its interior overlaps that of a polygon of block 1 that entry 0 places in "
      "this cell");
  EXPECT_TRUE(stage.world.isEmpty({9, 9}));
  const PolygonHandle both[] = {stage.upper, stage.lower, stage.upper};
  const auto again = stage.world.removeMany(both);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().index, 2);
  EXPECT_EQ(message(again.error()), "entry 2: the handle " + std::to_string(stage.upper.cellRef) + ":" +
                                        std::to_string(stage.upper.serial) + " comes twice: entry 0 has it, too");
  EXPECT_TRUE(stage.world.removeMany(std::span(both).first(2)));
}

TEST(ManyEdits, NameTheEntryThatPlacedTheOtherPolygon) {
  Stage stage = makeStage();
  const LocalPolygon sliver = eighths({{0, 0}, {1, 0}, {1, 1}});
  const ShapeId small = shapeOf(stage.world, {sliver});
  const Cell cell{9, 9}, other{10, 9};
  const PolygonHandle old = place(stage.world, cell, sliver, 5);
  const LocalPolygon rest = eighths({{1, 0}, {8, 0}, {8, 8}});
  const ShapeId two = shapeOf(stage.world, {rest, eighths({{0, 1}, {7, 8}, {0, 8}})});
  const auto refusal = [&](ShapeId last) {
    const Placement entries[] = {{other, stage.twoRamps, 1}, {cell, two, 2}, {other, small, 3}, {cell, last, 4}};
    return stage.world.addMany(std::span(entries).subspan(1)).error();
  };
  const Error ofNew = refusal(shapeOf(stage.world, {eighths({{0, 6}, {1, 7}, {0, 8}})}));
  EXPECT_EQ(ofNew.index2, 0) << "its second polygon";
  EXPECT_EQ(ofNew.otherBlock, 2U);
  EXPECT_EQ(ofNew.other, PolygonHandle{});
  const Error ofOld = refusal(small);
  EXPECT_EQ(ofOld.index2, -1);
  EXPECT_EQ(ofOld.other, old);
}

}  // namespace
}  // namespace lgs::test
