// The list of known mismatches, and which laws are a recommendation.
#include "checking.h"
#include "oracle/calls/shapes.h"
#include "oracle/check/known.h"
#include "oracle/check/levels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::oracle {
namespace {

using test::U;

Trace parsed(const std::string& text) {
  ParsedTrace parsed = parseTrace(text);
  EXPECT_FALSE(parsed.error);
  return std::move(parsed.trace);
}

const char* const kTwo =
    "lgs-trace 1\nadd p1 0 0 1  0 0 1 0 1 1 0 1\nadd p2 0 1 1  0 0 1 0 0.5 1\ncommit\nremove p1\nadd p3 3 4 2  0 0 1 0 "
    "0 1\n";

TEST(CheckKnown, OneMismatchHasOneIdentity) {
  const Trace two = parsed(kTwo);
  const std::string identity = identityOf({"a kind", two});
  EXPECT_NE(identity, identityOf({"another", two}));
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    Trace other = two;
    for (Call& call : other.calls) {
      for (Coming& coming : call.comes) {
        Cell& c = coming.cell;
        if (symmetry & 1) c.i = -1 - c.i;
        if (symmetry & 2) c.j = -1 - c.j;
        if (symmetry & 4) std::swap(c.i, c.j);
        c = {c.i + 1'000'000, c.j - 7};
        coming.shape[0] = turned(coming.shape[0], symmetry);
        std::rotate(coming.shape[0].begin(), coming.shape[0].begin() + 1, coming.shape[0].end());
        coming.names[0] += "x";
      }
      for (Named& named : call.goes) named.name += "x";
    }
    EXPECT_EQ(identityOf({"a kind", other}), identity) << symmetry;
  }
  Trace swapped = two, last = two, rounder = two, committed = two;
  std::swap(swapped.calls[0], swapped.calls[1]);
  EXPECT_EQ(identityOf({"a kind", swapped}), identity) << "adds that follow one another";
  committed.calls.push_back(Call::commit());
  EXPECT_EQ(identityOf({"a kind", committed}), identity);
  std::swap(last.calls[1], last.calls[2]);
  EXPECT_NE(identityOf({"a kind", last}), identity) << "another commit";
  rounder.calls[1].comes[0].shape[0][2].x = U;
  EXPECT_NE(identityOf({"a kind", rounder}), identity);
}

TEST(CheckKnown, BrushesMoveToo) {
  const Trace a = parsed("lgs-trace 2\npaint 7 fill 0.5 0.5 2 0.5 2 2\ncarve 1 1 1.5 1 1.5 1.25\n");
  const Trace b = parsed("lgs-trace 2\npaint 7 fill -4.5 3.5 -6 3.5 -6 5\ncarve -5 4 -5.5 4 -5.5 4.25\n");
  EXPECT_EQ(identityOf({"k", a}), identityOf({"k", b}));
}

TEST(CheckKnown, AListIsReadAsItIsPrinted) {
  const std::vector<KnownMismatch> known{{"wrong link", parsed(kTwo)}, {"crash", parsed("lgs-trace 1\n")}};
  const auto read = parseKnown(printKnown(known));
  ASSERT_TRUE(read) << read.error();
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ((*read)[0].kind, "crash");
  EXPECT_EQ((*read)[1].kind, "wrong link");
  EXPECT_EQ((*read)[1].trace, known[0].trace);
  EXPECT_TRUE(parseKnown("")->empty());
  EXPECT_TRUE(parseKnown("# nothing\n\n")->empty());
  EXPECT_EQ(parseKnown("add p1 0 0 1\n").error(), "1: a list begins with a line 'known KIND'");
  EXPECT_TRUE(parseKnown("known a\nlgs-trace 1\n\nknown b\nlgs-trace 1\nmove\n").error().starts_with("6: "));
}

TEST(CheckLevels, AreRead) {
  EXPECT_EQ(parseLaws("").value(), 0U);
  EXPECT_NE(parseLaws("ghosts=should").value(), parseLaws("minimality=should").value());
  for (const char* const bad : {"ghosts", "ghosts=must", "segments=should"}) EXPECT_FALSE(parseLaws(bad)) << bad;
}

TEST(CheckLevels, AdviceBreaksRecommendationsAlone) {
  const OutlineSegment s{{0, 0}, {U, 0}, 1, {}, Point{U, U}};
  OutlineSegment ghost = s, block = s, both = s;
  ghost.ghost2.reset();
  block.block = both.block = 2;
  both.ghost1 = Point{0, U};
  const auto isAdvice = [&](Mismatch::Kind kind, const Outline& actual, const char* laws) {
    Mismatch found;
    found.kind = kind;
    found.expected = {s};
    found.actual = actual;
    return oracle::isAdvice(found, parseLaws(laws).value());
  };
  using enum Mismatch::Kind;
  for (const Mismatch::Kind kind : {naive, cgal}) {
    EXPECT_TRUE(isAdvice(kind, {ghost}, "ghosts=should"));
    EXPECT_FALSE(isAdvice(kind, {ghost}, "blocks=should history=should islands=should minimality=should"));
    EXPECT_TRUE(isAdvice(kind, {block}, "blocks=should"));
    EXPECT_FALSE(isAdvice(kind, {both}, "blocks=should"));
    EXPECT_TRUE(isAdvice(kind, {both}, "blocks=should ghosts=should"));
    EXPECT_FALSE(isAdvice(kind, {}, "blocks=should ghosts=should history=should"));
  }
  EXPECT_TRUE(isAdvice(history, {}, "history=should"));
  EXPECT_TRUE(isAdvice(history, {ghost}, "ghosts=should")) << "wrong in one order";
  EXPECT_TRUE(isAdvice(views, {s}, "islands=should"));
  EXPECT_TRUE(isAdvice(needless, {s}, "minimality=should"));
  const char* const all = "ghosts=should blocks=should history=should islands=should minimality=should";
  for (const Mismatch::Kind kind : {verdict, changes, crash, hang, protocol}) EXPECT_FALSE(isAdvice(kind, {s}, all));
  EXPECT_FALSE(isAdvice(naive, {ghost}, ""));
}

}  // namespace
}  // namespace lgs::oracle
