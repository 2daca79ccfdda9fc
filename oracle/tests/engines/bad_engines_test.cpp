// Engines that misbehave: each is found out in time, nothing hangs, and no process is left behind.
#include "oracle/tests/engines/workbench.h"

namespace lgs::test {
namespace {

class BadEngines : public Workbench {
 protected:
  /// Of an engine that hangs the timeout is waited for, several times. Of the others nobody waits for it.
  void expectTold(const std::string& engine, const std::string& part, int timeout = kPatience) const {
    const Outcome outcome = check(engine, "--edits 200 --shrink 0.5", timeout);
    EXPECT_EQ(outcome.status, 1) << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << part << "\n" << outcome.text;
    EXPECT_LT(outcome.seconds, kPatience) << "timeout, shrinking, looking again";
    EXPECT_FALSE(isAnyoneLeft());
  }
};

TEST_F(BadEngines, Hangs) {
  expectTold(naiveThat("time.sleep(1000 if len(polygons) > 2 else 0.8)"),
             "has not answered within 3 s (perhaps it is slow, and not stuck: it needed ", 3);
}

TEST_F(BadEngines, IsBusyForEver) {
  expectTold(naiveThat("while True: pass"), "has not answered within 3 s after edit", 3);
}

TEST_F(BadEngines, Dies) { expectTold(naiveThat("os._exit(3)"), "the engine ended with status 3 after edit"); }

TEST_F(BadEngines, EndsWithoutAnAnswer) {
  expectTold(naiveThat("return"), "the engine ended with status 0 before it has answered after edit");
}

TEST_F(BadEngines, Crashes) {
  expectTold(naiveThat("os.kill(os.getpid(), signal.SIGSEGV)"), "the engine crashed with SIGSEGV after edit");
}

TEST_F(BadEngines, TellsWhyInItsLog) { expectTold(naiveThat("raise ValueError('my fault')"), "ValueError: my fault"); }

TEST_F(BadEngines, PrintsGarbage) {
  expectTold(naiveThat("print('\\1garbage', flush=True)"),
             "the engine answered '?garbage': a line of an answer begins with refused, segment, island, end or #");
}

TEST_F(BadEngines, EndsItsLinesAsWindowsDoes) {
  expectTold(naiveThat("print('end\\r', flush=True)"), "the engine answered 'end?': lines end with a line feed alone");
}

TEST_F(BadEngines, PrintsALineWithoutEnd) {
  expectTold(naiveThat("\n            while True: print('x' * 9999, end='')"), "a line of more than 1 MiB");
}

TEST_F(BadEngines, AnswersWithoutEnd) {
  expectTold(naiveThat("\n            while True: print('# ' + 'x' * 9999)"), "answers without end: more than 64 MiB");
}

TEST_F(BadEngines, AnswersTooMuch) {
  expectTold(naiveThat("os.write(1, b'end\\nend\\n')"), "it was not asked");  // at once, so that both are read at once
}

TEST_F(BadEngines, AreWrongForAWhileOnly) {
  const char* const forAWhile =
      "log = open('commits', 'a+'); log.write('x'); log.seek(0); len(log.read()) < 2 and print('end')";
  expectTold(naiveThat(forAWhile), "but not again: the engine does not always do the same");
}

TEST_F(BadEngines, ClosesItsOutput) {
  expectTold(naiveThat("os.close(1); time.sleep(1000)"), "closed its output, and lives on", 3);
}

TEST_F(BadEngines, FloodsItsLog) {
  expectTold(naiveThat("\n            while True: sys.stderr.write('x' * 65536)"), "floods its log");
}

TEST_F(BadEngines, DoesNotRead) {
  expectTold(naiveWith("for line in sys.stdin:", "for line in [\"lgs-engine 1\"]:"), "the engine ended with status 0");
}

// What does not begin is no engine: bad usage, and no mismatch.
TEST_F(BadEngines, DoesNotBegin) {
  const auto expectNone = [&](const std::string& engine, const std::string& why) {
    const Outcome outcome = check(engine, "--edits 200", kPatience);
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_TRUE(outcome.text.starts_with("lgs: there is no engine to check: the engine ")) << outcome.text;
    EXPECT_NE(outcome.text.find(why), std::string::npos) << outcome.text;
  };
  expectNone("no-such-program", "ended with status 127");
  expectNone(naiveWith("\"lgs-engine 1 naive.py", "\"hello 1 naive.py"), "the first line must be 'lgs-engine 1 NAME");
  expectNone(naiveWith("several preserve", "several magic"), "'magic' is no capability");
}

TEST_F(BadEngines, DoesNotEnd) {
  expectTold(naiveWith("\n\nmain()", "\n\nmain()\nimport time; time.sleep(1000)"),
             "does not end at the end of its input", 3);
}

TEST_F(BadEngines, EndsBadly) {
  expectTold(naiveWith("\n\nmain()", "\n\nmain()\nsys.exit(4)"), "ended with status 4 at the end of its input");
}

// Its output stays open in the process that it leaves. Nobody waits for that.
TEST_F(BadEngines, LeavesProcessesBehind) {
  expectTold(naiveThat("os.fork() or time.sleep(1000)\n            os._exit(0)"),
             "the engine ended with status 0 before it has answered after edit");
}

TEST_F(BadEngines, LeavesASessionBehind) {
  expectTold(naiveThat("os.fork() or (os.setsid(), os.fork(), time.sleep(1000))\n            os._exit(0)"),
             "the engine ended with status 0 before it has answered after edit");
  expectTold("true; timeout 100 " + naiveThat("time.sleep(1000)").substr(5) + "; true", "has not answered within 3 s",
             3);
}

TEST_F(BadEngines, JoinsAnotherGroup) {
  expectTold(naiveThat("os.setpgid(0, os.getpgid(os.getppid())); time.sleep(1000)"), "has not answered within 3 s", 3);
}

TEST_F(BadEngines, KillsItsParent) {
  expectTold(naiveThat("os.kill(os.getppid(), signal.SIGKILL); time.sleep(1000)"),
             "killed the process that watches it");
}

// Whatever ends lgs, the engine goes as well.
TEST_F(BadEngines, GoWhenTheHarnessGoes) {
  const std::string engine = naiveThat("open('here', 'w').close(); time.sleep(1000)");
  for (const auto& [signal, status] :
       {std::pair<std::string, std::string>{"HUP", "129"}, {"TERM", "143"}, {"KILL", "137"}}) {
    const Outcome outcome = sh(
        "rm -f here; '" LGS_COMMAND "' check --engine '" + engine +
        "' > log 2>&1 & p=$!; for k in $(seq 400); do sleep 0.05; test -e here && break; done; test -e here && echo it "
        "was there; kill -" +
        signal + " $p; wait $p; echo status $?");
    EXPECT_NE(outcome.text.find("status " + status + "\n"), std::string::npos) << outcome.text;
    EXPECT_NE(outcome.text.find("it was there"), std::string::npos) << outcome.text;
    EXPECT_LT(outcome.seconds, 60) << signal;
    EXPECT_FALSE(isAnyoneLeft()) << signal;
  }
}

TEST_F(BadEngines, AGoodOneMaySayMuchAtItsEnd) {
  const std::string engine =
      naiveWith("\n\nmain()", "\n\nmain()\nimport os; os.close(1); sys.stderr.write('x' * 200000)");
  const Outcome outcome = check(engine, "--edits 100");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
}

// The files that lgs opens then get the numbers of the standard files.
TEST_F(BadEngines, AGoodOneIsNotBlamedForClosedFiles) {
  const std::string engine = naiveThat("pass");
  const std::string command = "lgs check --engine '" + engine + "' --edits 100 ";
  for (const std::string closed : {"<&-", "2>&-", "<&- 2>&-"}) EXPECT_EQ(sh(command + closed).status, 0) << closed;
}

TEST_F(BadEngines, AGoodOneMaySayMuchAndBeSlowAndCareless) {
  const Outcome outcome =
      check(naiveThat("print('# comment'); sys.stderr.write('log' * 9999); time.sleep(0.01)"), "--edits 100 --verbose");
  EXPECT_EQ(outcome.status, 0) << outcome.text.substr(0, 2000);
  EXPECT_NE(outcome.text.find("# comment\n"), std::string::npos);
  EXPECT_NE(outcome.text.find("loglog"), std::string::npos);
}

}  // namespace
}  // namespace lgs::test
