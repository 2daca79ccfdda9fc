// Places of chunks, in order: by rows, as the first one of a rectangle is asked for. A hash index has no order.
#pragma once

#include "ground/chunk.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace lgs::detail {

class ChunkRows {
 public:
  void insert(std::int32_t ci, std::int32_t cj) { words_[{cj, ci >> 6}] |= bit(ci); }
  void erase(std::int32_t ci, std::int32_t cj) {
    const auto found = words_.find({cj, ci >> 6});
    if ((found->second &= ~bit(ci)) == 0) words_.erase(found);
  }
  /// The first one of a rectangle, by rows: its column and its row. Cost: O(log n), for each row of the rectangle that
  /// has some, up to there.
  std::optional<std::pair<std::int32_t, std::int32_t>> first(const ChunkRect& in) const {
    const std::int32_t i0 = in.i0 >> 6, i1 = in.i1 >> 6;
    for (auto at = words_.lower_bound({in.j0, i0}); at != words_.end() && at->first.first <= in.j1;) {
      const auto [cj, i] = at->first;
      if (i < i0 || i > i1) {
        at = words_.lower_bound({i < i0 ? cj : cj + 1, i0});
        continue;
      }
      std::uint64_t there = at->second;
      if (i == i0) there &= ~(bit(in.i0) - 1);
      if (i == i1) there &= std::numeric_limits<std::uint64_t>::max() >> (63 - (in.i1 & 63));
      if (there != 0) return std::pair(64 * i + std::countr_zero(there), cj);
      ++at;
    }
    return std::nullopt;
  }
  /// As far as that can be known of a map.
  std::uint64_t bytes() const { return words_.size() * (sizeof(*words_.begin()) + 4 * sizeof(void*)); }

 private:
  static std::uint64_t bit(std::int32_t ci) { return std::uint64_t{1} << (ci & 63); }

  std::map<std::pair<std::int32_t, std::int32_t>, std::uint64_t> words_;  ///< by row, and column / 64
};

}  // namespace lgs::detail
