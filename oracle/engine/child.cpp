#include "oracle/engine/child.h"

#include "oracle/engine/answer.h"
#include "oracle/engine/ending.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

namespace lgs::oracle {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMiB = std::size_t{1} << 20;
constexpr std::size_t kLongestAnswer = 64 * kMiB;
constexpr std::size_t kLongestLog = 16 * kMiB;  // for one answer
constexpr std::size_t kLongestLine = kMiB;
constexpr std::size_t kTail = 2'000;

Ends makePipe() {
  Ends ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  return kept(ends);
}

void closeEnd(int& end) {
  if (end >= 0) close(end);
  end = -1;
}

Failure protocol(std::string text) { return {Failure::Kind::protocol, std::move(text)}; }

}  // namespace

Child::Child(const Guard::Program& program, bool verbose) : verbose_(verbose) {
  Ends in = makePipe(), out = makePipe(), log = makePipe();
  signal(SIGPIPE, SIG_IGN);  // a child that reads no more shows by its end
  guard_.emplace(program, Guard::Files{in[0], out[1], log[1]});
  closeEnd(in[0]);
  closeEnd(out[1]);
  closeEnd(log[1]);
  input_ = in[1];
  output_ = out[0];
  log_ = log[0];
  for (const int end : {input_, output_, log_}) fcntl(end, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  closeEnd(input_);
  closeEnd(output_);
  closeEnd(log_);
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
    if (output_ < 0) break;
    const auto goesOn = transfer(text, deadline);
    if (!goesOn) return goesOn.error();
    if (!*goesOn) return noAnswer(patience);
  }
  // As a rule it has closed its output because it has ended.
  if (auto failure = settle(std::min(deadline, Clock::now() + 500ms))) return failure;
  return noAnswer(patience);
}

std::optional<Failure> Child::finish(Clock::duration patience) {
  answered_ = logged_ = 0;
  closeEnd(input_);
  if (auto failure = settle(Clock::now() + patience)) return failure;
  const std::string& how = guard_->howItEnded();
  if (how.empty()) return Failure{Failure::Kind::hang, "does not end at the end of its input", endOfLog()};
  if (how == kEndedWell) return std::nullopt;
  return Failure{Failure::Kind::crash, how + " at the end of its input", endOfLog()};
}

// Reads until it has ended, and has closed its output and its log.
std::optional<Failure> Child::settle(Clock::time_point deadline) {
  std::string_view nothing;
  while (output_ >= 0 || log_ >= 0 || !ended_) {
    const auto goesOn = transfer(nothing, deadline);
    if (!goesOn) return goesOn.error();
    if (auto failure = takeRest()) return failure;
    if (!*goesOn) break;
  }
  return std::nullopt;
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
    if (line.ends_with('\r'))
      return protocol(fmt::format("answered '{}': lines end with a line feed alone", shortened(line)));
    const auto complete = take(line);
    if (!complete) return protocol(fmt::format("answered '{}': {}", shortened(line), complete.error()));
    isComplete = *complete;
  }
  lines_.erase(0, taken_);
  taken_ = 0;
  if (!isComplete && lines_.size() > kLongestLine) return protocol("answered a line of more than 1 MiB");
  return std::nullopt;
}

// Waits until something can be written or read, and does that. Whether it makes sense to go on. It makes none when time
// is up and nothing has come. Time is up soon after the end of the child: what it has started may hold its pipes open.
tl::expected<bool, Failure> Child::transfer(std::string_view& unsent, Clock::time_point deadline) {
  const Clock::time_point until = ended_ ? std::min(deadline, *ended_ + 100ms) : deadline;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
  const bool isLate = left.count() <= 0;
  const std::size_t before = answered_ + logged_;
  const bool writes = !unsent.empty() && input_ >= 0;
  std::array ends{pollfd{writes ? input_ : -1, POLLOUT, 0}, pollfd{output_, POLLIN, 0}, pollfd{log_, POLLIN, 0},
                  pollfd{ended_ ? -1 : guard_->news(), POLLIN, 0}};
  poll(ends.data(), ends.size(), isLate ? 0 : static_cast<int>(left.count()));
  if (ends[0].revents != 0) write(unsent);
  std::optional<Failure> failure;
  if (ends[1].revents != 0) failure = readOutput();
  if (!failure && ends[2].revents != 0) failure = readLog();
  if (failure) return tl::unexpected(std::move(*failure));
  if (ends[3].revents != 0 && !guard_->howItEnded().empty()) ended_ = Clock::now();
  return !isLate || answered_ + logged_ != before;
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

Failure Child::noAnswer(Clock::duration patience) {
  const std::string& how = guard_->howItEnded();
  if (!how.empty())
    return {Failure::Kind::crash, how == kEndedWell ? how + " before it has answered" : how, endOfLog()};
  if (output_ < 0) return {Failure::Kind::crash, "closed its output, and lives on", endOfLog()};
  return {Failure::Kind::hang,
          fmt::format("has not answered within {} s", std::chrono::duration<double>(patience).count()), endOfLog()};
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
