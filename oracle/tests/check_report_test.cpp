// What is printed and saved of a mismatch, for engines that are wrong once there are two polygons.
#include "checking.h"
#include "oracle/check/levels.h"
#include "oracle/check/reference_engine.h"
#include "oracle/check/report.h"
#include "oracle/check/shell.h"
#include "oracle/check/survey.h"
#include "oracle/trace/file.h"
#include "proptests/support/command.h"
#include "proptests/support/must.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>

namespace lgs::oracle::reporting {
namespace {

using namespace std::chrono_literals;
using test::must;

/// Four squares, each committed. What an engine gets wrong with two of them shows after the fourth edit.
Trace fourSquares() {
  Trace trace;
  for (std::int32_t i = 0; i < 4; ++i) {
    trace.calls.push_back(square("s" + std::to_string(i), {3 * i, 0}, 5));
    trace.calls.push_back(Call::commit());
  }
  return trace;
}

/// The naive reference, but for what a test makes of its outline once it has that many segments.
class Wrong : public ReferenceEngine {
 public:
  explicit Wrong(std::function<void(Outline&)> change, std::size_t from = 8)
      : ReferenceEngine(true, false), change_(std::move(change)), from_(from) {}
  Outline outline() const override {
    Outline outline = ReferenceEngine::outline();
    if (outline.size() >= from_) change_(outline);
    return outline;
  }
  void restart() override { ++restarts; }

  int restarts = 0;

 private:
  std::function<void(Outline&)> change_;
  std::size_t from_;
};

class CheckReport : public test::InAFolder {
 protected:
  std::string reported(const Trace& trace, const CheckOptions& options, const ReportOptions& report) const {
    testing::internal::CaptureStdout();
    reportMismatch(must(findMismatch(trace, options)), trace, options, report);
    return testing::internal::GetCapturedStdout();
  }
  ReportOptions to(std::chrono::milliseconds shrinkFor) const {
    return {path("some where"), "found", "lgs check --again", shrinkFor, "LGS", " --engine E"};
  }
  Trace saved() const {
    const ParsedTrace parsed = parseTrace(get("some where/found.trace"));
    EXPECT_FALSE(parsed.error);
    return parsed.trace;
  }
  static void expectSaid(const std::string& text, const std::string& part, bool isThere = true) {
    EXPECT_EQ(text.find(part) != std::string::npos, isThere) << part << "\nin\n" << text;
  }
};

TEST_F(CheckReport, HasTheSmallestTraceAndWhereItIs) {
  Wrong engine([](Outline& o) { o.pop_back(); });
  const std::string text = reported(fourSquares(), {.engine = &engine}, to(60s)), base = path("some where/found");
  EXPECT_TRUE(text.starts_with("MISMATCH after edit 4 (2 commits): the outline differs from the naive reference's:\n"))
      << text;
  expectSaid(text, "\nshrinking the trace of 4 lines …\n\nlgs-trace 1\n");
  expectSaid(text, "\n\nafter edit 2 (1 commit): the outline differs from the naive reference's:\nmissing segment: ");
  expectSaid(text, "\ntrace      " + base + ".trace\npicture    " + base + ".svg\npage       " + base + ".html\n");
  expectSaid(text, "\nagain      lgs check --again\nlook at it cd " + thisFolder() + " && LGS replay '" + base +
                       ".trace' --check --engine E --svg '" + base + ".svg'\n");
  expectSaid(text, "but not again", false);
  EXPECT_EQ(editCount(saved()), 2U);
  EXPECT_EQ(saved().calls.size(), 2U);
  expectSaid(get("some where/found.trace"), "\n# lgs check --again\n");
  expectSaid(get("some where/found.svg"), "<svg");
  const std::string page = get("some where/found.html");
  expectSaid(page, "<title>the outline differs from the naive reference's</title>");
  expectSaid(page, "\"expectedName\":\"naive reference\"");
}

// As decodeURIComponent() reads it.
TEST_F(CheckReport, HasALinkWhereTheSandboxIsServed) {
  Wrong engine([](Outline& o) { o.pop_back(); });
  ReportOptions report = to(60s);
  report.site = "http://host/a/";
  expectSaid(reported(fourSquares(), {.engine = &engine}, report),
             "\nlink       http://host/a/#plain=lgs-trace%201%0Aadd%20p1%200%200%201%20%200%200%20");
  expectSaid(reported(fourSquares(), {.engine = &engine}, to(60s)), "\nlink ", false);
  Trace many;
  for (int k = 0; k < 200; ++k) many.calls.push_back(square(std::to_string(k), {k, 0}));
  EXPECT_EQ(linkTo(report.site, many), "") << "it is too long";
  EXPECT_EQ(linkTo(report.site, {}), "");
}

TEST_F(CheckReport, ReplacesNothingOfAnEarlierRun) {
  Wrong engine([](Outline& o) { o.pop_back(); });
  Trace other = fourSquares();
  other.calls.insert(other.calls.begin(), square("more", {0, 3}));
  for (const Trace& trace : {fourSquares(), other, fourSquares(), other}) reported(trace, {.engine = &engine}, to(0ms));
  EXPECT_EQ(saved().calls.size(), 4U);
  EXPECT_EQ(parseTrace(get("some where/found.2.trace")).trace.calls.size(), 3U);
  for (const std::string name : {"found.2.svg", "found.2.html"}) EXPECT_NE(get("some where/" + name), "") << name;
  EXPECT_FALSE(std::filesystem::exists(path("some where/found.3.trace"))) << "but by the same";
}

TEST_F(CheckReport, WithoutTimeHasTheTraceUpToTheMismatch) {
  Wrong engine([](Outline& o) { o.pop_back(); });
  const Trace trace = fourSquares();
  const std::string text = reported(trace, {.engine = &engine}, to(0ms));
  expectSaid(text, "shrinking", false);
  EXPECT_EQ(saved(), (Trace{{}, {trace.calls.begin(), trace.calls.begin() + 4}}));
}

TEST_F(CheckReport, SaysThatItWasNotThereAgain) {
  int answers = 0;
  Wrong engine([&](Outline& o) {
    if (answers++ == 0) o.pop_back();
  });
  const std::string text = reported(fourSquares(), {.engine = &engine}, to(1s));
  expectSaid(text, "\nbut not again: the engine does not always do the same, or keeps something when it is reset\n");
  EXPECT_EQ(saved().calls.size(), 4U);
  EXPECT_GT(engine.restarts, 0);
}

// It is there again in the trace itself and in the first one that is smaller, and then no more.
TEST_F(CheckReport, OfWhatIsNotThereAgainHasTheTraceAsItWas) {
  Wrong engine([](Outline& o) { o.pop_back(); });
  const Trace trace = fourSquares();
  const Mismatch found = must(findMismatch(trace, {.engine = &engine}));
  int times = 0;
  const auto findAgain = [&](const Trace&) { return times++ < 2 ? std::optional(found) : std::nullopt; };
  testing::internal::CaptureStdout();
  reportMismatch(found, trace, findAgain, to(60s));
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_EQ(saved(), untilFound(trace, found));
  expectSaid(text, "but not again", false);
  expectSaid(text, "again      lgs check --again\n");
  expectSaid(text, "look at it", false);
}

TEST_F(CheckReport, SaysWhereNothingIsIfItCanNotBeWritten) {
  std::filesystem::create_directories(path("some where/found.html"));
  Wrong engine([](Outline& o) { o.pop_back(); });
  testing::internal::CaptureStderr();
  const std::string text = reported(fourSquares(), {.engine = &engine}, to(0ms));
  expectSaid(testing::internal::GetCapturedStderr(), "found.html");
  expectSaid(text, "picture", false);
  expectSaid(text, "\nagain      lgs check --again\n");
  expectSaid(text, "look at it", false);
  EXPECT_EQ(saved().calls.size(), 4U);
}

TEST_F(CheckReport, HasNoTraceThatIsTooLongToRead) {
  Trace trace;
  for (std::int32_t i = 0; i < 41; ++i) trace.calls.push_back(square("s" + std::to_string(i), {3 * i, 0}));
  Wrong engine([](Outline& o) { o.pop_back(); });
  expectSaid(reported(trace, {.engine = &engine}, to(0ms)),
             "\n41 edits are left, too many to print here\nafter edit 41");
  trace.calls.pop_back();
  expectSaid(reported(trace, {.engine = &engine}, to(0ms)), "\nlgs-trace 1\n# ", false);
  expectSaid(reported(trace, {.engine = &engine}, to(0ms)), "\nlgs-trace 1\nadd s0 ");
}

TEST_F(CheckReport, OfACrashHasTheSmallestTraceThatCrashes) {
  Wrong engine([](Outline&) { std::abort(); });
  testing::internal::CaptureStdout();
  reportCrash("crashed with SIGABRT", fourSquares(), {.engine = &engine}, to(60s));
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(text.starts_with("MISMATCH the engine crashed with SIGABRT\nshrinking the trace of 8 lines …\n")) << text;
  expectSaid(text, "\n\nthe engine crashed with SIGABRT\n\ntrace ");
  expectSaid(text, "\nlook at it ");
  EXPECT_EQ(saved().calls.size(), 2U);
  expectSaid(get("some where/found.svg"), "the engine crashed with SIGABRT");
}

TEST_F(CheckReport, OfACrashShowsWhatIsPreserved) {
  Trace trace{{}, {square("a", {0, 0}, 1), square("b", {1, 0}, 2)}};
  const std::string without = drawWithoutEngine(trace, "title");
  trace.preserve.add(1, 2);
  EXPECT_NE(drawWithoutEngine(trace, "title"), without);
}

TEST_F(CheckReport, OfACrashThatIsNotThereAgain) {
  ReferenceEngine engine(true, false);
  testing::internal::CaptureStdout();
  reportCrash("hung", fourSquares(), {.engine = &engine}, to(1s));
  const std::string text = testing::internal::GetCapturedStdout();
  expectSaid(text, "\nthe engine hung, but not again\n");
  expectSaid(text, "look at it", false);
  EXPECT_EQ(saved(), fourSquares());
}

TEST_F(CheckReport, IsNoSmallerThanWhatABegunEngineShows) {
  Wrong engine([](Outline&) {});
  const Trace trace = fourSquares();
  Mismatch found;
  found.edits = 4;
  const auto untilRestarted = [&](const Trace&) { return engine.restarts == 0 ? std::optional(found) : std::nullopt; };
  EXPECT_EQ(shrinkWithEngine(found, trace, engine, untilRestarted, 60s), untilFound(trace, found));
}

// --- The report on a whole engine -------------------------------------------------------------------------------------

class CheckSurvey : public CheckReport {
 protected:
  void SetUp() override {
    CheckReport::SetUp();
    std::filesystem::create_directories(path("report"));
  }
  Survey survey(Engine* engine) const {
    return Survey({.engine = engine}, {path("report"), "lgs check --all", 60s, 3, {}, "../site/"});
  }
  static void add(Survey& survey, Engine& engine, const Trace& trace) {
    survey.add(must(findMismatch(trace, {.engine = &engine})), trace, {.edits = 12, .commits = 1});
  }
};

TEST_F(CheckSurvey, KeepsTheSmallestTraceOfEachKind) {
  Wrong engine([](Outline& o) { o[0].block = 9; });
  Survey all = survey(&engine);
  add(all, engine, fourSquares());
  const std::string md = get("report/report.md");
  expectSaid(md, "# oracle under the harness\n\n12 edits, 1 commit. ");
  expectSaid(md,
             "\n| wrong block | 1 | [2 edits](wrong-block.trace) | [wrong-block.svg](wrong-block.svg) | "
             "[wrong-block.html](wrong-block.html) |\n");
  expectSaid(md, "\n## wrong block\n\n    lgs-trace 1\n    add p1 ");
  expectSaid(md, "\n    after edit 2 (1 commit): the outline differs from the naive reference's:\n    wrong block: ");
  expectSaid(md, "\n[in the sandbox](../site/#plain=lgs-trace%201%0Aadd%20p1%20");
  expectSaid(get("report/report.html"), "<p><a href=\"../site/#plain=lgs-trace%201%0Aadd%20p1%20");
  expectSaid(get("report/report.html"),
             "<tr><td><a href=\"#wrong-block\">wrong block</a><td>1<td><a "
             "href=\"wrong-block.trace\">2 edits</a>");
  expectSaid(get("report/wrong-block.trace"), "lgs-trace 1\n# wrong block\nadd p1 ");
  expectSaid(get("report/wrong-block.svg"), "<svg");
  expectSaid(get("report/wrong-block.html"), "<script");
}

// With one polygon the links are wrong, with two the blocks: that is another fault.
TEST_F(CheckSurvey, ShrinksNoFaultToAnother) {
  Wrong engine(
      [](Outline& o) {
        if (o.size() < 8)
          o[0].ghost1 = o[0].end;
        else
          o[0].block = 9;
      },
      1);
  Survey all = survey(&engine);
  Trace trace{{}, {square("a", {0, 0}), square("b", {3, 0})}};
  add(all, engine, trace);
  expectSaid(get("report/report.md"), "| wrong block | 1 | [2 edits]");
  trace.calls.pop_back();
  add(all, engine, trace);
  expectSaid(get("report/report.md"), "| wrong link | 1 | [1 edit]");
}

TEST_F(CheckSurvey, ShrinksAdviceThatComesBehindOtherAdvice) {
  Wrong engine([](Outline& o) { o.size() == 8 ? void(o[0].ghost1 = o[0].end) : void(o[0].block = 9); });
  CheckOptions options{.engine = &engine, .recommended = parseLaws("ghosts=should blocks=should").value()};
  Survey all(options, {path("report"), "lgs check --all", 60s});
  std::vector<Mismatch> advice;
  options.advise = [&](const Mismatch& found) { advice.push_back(found); };
  EXPECT_FALSE(findMismatch(fourSquares(), options));
  for (const Mismatch& found : advice) all.add(found, fourSquares(), {});
  expectSaid(get("report/report.md"), "| wrong link | 1 | [2 edits]");
  expectSaid(get("report/wrong-block.trace"), "commit", false);
}

TEST_F(CheckSurvey, LooksForWhatIsNewBehindAnyNumberOfKnownOnes) {
  std::size_t from = 4;
  Wrong engine([&](Outline& o) { o[0].block = o.size() < from ? o[0].block : 9; }, 1);
  Survey first = survey(&engine);
  add(first, engine, fourSquares());
  Survey all({.engine = &engine}, {path("report"), "", 60s, 1, first.faults()});
  for (int k = 0; k < 3; ++k) add(all, engine, fourSquares());
  EXPECT_TRUE(all.faults().empty());
  from = 8;
  for (const std::uint64_t onlyCounted : {0U, 1U}) {
    add(all, engine, fourSquares());
    EXPECT_EQ(all.faults().size(), 1U);
    EXPECT_EQ(all.kinds().at("wrong block").onlyCounted(), onlyCounted);
  }
}

TEST_F(CheckSurvey, HasFailuresWithoutATrace) {
  Survey all = survey(nullptr);
  EXPECT_TRUE(all.isEmpty());
  all.add(Failure{Failure::Kind::hang, "is silent"});
  EXPECT_TRUE(std::filesystem::exists(path("report/hang.svg")));
  all.add(Failure{Failure::Kind::hang, "is silent again"});
  EXPECT_FALSE(all.isEmpty());
  EXPECT_TRUE(all.write({}));
  const std::string md = get("report/report.md");
  expectSaid(md, "# An engine under the harness\n\nIt has not started.\n\n    lgs check --all\n");
  expectSaid(md, "\n| hang | 2 | [0 edits](hang.trace) | ");
  expectSaid(md, "    the engine is silent\n");
}

TEST_F(CheckSurvey, SaysThatThereIsNothing) {
  ReferenceEngine engine(true, false);
  EXPECT_TRUE(survey(&engine).write({}));
  expectSaid(get("report/report.md"), "\n\nNo mismatch.\n");
  EXPECT_FALSE(Survey({.engine = &engine}, {path("nowhere"), "", 0s}).write({}));
}

}  // namespace
}  // namespace lgs::oracle::reporting
