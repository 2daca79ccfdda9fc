// Law 14 needs a whole world beside one whose chunks leave memory.
#pragma once

#include "proptests/support/worlds.h"

#include <lgs/loops.h>

#include <cstddef>
#include <set>

namespace lgs::test {

/// Of a chunk by its place, in chunks.
inline CellRect chunkAt(std::int32_t ci, std::int32_t cj) { return {{32 * ci, 32 * cj}, {32 * ci + 31, 32 * cj + 31}}; }

/// So many chunks in a row, full of squares.
World rowOfChunks(std::int32_t chunks);

/// The bytes of chunks, by their lower-left cells, as a game would keep them: the newest last.
class Shelf {
 public:
  ChunkSink sink() {
    return [this](Cell corner, std::span<const std::byte> bytes) {
      chunks_[corner].emplace_back(bytes.begin(), bytes.end());
    };
  }
  /// Brings a chunk back from the newest bytes that fit.
  bool reload(World& world, Cell corner) const {
    const auto found = chunks_.find(corner);
    if (found == chunks_.end()) return false;
    for (auto bytes = found->second.rbegin(); bytes != found->second.rend(); ++bytes)
      if (const auto done = world.reload(*bytes); done) return *done == corner;
    return false;
  }
  const std::vector<std::byte>& newest(Cell corner) const { return chunks_.at(corner).back(); }

 private:
  std::map<Cell, std::vector<std::vector<std::byte>>> chunks_;
};

inline constexpr CellRect kEverywhere{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

}  // namespace lgs::test
