// What a person reads of a mismatch: which kind, where, how often. What kind of fault a report counts it as engines with
// one fault each show (engines/report_test.cpp).
#include "oracle/check/checker.h"
#include "oracle/check/failure.h"
#include "oracle/check/refusal.h"
#include "oracle/reference/words.h"

#include <gtest/gtest.h>

namespace lgs::oracle::telling {
namespace {

TEST(CheckWords, EachKindHasItsOwn) {
  using enum Mismatch::Kind;
  EXPECT_EQ(describe(verdict), "a call was not answered as it must be");
  EXPECT_EQ(describe(reach), "a brush changed what it does not reach");
  EXPECT_EQ(describe(rounding), "a region is too far from the exact result");
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
  stats.made[static_cast<std::size_t>(Call::Kind::rollBack)] = 3;
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
  EXPECT_EQ(wrongRefusals({a, b}, {b, a}), "the refusal of 'b' is not reported in the order of the edits");
}

}  // namespace
}  // namespace lgs::oracle::telling
