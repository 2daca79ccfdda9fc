#include "outline/segment_lists.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace lgs::detail {

void SegmentLists::make(const Chunk& chunk) {
  if (chunk.index >= short_.size()) {
    const std::size_t more = chunk.index + 1 - short_.size();
    short_.addMissing(more);
    refs_.addMissing(more);
  }
  std::uint32_t inside = 0;
  if ((chunk.everFacts & kInside) != 0)
    for (const Facts facts : chunk.facts) inside += facts / kInside & 1u;
  if (inside >= kChunkCells * 3 / 4)
    short_.make(chunk.index);
  else
    refs_.make(chunk.index);
}

std::uint32_t* SegmentLists::splice(CellAt at, std::uint32_t begin, std::uint32_t removed, std::uint32_t added) {
  const std::uint32_t number = at.chunk->index;
  if (!liveOf(number)) [[unlikely]]
    make(*at.chunk);
  if (short_.has(number)) return spliceShort(at, begin, removed, added);
  Refs& shown = refs_[number];
  RecordArena::Ref& ref = shown.lists[at.local];
  const RecordArena::Ref old = ref;
  const std::uint32_t before = old != 0 ? CellSegments(arena_.at(old)).count() : 0, count = before - removed + added;
  assert(begin + removed <= before);
  const std::uint32_t oldSize = Layout::kWords + before, newSize = Layout::kWords + count;
  RowMask& live = shown.rows[at.row()];
  if (count == 0) {
    live &= ~at.bit();
    if (old != 0) arena_.release(old, oldSize);
    ref = 0;
    return nullptr;
  }
  if (old == 0) {
    live |= at.bit();
    ref = arena_.allocate(newSize);
    return arena_.at(ref);
  }
  const std::uint32_t *from = arena_.at(old), keep = Layout::kWords + begin, rest = keep + removed;
  if (!RecordArena::sameSize(newSize, oldSize)) {
    ref = arena_.allocate(newSize);
    std::copy_n(from, keep, arena_.at(ref));
  }
  std::uint32_t* words = arena_.at(ref);
  std::memmove(words + keep + added, from + rest, (oldSize - rest) * sizeof *from);
  if (ref != old) arena_.release(old, oldSize);
  return words;
}

std::uint32_t* SegmentLists::spliceShort(CellAt at, std::uint32_t begin, std::uint32_t removed, std::uint32_t added) {
  ShortLists& shown = short_[at.chunk->index];
  ShortList& list = shown.lists[at.local];
  RowMask& live = shown.rows[at.row()];
  const CellSegments old = of(list);
  const std::uint32_t before = old.count(), count = before - removed + added;
  assert(begin + removed <= before);
  if (count == 0) {
    live &= ~at.bit();
    if (before > kMostShort) arena_.release(list[0], Layout::kWords + before);
    list = {};
    return nullptr;
  }
  live |= at.bit();
  if (before == 0 && count <= kMostShort) return list.data();
  const std::uint32_t oldSize = Layout::kWords + before, newSize = Layout::kWords + count;
  const RecordArena::Ref ref = before > kMostShort ? list[0] : 0;
  RecordArena::Ref now = 0;
  if (count > kMostShort) now = ref != 0 && RecordArena::sameSize(oldSize, newSize) ? ref : arena_.allocate(newSize);
  const std::uint32_t *from = old.words().data(), keep = Layout::kWords + begin, rest = keep + removed;
  std::uint32_t* words = now != 0 ? arena_.at(now) : list.data();
  if (words != from) std::copy_n(from, keep, words);
  std::memmove(words + keep + added, from + rest, (before - begin - removed) * sizeof *words);
  if (ref != 0 && ref != now) arena_.release(ref, oldSize);
  if (now != 0) list = {now, 0, kElsewhere};
  return words;
}

void SegmentLists::forget(std::uint32_t chunk) {
  if (!liveOf(chunk)) return;
  short_.has(chunk) ? short_.drop(chunk) : refs_.drop(chunk);
  std::size_t size = short_.size();
  while (size != 0 && !liveOf(static_cast<std::uint32_t>(size) - 1)) --size;
  short_.shorten(size);
  refs_.shorten(size);
}

}  // namespace lgs::detail
