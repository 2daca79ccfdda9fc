// What a job of CI meets: known mismatches, what failed before, recommendations, results for other programs.
#include "oracle/tests/engines/workbench.h"

#include <algorithm>
#include <regex>

namespace lgs::test {
namespace {

class Ci : public Workbench {
 protected:
  std::string wrongLink() const { return naiveWith("into.get(a, []), -1)", "into.get(a, []), 1)"); }
  std::string missingCut() const {
    return naiveWith("for v in lines[1 - along].get(a[1 - along], ())", "for v in (a, b)");
  }
  std::string good() const { return naiveWith(Pieces()); }

  Outcome run(const std::string& engine, const std::string& arguments) const {
    return check(engine, "--edits 100 --shrink 60 " + arguments);
  }
  void expect(const std::string& engine, const std::string& arguments, int status, const std::string& part) const {
    const Outcome outcome = run(engine, arguments);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << part << "\n" << outcome.text;
  }
  bool has(const std::string& file, const std::string& part) const { return get(file).find(part) != std::string::npos; }
};

TEST_F(Ci, WhatIsKnownIsNoFaultUntilItIsGone) {
  expect(wrongLink(), "--known list --fix", 0, "fixed      list: 0 gone, ");
  EXPECT_TRUE(has("list", "\nknown wrong link\nlgs-trace 1\n"));
  expect(wrongLink(), "--known list --json r.json --junit r.xml", 0, "no mismatch that is not known");
  EXPECT_TRUE(has("r.json", "\"fine\": true") && has("r.json", "\"state\": \"known\""));
  EXPECT_TRUE(has("r.xml", " failures=\"0\"") && has("r.xml", "<skipped message=\"known\">lgs-trace 1\n"));
  expect(good(), "--known list --json r.json --junit r.xml", 1,
         "gone, and still in list (--fix takes it out): wrong link");
  EXPECT_TRUE(has("r.json", "\"fine\": false") && has("r.json", "\"gone\": [\n"));
  EXPECT_TRUE(has("r.xml", "<failure message=\"known, but gone: wrong link\">"));
  expect(good(), "--known list --fix", 0, " gone, 0 traces in all");
  EXPECT_FALSE(has("list", "wrong link"));
  expect(good(), "--known list", 0, "no mismatch\n");
}

TEST_F(Ci, WhatIsNotKnownIsAFault) {
  put("list", "known wrong link\nlgs-trace 1\nadd p1 0 0 1  1 1 0 1 0 0 1 0\nadd p2 1 1 1  1 0 1 1 0 1 0 0\n");
  expect(missingCut(), "--known list --json r.json --junit r.xml", 1, "missing cut, ");
  EXPECT_TRUE(has("r.json", "\"state\": \"fault\""));
  EXPECT_TRUE(has("r.xml", "name=\"missing cut 1\"><failure message=\"missing cut\">lgs-trace 1\n"));
  EXPECT_FALSE(has("r.xml", "failures=\"0\""));
  EXPECT_TRUE(get("list").starts_with("known wrong link")) << "without --fix it stays as it is";
}

// What an engine does at its end has no trace, so it can not be known, though other crashes are.
TEST_F(Ci, ABadEndIsAFault) {
  put("list", "known crash\nlgs-trace 1\nadd p1 0 0 1  0 0 1 0 1 1 0 1\nadd p2 3 0 1  0 0 1 0 1 1 0 1\n");
  const std::string line = "        elif word == \"commit\":\n", end = "\n\nmain()";
  const Pieces crash{{line, line + "            len(polygons) == 2 and __import__('os')._exit(3)\n"}};
  Pieces both = crash;
  both.emplace_back(end, end + "\nsys.exit(4)");
  EXPECT_EQ(check(naiveWith(crash), "--edits 1 --known list").status, 0);
  const Outcome outcome = check(naiveWith(both), "--edits 1 --known list --fix");
  EXPECT_EQ(outcome.status, 1) << outcome.text;
  EXPECT_NE(outcome.text.find("ended with status 4 at the end of its input"), std::string::npos) << outcome.text;
  EXPECT_TRUE(has("list", "known crash")) << "what is still there stays in the list";
}

TEST_F(Ci, WhatFailedIsKeptAndComesFirst) {
  const auto kept = [&] {
    return std::distance(std::filesystem::directory_iterator(folder_ / "kept"), std::filesystem::directory_iterator());
  };
  expect(wrongLink(), "--replay kept", 1, "MISMATCHES of some kinds");
  EXPECT_TRUE(has("kept/wrong-link.trace", "lgs-trace 1\n# wrong link\n"));
  const auto before = kept();
  put("kept/wrong-link.trace", std::regex_replace(get("kept/wrong-link.trace"), std::regex("add p"), "add other"));
  expect(wrongLink(), "--replay kept", 1, "MISMATCHES of some kinds");
  EXPECT_EQ(kept(), before) << "none is kept twice, under whatever names";
  expect(check(wrongLink(), "--edits 1 --replay kept").status == 1 ? good() : "false", "--replay kept", 0,
         "no mismatch\n");
  EXPECT_EQ(kept(), before);
  put("kept/bad.trace", "lgs-trace 1\nmove\n");
  expect(good(), "--replay kept", 2, "bad.trace:2");
}

TEST_F(Ci, AFolderIsReplayed) {
  std::filesystem::create_directories(folder_ / "f");
  for (const std::string name : {"f/a.trace", "f/b.trace"}) put(name, "lgs-trace 1\nadd a 0 0 1  0 0 1 0 1 1 0 1\n");
  put("f/note.txt", "this is none");
  const auto replay = [&](const std::string& arguments, int status, const std::string& part) {
    const Outcome outcome = sh("lgs replay f " + arguments);
    EXPECT_EQ(outcome.status, status) << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
  };
  replay("--check --engine \"" + good() + "\"", 0, "2 of 2 traces are fine\n");
  put("f/c.trace", "lgs-trace 1\nmove\n");
  replay("--check", 2, "2 of 3 traces are fine\n");
  replay("--svg s.svg", 2, "take one trace, not 3");
}

TEST_F(Ci, ARecommendationIsNoFault) {
  expect(wrongLink(), "--laws ghosts=should", 0, "wrong link, ");
  expect(wrongLink(), "--laws blocks=should", 1, "wrong link, ");
  expect(missingCut(), "--laws ghosts=should", 1, "missing cut, ");
  const std::string needless =
      exampleWith("incremental.py", {{"if new == old:", "if new == old and not (new and edited):"}});
  expect(needless, "--laws 'ghosts=should minimality=should' --json r.json", 0, "needless change, ");
  EXPECT_TRUE(has("r.json", "\"state\": \"advice\""));
  // What must hold is not hidden by it; and advice is shrunk whatever other advice there is.
  const Pieces both{{"if new == old:", "if new == old and not (new and edited):"},
                    {"for f in (way - 1, way, way + 1)", "for f in (way + 1, way, way - 1)"}};
  expect(exampleWith("incremental.py", both), "--laws 'minimality=should'", 1, "wrong link, ");
  expect(exampleWith("incremental.py", both), "--laws 'minimality=should ghosts=should' --report r", 0,
         "needless change, ");
  for (const std::string kind : {"needless-change", "wrong-link"}) {
    const std::string trace = get("r/" + kind + ".trace");
    EXPECT_LE(std::ranges::count(trace, '\n'), 5) << trace;
  }
}

TEST_F(Ci, ARunTakesATime) {
  const Outcome outcome = check(good(), "--time 0.5");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("no mismatch\nedits      "), std::string::npos) << outcome.text;
  EXPECT_EQ(check(good(), "--time 0.000001 --report r").status, 0);
  EXPECT_TRUE(has("r/report.md", " --time 1e-06 ") && has("r/report.md", "\n100 edits, ")) << get("r/report.md");
}

TEST_F(Ci, BadOnesAreTold) {
  put("list", "known wrong link\nlgs-trace 1\nmove\n");
  put("slants", "known wrong link\nlgs-trace 1\nadd p1 0 0 1  0 0 1 0 0 1\n");
  expect(good(), "--known list", 2, "list:3: ");
  expect(good(), "--known slants", 2, "slants: the engine can not have it: ");
  expect(good(), "--known none", 2, "none: ");
  expect(good(), "--fix", 2, "--fix requires --known");
  expect(good(), "--time 3", 2, "--edits");
  expect(good(), "--laws ghosts", 2, "'ghosts' is no such word");
  EXPECT_EQ(sh("lgs check --known list --edits 10").status, 2);
  EXPECT_EQ(sh("lgs check --json r.json --edits 10").status, 2);
}

}  // namespace
}  // namespace lgs::test
