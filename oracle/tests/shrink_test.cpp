// The steps by which a trace is made smaller: which candidates there are, and in which order.
#include "oracle/check/shrink.h"
#include "oracle/check/simpler.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace lgs::oracle::shrinking {
namespace {

using namespace std::chrono_literals;
using test::U;

Call square(const std::string& name, Cell cell, Block block = 1) {
  return Call::add(name, {cell, block, test::unitSquare()});
}

Call painting(std::vector<std::vector<Point>> rings, Block block = 1) {
  return Call::byBrush({BrushEdit::Deed::fill, block, std::move(rings)});
}

/// All candidates of a walk that accepts none.
std::vector<Trace> candidatesOf(const Trace& trace) {
  ShrinkWalk walk(trace);
  std::vector<Trace> candidates;
  while (auto candidate = walk.next()) candidates.push_back(std::move(*candidate));
  return candidates;
}

bool has(const std::vector<Trace>& candidates, const Trace& trace) {
  return std::ranges::find(candidates, trace) != candidates.end();
}

// --- Traces -----------------------------------------------------------------------------------------------------------

TEST(ShrinkWalk, BeginsWithPlainNames) {
  const Trace trace{{}, {square("a", {0, 0}), Call::commit(), Call::remove("a")}};
  ShrinkWalk walk(trace);
  EXPECT_EQ(walk.next(), Trace()) << "what stands at the end";
  EXPECT_EQ(walk.next(), (Trace{{}, {square("p1", {0, 0}), Call::commit(), Call::remove("p1")}}));
  EXPECT_EQ(walk.best(), trace);
}

TEST(ShrinkWalk, BuildsAtOnceWhatStandsAtTheEnd) {
  const Call mark = Call::of(Call::Kind::mark);
  const Trace trace{{},
                    {square("a", {0, 0}), Call::commit(), square("b", {1, 0}), Call::remove("a"), mark,
                     square("a", {2, 0}), Call::commit(), Call::remove("other")}};
  EXPECT_EQ(ShrinkWalk(trace).next(), (Trace{{}, {square("p2", {1, 0}), mark, square("p3", {2, 0})}}));
}

TEST(ShrinkWalk, DropsHalfOfTheEditsAndThenTheOtherHalf) {
  const std::vector<Call> edits{square("p1", {0, 0}), square("p2", {1, 0}), square("p3", {2, 0}), square("p4", {3, 0})};
  const Trace half{{}, {edits[0], edits[1]}};
  ShrinkWalk walk({{}, edits});
  EXPECT_EQ(walk.next(), half);
  walk.accept(half);
  EXPECT_EQ(walk.next(), Trace());
  EXPECT_EQ(walk.next(), (Trace{{}, {edits[0]}}));
}

TEST(ShrinkWalk, TakesARemovalAwayWithItsPolygon) {
  const auto candidates = candidatesOf({{}, {square("p1", {0, 0}), Call::remove("p1"), square("p2", {1, 0})}});
  EXPECT_TRUE(has(candidates, {{}, {square("p2", {1, 0})}}));
  EXPECT_FALSE(has(candidates, {{}, {Call::remove("p1"), square("p2", {1, 0})}}));
}

TEST(ShrinkWalk, MakesCallsSimpler) {
  Call group = Call::of(Call::Kind::group), place = square("p1", {0, 0});
  place.kind = Call::Kind::addShape;
  place.room = 2;
  group.group = {place, Call::remove("p1")};
  const auto places = [](const Trace& trace) {
    const auto isPlaced = [](const Call& call) { return call.kind != Call::Kind::remove && !call.comes.empty(); };
    return std::ranges::any_of(
        trace.calls, [&](const Call& call) { return isPlaced(call) || std::ranges::any_of(call.group, isPlaced); });
  };
  const Trace small =
      shrink({{}, {Call::of(Call::Kind::mark), group, Call::of(Call::Kind::rollBack)}, true}, places, 60s);
  EXPECT_EQ(printTrace(small), "lgs-trace 1\nadd p1 0 0 1  0 0 1 0 0 1\n");
}

TEST(ShrinkWalk, DropsTheLastOfSeveralEditsByItself) {
  const auto hasThree = [](const Trace& trace) {
    std::set<std::int32_t> rows;
    for (const Call& edit : trace.calls) rows.insert(edit.polygon().cell.j);
    return rows.contains(1) && rows.contains(2) && rows.contains(3);
  };
  const Trace small =
      shrink({{}, {square("a", {0, 1}), square("b", {0, 2}), square("c", {0, 3}), square("d", {0, 4})}}, hasThree, 60s);
  EXPECT_EQ(small.calls.size(), 3U);
}

TEST(ShrinkWalk, NumbersBlocksInTheOrderOfTheirUse) {
  Trace trace{{}, {square("p1", {0, 0}, 9), square("p2", {1, 0}, 7), painting({{{0, 0}, {U, 0}, {0, U}}}, 8)}};
  trace.preserve.add(7, 9);
  trace.preserve.add(8, 20);
  Trace numbered{{}, {square("p1", {0, 0}, 1), square("p2", {1, 0}, 2), painting({{{0, 0}, {U, 0}, {0, U}}}, 3)}};
  numbered.preserve.add(1, 2);
  numbered.preserve.add(3, 4);
  EXPECT_TRUE(has(candidatesOf(trace), numbered));
}

TEST(ShrinkWalk, DropsOnePairAfterTheOther) {
  Trace trace{{}, {square("p1", {0, 0})}};
  for (const auto& [a, b] : {std::pair{1U, 2U}, {1U, 3U}, {2U, 3U}}) trace.preserve.add(a, b);
  std::size_t without = 0;
  for (const Trace& candidate : candidatesOf(trace))
    if (candidate.calls == trace.calls && candidate.preserve.pairs().size() == 2) ++without;
  EXPECT_EQ(without, 3U);
}

TEST(ShrinkWalk, MakesEachBlockOneByItself) {
  const auto hasTwo = [](const Trace& trace) {
    return trace.calls.size() == 5 && trace.calls[1].kind == Call::Kind::commit;
  };
  const Trace small = shrink(
      {{},
       {square("p1", {0, 0}, 1), Call::commit(), square("p2", {1, 0}, 2), Call::remove("p1"), square("p3", {0, 0}, 3)}},
      hasTwo, 60s);
  ASSERT_EQ(small.calls.size(), 5U);
  for (const std::size_t k : {0U, 2U, 4U}) EXPECT_EQ(small.calls[k].comes[0].block, 1U);
}

TEST(ShrinkWalk, MovesLinesOfCellsTogetherAndToTheOrigin) {
  const auto candidates = candidatesOf({{}, {square("p1", {5, 7}), square("p2", {9, 7})}});
  const auto with = [](Cell a, Cell b) { return Trace{{}, {square("p1", a), square("p2", b)}}; };
  for (const auto& [a, b] : {std::pair<Cell, Cell>{{5, 7}, {6, 7}},
                             {{0, 7}, {4, 7}},
                             {{-1, 7}, {3, 7}},
                             {{5, 0}, {9, 0}},
                             {{5, -1}, {9, -1}}})
    EXPECT_TRUE(has(candidates, with(a, b))) << a.i << ", " << a.j;
}

TEST(ShrinkWalk, EndsWhereNothingIsAccepted) {
  EXPECT_EQ(candidatesOf({}).size(), 0U);
  EXPECT_EQ(candidatesOf({{}, {Call::commit()}}), std::vector<Trace>(2));
}

// --- Polygons and regions ----------------------------------------------------------------------------------------

TEST(ShrinkPolygon, TriesTheSquareAndItsHalvesWhereTheyAreSimpler) {
  const LocalPolygon odd{{0, 0}, {U, 1}, {U, U}, {1, U}};
  const std::vector<LocalPolygon> plain{{{0, 0}, {U, 0}, {U, U}, {0, U}},
                                        {{0, 0}, {U, 0}, {U, U}},
                                        {{0, 0}, {U, 0}, {0, U}},
                                        {{0, 0}, {U, U}, {0, U}},
                                        {{U, 0}, {U, U}, {0, U}}};
  for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_EQ(simplerPolygon(odd, k), plain[k]) << k;
  EXPECT_EQ(simplerPolygon(plain[1], 0), std::nullopt);
  EXPECT_EQ(simplerPolygon(plain[1], 2), plain[2]) << "one zero more";
  EXPECT_EQ(simplerPolygon(plain[2], 1), std::nullopt);
  EXPECT_EQ(simplerPolygon({{0, 0}, {U, 0}, {U, 3}}, 1), plain[1]);
  EXPECT_EQ(simplerPolygon({{0, 0}, {U / 2, 0}, {0, U / 2}}, 4), std::nullopt) << "a half counts as two wholes";
  EXPECT_EQ(simplerPolygon({{0, 0}, {U / 2, 0}, {0, U / 4}}, 4), plain[4]);
}

/// The polygons with one coordinate changed that are simpler than this one.
std::set<LocalPolygon> rounded(const LocalPolygon& polygon) {
  std::set<LocalPolygon> all;
  for (std::size_t k = 5; k < variantsOf(polygon); ++k)
    if (const auto simple = simplerPolygon(polygon, k); simple && simple->size() == polygon.size()) all.insert(*simple);
  return all;
}

TEST(ShrinkPolygon, RoundsEachCoordinateDownAndUp) {
  const std::set<LocalPolygon> expected{{{0, 0}, {U, 0}, {U, U}},
                                        {{0, 0}, {U, 0}, {U / 2, U}},
                                        {{0, 0}, {U, 0}, {3 * U / 4, U}},
                                        {{0, 0}, {U, 0}, {0, U}},
                                        {{0, 0}, {U, 0}, {5 * U / 8 + 0, U}}};
  std::set<LocalPolygon> found = rounded({{0, 0}, {U, 0}, {11 * U / 16, U}});
  EXPECT_EQ(found, expected);
  const LocalPolygon upright{{0, 0}, {U, 11 * U / 16}, {0, U}};
  for (const LocalPolygon& simple : rounded(upright)) EXPECT_EQ(simple[1].x, U);
  EXPECT_EQ(rounded(upright).size(), 5U);
}

TEST(ShrinkBrush, DropsRingsAndVerticesAndRoundsCoordinates) {
  const std::vector<Point> ring{{-3, 0}, {8 * U, 5}, {0, 9 * U}, {-8, U}}, other{{0, 0}, {U, 0}, {0, U}};
  const BrushEdit two{BrushEdit::Deed::carve, 0, {ring, other}}, one{BrushEdit::Deed::carve, 0, {ring}};
  EXPECT_EQ(simplerBrush(two, 0), (BrushEdit{BrushEdit::Deed::carve, 0, {other}}));
  EXPECT_EQ(simplerBrush(two, 1), one);
  EXPECT_EQ(simplerBrush(one, 0), std::nullopt);
  ASSERT_LT(variantsOf(one), 1'000U);
  std::set<std::vector<Point>> rings;
  for (std::size_t k = 0; k < variantsOf(one); ++k)
    if (const auto simple = simplerBrush(one, k)) rings.insert(simple->rings.at(0));
  for (std::size_t k = 0; k < ring.size(); ++k) {
    std::vector<Point> without = ring;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_TRUE(rings.contains(without)) << k;
  }
  const auto with = [&](std::size_t vertex, Point p) {
    std::vector<Point> changed = ring;
    changed[vertex] = p;
    return changed;
  };
  for (const Point p : {Point{-U, 0}, Point{0, 0}, Point{-4, 0}, Point{-2, 0}}) EXPECT_TRUE(rings.contains(with(0, p)));
  for (const std::int64_t y : {0, U, 4, 6, 8}) EXPECT_TRUE(rings.contains(with(1, {8 * U, y}))) << y;
  EXPECT_FALSE(rings.contains(ring));
  EXPECT_FALSE(rings.contains(with(3, {-9, U}))) << "it is not rounder";
}

// An engine without slants refuses all others.
TEST(ShrinkBrush, KeepsEdgesAlongTheAxes) {
  const auto failsStill = [](const Trace& trace) {
    const auto isAlongAnAxis = [](Point a, Point b) { return a.x == b.x || a.y == b.y; };
    std::int64_t area2 = 0;
    for (const Call& call : trace.calls)
      for (const auto& ring : call.brush.rings)
        for (std::size_t k = 0; k < ring.size(); ++k) {
          const Point a = ring[k], b = ring[(k + 1) % ring.size()];
          if (!isAlongAnAxis(a, b)) return false;
          area2 += a.x * b.y - b.x * a.y;
        }
    return area2 != 0;
  };
  const std::int64_t x = 3 * U, y = 2 * U + 9, right = 7 * U + 1, top = 5 * U - 7;
  const std::vector<Point> notched{{5, 3}, {right, 3}, {right, y}, {x, y}, {x, top}, {5, top}};
  const std::vector<Point> flat{{5, 3}, {5, 3}, {99, 3}};
  const Trace small = shrink({{}, {painting({flat, notched})}}, failsStill, 10s);
  ASSERT_EQ(small.calls.size(), 1U);
  ASSERT_EQ(small.calls[0].brush.rings.size(), 1U);
  const std::vector<Point>& ring = small.calls[0].brush.rings[0];
  EXPECT_EQ(ring.size(), 4U);
  for (const Point p : ring) EXPECT_TRUE(p.x % U == 0 && p.y % U == 0) << p.x << ", " << p.y;
}

TEST(ShrinkPolygon, KeepsEdgesAlongTheAxes) {
  std::set<LocalPolygon> found;
  const LocalPolygon flat{{0, 5}, {U, 5}, {U, U}, {0, U}};
  for (std::size_t k = 0; k < variantsOf(flat); ++k)
    if (const auto simple = simplerPolygon(flat, k)) found.insert(*simple);
  EXPECT_TRUE(found.contains({{0, U / 2}, {U, U / 2}, {U, U}, {0, U}}));
}

}  // namespace
}  // namespace lgs::oracle::shrinking
