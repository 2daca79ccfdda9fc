#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>
#include <cstdio>

namespace lgs::cli {

using namespace std::chrono_literals;

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

bool Progress::isDue() {
  if (!terminal_ || std::chrono::steady_clock::now() - last_ < 100ms) return false;
  last_ = std::chrono::steady_clock::now();
  return true;
}

void Progress::show(std::string_view text) {
  fmt::print(stderr, "\r\x1b[K{}", text);
  std::fflush(stderr);
  shown_ = true;
}

void Progress::wipe() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
  shown_ = false;
}

}  // namespace lgs::cli
