// A progress line on the standard error, if that is a terminal; in a pipe nothing.
#pragma once

#include <chrono>
#include <string_view>

namespace lgs::oracle {

class Progress {
 public:
  Progress();
  ~Progress() { wipe(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Whether it is time to show something: the caller makes up its text only then.
  bool isDue();
  void show(std::string_view text);
  void wipe();  ///< the line, before something is printed

 private:
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace lgs::oracle
