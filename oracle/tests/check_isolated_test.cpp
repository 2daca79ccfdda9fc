// How work in a child process ends.
#include "oracle/check/isolated.h"

#include <gtest/gtest.h>
#include <sys/time.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace lgs::oracle::isolated {
namespace {

const IsolationOptions kQuiet{.seconds = 5, .quiet = true};

TEST(CheckIsolated, SaysHowItEnds) {
  errno = EINTR;  // as something else may have left it
  EXPECT_EQ(crashOf([] {}, kQuiet), std::nullopt);
  EXPECT_EQ(crashOf([] { std::abort(); }, kQuiet), "crashed with SIGABRT");
  EXPECT_EQ(crashOf([] { std::raise(SIGKILL); }, kQuiet), "crashed with SIGKILL");
  EXPECT_EQ(crashOf([] { std::_Exit(1); }, kQuiet), "crashed");
  EXPECT_EQ(crashOf([] { throw std::runtime_error("oh"); }, kQuiet), "crashed");
}

TEST(CheckIsolated, WaitsAlthoughASignalComes) {
  struct sigaction handled {
  }, before{};
  handled.sa_handler = [](int) {};
  sigaction(SIGALRM, &handled, &before);
  const itimerval soon{{}, {0, 50'000}}, never{};
  setitimer(ITIMER_REAL, &soon, nullptr);
  EXPECT_EQ(crashOf([] { usleep(200'000); }, {.seconds = 5, .asleep = 0}), std::nullopt);
  setitimer(ITIMER_REAL, &never, nullptr);
  sigaction(SIGALRM, &before, nullptr);
}

TEST(CheckIsolated, KeepsWhatIsShared) {
  const Shared<int> shared;
  int mine = 0;
  EXPECT_EQ(crashOf([&] { *shared = mine = 3; }, kQuiet), std::nullopt);
  EXPECT_EQ(*shared, 3);
  EXPECT_EQ(mine, 0);
}

TEST(CheckIsolated, IsQuietWhereThatIsAskedFor) {
  for (const bool quiet : {true, false}) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(crashOf([] { std::fputs("a word", stderr); }, {.quiet = quiet}), std::nullopt);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), quiet ? "" : "a word");
  }
}

}  // namespace
}  // namespace lgs::oracle::isolated
