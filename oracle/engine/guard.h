// A small process between this one and a program: it starts the program, tells how it ended, and leaves nothing of it
// behind. It does so when the guard is given up, and when this process ends, in whatever way. POSIX only.
//
// On Linux nothing escapes: a process that has lost its parent becomes a child of the guard, whatever its group and its
// session. On other systems only the program and its process group are killed.
#pragma once

#include <sys/types.h>

#include <array>
#include <functional>
#include <string>

namespace lgs::oracle {

class Guard {
 public:
  /// What the new process does. When it comes back, the process ends with status 127, as a shell's does that finds no
  /// command.
  using Program = std::function<void()>;

  /// The files that become the program's standard input, output and error. They are not 0, 1 or 2 themselves: see
  /// kept().
  struct Files {
    int input, output, log;
  };

  Guard(const Program& program, const Files& files);
  ~Guard();
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  /// Readable when the program has ended.
  int news() const { return line_; }

  /// In words; empty while the program lives.
  const std::string& howItEnded();

 private:
  pid_t guard_ = -1;
  int line_ = -1;  // to the guard; it is closed when this process ends
  std::string how_;
};

/// Two files that belong together: the ends of a pipe.
using Ends = std::array<int, 2>;

/// Keeps them from other programs, and from the numbers 0, 1 and 2. Those are free if this process was started with its
/// standard files closed; what it prints would go into a pipe.
Ends kept(Ends ends);

/// Closes all files from this one on: for a process that was forked and runs no other program.
void closeFrom(int first);

}  // namespace lgs::oracle
