// A set of numbers, with a bit for each up to the greatest that was ever in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lgs::detail {

class BitSet {
 public:
  /// Whether the number was not in it yet.
  bool insert(std::uint32_t number) {
    if (number / 64 >= words_.size()) words_.resize(number / 64 + std::size_t{1});
    std::uint64_t& word = words_[number / 64];
    const std::uint64_t bit = std::uint64_t{1} << number % 64;
    const bool isNew = (word & bit) == 0;
    word |= bit;
    return isNew;
  }
  /// It is in the set.
  void erase(std::uint32_t number) { words_[number / 64] &= ~(std::uint64_t{1} << number % 64); }

  std::uint64_t bytes() const { return words_.capacity() * sizeof words_[0]; }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace lgs::detail
