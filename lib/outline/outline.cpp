#include "outline/outline.h"

#include "storage/held_bytes.h"

namespace lgs::detail {

std::span<const SegmentId> Outline::createIds(std::size_t count) {
  changes_.added.reserve(count);
  for (; count != 0; --count) changes_.added.push_back({segments.take()});
  return changes_.added;
}

void Outline::load(std::uint32_t count, std::vector<std::uint32_t> free, std::span<const std::uint32_t> removed) {
  segments.reset(count, std::move(free));
  for (const std::uint32_t id : removed) changes_.removed.push_back({id});
}

std::uint64_t Outline::liveCount(const Grid& grid) const {
  std::uint64_t count = segments.maxId() - segments.free().size() - changes_.removed.size();
  if (hasHidden()) {
    for (Chunk* chunk : grid.chunks())
      for (CellAt at{chunk, 0}; isHidden(chunk->index) && at.local < kChunkCells; ++at.local)
        count -= lists.of(at).count();
  }
  return count;
}

void Outline::forget(std::uint32_t chunk) {
  lists.forget(chunk);
  if (isHidden(chunk)) toggleHidden(chunk);
  while (!hidden_.empty() && hidden_.back() == 0) hidden_.pop_back();
  giveBackSpare(hidden_);
}

/// A chunk was loaded and is unloaded now, or the other way around.
void Outline::toggleHidden(std::uint32_t chunk) {
  if (hidden_.size() <= chunk) hidden_.resize(std::size_t{chunk} + 1);
  hidden_[chunk] ^= kHidden | kWasHidden;
  isHidden(chunk) ? ++hiddenChunks_ : --hiddenChunks_;
}

std::uint64_t Outline::bytes() const {
  std::uint64_t sum = segments.bytes() + lists.bytes() + bytesOf(changes_) + bytesOf(shown_) +
                      heldBytes(hidden_, turned_, ids_, fan_, notes_, undone_) + notedSegments_.bytes() +
                      notedLists_.bytes();
  for (const Note& n : notes_) sum += n.bytes();
  for (const UndoneNote& u : undone_) sum += u.note.bytes() + heldBytes(u.removed, u.freeTaken, u.segments, u.lists);
  return sum;
}

}  // namespace lgs::detail
