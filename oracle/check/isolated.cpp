#include "oracle/check/isolated.h"

#include "oracle/engine/ending.h"

#include <fcntl.h>
#include <fmt/format.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <system_error>

// The child leaves without running what is registered for the end of the program; a coverage build has to save its
// counts. NOLINTNEXTLINE(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp,readability-identifier-naming)
extern "C" void __gcov_dump() __attribute__((weak));

namespace lgs::oracle {
namespace {

IsolationOptions limits{.seconds = 0, .asleep = 0};  // between two signs of life; the parent has none

void silenceTheChild() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);  // one crash of many: no core file
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
}

[[noreturn]] void runAndLeave(const std::function<void()>& work, const IsolationOptions& options, bool& finished) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // who interrupts the parent means the child as well
#endif
  if (options.quiet) silenceTheChild();
  limits = options;
  stillAlive();
  try {
    work();
    finished = true;
  } catch (const std::exception& error) {
    fmt::print(stderr, "an exception: {}\n", error.what());
  }
  std::fflush(nullptr);
  if (__gcov_dump != nullptr) __gcov_dump();
  _exit(0);
}

}  // namespace

std::optional<std::string> crashOf(const std::function<void()>& work, const IsolationOptions& options) {
  const Shared<bool> finished;
  std::fflush(nullptr);  // or the child would write it again
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) runAndLeave(work, options, *finished);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (*finished) return std::nullopt;
  if (!WIFSIGNALED(status)) return "crashed";  // a sanitizer or an exception has said more
  if (WTERMSIG(status) == SIGPROF) return fmt::format("hung for {} s of CPU time", options.seconds);
  if (WTERMSIG(status) == SIGALRM) return fmt::format("hung asleep for {} s", options.asleep);
  return endingOfSignal(WTERMSIG(status));
}

void stillAlive() {
  const itimerval busy{{}, {static_cast<time_t>(limits.seconds), 0}};
  setitimer(ITIMER_PROF, &busy, nullptr);
  alarm(limits.asleep);
}

}  // namespace lgs::oracle
