// What the outline keeps. commit.cpp has the algorithm, and roll_back.cpp what marks need.
#include "outline/outline.h"

#include "outline/fetch.h"
#include "storage/vectors.h"

namespace lgs::detail {

std::span<const SegmentId> Outline::createIds(std::size_t count) {
  changes_.added.reserve(count);
  for (; count != 0; --count) changes_.added.push_back({segments.take()});
  return changes_.added;
}

std::uint64_t Outline::liveCount(const Grid& grid) const {
  std::uint64_t count = segments.maxId() - segments.free().size();
  for (const std::uint32_t chunk : hidden_)
    for (CellAt at = grid.find(chunk * kChunkCells); at && at.local < kChunkCells; ++at.local)
      count -= lists.of(at).count();
  return count;
}

void Outline::forget(std::uint32_t chunk) {
  lists.forget(chunk);
  setHidden(chunk, false);
}

void fetchAround(const Outline& outline, const Grid& grid, std::uint32_t cellRef) {
  const CellAt at = grid.find(cellRef);
  if (!at) return;
  prefetch(at.chunk);
  prefetch(&at.chunk->dirty[at.row()]);
  fetchCells(outline, at, cellRef);
  fetchLists(outline, cellRef);
}

std::uint64_t Outline::bytes() const {
  return segments.bytes() + lists.bytes() + bytesOf(changes_) + bytesOf(shown_) + tableBytes(hidden_) +
         heldBytes(ids_, fan_);
}

}  // namespace lgs::detail
