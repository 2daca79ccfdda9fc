// All of a small world, one after the other: a test draws as it would at random, and every combination comes up once.
//
//   Exhaust all;
//   while (all.next()) {
//     const int colour = all.below(3);
//     const bool isBig = all.coin();
//     …
//   }
#pragma once

#include "proptests/support/scale.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lgs::test {

class Exhaust {
 public:
  /// To the next combination, or the first. False after the last one.
  bool next() {
    drawn_ = 0;
    if (count_++ == 0) return true;
    // The last draw that can go on does; those after it begin anew.
    while (known_ != 0 && draws_[known_ - 1].value + 1 == draws_[known_ - 1].bound) --known_;
    if (known_ == 0) return false;
    ++draws_[known_ - 1].value;
    return true;
  }

  /// 0 … bound - 1. A bound may depend on what was drawn before. At most 32 draws.
  template <class Integer>
  Integer below(Integer bound) {
    if (drawn_ == known_) draws_.at(known_++) = {0, static_cast<std::uint64_t>(bound)};
    return static_cast<Integer>(draws_[drawn_++].value);
  }

  bool coin() { return below(2) == 1; }

  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[below(from.size())];
  }

  /// Whether a test at less than full scale leaves this combination out. To be asked when all is drawn.
  bool isLeftOut() const { return (count_ - 1) % exhaustStride() != 0; }

 private:
  struct Draw {
    std::uint64_t value = 0;
    std::uint64_t bound = 0;
  };
  std::array<Draw, 32> draws_;
  std::size_t known_ = 0;  // draws whose bound is known
  std::size_t drawn_ = 0;  // of this combination so far
  std::int64_t count_ = 0;
};

}  // namespace lgs::test
