// The worlds that are made for what an engine can do, and what is compared.
#include "oracle/engine/capabilities.h"
#include "oracle/check/comparable.h"
#include "oracle/check/failure.h"
#include "oracle/check/library_engine.h"
#include "oracle/generate/generator.h"
#include "oracle/reference/naive.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

constexpr std::int32_t U = kUnitsPerCell;

Capabilities canDo(const std::string& words) { return parseCapabilities(words).value(); }

TEST(Capabilities, AreReadAsTheyArePrinted) {
  for (const std::string words : {"", "ghosts blocks several slants preserve refuses", "squares merged",
                                  "ghosts islands", "lattice=8 cells=100", "cells=0", "lattice=1"})
    EXPECT_EQ(print(canDo(words)), words);
  EXPECT_EQ(canDo("ghosts blocks several slants preserve refuses"), Capabilities::all());
  for (const std::string bad : {"ghost", "lattice", "lattice=", "lattice=0", "lattice=3", "lattice=131072",
                                "lattice=-2", "lattice=8x", "cells=-1", "cells=1073741825", "cells=", "Ghosts"})
    EXPECT_FALSE(parseCapabilities(bad)) << bad;
}

TEST(Capabilities, SayWhyAPolygonIsNotFit) {
  const ScenePolygon square{{3, -3}, 1, {{0, 0}, {U, 0}, {U, U}, {0, U}}},
      half{{}, 1, {{0, 0}, {U, 0}, {U, U / 2}, {0, U / 2}}}, ramp{{}, 1, {{0, 0}, {U, 0}, {U, U}}};
  EXPECT_EQ(whyNot(square, canDo("squares lattice=1 cells=3")), "");
  EXPECT_EQ(whyNot(square, canDo("cells=2")), "its cell is beyond ±2");
  EXPECT_EQ(whyNot(half, canDo("squares")), "it is no whole square");
  EXPECT_EQ(whyNot(half, canDo("lattice=2")), "");
  EXPECT_EQ(whyNot(half, canDo("lattice=1")), "it is not on 1/1 of a cell");
  EXPECT_EQ(whyNot(ramp, canDo("")), "it has a slanted edge");
  EXPECT_EQ(whyNot(ramp, canDo("slants lattice=1")), "");
}

TEST(Capabilities, OnlyFitWorldsAreMade) {
  for (const std::string words :
       {"", "several", "slants", "squares", "squares refuses", "preserve", "several slants refuses", "lattice=1",
        "slants lattice=1", "several slants lattice=8 cells=40", "cells=0", "cells=2 refuses"}) {
    const Capabilities can = canDo(words);
    std::size_t edits = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Trace trace = caseOf(seed, {4, 4, 60, can, false}, seed);
      EXPECT_EQ(whyNot(trace, can), "") << words;
      edits += editCount(trace);
      EXPECT_EQ(whyNot(digIn(withoutRefused(trace), 20, seed, can), can), "") << words;
    }
    EXPECT_EQ(edits, 60U * 60U) << words;
  }
}

// Without the capability nothing of it is made; with it, it is.
TEST(Capabilities, AreUsedWhereTheyAreThere) {
  const auto isMadeWith = [](const std::string& words, const std::string& without) {
    for (std::uint64_t seed = 0; seed < 60; ++seed)
      if (!whyNot(caseOf(seed, {4, 4, 60, canDo(words), false}, seed), canDo(without)).empty()) return true;
    return false;
  };
  EXPECT_TRUE(isMadeWith("several", ""));
  EXPECT_TRUE(isMadeWith("slants", ""));
  EXPECT_TRUE(isMadeWith("preserve", ""));
  EXPECT_TRUE(isMadeWith("refuses", ""));
  EXPECT_TRUE(isMadeWith("refuses squares", "squares"));
  EXPECT_TRUE(isMadeWith("", "lattice=8"));
  EXPECT_TRUE(isMadeWith("lattice=8", "lattice=4"));
  EXPECT_TRUE(isMadeWith("cells=40", "cells=30"));
}

Outline outlineOfSquares(std::initializer_list<Cell> cells, Block block = 1) {
  Scene scene;
  for (const Cell& cell : cells) scene.polygons.push_back({cell, block++, {{0, 0}, {U, 0}, {U, U}, {0, U}}});
  return naiveOutline(scene);
}

TEST(Comparable, LeavesOutWhatAnEngineHasNot) {
  const Outline outline = outlineOfSquares({{0, 0}, {1, 0}});
  for (const OutlineSegment& s : comparable(outline, canDo("blocks")))
    EXPECT_TRUE(!s.ghost1 && !s.ghost2 && s.block != 0);
  for (const OutlineSegment& s : comparable(outline, canDo("ghosts")))
    EXPECT_TRUE(s.ghost1 && s.ghost2 && s.block == 0);
  EXPECT_EQ(comparable(outline, Capabilities::all()), outline);
}

TEST(Comparable, JoinsWhatIsCollinear) {
  const Outline row = comparable(outlineOfSquares({{0, 0}, {1, 0}, {2, 0}}), canDo("ghosts merged"));
  const Outline expected{{{0, 0}, {3 * U, 0}, 0, Point{0, U}, Point{3 * U, U}},
                         {{0, U}, {0, 0}, 0, Point{3 * U, U}, Point{3 * U, 0}},
                         {{3 * U, 0}, {3 * U, U}, 0, Point{0, 0}, Point{0, U}},
                         {{3 * U, U}, {0, U}, 0, Point{3 * U, 0}, Point{0, 0}}};
  EXPECT_EQ(row, expected);
  EXPECT_EQ(comparable(row, canDo("ghosts merged")), row);
  EXPECT_EQ(comparable(outlineOfSquares({{0, 0}, {1, 0}}), canDo("blocks merged")).size(), 6U) << "other blocks";
  // Two squares that touch in a corner, beside two that share a wall: nothing is joined through the corner.
  EXPECT_EQ(comparable(outlineOfSquares({{0, 0}, {1, 1}}), canDo("merged")).size(), 8U);
}

// The corner of a triangle touches the middle of the top of a square. The links turn there, so the top stays in two.
TEST(Comparable, JoinsNothingThroughACornerOfAnother) {
  const Scene scene{{{{0, 0}, 1, {{0, 0}, {U, 0}, {U, U}, {0, U}}}, {{0, 1}, 1, {{U / 2, 0}, {U, U}, {0, U}}}}, {}};
  const Outline outline = naiveOutline(scene);
  ASSERT_EQ(outline.size(), 8U);
  EXPECT_EQ(comparable(outline, canDo("ghosts blocks merged")), outline);
}

// Between two rows of two squares the wall is preserved: there both directions of it are joined, each to its own.
TEST(Comparable, JoinsBothDirectionsOfAPreservedWall) {
  const auto square = [](Cell cell, Block block) {
    return ScenePolygon{cell, block, {{0, 0}, {U, 0}, {U, U}, {0, U}}};
  };
  Scene scene{{square({0, 0}, 1), square({1, 0}, 1), square({0, 1}, 2), square({1, 1}, 2)}, {}};
  scene.preserve.add(1, 2);
  const Outline joined = comparable(naiveOutline(scene), canDo("blocks merged"));
  const auto has = [&](Point start, Point end, Block block) {
    return std::ranges::find(joined, OutlineSegment{start, end, block, {}, {}}) != joined.end();
  };
  EXPECT_TRUE(has({2 * U, U}, {0, U}, 1));
  EXPECT_TRUE(has({0, U}, {2 * U, U}, 2));
  EXPECT_EQ(joined.size(), 8U);
}

/// This library's engine, and what it would put out if it joined its segments.
class Merging : public LibraryEngine {
 public:
  Merging() { assume(canDo("ghosts several slants refuses merged")); }
  Outline outline() const override { return comparable(LibraryEngine::outline(), canDo("ghosts merged")); }
};

TEST(Checker, HoldsAnEngineToWhatItCan) {
  Merging merging;
  LibraryEngine plain;
  plain.assume(canDo("blocks several slants refuses"));
  for (Engine* const engine : {static_cast<Engine*>(&merging), static_cast<Engine*>(&plain)}) {
    CheckOptions options{.engine = engine, .skipRefused = true};
    CheckStats stats;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto found = checkTrace(caseOf(seed, {3, 3, 40, engine->can(), false}, seed), options, stats);
      ASSERT_TRUE(found) << found.error().text;
      EXPECT_FALSE(*found) << (*found)->text;
    }
    EXPECT_GT(stats.refused, 5U);
    EXPECT_GT(stats.cgal, 100U);
  }
  // What does not join is no trouble; what joins and does not say so is.
  merging.assume(canDo("ghosts several slants refuses"));
  CheckOptions options{.engine = &merging, .skipRefused = true};
  EXPECT_TRUE(findMismatch({{}, {Call::add("a", {{}, 1, {{0, 0}, {U / 2, 0}, {U, 0}, {U, U}}})}}, options));
}

}  // namespace
}  // namespace lgs::oracle
