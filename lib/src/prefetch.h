// In a world that is larger than the processor's caches a commit mostly waits for memory. What it will read is known
// beforehand, so it is asked for all at once.
#pragma once

#include "world_impl.h"

#include <algorithm>
#include <array>

namespace lgs::detail {

inline void prefetch(const void* memory) {
#if defined(__GNUC__)
  __builtin_prefetch(memory);
#else
  static_cast<void>(memory);
#endif
}

/// Below this many segments they fit in most caches, and asking costs more than it saves.
inline constexpr std::uint32_t kBeyondCaches = 1u << 16;

/// Asks for the records of a cell and of the eight around it, and then for their segments.
inline void prefetchAround(const World::Impl& world, CellAt at) {
  std::array<const CellRecord*, 9> records{};
  const auto x = static_cast<std::int32_t>(at.local % kChunkSize), y = static_cast<std::int32_t>(at.local / kChunkSize);
  std::size_t count = 0;
  for (std::int32_t dy = -1; dy <= 1; ++dy) {
    for (std::int32_t dx = -1; dx <= 1; ++dx) {
      const CellAt beside = cellAt(*at.chunk, x + dx, y + dy);
      const CellRecord* record = beside ? world.grid.record(beside) : nullptr;
      if (!record) continue;
      prefetch(record);
      records[count++] = record;
    }
  }
  constexpr std::uint32_t kEnough = 4;  // for most cells
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t* ids = records[k]->ids();
    for (std::uint32_t n = 0; n < std::min(kEnough, records[k]->count()); ++n) prefetch(&world.segments[ids[n]]);
  }
}

}  // namespace lgs::detail
