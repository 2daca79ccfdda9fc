// The report on a whole engine: kinds of findings, how often, and the smallest trace of each.
#include "oracle/trace/file.h"
#include "proptests/engines/workbench.h"

#include <algorithm>
#include <vector>

namespace lgs::test {
namespace {

class Reports : public Workbench {
 protected:
  std::string page(const std::string& name) const {
    return oracle::readFile((folder_ / "report" / name).string()).value_or("");
  }

  /// Makes a report on an engine. It must have these kinds, each with a small trace, a picture and a page.
  void expectKinds(const std::string& engine, const std::vector<std::string>& kinds, int status = 1) const {
    const Outcome outcome = sh("lgs check " + engine + " --engine-timeout 1 --edits 1000 --shrink 5 --report report");
    EXPECT_EQ(outcome.status, status) << outcome.text;
    for (std::string kind : kinds) {
      EXPECT_NE(page("report.md").find("| " + kind + " | "), std::string::npos) << kind << "\n" << page("report.md");
      EXPECT_NE(page("report.html").find(">" + kind + "</a>"), std::string::npos) << kind;
      std::replace(kind.begin(), kind.end(), ' ', '-');
      const auto parsed = oracle::parseTrace(page(kind + ".trace"));
      EXPECT_FALSE(parsed.error) << kind;
      EXPECT_LE(oracle::editCount(parsed.trace), 4U) << kind << "\n" << page(kind + ".trace");
      EXPECT_NE(page(kind + ".svg").find("<svg"), std::string::npos) << kind;
      EXPECT_NE(page(kind + ".html").find("<script"), std::string::npos) << kind;
    }
  }
};

TEST_F(Reports, OnThePublishedAlgorithm) {
  expectKinds("--engine-so '" LGS_PUBLISHED_SO "'",
              {"missing cut", "uncancelled edge", "lost preserve", "wrong block"});
}

TEST_F(Reports, OnAnEngineThatForgetsWhatItShouldNot) {
  const std::string engine = naiveWith("del polygons[rest[0]]", "polygons.popitem()");
  expectKinds("--engine \"" + engine + "\"", {"order of edits matters"});
}

TEST_F(Reports, OnAnEngineThatCrashes) {
  const std::string engine = naiveWith("del polygons[rest[0]]", "polygons or 0; sys.exit(7)");
  expectKinds("--engine \"" + engine + "\"", {"crash"});
}

TEST_F(Reports, OnAGoodEngine) {
  expectKinds("--engine-so '" LGS_ENGINE_SO "'", {}, 0);
  EXPECT_NE(page("report.md").find("No mismatch."), std::string::npos);
}

TEST_F(Reports, NeedAnEngineAndAFolder) {
  EXPECT_EQ(sh("lgs check --report r --edits 10").status, 2);
  EXPECT_EQ(sh("touch f; lgs check --engine-so '" LGS_ENGINE_SO "' --report f --edits 10").status, 2);
}

}  // namespace
}  // namespace lgs::test
