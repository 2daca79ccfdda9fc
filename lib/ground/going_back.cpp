// The ground's part of going back and forward: what a note of it is exchanged with.
#include "ground/ground.h"

#include <array>
#include <cassert>

namespace lgs::detail {
namespace {

constexpr std::size_t kBorderHead = 4, kRunWords = 3;  // of a border that the journal keeps

}  // namespace

/// Before a cell gets another word. The note takes over what its word stands for, if there is to be one.
void Ground::noteOrDrop(CellAt at) {
  if (journal.isNoted(Thing::cell, at.ref())) return drop(at.word());
  Note& note = journal.add(Thing::cell, at.ref());
  note.wasClean = (at.chunk->dirty[at.row()] & at.bit()) == 0;
  note.block = at.chunk->block(at.local);
  note.value = moveOut(at, journal);
}

void Ground::exchange(Note& note) {
  if (note.thing == Thing::cell) {
    const CellAt at = grid.find(note.key);
    const Block block = at.chunk->block(at.local);
    const CellWord word = moveOut(at, journal);
    moveIn(at, note.value, note.block, journal);
    note.value = word;
    note.block = block;
  } else if (note.thing == Thing::border) {
    Chunk& chunk = grid.chunk(note.key);
    const std::uint32_t border = chunk.isUnloaded ? keep(grid.load(chunk)) : 0;
    if (note.value != 0) {
      grid.unload(chunk, takeKept(note.value));
      sleepy_.push_back(note.key);
    }
    note.value = border;
  } else if (note.thing == Thing::chunk) {
    const Cell corner{static_cast<std::int32_t>(note.value) * kChunkSize,
                      static_cast<std::int32_t>(note.block) * kChunkSize};
    if (grid.placeOf(note.key)) {
      grid.forget(note.key);
    } else {
      [[maybe_unused]] const CellAt at = grid.obtain(corner);
      assert(at.chunk->index == note.key);  // the least number that is free
    }
  } else {
    assert(note.thing == Thing::commit);  // which holds nothing
  }
}

void Ground::drop(const Note& note) {
  if (note.thing == Thing::cell) return dropMoved(note.value, journal);
  if (note.thing == Thing::border && note.value != 0) {
    for (const Border::Run& run : takeKept(note.value).runs) drop(run.word);
  } else if (note.thing == Thing::segment || note.thing == Thing::list) {
    journal.release(note.value);
  }
}

void Ground::forEachNotedContent(const std::function<void(ContentId)>& visit) const {
  journal.forEach([&](const Note& note) {
    if (note.thing == Thing::cell) {
      const Held held = this->held(note);
      visit(held.list != nullptr ? PolygonList(held.list).content() : held.word >> kLowBits);
    } else if (note.thing == Thing::border && note.value != 0) {
      const std::span<const std::uint32_t> words = journal.kept(note.value);
      for (std::size_t k = kBorderHead; k < words.size(); k += kRunWords) visit(contentOf(words[k + 1]));
    }
  });
}

void Ground::takeBack(Journal::Moment moment) {
  journal.undoTo(
      moment, Undone::drop,
      [this](Note& note) {
        if (note.thing == Thing::cell && note.wasClean) setUnchanged(grid.find(note.key));
        exchange(note);
      },
      [this](const Note& note) { drop(note); });
}

// --- A border as words: some numbers, and then the runs

std::uint32_t Ground::keep(const Border& border) {
  std::vector<std::uint32_t> words{static_cast<std::uint32_t>(border.ci), static_cast<std::uint32_t>(border.cj),
                                   border.checksum, border.lastSerial};
  for (const Border::Run& run : border.runs)
    words.insert(words.end(), {run.cells | std::uint32_t{run.facts} << 8, run.word, run.block});
  return journal.keep(words);
}

Border Ground::takeKept(std::uint32_t kept) {
  const std::span<const std::uint32_t> words = journal.kept(kept);
  Border border{static_cast<std::int32_t>(words[0]), static_cast<std::int32_t>(words[1]), words[2], words[3], {}};
  border.runs.reserve((words.size() - kBorderHead) / kRunWords);
  for (std::size_t k = kBorderHead; k < words.size(); k += kRunWords)
    border.runs.push_back({words[k] & 0xffu, words[k] >> 8 & 0xffu, words[k + 1], words[k + 2]});
  journal.release(kept);
  return border;
}

}  // namespace lgs::detail
