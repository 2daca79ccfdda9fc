// A process that is asked by lines of text and answers by lines. It is given up on when it takes too long, and is
// killed with all that it has started (guard.h). POSIX only.
#pragma once

#include "oracle/engine/engine.h"
#include "oracle/engine/guard.h"

#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace lgs::oracle {

class Child {
 public:
  using Clock = std::chrono::steady_clock;

  /// What a line of the child's means to whoever asked: the answer goes on, or it is complete; or what is wrong.
  using Take = std::function<tl::expected<bool, std::string>(std::string_view line)>;

  /// Starts a program, in a process group of its own. With `verbose` its comments and its standard error are shown on
  /// the standard error.
  Child(const Guard::Program& program, bool verbose);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Sends a text and hands each line that comes to `take`, but for comments, until the answer is complete. Reads and
  /// writes at once, so full pipes are no trouble. What went wrong, if anything did; then the child is of no more use.
  std::optional<Failure> ask(std::string_view text, const Take& take, Clock::duration patience);

  /// Ends the child's input. It must then end with status 0.
  std::optional<Failure> finish(Clock::duration patience);

 private:
  std::optional<Failure> takeLines(const Take& take, bool& isComplete);
  std::optional<Failure> takeRest();
  std::optional<Failure> settle(Clock::time_point deadline);
  tl::expected<bool, Failure> transfer(std::string_view& unsent, Clock::time_point deadline);
  std::optional<Failure> readOutput();
  std::optional<Failure> readLog();
  void write(std::string_view& unsent);
  Failure noAnswer(Clock::duration patience);
  std::string endOfLog() const;

  bool verbose_;
  std::optional<Guard> guard_;
  std::optional<Clock::time_point> ended_;   // when that was noticed
  int input_ = -1, output_ = -1, log_ = -1;  // our ends; -1: closed
  std::string lines_;                        // read and not yet taken
  std::size_t taken_ = 0;                    // of lines_
  std::string tail_;                         // of the log
  std::array<char, 65'536> buffer_{};
  std::size_t answered_ = 0, logged_ = 0;  // bytes since the last question
};

}  // namespace lgs::oracle
