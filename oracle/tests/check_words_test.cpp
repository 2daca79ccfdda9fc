// What a person reads of a mismatch: which kind, where, how often; and what kind of fault a report counts it as.
#include "oracle/check/checker.h"
#include "oracle/check/failure.h"
#include "oracle/check/finding.h"
#include "oracle/check/reference_engine.h"
#include "oracle/check/refusal.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/words.h"
#include "outlines_by_hand.h"

#include <gtest/gtest.h>
#include <functional>

namespace lgs::oracle::telling {
namespace {

TEST(CheckWords, EachKindHasItsOwn) {
  using enum Mismatch::Kind;
  EXPECT_EQ(describe(verdict), "a call was not answered as it must be");
  EXPECT_EQ(describe(reach), "a brush changed what it does not reach");
  EXPECT_EQ(describe(rounding), "a brush is too far from the exact result");
  EXPECT_EQ(describe(history), "the outline depends on the order of the edits");
  EXPECT_EQ(describe(protocol), "the engine does not keep to the protocol");
}

TEST(CheckWords, AMismatchHasAPlaceInItsTrace) {
  Trace trace{{}, {Call::commit(), Call::commit()}};
  trace.calls[1].line = 7;
  Mismatch found;
  found.kind = Mismatch::Kind::cgal;
  found.text = "all of it\n";
  found.edits = found.commit = 1;
  EXPECT_EQ(describe(found, trace), "after edit 1 (1 commit): the outline differs from CGAL's:\nall of it\n");
  found.edits = found.commit = 2;
  EXPECT_EQ(describe(found, trace), "after edit 2, line 7 (2 commits): the outline differs from CGAL's:\nall of it\n");
  found.edits = 0;
  EXPECT_EQ(describe(found, Trace()), "after edit 0 (2 commits): the outline differs from CGAL's:\nall of it\n");
}

TEST(CheckWords, AFailureHasItsLog) {
  Failure failure{Failure::Kind::crash, "crashed"};
  EXPECT_EQ(inWords(failure, " after edit 3"), "the engine crashed after edit 3\n");
  failure.log = "Oh\nno";
  EXPECT_EQ(inWords(failure), "the engine crashed\nits log ends:\nOh\nno\n");
}

TEST(CheckWords, ACommentHasALineForEachOfItsLines) {
  const Trace trace{{}, {Call::commit()}};
  EXPECT_EQ(printTrace(trace, "one\ntwo"), "lgs-trace 1\n# one\n# two\ncommit\n");
  EXPECT_EQ(printTrace(trace, "one\n"), "lgs-trace 1\n# one\ncommit\n");
  EXPECT_EQ(printTrace(trace, ""), "lgs-trace 1\ncommit\n");
}

TEST(CheckWords, SharesOfCalls) {
  CheckStats stats;
  EXPECT_EQ(callsInWords(stats), "");
  stats.made[static_cast<std::size_t>(Call::Kind::add)] = 1;
  stats.made[static_cast<std::size_t>(Call::Kind::goBack)] = 3;
  EXPECT_EQ(callsInWords(stats), "add 25.0%, back 75.0%");
}

TEST(CheckWords, NumbersAreInThousands) {
  EXPECT_EQ(counted(0, "edit"), "0 edits");
  EXPECT_EQ(counted(1, "edit"), "1 edit");
  EXPECT_EQ(counted(999, "edit"), "999 edits");
  EXPECT_EQ(counted(1'000, "edit"), "1,000 edits");
  EXPECT_EQ(counted(123'456'789, "edit"), "123,456,789 edits");
}

TEST(CheckWords, RefusalsTooManyTooFewAndInAnotherOrder) {
  const RefusedEdit a{"a", "overlap"}, b{"b", "capacity"};
  EXPECT_EQ(wrongRefusals({a, b}, {{"a", "other words"}, b}), "");
  EXPECT_EQ(wrongRefusals({a}, {a, b}), "refused, but is good: 'b': capacity");
  EXPECT_EQ(wrongRefusals({a, b}, {b}), "accepted, but must be refused as overlap: 'a'");
  EXPECT_EQ(wrongRefusals({a, b}, {a}), "accepted, but must be refused as capacity: 'b'");
  EXPECT_EQ(wrongRefusals({a, a}, {a}), "accepted, but must be refused as overlap: 'a'");
  EXPECT_EQ(wrongRefusals({a, b}, {b, a}), "the refusal of 'b' is not told in the order of the edits");
}

// --- The kinds that a report counts -----------------------------------------------------------------------------------

Scene twoSquares() { return {{square({0, 0}, 1), square({1, 0}, 1)}, {}}; }

// Of an engine that puts out this for the two squares, and will again.
class Stubborn : public ReferenceEngine {
 public:
  explicit Stubborn(Outline always) : ReferenceEngine(true, false), always_(std::move(always)) {}
  Outline outline() const override { return always_; }

 private:
  Outline always_;
};

std::string kindOf(const Outline& actual, bool isStubborn = true) {
  Mismatch found;
  found.kind = Mismatch::Kind::naive;
  found.scene = twoSquares();
  found.expected = naiveOutline(found.scene);
  found.actual = actual;
  Stubborn stubborn(actual);
  ReferenceEngine right(true, false);
  return kindOfFinding(found, isStubborn ? static_cast<Engine&>(stubborn) : right);
}

std::string kindOfChanged(const std::function<void(Outline&)>& change, bool isStubborn = true) {
  Outline outline = naiveOutline(twoSquares());
  change(outline);
  std::ranges::sort(outline);
  return kindOf(outline, isStubborn);
}

TEST(CheckFindings, AreNamedByWhatDiffers) {
  EXPECT_EQ(kindOf(chain({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, {1})), "missing cut");
  EXPECT_EQ(
      kindOfChanged([](Outline& o) {
        std::erase_if(o, [](const OutlineSegment& s) { return s.start == point({1, 0}) && s.end == point({2, 0}); });
        o.push_back({point({0, 0}), point({2, 0}), 1, {}, {}});
      }),
      "missing cut");
  EXPECT_EQ(kindOfChanged([](Outline& o) {
              o.push_back({point({1, 1}), point({1, 0}), 1, {}, {}});
            }),
            "other segments");
  EXPECT_EQ(
      kindOf(together({chain({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {1}), chain({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, {1})})),
      "uncancelled edge");
  EXPECT_EQ(kindOfChanged([](Outline& o) { o.pop_back(); }), "other segments");
  EXPECT_EQ(kindOfChanged([](Outline& o) { o[0].ghost1 = point({1, 1}); }), "wrong link");
  EXPECT_EQ(kindOfChanged([](Outline& o) { o[0].ghost2.reset(); }), "wrong link");
  EXPECT_EQ(kindOfChanged([](Outline& o) { o[0].block = 9; }), "wrong block");
}

TEST(CheckFindings, ArePreservedEdgesThatAreLost) {
  Mismatch found;
  found.kind = Mismatch::Kind::cgal;
  found.scene.polygons = {square({0, 0}, 1), square({1, 0}, 2)};
  found.actual = naiveOutline(found.scene);
  found.scene.preserve.add(1, 2);
  found.expected = naiveOutline(found.scene);
  Stubborn stubborn(found.actual);
  EXPECT_EQ(kindOfFinding(found, stubborn), "lost preserve");
}

TEST(CheckFindings, AreThingsOfThePastWhereTheEngineIsRightAfresh) {
  EXPECT_EQ(kindOfChanged([](Outline& o) { o[0].ghost1 = o[1].ghost2 = point({1, 1}); }, false), "stale ghost");
  EXPECT_EQ(kindOfChanged([](Outline& o) { o[0].block = 9; }, false), "order of edits matters");
}

TEST(CheckFindings, AreWhatTheCheckSaysWhereNoOutlineTells) {
  ReferenceEngine right(true, false);
  const auto kind = [&](Mismatch::Kind of) {
    Mismatch found;
    found.kind = of;
    return kindOfFinding(found, right);
  };
  EXPECT_EQ(kind(Mismatch::Kind::crash), "crash");
  EXPECT_EQ(kind(Mismatch::Kind::hang), "hang");
  EXPECT_EQ(kind(Mismatch::Kind::protocol), "protocol");
  EXPECT_EQ(kind(Mismatch::Kind::verdict), "refusal");
  EXPECT_EQ(kind(Mismatch::Kind::history), "order of edits matters");
}

}  // namespace
}  // namespace lgs::oracle::telling
