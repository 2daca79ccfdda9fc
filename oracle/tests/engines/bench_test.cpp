// `lgs bench` with an engine of others.
#include "oracle/tests/engines/workbench.h"

#include "oracle/check/shell.h"

namespace lgs::test {
namespace {

class Bench : public Workbench {
 protected:
  Outcome bench(const std::string& engine, const std::string& arguments) const {
    return sh("lgs bench --engine " + oracle::shellWord(engine) + " --side 8 --rounds 1 " + arguments);
  }
  void expect(const Outcome& outcome, int status, const std::string& part, bool isThere = true) const {
    EXPECT_EQ(outcome.status, status) << outcome.text;
    EXPECT_EQ(outcome.text.find(part) != std::string::npos, isThere) << part << "\n" << outcome.text;
  }
};

TEST_F(Bench, TakesTheTimeThatAnEngineTells) {
  const Outcome outcome =
      bench(exampleWith("incremental.py", {{"{time.perf_counter_ns() - begin}", "123456789"}}), "--json r.json");
  expect(outcome, 0, "123.46 ms");
  expect(outcome, 0, "tell its time", false);
  EXPECT_NE(
      get("r.json").find("\"scenario\": \"edit-8\",\n  \"subject\": \"incremental.py\",\n  \"median_ns\": 123456789"),
      std::string::npos)
      << get("r.json");
  expect(outcome, 0, "ramp-8", false);
}

TEST_F(Bench, SaysThatThePipeIsInAnyOther) {
  const Outcome outcome = bench("exec " LGS_PYTHON " '" LGS_SOURCE_DIR "/examples/engines/naive.py'", "");
  expect(outcome, 0, "naive.py does not tell its time: in its times are the pipe, what it puts out, and reading that.");
  for (const std::string subject : {"engine-shapes", "cgal"}) expect(outcome, 0, subject);
  const Outcome loaded = sh("lgs bench --engine-so '" LGS_ENGINE_SO "' --side 8 --rounds 1");
  expect(loaded, 0, "LocalGridSeg does not tell its time: in its times are what it puts out, and reading that.");
  expect(loaded, 0, "edit-ramp-8");
}

TEST_F(Bench, AWrongOneHasNoTimes) {
  expect(bench(exampleWith("incremental.py", {{"if new == old:", "if new == old or len(told) > 50:"}}), ""), 1,
         "incremental.py: MISMATCH with the engine");
  expect(bench(naiveThat("os._exit(3)"), ""), 1, "naive.py: refuses the input");
  expect(bench("no-such-program", ""), 2, "there is no engine to check");
  expect(bench(exampleWith("incremental.py", {{"squares ghosts", "squares cells=5 ghosts"}}), ""), 2, "give a --side");
}

}  // namespace
}  // namespace lgs::test
