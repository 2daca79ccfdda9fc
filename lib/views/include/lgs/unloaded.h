// Which chunks of a world are unloaded, and what views make of them.
#pragma once

#include <lgs/world.h>

#include <cstdint>
#include <vector>

namespace lgs {

/// What is at the edge of memory.
enum class AtEdge : std::uint8_t {
  holds,  ///< ground of which nothing more is known: what reaches it is held there
  open    ///< nothing: unloaded ground counts as empty, and what reaches it ends there
};

/// All unloaded chunks of 32×32 cells, by rows: their cells, as far as they are in range. Cost: O(log n)
/// for each of them.
[[nodiscard]] std::vector<CellRect> unloadedChunks(const World& world) noexcept;

}  // namespace lgs
