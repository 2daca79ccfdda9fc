// Times: how one is taken, and what is said of many.
//
// A single edit takes some hundred nanoseconds, and reading the clock takes some twenty. So timeOf() subtracts what it
// measures for no work at all: the median of many such measurements, taken at the start. A processor may begin the work
// while it still reads the clock, and that part is lost. So single times of less than some 50 ns mean little. Google
// Benchmark reads the clock seldom; its means over many edits are there to compare with.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lgs::bench {

using Clock = std::chrono::steady_clock;
using Nanoseconds = std::int64_t;

class Times {
 public:
  void add(Nanoseconds time) { times_.push_back(time); }
  void add(const Times& other) { times_.insert(times_.end(), other.times_.begin(), other.times_.end()); }
  void reserve(std::size_t count) { times_.reserve(times_.size() + count); }
  std::size_t size() const { return times_.size(); }
  bool empty() const { return times_.empty(); }

  /// The least time that `percent` of all do not exceed. There must be times.
  Nanoseconds percentile(std::size_t percent) const {
    std::vector<Nanoseconds> times = times_;
    const std::size_t rank = std::max<std::size_t>(1, (times.size() * percent + 99) / 100);
    const auto at = times.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(times.begin(), at, times.end());
    return *at;
  }
  Nanoseconds median() const { return percentile(50); }
  Nanoseconds max() const { return percentile(100); }

 private:
  std::vector<Nanoseconds> times_;
};

inline Nanoseconds nanoseconds(Clock::duration time) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time).count();
}

/// What taking a time costs by itself.
inline Nanoseconds clockCost() {
  static const Nanoseconds cost = [] {
    Times times;
    for (int k = 0; k < 10'001; ++k) {
      const Clock::time_point begin = Clock::now();
      times.add(nanoseconds(Clock::now() - begin));
    }
    return times.median();
  }();
  return cost;
}

template <class Work>
Nanoseconds timeOf(Work&& work) {
  const Nanoseconds cost = clockCost();
  const Clock::time_point begin = Clock::now();
  work();
  return std::max(Nanoseconds{0}, nanoseconds(Clock::now() - begin) - cost);
}

}  // namespace lgs::bench
