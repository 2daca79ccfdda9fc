// Among millions of cells nothing of an edit's place is in a cache, and a commit waits for one line of memory after the
// other. So it asks for all of them first.
//
// always_inline is needed: GCC takes a function that only prefetches for one without effect, and deletes the call of
// it. A test counts the prefetches in the object file.
#pragma once

#include "outline/outline.h"
#include "outline/wide_row.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lgs::detail {

/// With fewer segments most of it is in a cache, and to ask costs more than it spares. Tests that count what is done have
/// all worlds ask, so that small ones can be compared with large ones.
#ifdef LGS_ALWAYS_FETCH
inline constexpr std::uint32_t kManySegments = 0;
#else
inline constexpr std::uint32_t kManySegments = 1u << 17;
#endif

inline constexpr std::size_t kFewSegments = 4;  ///< most cells have no more

#ifdef __GNUC__
[[gnu::always_inline]] inline void prefetch(const void* address) { __builtin_prefetch(address); }

/// Asks for what the two phases read of the only changed cell of a chunk, and of those around it. At the rim of the
/// chunk, or if there are several, it does nothing.
[[gnu::always_inline]] inline void fetchAround(const Outline& outline, const Chunk& chunk) {
  const CellAt at = onlyDirtyCell(chunk);
  if (!at || !isInner(at.local)) return;
  const std::uint32_t first = at.local - kChunkSize - 1;  // the lowest of the nine
  for (std::uint32_t row = 0; row < 3; ++row) {
    prefetch(&chunk.cells[first + row * kChunkSize]);
    prefetch(&chunk.facts[first + row * kChunkSize]);
    outline.lists.prefetchReference(chunk, first + row * kChunkSize);
  }
  for (std::uint32_t row = 0; row < 3; ++row)
    for (std::uint32_t k = 0; k < 3; ++k) outline.lists.prefetchList(chunk, first + row * kChunkSize + k);
  for (std::uint32_t row = 0; row < 3; ++row) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::span<const std::uint32_t> ids = outline.lists.of({chunk.self(), first + row * kChunkSize + k}).all();
      for (const std::uint32_t id : ids.first(std::min(ids.size(), kFewSegments))) prefetch(&outline.segments[id]);
    }
  }
}
#else
inline void fetchAround(const Outline&, const Chunk&) {}
#endif

}  // namespace lgs::detail
