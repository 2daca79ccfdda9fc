// Runs of suites of others by the command: what is played, what a job of CI is told, and a mismatch.
#include "oracle/tests/engines/workbench.h"

namespace lgs::test {
namespace {

class SuiteRuns : public Workbench {
 protected:
  void SetUp() override {
    Workbench::SetUp();
    put("two.wkt", "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON((2 2, 6 2, 6 6, 2 6, 2 2))\n");
    put("slanted.wkt", "POLYGON((0 0, 4 0, 4 4, 0 0))\nPOLYGON((2 2, 6 2, 6 6, 2 2))\n");
    put("flat.wkt", "POLYGON((0 0, 4 0, 0 0))\nPOLYGON((0 0, 4 0, 0 0))\n");
  }
  void expect(const Outcome& outcome, int status, const std::vector<std::string>& parts) const {
    EXPECT_EQ(outcome.status, status) << outcome.text;
    for (const std::string& part : parts) EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
  }
  /// It puts out nothing, whatever is painted.
  std::string empty(const std::string& words) const {
    put("engine.py",
        "import sys\nfor line in sys.stdin:\n"
        "  if line.startswith('lgs-engine'): print('lgs-engine 1 empty " +
            words + "', flush=True)\n  if line.startswith('commit'): print('end', flush=True)\n");
    return "exec " LGS_PYTHON " -S engine.py";
  }
};

TEST_F(SuiteRuns, ASuiteIsPlayedAndDrawn) {
  expect(
      sh("lgs check --suite two.wkt slanted.wkt --svg last.svg"), 0,
      {"suite      2 files, 8 cases\nplayed     8 cases, 0 of them rounded", "no mismatch\n", "picture    last.svg"});
  EXPECT_NE(get("last.svg").find("the last case of the suites"), std::string::npos);
  EXPECT_NE(get("last.svg").find(", 0) → ("), std::string::npos) << "what was painted, and no empty world";
  expect(sh("lgs check --suite two.wkt --case 3"), 0, {"played     1 case, "});
}

// Or a job of CI would be content with a suite of which it plays nothing.
TEST_F(SuiteRuns, WhatCanNotBePlayedIsNoSuccess) {
  expect(sh("lgs check --suite flat.wkt"), 2,
         {"left out   4 times: case without area", "no case of the suites can be"});
  expect(sh("lgs check --suite two.wkt flat.wkt"), 2, {"no case of flat.wkt can be played"});
  expect(check(empty("regions"), "--suite slanted.wkt two.wkt"), 2,
         {"times: case that the engine can not have: ", "no case of slanted.wkt can be played"});
  expect(check(empty("squares"), "--suite two.wkt"), 2, {"the engine does not say 'regions'"});
}

TEST_F(SuiteRuns, WhatAnEngineHasPaintedIsDrawn) {
  const std::string engine = exampleWith("squares_regions.py", {});
  for (const std::string report : {"", " --report r"}) {
    expect(check(engine, "--edits 60 --svg last.svg" + report), 0, {"no mismatch\n", "picture    last.svg"});
    EXPECT_NE(get("last.svg").find(", seed 1"), std::string::npos);
    EXPECT_NE(get("last.svg").find(") → ("), std::string::npos) << "what was painted, and no empty world";
    std::filesystem::remove(folder_ / "last.svg");
  }
}

TEST_F(SuiteRuns, AMismatchNamesItsCase) {
  const Outcome outcome = check(empty("regions"), "--suite two.wkt");
  expect(outcome, 1, {"case       ", "two.wkt:2: union", "missing solid", "mismatch-suite-0.trace"});
  expect(sh(afterWord(outcome.text, "again ")), 1, {"played     1 case, ", "missing solid"});
  expect(check(empty("regions"), "--suite two.wkt --json r.json"), 1, {"missing solid, 4 times; "});
  EXPECT_NE(get("r.json").find("\"count\": 4"), std::string::npos);
}

}  // namespace
}  // namespace lgs::test
