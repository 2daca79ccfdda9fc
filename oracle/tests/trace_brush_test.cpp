// Brushes in traces: what is read, what is refused and how, what is written, how it is played and checked.
#include "oracle/check/checker.h"
#include "oracle/check/failure.h"
#include "oracle/check/shrink.h"
#include "oracle/generate/generator.h"
#include "oracle/generate/strokes.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/model.h"
#include "oracle/trace/plain_edits.h"
#include "read_traces.h"

#include <algorithm>
#include <chrono>

namespace lgs::oracle::brushed {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t U = kUnitsPerCell;

const std::string kHead = "lgs-trace 2\n";
const std::string kGround =
    "add left 0 0 7  0 0  1 0  1 1  0 1\n"
    "add right 1 0 7  0 0  1 0  1 1  0 1\n"
    "add far 9 9 7  0 0  1 0  1 1  0 1\n";

TEST(TraceBrush, ReadsWorldCoordinatesAndRings) {
  const Trace trace = mustParse(
      "lgs-trace 2\n"
      "paint 5 fill  0 0, 1/3 0, -0.5 2 | 1 1 2 1 2 2 1 2\n"
      "paint 0 replace 0 0 1 0 1 1 # a comment\n"
      "carve 1073741825 0 3 0 3 1e-1\n"
      "carve 4 4\n");
  ASSERT_EQ(trace.calls.size(), 4U);
  const BrushEdit& fill = trace.calls[0].brush;
  EXPECT_EQ(trace.calls[0].kind, Call::Kind::brush);
  EXPECT_EQ(fill.deed, BrushEdit::Deed::fill);
  EXPECT_EQ(fill.block, 5U);
  EXPECT_EQ(fill.rings, (std::vector<std::vector<Point>>{{{0, 0}, {21'845, 0}, {-U / 2, 2 * U}},
                                                         {{U, U}, {2 * U, U}, {2 * U, 2 * U}, {U, 2 * U}}}));
  EXPECT_TRUE(fill.isEvenOdd);
  EXPECT_EQ(trace.calls[1].brush.deed, BrushEdit::Deed::replace);
  EXPECT_EQ(trace.calls[2].brush.deed, BrushEdit::Deed::carve);
  EXPECT_EQ(trace.calls[2].brush.rings[0][0].x, kMaxCoordinate);
  EXPECT_EQ(trace.calls[3].line, 5U);
  EXPECT_EQ(editCount(trace), 4U);
}

TEST(TraceBrush, RoundTrips) {
  const std::string text = "lgs-trace 2\npreserve 3 9\n" + kGround +
                           "carve  0.5 0.5 1/65536 -3.25 1073741825 7  | 0 0 1 0 1 1\ncommit\n"
                           "paint 4294967295 fill  -1073741825 0 1 0 1 1\npaint 0 replace  5 5\nremove far\n";
  const Trace trace = mustParse(text);
  EXPECT_EQ(mustParse(printTrace(trace)), trace) << printTrace(trace);
}

TEST(TraceBrush, TheVersionSaysWhetherThereAreBrushes) {
  Trace trace = mustParse(kHead + kGround);
  EXPECT_TRUE(printTrace(trace).starts_with("lgs-trace 1\n")) << "none needs version 2";
  trace.calls.push_back(Call::byBrush({BrushEdit::Deed::carve, 0, {{{0, 0}, {U, 0}, {0, U}}}}));
  EXPECT_TRUE(printTrace(trace).starts_with("lgs-trace 2\n"));
}

TEST(TraceBrush, BadLinesSayFileLineAndReason) {
  expectFaults({
      {"lgs-trace 1\ncarve 0 0 1 0 1 1\n", "bad.trace:2: carve needs 'lgs-trace 2' as the first line of the trace"},
      {"lgs-trace 1\npaint 1 fill 0 0 1 0 1 1\n", "bad.trace:2: paint needs 'lgs-trace 2' as the first line"},
      {kHead + "dig 0 0\n",
       "bad.trace:2: unknown word 'dig'; a line starts with preserve, add, remove, commit, paint, carve or #"},
      {kHead + "paint 1\n", "bad.trace:2: paint needs a block, and fill or replace, before its coordinates"},
      {kHead + "paint x fill 0 0 1 0 1 1\n", "bad.trace:2: the block 'x' is not an integer"},
      {kHead + "paint 1 over 0 0 1 0 1 1\n", "bad.trace:2: paint is in the mode fill or replace, not 'over'"},
      {kHead + "paint 1 fill\n", "bad.trace:2: ring 0 has no coordinates"},
      {kHead + "carve\n", "bad.trace:2: ring 0 has no coordinates"},
      {kHead + "carve 0 0 1 0 1 1 |\n", "bad.trace:2: ring 1 has no coordinates"},
      {kHead + "carve 0 0 1 0 1 1 | | 0 0\n", "bad.trace:2: ring 1 has no coordinates"},
      {kHead + "carve 0 0 1 0 1 1 | 0 0 1\n", "bad.trace:2: ring 1 has 3 coordinates: they come in pairs x y"},
      {kHead + "carve 0 0 1 zero\n", "bad.trace:2: the y of vertex 1 of ring 0, 'zero': not a number"},
      {kHead + "carve 0 0 3e9 0\n", "bad.trace:2: the x of vertex 1 of ring 0, '3e9': far outside of all cells"},
      {kHead + "carve 0 0 1 0 1 1 | 0 0 1 0 1 1073741826\n", "bad.trace:2: ring 1, vertex 2: "},
      {kHead + "carve 0 0 4096.5 0 1 1\n", "bad.trace:2: "},
      {kHead + kGround + "carve 0.5 0.5 0.6 0.5 0.6 0.6\nremove left\n",
       "bad.trace:6: there is no polygon named 'left' to remove; a brush has changed it, and a changed polygon has no "
       "name (line 5)"},
      {kHead + kGround + "paint 7 replace 0 0 1 0 1 1 0 1\nremove left\n", ""},  // it has not changed
      {kHead + kGround + "paint 8 replace 0 0 1 0 1 1 0 1\nremove left\n", "bad.trace:6: there is no polygon named"},
      {kHead + kGround + "carve 0.5 0.5 0.6 0.5 0.6 0.6\nadd x 0 0 1  0 0 0.1 0 0.1 0.1\n",
       "bad.trace:6: cell (0, 0): its interior overlaps"},
      {kHead + kGround + "carve 0 0 1 0 1 1 0 1\nadd left 0 0 1  0 0 0.1 0 0.1 0.1\nremove left\nremove left\n",
       "bad.trace:8: there is no polygon named 'left' to remove"},
  });
}

TEST(TraceBrush, ThePlayerReadsBackWhatABrushDid) {
  Player player({});
  const Trace trace = mustParse(kHead + kGround + "carve 0.5 0.5 1.5 0.5 1.5 0.75\n");
  ASSERT_TRUE(play(trace, player));
  EXPECT_FALSE(player.isAlive("left"));
  EXPECT_FALSE(player.isAlive("right"));
  EXPECT_TRUE(player.isAlive("far"));
  std::size_t there = 0;
  player.world().forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    const ScenePolygon polygon{cell, p.block, {p.vertices.begin(), p.vertices.end()}};
    EXPECT_EQ(std::ranges::count(player.scene().polygons, polygon), 1);
    ++there;
  });
  EXPECT_EQ(player.standing().polygons(), there);
  const auto& did = player.brushed().edits;
  EXPECT_EQ(std::ranges::count(did, Call::Kind::remove, &Call::kind), 2);
  EXPECT_EQ(did.size(), 2 + there - 1);
}

TEST(TraceBrush, WithoutBrushesItIsTheSameWorld) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Trace trace =
        randomCase({.width = 3, .height = 3, .edits = 30, .isOfCalls = true, .brushes = true, .inMemory = true}, seed);
    const Trace plain = inPlainEdits(trace);
    EXPECT_FALSE(hasBrushes(plain));
    ASSERT_EQ(mustParse(printTrace(plain)), plain) << "its names can be written";
    const auto outline = [](const Trace& played) {
      Player player(played.preserve);
      for (const Call& edit : played.calls)
        edit.kind == Call::Kind::commit ? void(player.commit()) : void(player.apply(edit));
      player.commit();
      return outlineOf(player.world());
    };
    ASSERT_EQ(outline(plain), outline(trace)) << "seed " << seed;
  }
}

TEST(TraceBrush, TheShrinkerMakesRegionsSimpler) {
  const Trace trace =
      mustParse(kHead + kGround +
                "carve 7.3 7.3 7.4 7.31 7.35 7.4\ncommit\n"
                "paint 12 fill 3.11 3.07 4.2 3.3 4.9 4.1 3.1 4.8 | 20 20 21 20 21 21 | 2 2 3 2 3 2.5\n");
  const auto paints = [](const Trace& candidate) {
    return std::ranges::any_of(candidate.calls, [](const Call& edit) {
      return edit.kind == Call::Kind::brush && edit.brush.deed == BrushEdit::Deed::fill;
    });
  };
  const Trace small = shrink(trace, paints, 20s);
  ASSERT_EQ(small.calls.size(), 1U) << printTrace(small);
  const BrushEdit& brush = small.calls[0].brush;
  EXPECT_EQ(brush.block, 1U);
  ASSERT_EQ(brush.rings.size(), 1U);
  EXPECT_EQ(brush.rings[0].size(), 3U);
  for (const Point p : brush.rings[0]) {
    EXPECT_EQ(p.x % U, 0);
    EXPECT_EQ(p.y % U, 0);
    EXPECT_LE(std::max(p.x, p.y), 2 * U) << "near the origin";
  }
}

}  // namespace
}  // namespace lgs::oracle::brushed
