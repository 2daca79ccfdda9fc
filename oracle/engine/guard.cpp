#include "oracle/engine/guard.h"

#include "oracle/engine/ending.h"

#include <fcntl.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <utility>

namespace lgs::oracle {
namespace {

// How a program ended, as waitid() says it.
struct Ending {
  int code;
  int status;
};

// What runs in the new processes is safe after a fork() in a process with threads: it takes no memory.

// The others do not outlive the guard: whoever kills it leaves nothing behind either.
void endWithParent() {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
#endif
}

[[noreturn]] void run(const Guard::Program& program, const Guard::Files& files) {
  endWithParent();
  setpgid(0, 0);
  signal(SIGPIPE, SIG_DFL);
  dup2(files.input, STDIN_FILENO);
  dup2(files.output, STDOUT_FILENO);
  dup2(files.log, STDERR_FILENO);
  program();
  _exit(127);
}

// A process that ends when the other end of the line is closed. So the guard waits for processes only.
pid_t startListening(int line) {
  const pid_t listener = fork();
  if (listener != 0) return listener;
  endWithParent();
  char word = 0;
  while (read(line, &word, 1) < 0 && errno == EINTR) {
  }
  _exit(0);
}

// Waits until one of the two ends. It stays a zombie, so its number stays taken.
siginfo_t firstToEnd(pid_t program, pid_t listener) {
  siginfo_t info{};
  while (waitid(P_ALL, 0, &info, WEXITED | WNOWAIT) == 0 || errno == EINTR) {
    if (info.si_pid == program || info.si_pid == listener) break;
    if (info.si_pid != 0) waitpid(info.si_pid, nullptr, 0);  // an orphan of the program's
  }
  return info;
}

void killChildren() {
#ifdef __linux__
  const int list = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);  // numbers, a blank after each
  std::array<char, 4096> text{};
  const ssize_t n = read(list, text.data(), text.size());
  pid_t child = 0;
  for (ssize_t k = 0; k < n; ++k) {
    const char c = text[static_cast<std::size_t>(k)];
    if ('0' <= c && c <= '9') {
      child = child * 10 + (c - '0');
    } else {
      if (child > 0) kill(child, SIGKILL);
      child = 0;
    }
  }
  close(list);
#endif
}

// The children of what is killed become the guard's, so it goes on until it has none. It does not wait for ever: what
// runs as another user can not be killed.
void killAll(pid_t program) {
  constexpr int kMilliseconds = 5'000;
  kill(-program, SIGKILL);
  kill(program, SIGKILL);  // it may have left its group
  for (int k = 0; k < kMilliseconds;) {
    killChildren();
    const pid_t gone = waitpid(-1, nullptr, WNOHANG);
    if (gone < 0 && errno == ECHILD) return;
    if (gone > 0) continue;
    poll(nullptr, 0, 1);
    ++k;
  }
}

[[noreturn]] void guard(const Guard::Program& program, const Guard::Files& files, int line) {
  setpgid(0, 0);  // what is typed at a terminal, to interrupt, goes to the groups of others
  signal(SIGCHLD, SIG_DFL);
#ifdef __linux__
  prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
#endif
  const pid_t process = fork();
  if (process == 0) run(program, files);
  if (process < 0) _exit(1);
  setpgid(process, process);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) ::signal(signal, SIG_IGN);
  line = dup2(line, 0);
  closeFrom(1);  // or pipes of others would stay open as long as the guard lives
  const pid_t listener = startListening(line);
  if (listener > 0) {
    const siginfo_t info = firstToEnd(process, listener);
    if (info.si_pid == process) {
      const Ending ending{info.si_code, info.si_status};
      static_cast<void>(!write(line, &ending, sizeof ending));
      waitpid(listener, nullptr, 0);
    }
  }
  killAll(process);
  _exit(0);
}

}  // namespace

Ends kept(Ends ends) {
  constexpr int kFirst = 3;
  for (int& end : ends) {
    const int moved = fcntl(end, F_DUPFD_CLOEXEC, kFirst);
    if (moved < 0) throw std::system_error(errno, std::generic_category(), "fcntl");
    close(std::exchange(end, moved));
  }
  return ends;
}

void closeFrom(int first) {
  const auto most = static_cast<int>(std::clamp(sysconf(_SC_OPEN_MAX), 256L, 4096L));
  for (int file = first; file < most; ++file) close(file);
}

Guard::Guard(const Program& program, const Files& files) {
  Ends line{};
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, line.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "socketpair");
  line = kept(line);
  std::fflush(nullptr);  // or a program that is no other one would write it again
  guard_ = fork();
  if (guard_ == 0) {
    close(line[0]);
    guard(program, files, line[1]);
  }
  close(line[1]);
  line_ = line[0];
  if (guard_ < 0) {
    const int why = errno;
    close(line_);
    throw std::system_error(why, std::generic_category(), "fork");
  }
}

Guard::~Guard() {
  close(line_);
  while (waitpid(guard_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

const std::string& Guard::howItEnded() {
  if (!how_.empty()) return how_;
  Ending ending{};
  const ssize_t n = recv(line_, &ending, sizeof ending, MSG_DONTWAIT);
  if (n == static_cast<ssize_t>(sizeof ending)) {
    how_ = ending.code == CLD_EXITED ? endingOfStatus(ending.status) : endingOfSignal(ending.status);
  } else if (n >= 0 || (errno != EAGAIN && errno != EINTR)) {
    how_ = "killed the process that watches it";
  }
  return how_;
}

}  // namespace lgs::oracle
