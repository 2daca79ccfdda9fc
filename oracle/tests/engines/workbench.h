// A folder in which engines are made by changing a line of a good one, and are checked by the lgs command.
#pragma once

#include "proptests/support/command.h"

#include <utility>
#include <vector>

namespace lgs::test {

class Workbench : public InAFolder {
 protected:
  struct Outcome : test::Outcome {
    double seconds = 0;
  };

  void TearDown() override;

  /// examples/engines/naive.py with one piece of it changed; the command that runs it. The piece must be there once.
  std::string naiveWith(const std::string& piece, const std::string& instead) const;

  /// The same with several pieces changed, one after the other; of any example.
  using Pieces = std::vector<std::pair<std::string, std::string>>;
  std::string naiveWith(const Pieces& replaced) const { return exampleWith("naive.py", replaced); }
  std::string exampleWith(const std::string& example, const Pieces& replaced) const;

  /// The same with a statement that runs before each answer to a commit.
  std::string naiveThat(const std::string& statement) const;

  /// Runs a command in the folder, with `lgs` for the command of that name.
  Outcome sh(const std::string& line) const;

  /// What an answer may take, in seconds: a busy machine starts an engine slowly. Tests of engines that hang give less.
  static constexpr int kPatience = 60;

  /// Checks an engine. `timeout` is what an answer may take, in seconds.
  Outcome check(const std::string& engine, const std::string& arguments, int timeout = kPatience) const;

  /// Whether any process was started from the folder and lives on. They get a moment to go.
  bool isAnyoneLeft() const;

  /// What follows a word at the beginning of a line: a command that lgs has printed.
  static std::string afterWord(const std::string& text, const std::string& word);

  /// How many edits and commits a saved mismatch has; commits at its end do not count.
  std::size_t editsOfMismatch() const;
};

}  // namespace lgs::test
