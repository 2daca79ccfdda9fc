#include "outline/segment_lists.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace lgs::detail {

SegmentLists::ShownChunk& SegmentLists::make(const Chunk& chunk) {
  if (chunk.index >= chunks_.size()) chunks_.addMissing(chunk.index + 1 - chunks_.size());
  return chunks_.make(chunk.index);
}

std::uint32_t* SegmentLists::splice(CellAt at, std::uint32_t begin, std::uint32_t removed, std::uint32_t added) {
  ShownChunk* there = shownBy(*at.chunk);
  ShownChunk& shown = there ? *there : make(*at.chunk);
  RecordArena::Ref& ref = shown.lists[at.local];
  const RecordArena::Ref old = ref;
  const std::uint32_t before = old != 0 ? CellSegments(arena_.at(old)).count() : 0, count = before - removed + added;
  assert(begin + removed <= before);
  const std::uint32_t oldSize = Layout::kWords + before, newSize = Layout::kWords + count;
  RowMask& live = shown.live[at.row()];
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

void SegmentLists::forget(std::uint32_t chunk) {
  if (!shownBy(chunk)) return;
  chunks_.drop(chunk);
  std::size_t size = chunks_.size();
  while (size != 0 && !chunks_.has(size - 1)) --size;
  chunks_.shorten(size);
}

}  // namespace lgs::detail
