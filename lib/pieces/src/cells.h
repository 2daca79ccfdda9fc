// Which content each cell has: a number for each cell, in chunks that are there only where cells hold polygons.
#pragma once

#include "catalogue.h"

#include <lgs/lattice.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace lgs::pieces {

class Cells {
 public:
  ContentId at(Cell cell) const {
    const auto found = chunks_.find(chunkOf(cell));
    return found == chunks_.end() ? kEmpty : found->second.contents[placeOf(cell)];
  }

  void set(Cell cell, ContentId content) {
    if (content == kEmpty && at(cell) == kEmpty) return;
    const auto found = chunks_.try_emplace(chunkOf(cell)).first;
    Chunk& chunk = found->second;
    ContentId& there = chunk.contents[placeOf(cell)];
    const int more = (content != kEmpty) - (there != kEmpty);
    chunk.held += more;
    held_ += static_cast<std::size_t>(more);
    there = content;
    if (chunk.held == 0) chunks_.erase(found);
  }

  std::size_t held() const { return held_; }  ///< cells that hold polygons

 private:
  static constexpr int kBits = 5;  // 32×32 cells
  static constexpr std::int32_t kMask = (1 << kBits) - 1;

  struct Chunk {
    std::array<ContentId, std::size_t{1} << 2 * kBits> contents{};
    int held = 0;
  };

  static std::uint64_t chunkOf(Cell cell) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.i >> kBits)) << 32 |
           static_cast<std::uint32_t>(cell.j >> kBits);
  }
  static std::size_t placeOf(Cell cell) {
    return static_cast<std::size_t>((cell.j & kMask) << kBits | (cell.i & kMask));
  }

  std::unordered_map<std::uint64_t, Chunk> chunks_;
  std::size_t held_ = 0;
};

}  // namespace lgs::pieces
