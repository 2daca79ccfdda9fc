// The spokes around one vertex of a rim, as linking collects them.
#pragma once

#include "content.h"
#include "radial_match.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::detail {

/// The grid gives the order around a rim vertex: directions along the sides, and between two of them the half-edges
/// inside one cell, which its content keeps in order. A *stretch* is a direction along a side with the half-edges that
/// follow it. Directions of stretch k are numbered from k × kStretch on.
inline constexpr std::uint32_t kStretch = 1u << 20;

/// Adding a spoke that is not there costs what adding one costs: on random terrain a branch would be a coin toss.
class Fan {
 public:
  /// `spokes` has room for one more than will be there, as one that is not there is written too.
  explicit Fan(std::vector<Spoke>& spokes) : begin_(spokes.data()), end_(begin_) {}

  /// `present` is 1 or 0.
  void add(std::uint32_t segment, std::uint32_t direction, std::uint32_t outgoing, std::uint32_t present) {
    *end_ = {segment, direction & kMaxDirection, outgoing & 1u};
    end_ += present;
  }
  /// Half-edges inside a cell with this content; `ids` are those of its segments.
  void addInterior(const Content& content, const SpokeRange& range, const std::uint32_t* ids, std::uint32_t stretch) {
    const auto addSpoke = [&](const Spoke& spoke, std::uint32_t present) {
      add(ids[spoke.segment], stretch * kStretch + 1 + spoke.direction, spoke.outgoing, present);
    };
    addSpoke(range.first, range.count > 0 ? 1 : 0);
    for (std::uint32_t k = 1; k < range.count; ++k) addSpoke(content.spokes[range.rest + k - 1], 1);
  }
  std::span<const Spoke> spokes() const { return {begin_, end_}; }

 private:
  Spoke* begin_;
  Spoke* end_;
};

}  // namespace lgs::detail
