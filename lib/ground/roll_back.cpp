// The ground's part of roll-back and redo: what a note of it is exchanged with.
#include "ground/ground.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lgs::detail {
/// Before a cell gets another word. The note takes over what its word stands for, if there is to be one.
void Ground::noteOrDrop(CellAt at) {
  Note* note = journal.addOnce(Thing::cell, at.ref());
  if (note == nullptr) return drop(at.word());
  note->wasClean = (at.chunk->dirty[at.row()] & at.bit()) == 0;
  note->block = at.chunk->block(at.local);
  note->value = moveOut(at.word(), journal);
}

void Ground::exchange(Note& note) {
  if (note.thing == Thing::cell) return exchangeCell(note);
  if (note.thing == Thing::chunk) return exchangeChunk(note);
  if (note.thing == Thing::streamed) return stream(note.key);
  assert(note.thing == Thing::commit);  // which holds nothing
}

/// Of an unloaded chunk too: of these cells its border has the last word, and not its bytes.
void Ground::exchangeCell(Note& note) {
  const std::uint32_t number = note.key / kChunkCells, local = note.key % kChunkCells;
  Border* border = grid.border(number);
  if (border) border->bytesAreStale = true;
  const auto swap = [&](CellWord word, Block& block) {
    const CellWord then = moveIn(note.value, journal);
    note.value = moveOut(word, journal);
    std::swap(note.block, block);
    return then;
  };
  if (border && !isAtRim(local)) {
    Border::Kept& kept = border->keptAt(local);
    kept.word = swap(kept.word, kept.block);
    return;
  }
  if (border) wakeRim(number);
  const CellAt at{&grid.chunk(number), local};
  Block block = at.chunk->block(local);
  const CellWord then = swap(at.word(), block);
  lay(at, then, block);
}

/// A chunk that an edit made is gone before that, unless it is unloaded: then it holds nothing there, and was there at
/// all times.
void Ground::exchangeChunk(Note& note) {
  if (note.isMoot) return;
  if (grid.stateOf(note.key) == ChunkState::none) {
    [[maybe_unused]] const CellAt at =
        grid.obtain(cellIn(static_cast<std::int32_t>(note.value), static_cast<std::int32_t>(note.block), 0));
    assert(at.chunk->index == note.key);  // the least number that is free
    refreshAround(note.key);
    if (note.isGivenUp) stream(note.key);
    return;
  }
  note.isMoot = grid.border(note.key) != nullptr;
  if (note.isMoot) return;
  refreshAround(note.key);
  for (const CellWord word : grid.chunk(note.key).cells) drop(word);
  grid.forget(note.key);
}

void Ground::drop(const Note& note) {
  if (note.thing == Thing::cell) {
    dropCell(note);
    const Border* border = grid.border(note.key / kChunkCells);
    const bool isWaiting = !spare_.empty() && spare_.back() == note.key / kChunkCells;
    if (border && !border->kept.empty() && !isWaiting) spare_.push_back(note.key / kChunkCells);
  } else if (note.thing == Thing::segment || note.thing == Thing::list) {
    journal.release(note.value);
  }
}

/// What a cell held.
void Ground::dropCell(const Note& note) {
  catalogue.release(held(note).content());
  if (isListed(note.value)) journal.release(note.value & ~kListBit);
}

void Ground::takeBack(Journal::Moment moment) {
  journal.undoTo(
      moment, Undone::drop,
      [this](Note& note) {
        if (note.thing == Thing::cell && note.wasClean) setClean(grid.find(note.key));
        exchange(note);
      },
      [this](const Note& note) { drop(note); });
}

}  // namespace lgs::detail
