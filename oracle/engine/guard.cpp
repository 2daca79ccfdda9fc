#include "oracle/engine/guard.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace lgs::oracle {
namespace {

// Only what is safe after fork() in a process with threads.
[[noreturn]] void watch(pid_t group, int lifeline) {
  setpgid(0, 0);  // what is typed at a terminal, to interrupt, goes to the groups of others
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) ::signal(signal, SIG_IGN);
  const auto most = static_cast<int>(std::clamp(sysconf(_SC_OPEN_MAX), 256L, 4096L));
  for (int file = 0; file < most; ++file)
    if (file != lifeline) close(file);  // or pipes of others would stay open as long as the guard lives
  char word = 0;
  ssize_t n = 0;
  do n = read(lifeline, &word, 1);
  while (n < 0 && errno == EINTR);
  if (n != 1) kill(-group, SIGKILL);
  _exit(0);
}

}  // namespace

Guard::Guard(pid_t group) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  lifeline_ = ends[1];
  fcntl(lifeline_, F_SETFD, FD_CLOEXEC);
  guard_ = fork();
  if (guard_ == 0) {
    close(lifeline_);
    watch(group, ends[0]);
  }
  close(ends[0]);
}

Guard::~Guard() {
  const char word = '.';
  static_cast<void>(!write(lifeline_, &word, 1));
  close(lifeline_);
  while (guard_ > 0 && waitpid(guard_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace lgs::oracle
