#include "oracle/engine/child.h"

#include "oracle/engine/ending.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <thread>

namespace lgs::oracle {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMiB = std::size_t{1} << 20;
constexpr std::size_t kLongestAnswer = 64 * kMiB;
constexpr std::size_t kLongestLog = 16 * kMiB;  // for one answer
constexpr std::size_t kLongestLine = kMiB;
constexpr std::size_t kTail = 2'000;

using Ends = std::array<int, 2>;

Ends makePipe() {
  Ends ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  return ends;
}

void closeEnd(int& end) {
  if (end >= 0) close(end);
  end = -1;
}

[[noreturn]] void become(const char* command, int input, int output, int log) {
  setpgid(0, 0);
  signal(SIGPIPE, SIG_DFL);
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execl("/bin/sh", "sh", "-c", command, nullptr);
  _exit(127);
}

Failure protocol(std::string text) { return {Failure::Kind::protocol, std::move(text)}; }

std::string shortened(std::string_view line) {
  constexpr std::size_t kShown = 80;
  std::string text(line.substr(0, kShown));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return line.size() > kShown ? text + "…" : text;
}

}  // namespace

Child::Child(const std::string& command, bool verbose) : verbose_(verbose) {
  Ends in = makePipe(), out = makePipe(), log = makePipe();
  signal(SIGPIPE, SIG_IGN);  // a child that reads no more shows by its end
  std::fflush(nullptr);
  process_ = fork();
  if (process_ == 0) become(command.c_str(), in[0], out[1], log[1]);
  if (process_ > 0) setpgid(process_, process_);
  closeEnd(in[0]);
  closeEnd(out[1]);
  closeEnd(log[1]);
  input_ = in[1];
  output_ = out[0];
  log_ = log[0];
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  guard_.emplace(process_);
  for (const int end : {input_, output_, log_}) fcntl(end, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  kill(-process_, SIGKILL);  // before it is waited for: until then the number of the group is taken
  closeEnd(input_);
  closeEnd(output_);
  closeEnd(log_);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

// What nobody has asked for.
std::optional<Failure> Child::takeRest() {
  const auto unasked = [](std::string_view) { return tl::unexpected<std::string>("it was not asked"); };
  bool isComplete = false;
  return takeLines(unasked, isComplete);
}

std::optional<Failure> Child::ask(std::string_view text, const Take& take, Clock::duration patience) {
  answered_ = logged_ = 0;
  if (output_ >= 0) static_cast<void>(readOutput());
  if (auto failure = takeRest()) return failure;
  const Clock::time_point deadline = Clock::now() + patience;
  bool isComplete = false;
  while (true) {
    if (auto failure = takeLines(take, isComplete)) return failure;
    if (isComplete) return takeRest();
    if (output_ < 0) return ended(deadline);
    if (Clock::now() >= deadline) return late(patience);
    if (auto failure = transfer(text, deadline)) return failure;
  }
}

std::optional<Failure> Child::finish(Clock::duration patience) {
  answered_ = logged_ = 0;
  closeEnd(input_);
  const Clock::time_point deadline = Clock::now() + patience;
  std::string_view nothing;
  while (output_ >= 0 && Clock::now() < deadline) {
    if (auto failure = transfer(nothing, deadline)) return failure;
    if (auto failure = takeRest()) return failure;
  }
  std::string how;
  while ((how = howItEnded()).empty() && Clock::now() < deadline) std::this_thread::sleep_for(1ms);
  if (how.empty()) return Failure{Failure::Kind::hang, "does not end at the end of its input"};
  if (how == kEndedWell) return std::nullopt;
  return Failure{Failure::Kind::crash, how + " at the end of its input", endOfLog()};
}

// Takes what has come, line by line.
std::optional<Failure> Child::takeLines(const Take& take, bool& isComplete) {
  while (!isComplete) {
    const std::size_t end = lines_.find('\n', taken_);
    if (end == std::string::npos) break;
    const std::string_view line = std::string_view(lines_).substr(taken_, end - taken_);
    taken_ = end + 1;
    if (line.starts_with('#')) {
      if (verbose_) fmt::print(stderr, "{}\n", line);
      continue;
    }
    const auto complete = take(line);
    if (!complete) return protocol(fmt::format("answered '{}': {}", shortened(line), complete.error()));
    isComplete = *complete;
  }
  lines_.erase(0, taken_);
  taken_ = 0;
  if (!isComplete && lines_.size() > kLongestLine) return protocol("answered a line of more than 1 MiB");
  return std::nullopt;
}

// Waits until something can be written or read, and does that.
std::optional<Failure> Child::transfer(std::string_view& unsent, Clock::time_point deadline) {
  const bool writes = !unsent.empty() && input_ >= 0;
  std::array<pollfd, 3> ends{pollfd{writes ? input_ : -1, POLLOUT, 0}, pollfd{output_, POLLIN, 0},
                             pollfd{log_, POLLIN, 0}};
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  poll(ends.data(), ends.size(), static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
  if (ends[0].revents != 0) write(unsent);
  std::optional<Failure> failure;
  if (ends[1].revents != 0) failure = readOutput();
  if (!failure && ends[2].revents != 0) failure = readLog();
  return failure;
}

void Child::write(std::string_view& unsent) {
  const ssize_t n = ::write(input_, unsent.data(), unsent.size());
  if (n > 0) {
    unsent.remove_prefix(static_cast<std::size_t>(n));
  } else if (n < 0 && errno != EAGAIN && errno != EINTR) {
    closeEnd(input_);  // nobody reads; the output, or its end, will tell more
  }
}

std::optional<Failure> Child::readOutput() {
  const ssize_t n = read(output_, buffer_.data(), buffer_.size());
  if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) closeEnd(output_);
  if (n <= 0) return std::nullopt;
  lines_.append(buffer_.data(), static_cast<std::size_t>(n));
  answered_ += static_cast<std::size_t>(n);
  if (answered_ > kLongestAnswer) return protocol("answers without end: more than 64 MiB");
  return std::nullopt;
}

std::optional<Failure> Child::readLog() {
  const ssize_t n = read(log_, buffer_.data(), buffer_.size());
  if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) closeEnd(log_);
  if (n <= 0) return std::nullopt;
  const std::string_view text(buffer_.data(), static_cast<std::size_t>(n));
  if (verbose_) std::fwrite(text.data(), 1, text.size(), stderr);
  tail_ += text;
  if (tail_.size() > kTail) tail_.erase(0, tail_.size() - kTail);
  logged_ += text.size();
  if (logged_ > kLongestLog) return protocol("floods its log: more than 16 MiB for one answer");
  return std::nullopt;
}

// The output is closed: because the child has ended, as a rule.
Failure Child::ended(Clock::time_point deadline) {
  const Clock::time_point grace = std::min(deadline, Clock::now() + 500ms);
  std::string how;
  while ((how = howItEnded()).empty() && Clock::now() < grace) std::this_thread::sleep_for(1ms);
  while (log_ >= 0 && !how.empty() && logged_ <= kLongestLog) {
    const std::size_t before = logged_;
    if (readLog() || logged_ == before) break;
  }
  if (how.empty()) return {Failure::Kind::crash, "closed its output, and lives on"};
  return {Failure::Kind::crash, how == kEndedWell ? how + " before it has answered" : how, endOfLog()};
}

Failure Child::late(Clock::duration patience) {
  if (std::string how = howItEnded(); !how.empty()) return {Failure::Kind::crash, how, endOfLog()};
  return {Failure::Kind::hang,
          fmt::format("has not answered within {} s", std::chrono::duration<double>(patience).count()), endOfLog()};
}

std::string Child::howItEnded() const {
  siginfo_t info{};
  if (waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == 0)
    return "";
  return info.si_code == CLD_EXITED ? endingOfStatus(info.si_status) : endingOfSignal(info.si_status);
}

std::string Child::endOfLog() const {
  std::string_view text = tail_;
  while (text.ends_with('\n')) text.remove_suffix(1);
  constexpr int kLines = 5;
  std::size_t begin = text.size();
  for (int k = 0; k < kLines && begin != std::string_view::npos && begin != 0; ++k) begin = text.rfind('\n', begin - 1);
  if (begin != std::string_view::npos && begin != 0) text.remove_prefix(begin + 1);
  return std::string(text);
}

}  // namespace lgs::oracle
