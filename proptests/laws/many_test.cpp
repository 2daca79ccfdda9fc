// Calls that take many, and reading many segments at once, by hand.
#include "bad_edits.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <limits>

namespace lgs::test {
namespace {

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
  const auto refused = refusal(stage.world.segments(ids, all));
  EXPECT_EQ(refused.code, ErrorCode::unknownSegment);
  EXPECT_EQ(refused.segment, ids[2]);
  EXPECT_EQ(message(refused), "entry 2: segment 4711 is not alive; it was removed, or never existed");
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

TEST(ManyEdits, TellTheHandlesOfWhatComesIntoEmptyCells) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  const Placement placements[] = {{{0, 0}, square, 1}, {{40, 0}, square, 2}, {{1, 0}, square, 3}};
  std::vector<PolygonHandle> handles(2);
  ASSERT_TRUE(world.addMany(placements, handles));
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(handles[k], world.polygons(placements[k].cell)[0].handle);
}

TEST(ManyEdits, OfOneCellGoTogether) {
  Stage stage = makeStage();
  const Placement twice[] = {{{9, 9}, stage.square, 1}, {{9, 9}, stage.square, 2}};
  std::vector<PolygonHandle> handles(2);
  const auto refused = refusal(stage.world.addMany(twice, handles));
  EXPECT_EQ(refused.index, 1);
  EXPECT_EQ(refused.other, PolygonHandle{}) << "the next polygon of this cell gets that handle";
  EXPECT_EQ(
      message(refused),
      "entry 1, cell (9, 9), polygon 0: its interior overlaps that of a polygon of block 1 that entry 0 places in "
      "this cell");
  EXPECT_TRUE(stage.world.isEmpty({9, 9}));
  const PolygonHandle both[] = {stage.upper, stage.lower, stage.upper};
  const auto again = refusal(stage.world.removeMany(both));
  EXPECT_EQ(again.index, 2);
  EXPECT_EQ(message(again), "entry 2: the handle " + std::to_string(stage.upper.cellRef) + ":" +
                                std::to_string(stage.upper.serial) + " comes twice: entry 0 has it, too");
  EXPECT_TRUE(stage.world.removeMany(std::span(both).first(2)));
}

}  // namespace
}  // namespace lgs::test
