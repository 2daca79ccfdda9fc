// Where choices come from: a random generator of any library's, the bytes of a fuzzer, a number that a test counts up.
#pragma once

#include "oracle/calls/random.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace lgs::oracle {

class Choices {
 public:
  /// `next` gives a number of any size; numbers of all sizes should be as likely.
  explicit Choices(std::function<std::uint64_t()> next) : next_(std::move(next)) {}

  /// 0 … n-1, for n ≥ 1. It is 0 where the number is 0: a source that ends gives the plainest choices.
  template <class Integer>
  Integer below(Integer n) {
    return static_cast<Integer>(next_() % static_cast<std::uint64_t>(n));
  }
  template <class Integer>
  Integer between(Integer least, Integer most) {
    return least + below(most - least + 1);
  }
  bool chance(int percent) { return below(100) >= 100 - percent; }

  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[below(from.size())];
  }

 private:
  std::function<std::uint64_t()> next_;
};

inline Choices choicesFrom(std::uint64_t seed) {
  return Choices([random = Random(seed)]() mutable { return random.next(); });
}

}  // namespace lgs::oracle
