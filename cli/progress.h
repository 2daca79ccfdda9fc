// A progress line on the standard error. It is shown only on a terminal, not in a pipe.
#pragma once

#include <chrono>
#include <string_view>

namespace lgs::cli {

class Progress {
 public:
  Progress();
  ~Progress() { wipe(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Whether it is time to show something. Only then does the caller need to make up a text.
  bool isDue();
  void show(std::string_view text);
  void wipe();  ///< clears the line, so that something else can be printed

 private:
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace lgs::cli
