// The report on a whole engine: kinds of findings, how often, and the smallest trace of each.
#include "oracle/check/comparable.h"
#include "oracle/check/survey.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/tests/engines/workbench.h"
#include "oracle/trace/file.h"
#include "proptests/support/must.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <regex>

namespace lgs::test {
namespace {

class Reports : public Workbench {
 protected:
  std::string page(const std::string& name) const {
    return oracle::readFile((folder_ / "report" / name).string()).value_or("");
  }

  /// Makes a report on an engine. It must have these kinds, each with a small trace, a picture and a page. There is
  /// time to shrink each as far as that goes: so a busy machine finds the same.
  void expectKinds(const std::string& engine, const std::vector<std::string>& kinds, int status = 1) const {
    const Outcome outcome = sh("lgs check " + engine + " --shrink 120 --report report" +
                               (engine.find("--edits") == std::string::npos ? " --edits 200" : ""));
    EXPECT_EQ(outcome.status, status) << outcome.text;
    for (const std::string& kind : kinds) expectKind(kind);
  }

  void expectKind(std::string kind) const {
    EXPECT_NE(page("report.md").find("| " + kind + " | "), std::string::npos) << kind << "\n" << page("report.md");
    EXPECT_NE(page("report.html").find(">" + kind + "</a>"), std::string::npos) << kind;
    std::replace(kind.begin(), kind.end(), ' ', '-');
    const auto parsed = oracle::parseTrace(page(kind + ".trace"));
    EXPECT_FALSE(parsed.error) << kind;
    EXPECT_LE(oracle::editCount(parsed.trace), 4U) << kind << "\n" << page(kind + ".trace");
    EXPECT_NE(page(kind + ".svg").find("<svg"), std::string::npos) << kind;
    EXPECT_NE(page(kind + ".html").find("<script"), std::string::npos) << kind;
  }
};

// An engine for each kind of finding: naive.py with some pieces replaced.
struct Canary {
  std::string kind;
  std::vector<std::pair<std::string, std::string>> replaced;
};

const std::vector<Canary> kCanaries{
    {"missing cut", {{"for v in lines[1 - along].get(a[1 - along], ())", "for v in (a, b)"}}},
    {"uncancelled edge", {{"e[::-1] not in edges or", "True or"}}},
    {"lost preserve", {{"in preserve}", "in ()}"}}},
    {"wrong link", {{"into.get(a, []), -1)", "into.get(a, []), 1)"}}},
    {"wrong block", {{"out_of.get(b, []), 1), block", "out_of.get(b, []), 1), polygons[0][0]"}}},
    {"stale ghost",
     {{"def main():", "seen = {}\n\n\ndef main():"},
      {"polygons, preserve = {}, set()\n        elif", "polygons, preserve = {}, set(); seen.clear()\n        elif"},
      {"in outline(list(polygons.values()), preserve):",
       "in outline(list(polygons.values()), preserve):\n"
       "                points[2] = seen.setdefault((points[0], points[1]), points[2])"}}},
    {"order of edits matters", {{"del polygons[rest[0]]", "polygons.popitem()"}}},
    {"wrong island", {{"not points.isdisjoint(f[0])", "len(points & f[0]) > 1"}}},
    {"wrong island", {{"area += other[1]", "pass"}}},
    {"refusal", {{"several preserve", "several refuses"}, {"del polygons[rest[0]]", "polygons.pop(rest[0], None)"}}},
    {"protocol", {{"del polygons[rest[0]]", "polygons or 0; print('removed')"}}},
    {"crash", {{"del polygons[rest[0]]", "polygons or 0; sys.exit(7)"}}},
    {"hang",
     {{"polygons[rest[0]] = block, ",
       "\n            while len(polygons) == 2: pass\n"
       "            polygons[rest[0]] = block, "}}},
};

// A report goes to people who did not choose the engine.
TEST_F(Reports, NameAnEngineAsTextAndNothingElse) {
  const std::string engine = naiveWith({{"lgs-engine 1 naive.py", "lgs-engine 1 <img/src=x>[a](b)"}});
  EXPECT_EQ(sh("lgs check --engine \"" + engine + "\" --edits 20 --report report").status, 0);
  EXPECT_EQ(page("report.md").find("<img"), page("report.md").find("\\<img") + 1) << page("report.md");
  EXPECT_NE(page("report.md").find("\\[a\\](b)"), std::string::npos) << page("report.md");
  EXPECT_EQ(page("report.html").find("<img/"), std::string::npos) << page("report.html");
}

TEST_F(Reports, HaveEachKindOfFinding) {
  for (const auto& [kind, replaced] : kCanaries)
    expectKinds("--engine \"" + naiveWith(replaced) + "\"" + (kind == "refusal" ? " --edits 1000" : "") +
                    (kind == "hang" ? " --engine-timeout 3" : ""),
                {kind});
}

// An engine that does not end has a report as well.
TEST_F(Reports, AreOfBadEndingsToo) {
  expectKinds("--engine \"" + naiveWith("\n\nmain()", "\n\nmain()\nsys.exit(4)") + "\"", {"crash"});
  EXPECT_NE(page("report.md").find("    the engine ended with status 4 at the end of its input"), std::string::npos)
      << page("report.md");
}

// What an engine says is shown, but it is no part of the page, and ends no block.
TEST_F(Reports, ShowWhatAnEngineSays) {
  const std::string text = "'<b>\\n```\\n\\x1b[1m\\udcff'";
  expectKinds(
      "--engine \"" + naiveThat("sys.stderr.reconfigure(errors='surrogateescape'); sys.exit(" + text + ")") + "\"",
      {"crash"});
  EXPECT_NE(page("report.md").find("| crash | 2 |"), std::string::npos) << "each world is tried once";
  const std::string md = page("report.md"), html = page("report.html");
  EXPECT_NE(md.find("\n    <b>\n    ```\n     [1m\xef\xbf\xbd\n"), std::string::npos) << md;
  EXPECT_NE(html.find("\n&lt;b&gt;\n```\n [1m\xef\xbf\xbd\n"), std::string::npos) << html;
}

TEST_F(Reports, OnThePublishedAlgorithm) {
  expectKinds("--edits 1000 --engine-so '" LGS_PUBLISHED_SO "'",
              {"missing cut", "uncancelled edge", "lost preserve", "wrong block"});
}

TEST_F(Reports, OnASharedObjectThatCrashes) {
  expectKinds("--engine-so '" LGS_BAD_SO "'", {"other segments"});
  ASSERT_EQ(::setenv("LGS_BAD", "crash", 1), 0);
  expectKinds("--engine-so '" LGS_BAD_SO "'", {"crash"});
  ::unsetenv("LGS_BAD");
  EXPECT_NE(page("report.md").find("the engine crashed with SIGABRT after edit 1"), std::string::npos);
}

TEST_F(Reports, OnAGoodEngine) {
  expectKinds("--engine-so '" LGS_ENGINE_SO "'", {}, 0);
  EXPECT_NE(page("report.md").find("No mismatch."), std::string::npos);
}

TEST_F(Reports, AreOfOneCaseToo) {
  const std::string lgs = "lgs check --engine-so '" LGS_PUBLISHED_SO "' --case 3 --shrink 0 --report report";
  EXPECT_EQ(sh(lgs).status, 1);
  const std::string md = page("report.md"), command = afterWord(md, "    cd ");
  EXPECT_NE(command.find(" --case 3 "), std::string::npos) << command;
  EXPECT_EQ(sh("cd " + command + " --shrink 0").status, 1);
  EXPECT_EQ(page("report.md"), md);
}

TEST_F(Reports, NeedAnEngineAndAFolder) {
  EXPECT_EQ(sh("lgs check --report r --edits 10").status, 2);
  EXPECT_EQ(sh("touch f; lgs check --engine-so '" LGS_ENGINE_SO "' --report f --edits 10").status, 2);
}

// An engine may put out very much: the picture and the page stay small, and say so. None of it takes quadratic time.
TEST_F(Reports, StaySmall) {
  oracle::Mismatch found;
  found.kind = oracle::Mismatch::Kind::naive;
  for (std::int64_t k = 1; k <= 30'000; ++k) {
    found.actual.push_back({{0, 0}, {k, 1}, 1, {}, {}});
    found.actual.push_back({{k, 1}, {0, 0}, 1, {}, {}});
  }
  std::ranges::sort(found.actual);
  for (const std::string& shown : {oracle::draw(found), oracle::page(found, oracle::Trace())}) {
    EXPECT_NE(shown.find("(58,000 segments more that differ are left out)"), std::string::npos);
    EXPECT_LT(shown.size(), 4'000'000U);
  }
  EXPECT_EQ(oracle::compare(found.expected, found.actual).size(), 60'000U);
}

// The steps before the last one show no more than the last: nothing that the engine does not put out.
TEST_F(Reports, PagesShowWhatIsCompared) {
  const auto square = [](Cell cell) {
    constexpr std::int32_t U = kUnitsPerCell;
    return oracle::ScenePolygon{cell, 1, {{0, 0}, {U, 0}, {U, U}, {0, U}}};
  };
  const oracle::Trace trace{{},
                            {oracle::Call::add("a", square({0, 0})), oracle::Call::commit(),
                             oracle::Call::add("b", square({1, 0})), oracle::Call::commit()}};
  oracle::Mismatch found;
  found.kind = oracle::Mismatch::Kind::naive;
  found.edits = trace.calls.size();
  found.scene.polygons = {square({0, 0}), square({1, 0})};
  for (const bool ghosts : {true, false}) {
    found.can.ghosts = ghosts;
    found.expected = oracle::comparable(oracle::naiveOutline(found.scene), found.can);
    std::smatch ghost;
    const std::string html = oracle::page(found, trace);
    EXPECT_EQ(std::regex_search(html, ghost, std::regex("\"ghost1\":[0-9]")), ghosts) << ghost.str();
  }
}

// It never answers.
class Hanging : public oracle::Engine {
 public:
  void reset(const oracle::PreservePairs&) override {}
  void add(const std::string&, const oracle::ScenePolygon&) override {}
  void remove(const std::string&) override {}
  Refusals commit() override { return tl::unexpected(oracle::Failure{oracle::Failure::Kind::hang, "hangs"}); }
  oracle::Outline outline() const override { return {}; }
  void hurry(Haste haste) override { haste_ = haste; }

  Haste haste_ = Haste::none;
};

// The report is there from the first finding on, whatever becomes of the run. The fourth hang is not waited for.
TEST_F(Reports, AreWrittenAsTheRunGoes) {
  std::filesystem::create_directories(folder_ / "report");
  Hanging engine;
  const oracle::CheckOptions options{.engine = &engine, .skipRefused = true};
  oracle::Survey survey(options, {(folder_ / "report").string(), "lgs check", std::chrono::milliseconds(10)});
  const oracle::Trace trace{{}, {oracle::Call::commit()}};
  const auto found = must(oracle::findMismatch(trace, options));
  for (const int count : {1, 2, 3, 4}) {
    survey.add(found, trace, {});
    EXPECT_NE(page("report.md").find("| hang | " + std::to_string(count) + " |"), std::string::npos);
    EXPECT_EQ(engine.haste_, count >= 3 ? oracle::Engine::Haste::some : oracle::Engine::Haste::none);
  }
}

}  // namespace
}  // namespace lgs::test
