// What reads a world agrees with a right one, and complains, each time in other words, where the world is not what the
// model or the mirror says.
#include "checking.h"
#include "oracle/check/reads.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/mirror.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>

namespace lgs::oracle::reading {
namespace {

using test::U;
using Segments = std::vector<Segment>;

std::string textOf(const std::optional<WrongRead>& wrong) { return wrong ? wrong->text : ""; }

// Two squares that touch in a corner, one that went, a floor in two pieces, and a small polygon far away.
class CheckReads : public testing::Test {
 protected:
  CheckReads() {
    for (const Call& edit : {square("gone", {9, 9}), square("a", {0, 0}), square("b", {1, 1}), square("c", {-1, 0}, 2),
                             Call::add("far", {{-3, 5}, 1, test::eighths({{0, 0}, {4, 0}, {0, 4}})})}) {
      EXPECT_TRUE(player_.apply(edit));
    }
    commit();
    EXPECT_TRUE(player_.apply(Call::remove("gone")));
    commit();
  }

  void start() {
    player_ = Player(PreservePairs());
    mirror_ = {};
  }

  void commit() {
    const Changes& changes = player_.commit();
    EXPECT_EQ(mirror_.update(world(), changes), std::nullopt);
    segments_.assign(mirror_.segments().begin(), mirror_.segments().end());
  }

  const World& world() const { return player_.world(); }
  Segment& segment(Point start, Point end) {
    return *std::ranges::find_if(segments_, [&](const Segment& s) { return s.id && s.start == start && s.end == end; });
  }

  Player player_{PreservePairs()};
  Mirror mirror_;
  Segments segments_;  // as the mirror has them
};

TEST_F(CheckReads, AgreesWithARightWorld) {
  EXPECT_EQ(textOf(readPolygons(player_)), "");
  EXPECT_EQ(textOf(readSegments(world(), segments_)), "");
  EXPECT_EQ(textOf(readLoops(world(), segments_)), "");
  const World nothing;
  EXPECT_EQ(textOf(readSegments(nothing, Segments(1))), "");
  EXPECT_EQ(textOf(readLoops(nothing, Segments(1))), "");
}

// Where a loop visits its first vertex twice, it begins with another visit once collinear vertices are gone.
TEST_F(CheckReads, AgreesWithALoopThatVisitsItsFirstVertexTwice) {
  start();
  EXPECT_TRUE(player_.apply(Call::add("a", {{0, 0}, 1, test::eighths({{0, 0}, {1, 0}, {8, 0}, {8, 8}})})));
  EXPECT_TRUE(player_.apply(Call::add("b", {{0, -1}, 1, test::eighths({{0, 8}, {4, 0}, {8, 4}})})));
  commit();
  ASSERT_EQ(world().loops(Collinear::keep).size(), 1U);
  EXPECT_EQ(textOf(readLoops(world(), segments_)), "");
}

TEST_F(CheckReads, SeesOtherPolygonsInACell) {
  const auto readWith = [&](const Call& edit, PolygonHandle handle) {
    Standing standing;
    standing.add(edit.name(), edit.polygon(), handle);
    return textOf(readCell(world(), standing, {0, 0}));
  };
  const PolygonHandle a = player_.handleOf("a");
  EXPECT_EQ(readWith(square("a", {0, 0}), a), "");
  EXPECT_EQ(readWith(square("a", {5, 0}), a), "cell (0, 0) has 1 polygons, but should have 0");
  EXPECT_EQ(readWith(square("a", {0, 0}, 2), a), "cell (0, 0) does not hold 'a' as it was placed");
  EXPECT_EQ(readWith(Call::add("a", {{0, 0}, 1, test::ramp()}), a), "cell (0, 0) does not hold 'a' as it was placed");
  EXPECT_EQ(readWith(square("a", {0, 0}), player_.handleOf("b")), "cell (0, 0) does not hold 'a' as it was placed");
}

TEST_F(CheckReads, SeesWhatStandsBesideTheModel) {
  ASSERT_TRUE(player_.world().add({7, 7}, kUnitSquare, 1));
  EXPECT_EQ(textOf(readPolygons(player_)), "stats() counts 5 polygons, but there should be 4");
}

TEST_F(CheckReads, SeesAPolygonTooFewInACell) {
  ASSERT_TRUE(player_.apply(Call::add("d", {{-3, 5}, 1, test::eighths({{8, 8}, {4, 8}, {8, 4}})})));
  ASSERT_TRUE(player_.world().remove(player_.handleOf("d")));
  ASSERT_TRUE(player_.world().add({7, 7}, kUnitSquare, 1));
  EXPECT_EQ(textOf(readPolygons(player_)), "cell (-3, 5) has 1 polygons, but should have 2");
}

TEST_F(CheckReads, SeesAChunkTooMany) {
  const auto stray = player_.world().add({99, 99}, kUnitSquare, 1);
  ASSERT_TRUE(stray && player_.world().remove(*stray));
  EXPECT_EQ(textOf(readPolygons(player_)), "stats() counts 3 chunks, but there should be 2");
}

TEST_F(CheckReads, SeesAShapeTooMany) {
  const std::size_t shapes = player_.shapes();
  ASSERT_TRUE(player_.world().shape(test::eighths({{1, 1}, {2, 1}, {2, 3}})));
  EXPECT_EQ(textOf(readPolygons(player_)),
            fmt::format("stats() counts {} shapes, but there should be {}", shapes + 1, shapes));
}

TEST_F(CheckReads, SeesAnIdTooManyOrTooFew) {
  const std::size_t most = segments_.size() - 1;
  Segments longer = segments_, other = segments_;
  longer.emplace_back();
  EXPECT_EQ(textOf(readSegments(world(), longer)),
            fmt::format("the highest id is said to be {}, but {} was", most, most + 1));
  Segment& known = segment({0, 0}, {U, 0});
  other[known.id.value].id = {};
  EXPECT_EQ(textOf(readSegments(world(), other)),
            fmt::format("id {} names no segment, but can be read", known.id.value));

  const auto dead = std::find_if(segments_.begin() + 1, segments_.end(), [](const Segment& s) { return !s.id; });
  ASSERT_NE(dead, segments_.end());
  const auto alive = world().stats().segments;
  dead->id = {static_cast<std::uint32_t>(dead - segments_.begin())};
  EXPECT_EQ(textOf(readSegments(world(), segments_)),
            fmt::format("stats() counts {} segments, but there should be {}", alive, alive + 1));
}

// Chunks that have nothing are asked for, too. Of so many segments in one cell no others are chosen by chance.
TEST_F(CheckReads, SeesASegmentInAnotherCell) {
  start();
  LocalPolygon comb{{0, U}, {0, 0}};
  for (std::int32_t k = 1; k < 200; ++k) comb.push_back({7 * k, k % 2});
  EXPECT_TRUE(player_.apply(Call::add("comb", {{0, 0}, 1, comb})));
  EXPECT_TRUE(player_.apply(Call::add("far", {{-3, 5}, 1, test::eighths({{0, 0}, {4, 0}, {0, 4}})})));
  commit();
  Segment& moved = segment({-3 * U, 5 * U + U / 2}, {-3 * U, 5 * U});
  moved.cell.j += 45;
  const auto wrong = readSegments(world(), segments_);
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->text, "204 segments in cells (-40, 0) to (0, 40), but there should be 203, or others");
  EXPECT_EQ(wrong->about, Outline{outlineSegment(moved)});
}

// Cells that are chosen by chance: of the rectangles that are always asked for none has this one.
TEST_F(CheckReads, SeesThatACellHasNothing) {
  for (Segment& s : segments_)
    if (s.id && s.cell == Cell{1, 1}) s.cell = {-50, -50};
  EXPECT_TRUE(readSegments(world(), segments_));
}

// A cell with few segments between two with many: a rectangle from one of these to the other holds it.
TEST_F(CheckReads, SeesThatACellBetweenOthersHasNothing) {
  start();
  LocalPolygon comb{{0, U}, {0, 0}};
  for (std::int32_t k = 1; k < 200; ++k) comb.push_back({7 * k, k % 2});
  for (const auto& [name, cell] : {std::pair{"left", Cell{0, 0}}, {"right", Cell{9, 0}}})
    EXPECT_TRUE(player_.apply(Call::add(name, {cell, 1, comb})));
  EXPECT_TRUE(player_.apply(square("middle", {5, 0})));
  commit();
  for (Segment& s : segments_)
    if (s.id && s.cell == Cell{5, 0}) s.cell = {5, 500};
  EXPECT_EQ(textOf(readSegments(world(), segments_)),
            "406 segments in cells (0, 0) to (9, 0), but there should be 402, or others");
}

TEST_F(CheckReads, SeesOtherLoops) {
  Segments broken = segments_;
  for (Segment& s : broken) s.successor = {};
  const std::size_t loops = world().loops(Collinear::keep).size();
  EXPECT_EQ(textOf(readLoops(world(), broken)),
            fmt::format("{} loops, {} where collinear segments are merged; there should be 0", loops, loops));
  Segment& moved = segment({0, 0}, {U, 0});
  moved.start.x = 1;
  const auto wrong = readLoops(world(), segments_);
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->text, "loop 1 has other vertices, or other segments");
  EXPECT_EQ(wrong->about.size(), 10U) << "all segments of that loop, and no others";
  EXPECT_NE(std::ranges::find(wrong->about, outlineSegment(moved)), wrong->about.end());
}

}  // namespace
}  // namespace lgs::oracle::reading
