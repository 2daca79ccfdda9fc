#include "ground/ground.h"

#include <algorithm>
#include <bit>

namespace lgs::detail {

Ground::Ground(const Ground& other)
    : preserve(other.preserve),
      catalogue(other.catalogue),
      grid(other.grid),
      lists_(other.lists_),
      changed_(other.changed_),
      notes_(other.notes_),
      notedLists_(other.notedLists_),
      dropped_(other.dropped_),
      forgotten_(other.forgotten_),
      isNoting_(other.isNoting_) {
  for (Chunk*& chunk : changed_) chunk = grid.chunks()[chunk->index - 1].get();
}

std::optional<Slot> Ground::slotOf(PolygonHandle handle) const {
  const CellAt at = grid.find(handle.cellRef);
  const std::size_t count = content(at).polygons.size();
  for (Slot slot = 0; slot < count; ++slot)
    if (placed(at)[slot].serial == handle.serial) return slot;
  return std::nullopt;
}

void Ground::set(CellAt at, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  const Facts facts = catalogue.use(content);
  const Block block = polygons.empty() ? at.chunk->block(at.local) : polygons[0].block;
  if (fitsWord(lastSerial, polygons))
    put(at, wordOf(content, lastSerial), block, facts);
  else
    put(at, makeList(content, lastSerial, polygons), at.chunk->block(at.local), facts);
}

CellWord Ground::makeList(ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  const RecordArena::Ref ref = lists_.allocate(PolygonList::sizeOf(polygons.size()));
  std::uint32_t* out = lists_.at(ref);
  *out++ = wordOf(content, static_cast<std::uint32_t>(polygons.size()));
  *out++ = lastSerial;
  for (const Placed& placed : polygons) {
    *out++ = placed.serial;
    *out++ = placed.block;
  }
  return kListBit | ref;
}

void Ground::dropList(CellWord word) {
  const PolygonList old = list(word);
  catalogue.release(old.content());
  lists_.release(word & ~kListBit, PolygonList::sizeOf(old.size()));
}

void Ground::commit() {
  for (std::size_t k = changed_.size(); k-- != 0;) {  // backwards, so that going back meets them in order
    Chunk& chunk = *changed_[k];
    for (RowMask rows = chunk.dirtyRows; rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::uint32_t>(std::countr_zero(rows));
      if (isNoting_) notes_.push_back({chunk.index * kChunkSize + row, chunk.dirty[row], 0, Note::Of::row});
      chunk.dirty[row] = 0;
    }
    chunk.dirtyRows = 0;
  }
  changed_.clear();
  catalogue.collect();
}

// The note takes over what the word stands for. A list is copied, so that the arena grows with the cells and not with
// the notes.
void Ground::note(CellAt at) {
  const bool isChanged = (at.chunk->dirty[at.row()] & at.bit()) != 0;
  CellWord word = at.word();
  if (isListed(at)) {
    const std::uint32_t size = PolygonList::sizeOf(list(word).size());
    const std::uint32_t* words = lists_.at(word & ~kListBit);
    notedLists_.insert(notedLists_.end(), words, words + size);
    lists_.release(word & ~kListBit, size);
    word = kListBit | size;
  }
  notes_.push_back({at.ref(), word, at.chunk->block(at.local), isChanged ? Note::Of::changedCell : Note::Of::cell});
}

/// What the word of a cell was before the last note.
CellWord Ground::takeBack(const Note& note) {
  if ((note.word & kListBit) == 0) return note.word;
  const std::uint32_t size = note.word & ~kListBit;
  const RecordArena::Ref ref = lists_.allocate(size);
  std::copy(notedLists_.end() - size, notedLists_.end(), lists_.at(ref));
  notedLists_.erase(notedLists_.end() - size, notedLists_.end());
  return kListBit | ref;
}

/// Lets go of what the first note has taken over.
void Ground::forgetFirst(const Note& note) {
  if (note.of == Note::Of::row) return;
  if ((note.word & kListBit) == 0) return drop(note.word);
  catalogue.release(notedLists_.front() >> kLowBits);
  notedLists_.erase(notedLists_.begin(), notedLists_.begin() + (note.word & ~kListBit));
}

void Ground::undo(const Note& note) {
  if (note.of == Note::Of::row) {
    Chunk& chunk = *grid.chunks()[note.ref / kChunkSize - 1];
    if (chunk.dirtyRows == 0) changed_.push_back(&chunk);
    chunk.dirtyRows |= RowMask{1} << note.ref % kChunkSize;
    chunk.dirty[note.ref % kChunkSize] = note.word;
    return;
  }
  const CellAt at = grid.find(note.ref);
  drop(at.word());
  at.word() = takeBack(note);
  if (!isListed(at) && note.word >> kLowBits != kEmptyContent) at.chunk->setBlock(at.local, note.block);
  at.chunk->facts[at.local] = catalogue.facts(contentId(at));
  if (note.of == Note::Of::changedCell) return;
  at.chunk->dirty[at.row()] &= ~at.bit();
  if (at.chunk->dirty[at.row()] == 0) at.chunk->dirtyRows &= ~(RowMask{1} << at.row());
  if (at.chunk->dirtyRows == 0) changed_.pop_back();  // the edit was the first in its chunk
}

void Ground::goBack(const Moment& moment) {
  for (; now().notes > moment.notes; notes_.pop_back()) undo(notes_.back());
  grid.forgetChunks(moment.chunks);
  catalogue.forgetShapes(moment.shapes);
}

void Ground::stopNoting() {
  isNoting_ = false;
  forgetBefore(now());
  constexpr std::size_t kMost = 4'096;
  if (notes_.capacity() > kMost) notes_ = std::vector<Note>();
}

void Ground::forgetBefore(const Moment& moment) {
  for (; forgotten_ + dropped_ < moment.notes; ++dropped_) forgetFirst(notes_[dropped_]);
  if (dropped_ < notes_.size() / 2) return;  // the rest moves to the front seldom
  notes_.erase(notes_.begin(), notes_.begin() + static_cast<std::ptrdiff_t>(dropped_));
  forgotten_ += std::exchange(dropped_, 0);
}

std::uint64_t Ground::bytes() const {
  return grid.bytes() + catalogue.bytes() + lists_.bytes() + changed_.capacity() * sizeof changed_[0] +
         notes_.capacity() * sizeof notes_[0] + notedLists_.size() * sizeof notedLists_[0];
}

}  // namespace lgs::detail
