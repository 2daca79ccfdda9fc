// Engines that are wrong in one thing: what the checker says of each.
#include "checking.h"
#include "oracle/check/failure.h"
#include "oracle/check/levels.h"
#include "oracle/check/reference_engine.h"
#include "oracle/generate/generator.h"
#include "oracle/views/named_islands.h"
#include "proptests/support/must.h"
#include "read_traces.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <functional>
#include <map>

namespace lgs::oracle::engines {
namespace {

using test::must;
using test::U;
using testing::ElementsAre;
using Kind = Mismatch::Kind;

Trace twoSquares() { return {{}, {square("a", {0, 0}), Call::commit(), square("b", {1, 0})}}; }

// The references, but for what a test changes.
class Wrong : public ReferenceEngine {
 public:
  Wrong() : ReferenceEngine(true, false) {}
  explicit Wrong(const Capabilities& can) : Wrong() { assume(can); }

  void reset(const PreservePairs& preserve) override {
    ReferenceEngine::reset(preserve);
    scene_ = {};
    ++resets;
  }
  void add(const std::string& name, const ScenePolygon& polygon) override {
    ReferenceEngine::add(name, polygon);
    scene_.polygons.push_back(polygon);
    ++adds;
  }
  Refusals commit() override {
    auto refusals = ReferenceEngine::commit();
    return answer ? answer(std::move(*refusals)) : refusals;
  }
  Outline outline() const override {
    Outline outline = ReferenceEngine::outline();
    if (change) change(outline);
    std::ranges::sort(outline);
    return outline;
  }
  NamedIslands islands() const override { return isIslandMissing ? NamedIslands() : namedIslands(scene_); }

  std::function<Refusals(std::vector<RefusedEdit>)> answer;
  std::function<void(Outline&)> change;
  bool isIslandMissing = false;
  int resets = 0;
  std::size_t adds = 0;

 private:
  Scene scene_;  // of what was added; nothing is removed in these tests
};

std::optional<Mismatch> check(Engine& engine, const Trace& trace) {
  return findMismatch(trace, {.engine = &engine, .skipRefused = true});
}

TEST(CheckEngines, ARightOneIsFoundRight) {
  Wrong right;
  CheckStats stats;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const CheckOptions options{.engine = &right, .skipRefused = true, .wholeEvery = seed % 3};
    const auto found = checked(randomCase({3, 3, 40, Capabilities::all(), false}, seed), options, stats);
    EXPECT_FALSE(found) << found->text;
  }
  EXPECT_GT(stats.refused, 5U);
  EXPECT_EQ(right.name(), "oracle");
  EXPECT_FALSE(ReferenceEngine(false, true).can().preserve);
}

TEST(CheckEngines, TheReferencesSayWhyTheyRefuse) {
  ReferenceEngine engine(true, true);
  engine.reset({});
  engine.add("a", {{0, 0}, 1, test::unitSquare()});
  engine.add("a", {{1, 0}, 1, test::unitSquare()});
  engine.remove("b");
  engine.add("c", {{0, 0}, 1, test::unitSquare()});
  const std::vector<RefusedEdit> all = engine.commit().value();
  std::vector<std::string> said;
  said.reserve(all.size());
  for (const RefusedEdit& refused : all) said.push_back(refused.name + ": " + refused.reason);
  EXPECT_THAT(said, ElementsAre("a: name in use", "b: unknown name", "c: overlap"));
  EXPECT_TRUE(engine.commit().value().empty());
}

TEST(CheckEngines, AnotherOutlineIsToldWithAllThatBelongsToIt) {
  Wrong engine;
  engine.change = [](Outline& o) {
    if (o.size() == 6) o.pop_back();
  };
  const Mismatch found = must(check(engine, twoSquares()));
  EXPECT_EQ(found.kind, Kind::naive);
  EXPECT_EQ(found.text, "missing segment: (2, 1) → (1, 1), the top of cell (1, 0), block 1\n");
  EXPECT_EQ(found.edits, 3U);
  EXPECT_EQ(found.commit, 2U);
  EXPECT_EQ(found.scene.polygons.size(), 2U);
  EXPECT_EQ(found.expected.size(), 6U);
  EXPECT_EQ(found.actual.size(), 5U);
  EXPECT_EQ(found.edited, (std::vector<Cell>{{1, 0}}));
  engine.change = nullptr;
  EXPECT_FALSE(check(engine, twoSquares()));
}

// It tells what changed; and from the second commit on it removes the first segment and adds it again.
class Remaking : public ReferenceEngine {
 public:
  Remaking() : ReferenceEngine(true, false) { assume(parseCapabilities("ghosts blocks delta").value()); }
  Refusals commit() override {
    SegmentChanges changes;
    auto refusals = ReferenceEngine::commit();
    for (const OutlineSegment& s : ReferenceEngine::outline())
      if (std::string id = std::to_string(ids_.size()); ids_.try_emplace(s, id).second) changes.push_back({'+', id, s});
    if (auto& [s, id] = *ids_.begin(); !delta_.outline().empty()) {
      changes.push_back({'-', id});
      changes.push_back({'+', id += "'", s});
    }
    delta_.take(changes);
    return refusals;
  }
  Outline outline() const override { return delta_.outline(); }
  const Delta* delta() const override { return &delta_; }

 private:
  std::map<OutlineSegment, std::string> ids_;
  Delta delta_;
};

// Of these squares the bottoms lie on one line: that is no excuse.
TEST(CheckEngines, ASegmentThatIsMadeAgainBesideANewPolygonIsNeedless) {
  Remaking engine;
  const Mismatch found = must(check(engine, {{}, {square("a", {0, 0}), Call::commit(), square("b", {2, 0})}}));
  EXPECT_EQ(found.kind, Kind::needless);
  EXPECT_TRUE(found.text.starts_with("removed and added, but is as it was: (0, 0) → (1, 0)")) << found.text;
}

TEST(CheckEngines, AdviceDoesNotEndTheCheck) {
  Wrong engine;
  engine.change = [](Outline& o) { o.size() == 4 ? o[0].ghost1.reset() : o.pop_back(); };
  std::size_t advised = 0;
  const Mismatch found = must(findMismatch(twoSquares(), {.engine = &engine,
                                                          .skipRefused = true,
                                                          .recommended = parseLaws("ghosts=should").value(),
                                                          .advise = [&](const Mismatch&) { ++advised; }}));
  EXPECT_EQ(found.commit, 2U);
  EXPECT_EQ(advised, 1U);
}

TEST(CheckEngines, ASegmentOfNothingIsToldBeforeAnyEdit) {
  Wrong engine;
  engine.change = [](Outline& o) { o.push_back({{0, 0}, {U, 0}, 1, {}, {}}); };
  const Mismatch found = must(check(engine, {}));
  EXPECT_EQ(found.kind, Kind::naive);
  EXPECT_EQ(found.edits, 0U);
  EXPECT_EQ(found.commit, 0U);
}

TEST(CheckEngines, AWindowAroundTheEditsIsComparedWhereTheWholeWorldIsNot) {
  Wrong engine;
  engine.change = [](Outline& o) {
    if (o.size() == 6) o.pop_back();  // a part of the second square
  };
  Trace trace = twoSquares();
  trace.calls.insert(trace.calls.end(), {Call::commit(), square("c", {9, 0})});
  for (const bool naive : {true, false}) {
    CheckStats stats;
    const Mismatch found = must(checked(trace, {.engine = &engine, .naive = naive, .wholeEvery = 0}, stats));
    EXPECT_EQ(found.kind, naive ? Kind::naive : Kind::cgal);
    EXPECT_EQ(found.commit, 2U);
    EXPECT_EQ(found.actual.size(), 5U);
    EXPECT_EQ(found.scene.polygons.size(), 2U);
    EXPECT_EQ(stats.whole, 0U);
  }
  engine.change = nullptr;
  CheckStats stats;
  EXPECT_FALSE(checked(trace, {.engine = &engine, .cgal = false, .wholeEvery = 0}, stats));
  EXPECT_EQ(stats.cgal, 0U);
}

TEST(CheckEngines, WithoutTheNaiveReferenceCgalTells) {
  Wrong engine;
  engine.change = [](Outline& o) { o[0].block = 9; };
  CheckStats stats;
  CheckOptions options{.engine = &engine, .naive = false};
  EXPECT_EQ(must(checked(twoSquares(), options, stats)).kind, Kind::cgal);
  options.unionAtEnd = true;
  const Mismatch atEnd = must(checked(twoSquares(), options, stats));
  EXPECT_EQ(atEnd.kind, Kind::cgal);
  EXPECT_EQ(atEnd.edits, 3U) << "after the last commit";
}

TEST(CheckEngines, WhatTheOrderOfEditsChangesIsTold) {
  Wrong engine;
  engine.change = [&](Outline& o) {
    if (engine.resets == 2) o[0].block = 9;
  };
  EXPECT_EQ(must(check(engine, twoSquares())).kind, Kind::history);
  Wrong refusing;
  refusing.answer = [&](std::vector<RefusedEdit> refused) -> Engine::Refusals {
    if (refusing.resets == 2) refused.push_back({"p0", "no room"});
    return refused;
  };
  const Mismatch found = must(check(refusing, twoSquares()));
  EXPECT_EQ(found.kind, Kind::history);
  EXPECT_EQ(found.text, "added in another order: refused, but is good: 'p0': no room\n");
}

TEST(CheckEngines, OtherRefusalsAreTold) {
  Wrong engine;
  engine.answer = [](const std::vector<RefusedEdit>&) -> Engine::Refusals { return std::vector<RefusedEdit>(); };
  const auto textOf = [&](const Call& edit) {
    const Mismatch found = must(check(engine, {{}, {square("a", {0, 0}), edit}}));
    EXPECT_EQ(found.kind, Kind::verdict);
    return found.text;
  };
  EXPECT_EQ(textOf(square("b", {0, 0})), "accepted, but must be refused as overlap: 'b'\n");
  EXPECT_EQ(textOf(square("a", {1, 0})), "accepted, but must be refused as a bad name: 'a'\n");
  EXPECT_EQ(textOf(Call::remove("c")), "accepted, but must be refused as a bad name: 'c'\n");
}

TEST(CheckEngines, NoAnswerIsToldWithWhatItShouldHaveBeen) {
  Wrong engine;
  int commits = 0;
  engine.answer = [&](const std::vector<RefusedEdit>& refused) -> Engine::Refusals {
    if (++commits == 2) return tl::unexpected(Failure{Failure::Kind::hang, "is silent"});
    return refused;
  };
  const Mismatch found = must(check(engine, twoSquares()));
  EXPECT_EQ(found.kind, Kind::hang);
  EXPECT_EQ(found.text, "the engine is silent after edit 3\n");
  EXPECT_EQ(found.commit, 2U);
  EXPECT_EQ(found.expected.size(), 6U);
  EXPECT_EQ(found.actual, found.expected);
}

TEST(CheckEngines, AnIslandThatIsMissingIsTold) {
  Capabilities can = Capabilities::all();
  can.islands = true;
  Wrong engine(can);
  EXPECT_FALSE(check(engine, twoSquares()));
  engine.isIslandMissing = true;
  const Mismatch found = must(check(engine, twoSquares()));
  EXPECT_EQ(found.kind, Kind::views);
  EXPECT_TRUE(found.text.starts_with("missing island: westernmost vertex (0, 0)")) << found.text;
}

TEST(CheckEngines, OfJoinedSegmentsCgalTellsNoGhostsWhereSomethingIsPreserved) {
  Capabilities can = Capabilities::all();
  can.merged = true;
  Wrong engine(can);
  engine.change = [](Outline& o) {
    for (OutlineSegment& s : o) s.block = 9;
  };
  for (const bool preserves : {true, false}) {
    Trace trace{{}, {square("a", {0, 0}, 1), square("b", {1, 0}, 2)}};
    if (preserves) trace.preserve.add(1, 2);
    CheckStats stats;
    const Mismatch found = must(checked(trace, {.engine = &engine, .naive = false}, stats));
    EXPECT_EQ(found.can.ghosts, !preserves);
  }
}

// The limits of a cell are this library's; and some engines refuse nothing.
TEST(CheckEngines, AreNotAskedForWhatTheyNeedNotRefuse) {
  const Trace crowded = crowdedCase(Crowd::polygons, kCrowdedEdits, 1);
  Wrong engine;
  EXPECT_FALSE(check(engine, crowded));
  const auto isAdd = [](const Call& edit) { return edit.kind == Call::Kind::add; };
  const auto good = std::ranges::count_if(withoutRefused(crowded).calls, isAdd);
  EXPECT_LT(good, std::ranges::count_if(crowded.calls, isAdd));
  EXPECT_LE(engine.adds, 2 * static_cast<std::size_t>(good)) << "once, and at most once more in another order";

  Capabilities can = Capabilities::all();
  can.refuses = false;
  Wrong careless(can);
  EXPECT_FALSE(check(careless, {{}, {square("a", {0, 0}), square("b", {0, 0})}}));
  EXPECT_EQ(careless.adds, 1U + 1U) << "once, and once more in another order";
}

/// Why a trace can not be checked with an engine at all.
TraceError errorOf(const std::string& trace) {
  Wrong engine;
  CheckStats stats;
  const auto result = checkTrace(mustParse(trace), {.engine = &engine}, stats);
  return result ? TraceError{} : result.error();
}

TEST(CheckEngines, BrushesAreForThisLibraryAlone) {
  const TraceError error = errorOf("lgs-trace 2\ncommit\ncarve 0 0 1 0 1 1\n");
  EXPECT_EQ(error.line, 3U);
  EXPECT_EQ(error.text, "only this library's engine has such calls: carve  0 0 1 0 1 1");
}

TEST(CheckEngines, AnEditThatIsRightlyRefusedEndsIt) {
  const TraceError error = errorOf("lgs-trace 1\nadd a 0 0 1 0 0 1 0 1 1\nadd b 0 0 1 0 0 1 0 1 1\n");
  EXPECT_EQ(error.line, 3U);
  EXPECT_TRUE(error.text.starts_with("must be refused: ")) << error.text;
}

}  // namespace
}  // namespace lgs::oracle::engines
