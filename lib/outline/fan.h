// Collects the spokes around one vertex on the rims of cells.
#pragma once

#include "geometry/radial_match.h"
#include "ground/content.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::detail {

/// The grid gives the order around such a vertex: a direction along a side, the half-edges inside one cell, the next
/// direction along a side, and so on. The content keeps the half-edges inside its cell in order. A *stretch* is a
/// direction along a side and the half-edges that follow it. The directions of stretch k are numbered from k · kStretch
/// on.
inline constexpr std::uint32_t kStretch = 1u << 20;

/// A spoke that may be absent is always written, and then counted if it is there. On random terrain a branch instead
/// would be a coin toss for the processor.
class Fan {
 public:
  /// `spokes` must have room for all of them and one more, which may be written and not counted.
  explicit Fan(std::vector<Spoke>& spokes) : begin_(spokes.data()), end_(begin_) {}

  /// `present` is 1 or 0.
  void add(std::uint32_t segment, std::uint32_t direction, std::uint32_t outgoing, std::uint32_t present) {
    *end_ = {segment, direction & kMaxDirection, outgoing & 1u};
    end_ += present;
  }
  /// Adds half-edges inside a cell with this content. `ids` are those of its segments inside.
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
