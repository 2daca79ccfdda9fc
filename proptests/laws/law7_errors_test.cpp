// What an error says: code, fields, message; and that the first reason in the order of ErrorCode is the one reported.
#include "bad_edits.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace lgs::test {
namespace {

constexpr ErrorCode kLast = ErrorCode::anchored;

TEST(Errors, SayWhatAndWhere) {
  for (const BadEdit& edit : badEdits()) {
    SCOPED_TRACE(edit.name);
    Stage stage = makeStage();
    const Error error = edit.attempt(stage);
    EXPECT_EQ(error.segment, SegmentId{});
    EXPECT_EQ(error.index2, -1);
    EXPECT_EQ(message(error), edit.text);
  }
}

TEST(Errors, EveryCodeIsTried) {
  // These are of no edit in this world: segments_test.cpp, law12_rollback_test.cpp, questions_test.cpp,
  // unloaded_by_hand_test.cpp and addons/box2d/tests/falling_test.cpp try them.
  std::set<ErrorCode> tried{ErrorCode::unknownSegment, ErrorCode::unknownMark, ErrorCode::uncommitted,
                            ErrorCode::outOfReach,     ErrorCode::unloaded,    ErrorCode::anchored};
  Stage stage = makeStage();
  for (const BadEdit& edit : badEdits()) tried.insert(edit.attempt(stage).code);
  EXPECT_EQ(tried.size(), static_cast<std::size_t>(kLast));
}

TEST(Errors, EveryCodeHasAName) {
  std::set<std::string> names;
  for (int code = 1; code <= static_cast<int>(kLast); ++code) names.insert(name(static_cast<ErrorCode>(code)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kLast));
  EXPECT_FALSE(names.contains(name(ErrorCode{})));
  EXPECT_EQ(message(Error{}), "unknown error");
  EXPECT_STREQ(name(static_cast<ErrorCode>(static_cast<int>(kLast) + 1)), "unknown error")
      << "so that was not the last";
}

TEST(Errors, OfUnloadedGroundSayWhatIsThere) {
  const Cell cell{3, 4};
  std::set<std::string> texts;
  for (const Error& error : {Error{.code = ErrorCode::unloaded, .cell = cell},
                             Error{.code = ErrorCode::unloaded, .cell = cell, .other = PolygonHandle{1, 1}},
                             Error{.code = ErrorCode::unloaded, .cell = cell, .segment = {7}}}) {
    texts.insert(message(error));
    EXPECT_NE(message(error).find("(3, 4)"), std::string::npos) << message(error);
  }
  EXPECT_EQ(texts.size(), 3U);
}

TEST(Errors, PolygonsInACellAreLimited) {
  World world;
  const auto tile = [](std::size_t k) {
    const auto x = static_cast<std::int32_t>(2 * k);
    return LocalPolygon{{x, 0}, {x + 1, 0}, {x + 1, 1}};
  };
  std::vector<PolygonHandle> handles;
  for (std::size_t k = 0; k < kMaxPolygonsPerCell; ++k) handles.push_back(place(world, {}, tile(k)));
  const LocalPolygon more = tile(kMaxPolygonsPerCell);
  const auto refused = refusal(world.add({}, std::span<const LocalPoint>(more), 1));
  EXPECT_EQ(refused.code, ErrorCode::capacity);
  EXPECT_EQ(refused.cell, Cell{});
  EXPECT_TRUE(refused.hasCell());
  world.commit();
  EXPECT_EQ(world.stats().segments, 3 * kMaxPolygonsPerCell);
  ASSERT_TRUE(world.remove(handles[100]));
  place(world, {}, more);
}

TEST(Errors, VerticesInACellAreLimitedAllTogether) {
  World world;
  const auto comb = [](std::int32_t floor, std::size_t vertices) {
    LocalPolygon polygon;
    for (std::size_t k = 0; k + 1 < vertices; ++k) polygon.push_back({static_cast<std::int32_t>(k), floor});
    polygon.push_back({0, floor + 10});
    return polygon;
  };
  place(world, {}, comb(0, kMaxVerticesPerCell - 4));
  place(world, {}, comb(100, 3));
  const LocalPolygon three = comb(200, 3);
  const auto refused = refusal(world.add({}, std::span<const LocalPoint>(three), 1));
  EXPECT_EQ(refused.code, ErrorCode::capacity);
  EXPECT_EQ(world.polygons({}).size(), 2U);
  EXPECT_EQ(world.stats().polygons, 2U);
}

TEST(Errors, OverlapIsFoundBeforeAnythingElseInTheCellChanges) {
  World world;
  const std::vector<LocalPolygon> halves = shapeNamed("two halves");
  const ShapeId shape = shapeOf(world, halves);
  const PolygonHandle upper = place(world, {3, 3}, halves[1]);
  std::array<PolygonHandle, 2> handles{PolygonHandle{1, 2}, PolygonHandle{3, 4}};
  const auto refused = world.add({3, 3}, shape, 5, handles);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::overlap);
  EXPECT_EQ(refused.error().polygon, 1);
  EXPECT_EQ(refused.error().other, upper);
  EXPECT_EQ(refused.error().polygon2, -1);
  EXPECT_EQ(handles[0], (PolygonHandle{1, 2})) << "a refused edit writes no handles";
  EXPECT_EQ(world.polygons({3, 3}).size(), 1U);
}

}  // namespace
}  // namespace lgs::test
