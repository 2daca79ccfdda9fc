// The harness itself: the degenerate shapes and the naive rules, the generator, the shrinker, the window.
#include "oracle/calls/shapes.h"
#include "oracle/check/checker.h"
#include "oracle/check/shrink.h"
#include "oracle/check/window.h"
#include "oracle/generate/generator.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/mirror.h"
#include "oracle/trace/model.h"
#include "oracle/trace/player.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>

namespace lgs::oracle {
namespace {

using namespace std::chrono_literals;
using test::U;

TEST(Palette, ShapesAreGoodInEverySymmetry) {
  for (const NamedShape& shape : degenerateShapes()) {
    for (int symmetry = 0; symmetry < 8; ++symmetry) {
      for (const LocalPolygon& a : shape.polygons) {
        EXPECT_FALSE(faultOf(turned(a, symmetry))) << shape.name;
        for (const LocalPolygon& b : shape.polygons) {
          EXPECT_EQ(overlap(turned(a, symmetry), turned(b, symmetry)), &a == &b) << shape.name;
        }
      }
    }
  }
}

TEST(Validity, NamesTheFault) {
  EXPECT_EQ(faultOf({{0, 0}, {1, 0}}), ErrorCode::tooFewVertices);
  EXPECT_EQ(faultOf({{0, 0}, {U + 1, 0}, {1, 1}}), ErrorCode::outsideCell);
  EXPECT_EQ(faultOf({{0, 0}, {9, 0}, {9, 9}, {0, 0}}), ErrorCode::repeatedVertex);
  EXPECT_EQ(faultOf({{0, 0}, {1, 1}, {2, 2}}), ErrorCode::zeroArea);
  EXPECT_EQ(faultOf({{0, 0}, {0, 9}, {9, 9}}), ErrorCode::clockwise);
  EXPECT_EQ(faultOf({{0, 0}, {9, 0}, {5, 0}, {5, 5}}), ErrorCode::selfIntersecting);          // folds back
  EXPECT_EQ(faultOf({{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}), ErrorCode::selfIntersecting);  // touches itself
  EXPECT_EQ(faultOf({{0, 0}, {9, 0}, {9, 9}, {3, 1}, {1, 3}, {8, 2}}), ErrorCode::selfIntersecting);
  EXPECT_EQ(faultOf({{0, 0}, {4, 0}, {8, 0}, {8, 8}}), std::nullopt);  // a vertex in a straight run is fine
}

TEST(Window, KnowsTheCellOfASegment) {
  const auto cell = [](Point a, Point b) { return cellOf({a, b, 0, {}, {}}); };
  EXPECT_EQ(cell({0, 0}, {U, 0}), (Cell{0, 0}));   // the floor of a cell: solid above
  EXPECT_EQ(cell({U, 0}, {0, 0}), (Cell{0, -1}));  // the top of the cell below
  EXPECT_EQ(cell({0, U}, {0, 0}), (Cell{0, 0}));
  EXPECT_EQ(cell({0, 0}, {0, U}), (Cell{-1, 0}));
  EXPECT_EQ(cell({0, 0}, {U, U}), (Cell{0, 0}));
  EXPECT_EQ(cell({-U, -1}, {-U, 0}), (Cell{-2, -1}));
  EXPECT_EQ(cell({-5, -5}, {-3, -9}), (Cell{-1, -1}));
}

TEST(Window, HasTheCellsAroundAndWhatStandsThere) {
  const CellSet nine = around({{5, -5}});
  EXPECT_EQ(nine.size(), 9U);
  EXPECT_TRUE(nine.contains({4, -6}) && nine.contains({6, -4}) && nine.contains({5, -5}));
  EXPECT_EQ(around({{0, 0}, {1, 0}}).size(), 12U);

  Model model;
  for (const Cell cell : {Cell{4, -6}, Cell{5, -5}, Cell{7, -5}})
    model.apply(Call::add("a" + std::to_string(cell.i), {cell, 1, test::unitSquare()}));
  EXPECT_EQ(sceneOf(model.standing(), {}, nine).polygons.size(), 2U);
  EXPECT_EQ(sceneOf(model.standing(), CellRect{{5, -5}, {7, -5}}).polygons.size(), 2U);
}

TEST(Generator, MakesAsManyEditsAsAskedFor) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) EXPECT_EQ(editCount(randomCase({4, 4, 10}, seed)), 10U);
}

TEST(Generator, IsTheSameEverywhere) {
  std::string text;
  for (std::uint64_t seed = 0; seed < 50; ++seed) text += printTrace(randomCase({}, seed));
  EXPECT_NE(printTrace(randomCase({}, 0)), printTrace(randomCase({}, 1)));
  // On every compiler. If this fails and the generator was changed on purpose, put the new number.
  std::uint64_t hash = 14'695'981'039'346'656'037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1'099'511'628'211U;
  EXPECT_EQ(hash, 11'338'930'422'088'812'206U);
}

// Whether two polygons stand in the cell (x, ·) at the end: the kind of thing that a bug needs.
bool hasCrowdedCell(const Trace& trace) {
  Model model;
  for (const Call& edit : trace.calls) {
    if (!model.judge(edit).accepted) return false;
    model.apply(edit);
  }
  return std::any_of(model.standing().cells().begin(), model.standing().cells().end(),
                     [](const auto& entry) { return entry.second.size() >= 2; });
}

TEST(Shrink, LeavesWhatTheFailureNeeds) {
  int shrunk = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Trace trace = randomCase({3, 3, 60}, seed);
    if (!hasCrowdedCell(trace)) continue;
    ++shrunk;
    const Trace small = shrink(trace, hasCrowdedCell, 60s);
    ASSERT_TRUE(hasCrowdedCell(small));
    ASSERT_EQ(small.calls.size(), 2U) << printTrace(small);
    EXPECT_TRUE(small.preserve.empty());
    EXPECT_EQ(small.calls[0].name(), "p1");
    EXPECT_EQ(small.calls[1].name(), "p2");
    for (const Call& edit : small.calls) {
      EXPECT_EQ(edit.polygon().cell, (Cell{0, 0}));
      EXPECT_EQ(edit.polygon().block, 1U);
      EXPECT_EQ(edit.polygon().vertices.size(), 3U) << printTrace(small);
    }
  }
  EXPECT_GT(shrunk, 5);
}

TEST(Shrink, KeepsRemovalsThatMatter) {
  const auto removesTwo = [](const Trace& trace) {
    return std::count_if(trace.calls.begin(), trace.calls.end(),
                         [](const Call& edit) { return edit.kind == Call::Kind::remove; }) >= 2;
  };
  const Trace small = shrink(randomCase({2, 2, 200}, 7), removesTwo, 60s);
  EXPECT_EQ(small.calls.size(), 4U) << printTrace(small);
}

TEST(Shrink, CopesWithThousandsOfVertices) {
  LocalPolygon comb{{0, U}, {0, 0}};
  for (std::int32_t k = 1; k < 4'000; ++k) comb.push_back({7 * k, k % 2});
  const Trace trace{{}, {Call::add("comb", {{0, 0}, 1, comb})}};
  const auto hasFive = [](const Trace& t) { return !t.calls.empty() && t.calls[0].comes[0].shape[0].size() >= 5; };
  const Trace small = shrink(trace, hasFive, 60s);
  EXPECT_EQ(small.calls.at(0).comes[0].shape[0].size(), 5U);
}

TEST(Shrink, StopsWhenTimeIsUp) {
  const Trace trace = randomCase({}, 1);
  EXPECT_EQ(shrink(
                trace, [](const Trace&) { return true; }, 0ms),
            trace);
}

TEST(Checker, StopsAtBadEditsUnlessTold) {
  Trace trace;
  trace.calls = {Call::add("a", {{0, 0}, 1, {{0, 0}, {0, U}, {U, U}}}), Call::commit()};
  CheckStats stats;
  EXPECT_FALSE(checkTrace(trace, {}, stats));
  CheckOptions lenient;
  lenient.skipRefused = true;
  EXPECT_TRUE(checkTrace(trace, lenient, stats));
  EXPECT_EQ(stats.refused, 1U);
}

TEST(Mirror, ShowsTheSegmentThatABadListNames) {
  World world;
  ASSERT_TRUE(world.add({}, kUnitSquare, 1));
  const Changes good = world.commit();
  const SegmentId known = good.added[0], unknown{99};
  using Ids = std::vector<SegmentId>;
  const auto shown = [&](const Ids& removed, const Ids& added, const Ids& relinked) {
    Mirror mirror;
    EXPECT_TRUE(mirror.update(world, {removed, added, relinked, 0, 1}));
    return mirror.blamed();
  };
  const Outline one{outlineSegment(*world.segment(known))};
  EXPECT_EQ(shown({}, {known, known}, {}), one) << "twice";
  EXPECT_EQ(shown({known}, {}, {}), one) << "was not there";
  EXPECT_EQ(shown({}, {}, {known}), one) << "was not there";
  EXPECT_EQ(shown({}, {unknown}, {}), Outline()) << "nobody knows it";
}

}  // namespace
}  // namespace lgs::oracle
