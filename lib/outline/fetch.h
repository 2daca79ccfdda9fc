// Among millions of cells nothing of an edit's place is in a cache, and whoever goes there waits for one line of memory
// after the other: for what the chunk has of the cells, for their lists of segments, for the segments. So all that an
// edit and its commit need is asked for before they need it.
#pragma once

#include "outline/outline.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lgs::detail {

#if defined(__GNUC__) && !defined(__wasm__)
inline constexpr bool kCanFetch = true;
/// GCC takes a function that only prefetches for one without effect, and deletes the call of it: hence the statement
/// behind it. A test counts the prefetches in the object files.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  __asm__ volatile("");
}
#else
inline constexpr bool kCanFetch = false;
inline void prefetch(const void* /*address*/) {}
#endif

/// With fewer segments most of it is in a cache, and to ask costs more than it spares. Tests that count what is done
/// have all worlds ask, so that small ones can be compared with large ones.
#ifdef LGS_ALWAYS_FETCH
inline constexpr std::uint32_t kManySegments = 0;
#else
inline constexpr std::uint32_t kManySegments = 1u << 17;
#endif

inline bool isLarge(const Outline& outline) { return kCanFetch && outline.segments.maxId() >= kManySegments; }

// Three steps for a cell and the eight around it. At the boundary of a chunk they do nothing.

inline void fetchCells(const Outline& outline, CellAt at, std::uint32_t cellRef) {
  if (!isInner(at.local)) return;
  for (std::uint32_t local = at.local - kChunkSize; local <= at.local + kChunkSize; local += kChunkSize) {
    prefetch(&at.chunk->cells[local]);
    prefetch(&at.chunk->facts[local]);
  }
  outline.lists.forEachPlaceAround(cellRef, [](const void* place) { prefetch(place); });
}
inline void fetchLists(const Outline& outline, std::uint32_t cellRef) {
  if (outline.lists.hasShortLists(cellRef / kChunkCells)) return;  // they are there already
  outline.lists.forEachAround(cellRef, [](CellSegments list) { prefetch(list.ids()); });
}
/// Of each list the first three; most cells have no more. A branch on how many there are would be mispredicted.
inline void fetchSegments(const Outline& outline, std::uint32_t cellRef) {
  outline.lists.forEachAround(cellRef, [&](CellSegments list) {
    for (std::uint32_t k = 0; k < 3; ++k) prefetch(&outline.segments[list.ids()[k < list.count() ? k : 0]]);
  });
}

/// The first two, before an edit, which may be the only one until the commit. By number: to read the chunk, which is in
/// no cache either, before it is known where the lists are noted would be one more wait.
void fetchAround(const Outline& outline, const Grid& grid, std::uint32_t cellRef);

/// Calls visit(CellAt) for the changed cells of a chunk, or for the first of many: these lie close to each other.
template <class Visit>
void forEachScattered(const Chunk& chunk, Visit&& visit) {
  std::uint32_t left = 32;
  for (RowMask rows = chunk.dirtyRows; rows != 0; rows &= rows - 1) {
    const auto row = static_cast<std::uint32_t>(std::countr_zero(rows));
    for (RowMask cells = chunk.dirty[row]; cells != 0; cells &= cells - 1) {
      if (left == 0) return;
      --left;
      visit(CellAt{chunk.self(), row * kChunkSize + static_cast<std::uint32_t>(std::countr_zero(cells))});
    }
  }
}

/// Calls visit(chunk) for each of these. While one is visited the memory for the next two is on its way.
template <class Visit>
void forEachFetched(const Outline& outline, std::span<Chunk* const> chunks, Visit&& visit) {
  for (std::size_t k = 0; k < chunks.size() + 2; ++k) {
    if (k < chunks.size()) forEachScattered(*chunks[k], [&](CellAt at) { fetchCells(outline, at, at.ref()); });
    if (k >= 1 && k <= chunks.size())
      forEachScattered(*chunks[k - 1], [&](CellAt at) { fetchLists(outline, at.ref()); });
    if (k < 2) continue;
    forEachScattered(*chunks[k - 2], [&](CellAt at) { fetchSegments(outline, at.ref()); });
    visit(*chunks[k - 2]);
  }
}

}  // namespace lgs::detail
