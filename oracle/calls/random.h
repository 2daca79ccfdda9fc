// Random numbers that are the same on every compiler and machine; <random>'s distributions are not.
#pragma once

#include <cstdint>
#include <vector>

namespace lgs::oracle {

/// splitmix64: every seed is as good as any other.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// No chance at all: the first of everything, in the order in which it comes.
  static Random asItComes() {
    Random random(0);
    random.isPlain_ = true;
    return random;
  }

  std::uint64_t next() {
    if (isPlain_) return 0;
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// 0 … n-1, for n ≥ 1. The bias of the modulus does not matter here.
  template <class Integer>
  Integer below(Integer n) {
    return static_cast<Integer>(next() % static_cast<std::uint64_t>(n));
  }

  /// True in about `percent` of 100 calls.
  bool chance(int percent) { return below(100) < percent && (!isPlain_ || percent >= 100); }

  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[below(from.size())];
  }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t k = isPlain_ ? 0 : items.size(); k > 1; --k) std::swap(items[k - 1], items[below(k)]);
  }

 private:
  std::uint64_t state_;
  bool isPlain_ = false;
};

}  // namespace lgs::oracle
