// Random numbers that are the same on every compiler and machine; <random>'s distributions are not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::oracle {

/// splitmix64: every seed is as good as any other.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// No chance at all: the first of everything, in the order in which it comes.
  static Random asItComes() { return of({}); }

  /// Each choice takes a byte of a fuzzer's, or two; then it goes as it comes. The bytes must outlive it.
  static Random of(std::span<const std::uint8_t> bytes) {
    Random random(0);
    random.isPlain_ = true;
    random.bytes_ = bytes;
    return random;
  }

  std::uint64_t next() {
    if (isPlain_) return nextByte();
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// 0 … n-1, for n ≥ 1. The bias of the modulus does not matter here.
  template <class Integer>
  Integer below(Integer n) {
    const auto most = static_cast<std::uint64_t>(n);
    const std::uint64_t high = isPlain_ && most > 256 ? nextByte() << 8 : 0;
    return static_cast<Integer>((high + next()) % most);
  }

  template <class Integer>
  Integer between(Integer least, Integer most) {
    return least + below(most - least + 1);
  }

  /// True in about `percent` of 100 calls; not, where the number is 0.
  bool chance(int percent) { return below(100) >= 100 - percent; }

  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[below(from.size())];
  }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t k = isPlain_ ? 0 : items.size(); k > 1; --k) std::swap(items[k - 1], items[below(k)]);
  }

 private:
  std::uint64_t nextByte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }

  std::uint64_t state_;
  bool isPlain_ = false;  // takes no chance, but bytes
  std::span<const std::uint8_t> bytes_;
};

}  // namespace lgs::oracle
