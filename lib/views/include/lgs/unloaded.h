// Which chunks of a world are unloaded.
#pragma once

#include <lgs/world.h>

#include <vector>

namespace lgs {

/// All unloaded chunks of 32×32 cells, by rows: their cells, as far as they are in range. Cost: for each of them, and for
/// each row of them, as of World::firstUnloaded().
[[nodiscard]] std::vector<CellRect> unloadedChunks(const World& world) noexcept;

}  // namespace lgs
