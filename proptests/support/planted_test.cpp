// The tests' own tools on bugs planted here, in what the engine puts out or is given: each is found in random cases and
// shrinks to a few edits; what was found is saved and drawn. A crash is such a bug. (proptests/bugs plants them in lib/.)
#include "oracle/check/isolated.h"
#include "oracle/generate/generator.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/file.h"
#include "oracle/trace/model.h"
#include "oracle/trace/player.h"
#include "random_traces.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace lgs::test {
namespace {

using oracle::Edit;
using oracle::Outline;
using oracle::OutlineSegment;
using oracle::Trace;

/// What a faulty engine makes of a trace.
using FaultyEngine = std::function<Outline(const Trace&)>;

std::optional<Failure> huntedDown(const std::string& name, const FaultyEngine& engine) {
  return firstFailure(
      {.name = "planted-" + name,
       .count = 200,
       .trace =
           [](std::uint64_t k) {
             return withoutRefused(oracle::randomCase({3, 3, 60}, k));
           },
       .complaint = [&](const Trace& t, std::uint64_t) { return differenceOf(outlineAfter(t), engine(t)); },
       .mayBe = [](const Trace& t) { return withoutRefused(t).edits.size() == t.edits.size(); }});
}

void expectSmall(const std::optional<Failure>& failure) {
  ASSERT_TRUE(failure) << "not found";
  EXPECT_LE(editCount(failure->trace), 4U) << failure->text;
  const std::size_t at = failure->text.find("trace      ") + 11;
  const std::string file = failure->text.substr(at, failure->text.find('\n', at) - at);
  const auto saved = oracle::readTrace(file);
  ASSERT_TRUE(saved) << failure->text;
  EXPECT_EQ(*saved, failure->trace);
  const auto picture = oracle::readFile(file.substr(0, file.rfind('.')) + ".svg");
  ASSERT_TRUE(picture) << failure->text;
  EXPECT_NE(picture->find("</svg>"), std::string::npos);
}

bool isStraight(Point a, Point b, Point c) { return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y); }

TEST(Planted, AWallThatIsNotCut) {
  expectSmall(huntedDown("uncut", [](const Trace& trace) {
    const Outline right = outlineAfter(trace);
    Outline wrong;
    for (const OutlineSegment& s : right) {
      const auto before = [&](const OutlineSegment& t) {
        return t.end == s.start && s.ghost1 == t.start && t.block == s.block && isStraight(t.start, s.start, s.end);
      };
      const auto found = std::find_if(wrong.begin(), wrong.end(), before);
      if (found == wrong.end()) {
        wrong.push_back(s);
      } else {
        found->end = s.end;
        found->ghost2 = s.ghost2;
      }
    }
    return wrong;
  }));
}

TEST(Planted, AWrongTurnWhereSolidsTouch) {
  expectSmall(huntedDown("turn", [](const Trace& trace) {
    Outline wrong = outlineAfter(trace);
    std::map<Point, std::vector<OutlineSegment*>> arriving;
    for (OutlineSegment& s : wrong) arriving[s.end].push_back(&s);
    for (auto& [at, segments] : arriving)
      if (segments.size() == 2) std::swap(segments[0]->ghost2, segments[1]->ghost2);
    return wrong;
  }));
}

TEST(Planted, APreserveRelationThatIsNotAsked) {
  expectSmall(huntedDown("preserve", [](const Trace& trace) { return outlineAfter({{}, trace.edits}); }));
}

TEST(Planted, AnAddThatIsForgottenWhereTheCellWasEmptied) {
  expectSmall(huntedDown("refill", [](const Trace& trace) {
    oracle::Player player(trace.preserve);
    std::map<std::string, Cell> cellOf;
    std::set<Cell> emptied;  // since the last commit
    for (Edit edit : trace.edits) {
      if (edit.kind == Edit::Kind::commit) emptied.clear();
      if (edit.kind == Edit::Kind::remove) emptied.insert(cellOf[edit.name]);
      if (edit.kind == Edit::Kind::add && emptied.contains(cellOf[edit.name] = edit.polygon.cell)) continue;
      if (edit.kind != Edit::Kind::commit) static_cast<void>(player.apply(edit));
    }
    player.commit();
    return oracle::outlineOf(player.world());
  }));
}

TEST(Planted, AnExpectationThatFails) {
  const auto failure = huntedDown("expectation", [](const Trace& trace) {
    for (const Edit& edit : trace.edits) EXPECT_NE(edit.polygon.vertices.size(), 5U);
    return outlineAfter(trace);
  });
  expectSmall(failure);
  EXPECT_NE(failure->text.find("edit.polygon.vertices.size()"), std::string::npos) << failure->text;
}

bool hasCrowdedCell(const Trace& trace) {
  oracle::Model model;
  for (const Edit& edit : trace.edits) model.apply(edit);
  return std::ranges::any_of(model.cells(), [](const auto& entry) { return entry.second.size() >= 2; });
}

TEST(Planted, ACrash) {
  const auto failure = huntedDown("crash", [](const Trace& trace) {
    if (hasCrowdedCell(trace)) std::abort();
    return outlineAfter(trace);
  });
  expectSmall(failure);
  EXPECT_NE(failure->text.find("the engine crashed: Aborted"), std::string::npos) << failure->text;
}

TEST(Planted, AFailureThatTakesTheCasesBeforeItIsSavedAsItIs) {
  const oracle::Shared<int> tried;
  const auto traceOf = [](std::uint64_t k) { return withoutRefused(oracle::randomCase({3, 3, 4}, k)); };
  const auto failure = firstFailure({.name = "planted-history",
                                     .count = 10,
                                     .trace = traceOf,
                                     .complaint = [&](const Trace&, std::uint64_t) -> std::optional<std::string> {
                                       if (++*tried != 3) return std::nullopt;
                                       return "the third one";
                                     }});
  expectSmall(failure);
  EXPECT_EQ(failure->trace, traceOf(2));
  EXPECT_NE(failure->text.find("not by itself: the third one"), std::string::npos) << failure->text;
}

TEST(Planted, AnEndlessLoop) {
  const oracle::IsolationOptions oneSecond{.seconds = 1, .quiet = true};
  EXPECT_EQ(oracle::crashOf(
                [] {
                  for (;;) pause();
                },
                oneSecond),
            "hung for 1 s");
  EXPECT_EQ(oracle::crashOf([] {}, oneSecond), std::nullopt);
}

}  // namespace
}  // namespace lgs::test
