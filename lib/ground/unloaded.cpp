// Chunks leave memory, and come back. That changes which chunks are here, and not what the ground is: so no cell is noted
// for it, and no roll-back undoes it; the next commit notes which outlines it renewed (Thing::streamed).
//
// Of an unloaded chunk the border stays known (border.h). While a loaded chunk is beside it, its cells at the rim hold
// what they held, so that a commit can show and link them as ever: what is loaded gets the segments and ghosts that it
// has in the whole world (law 14). Otherwise it is asleep. A roll-back changes what a cell is, loaded or not: of each
// cell that there is a note of the border keeps what it is, and not what the bytes say.
//
// What is to be done goes into lists of work (ground.h). The next commit does it all, in the order of places.
#include "geometry/sort.h"
#include "ground/ground.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>

namespace lgs::detail {
namespace {

/// Whether a chunk lies in a rectangle as a whole. Cells that there are not need not.
bool isWithin(const CellRect& cells, std::int32_t ci, std::int32_t cj) {
  const auto fits = [](std::int32_t chunk, std::int32_t min, std::int32_t max) {
    const std::int32_t first = chunk * kChunkSize, last = first + kChunkSize - 1;
    return min <= std::max(first, -kMaxCell) && std::min(last, kMaxCell) <= max;
  };
  return fits(ci, cells.min.i, cells.max.i) && fits(cj, cells.min.j, cells.max.j);
}

}  // namespace

// --- Which chunks

std::vector<std::uint32_t> Ground::byRows(std::vector<std::uint32_t> numbers) const {
  std::vector<std::tuple<std::int32_t, std::int32_t, std::uint32_t>> places;  // row, column, number
  for (const std::uint32_t number : numbers)
    if (const auto place = grid.placeOf(number)) places.emplace_back(place->second, place->first, number);
  detail::sort(places);
  numbers.clear();
  for (const auto& [row, column, number] : places)
    if (numbers.empty() || numbers.back() != number) numbers.push_back(number);
  return numbers;
}

std::vector<std::uint32_t> Ground::chunksWithin(const CellRect& cells, bool areUnloaded) const {
  std::vector<std::uint32_t> numbers;
  if (areUnloaded && grid.unloadedCount() == 0) return numbers;
  grid.forEachNumber(cells, [&](std::uint32_t number) {
    const auto [ci, cj] = *grid.placeOf(number);
    if ((grid.border(number) != nullptr) == areUnloaded && isWithin(cells, ci, cj)) numbers.push_back(number);
  });
  return byRows(std::move(numbers));
}

std::optional<Cell> Ground::firstUnloaded(const CellRect& cells) const {
  // Chunks at the end of the world have cells that there are not.
  const CellRect there{{std::max(cells.min.i, -kMaxCell), std::max(cells.min.j, -kMaxCell)},
                       {std::min(cells.max.i, kMaxCell), std::min(cells.max.j, kMaxCell)}};
  if (lgs::isEmpty(there)) return std::nullopt;
  const auto chunk = grid.firstUnloaded(there);
  if (!chunk) return std::nullopt;
  return Cell{std::max(chunk->first * kChunkSize, there.min.i), std::max(chunk->second * kChunkSize, there.min.j)};
}

std::vector<std::uint32_t> Ground::forgetChunks(const CellRect& cells) {
  assert(!hasChanged());
  std::vector<std::uint32_t> gone;
  for (const std::uint32_t number : chunksWithin(cells, false))
    if (std::ranges::all_of(grid.chunk(number).cells, [&](CellWord word) { return held(word).size() == 0; }))
      gone.push_back(number);
  for (const std::uint32_t number : gone) {
    const Chunk& chunk = grid.chunk(number);
    for (const Chunk* beside : chunk.around)
      if (beside && beside->isUnloaded) refreshLater(beside->index);
    for (const CellWord word : chunk.cells) drop(word);
    grid.forget(number);
  }
  for (const std::uint32_t number : chunksWithin(cells, true)) {
    const Border& border = *grid.border(number);
    if (grid.stateOf(number) != ChunkState::asleep || grid.hasLoadedBeside(border) || border.bytesAreStale) continue;
    for (const Border::Run& run : border.runs) drop(run.word);
    for (const Border::Kept& kept : border.kept) drop(kept.word);
    grid.forget(number);
    gone.push_back(number);
  }
  return gone;
}

// --- Leaving and coming back

/// The cells of a chunk that there are notes of, of what may come back too.
CellMask Ground::notedCells(std::uint32_t number) const {
  CellMask noted{};
  if (!journal.isOn()) return noted;
  for (std::uint32_t local = 0; local < kChunkCells; ++local)
    if (journal.isCellNoted(number * kChunkCells + local)) insert(noted, local);
  return noted;
}

void Ground::unload(std::uint32_t number, std::uint32_t checksum) {
  Chunk& chunk = grid.chunk(number);
  const CellMask noted = notedCells(number);
  Border border;
  border.checksum = checksum;
  for (CellAt at{&chunk, 0}; at.local < kChunkCells; ++at.local) {
    const bool isNoted = contains(noted, at.local), isRim = isAtRim(at.local);
    if (isNoted)
      border.kept.push_back(isRim ? Border::Kept{at.local} : Border::Kept{at.local, at.word(), chunk.block(at.local)});
    else
      border.lastSerial = std::max(border.lastSerial, held(at).lastSerial());
    if (isRim && (isNoted || held(at).size() != 0)) continue;
    if (!isNoted) drop(at.word());
    lay(at, 0, 0);
  }
  shrink(border.kept);
  grid.unload(chunk, std::move(border));
  stream(number);
}

Chunk& Ground::load(std::uint32_t number, CellMask& known) {
  wakeRim(number);
  Chunk& chunk = grid.chunk(number);
  const Border border = grid.load(chunk);
  known = {};
  for (const Border::Kept& kept : border.kept) {
    insert(known, kept.local);
    if (!isAtRim(kept.local)) lay({&chunk, kept.local}, kept.word, kept.block);
  }
  for (std::uint32_t k = 0; k < kRimCells; ++k) {
    const CellAt at{&chunk, rimCell(k)};
    if (!contains(known, at.local)) empty(at);
  }
  stream(number);
  return chunk;
}

/// The greatest serial that a cell of an unloaded chunk gave out, as the world is.
std::uint32_t Ground::lastSerialIn(std::uint32_t number) {
  wakeRim(number);
  const Border& border = *grid.border(number);
  std::uint32_t last = border.lastSerial;
  for (std::uint32_t k = 0; k < kRimCells; ++k)
    last = std::max(last, held(CellAt{&grid.chunk(number), rimCell(k)}).lastSerial());
  for (const Border::Kept& kept : border.kept) last = std::max(last, held(kept.word).lastSerial());
  return last;
}

/// None of its serials is given out again, nor one of what was undone and may be redone, which is gone then. What was
/// undone for good gave out none (law 12). Where another chunk had its number, that one's notes are left alone.
void Ground::loadEmpty(std::uint32_t number) {
  std::uint32_t lastSerial = lastSerialIn(number);
  const std::pair place = *grid.placeOf(number);
  const bool withUndone = std::ranges::none_of(std::as_const(journal).undone(), [&](const Note& note) {
    const std::pair then{static_cast<std::int32_t>(note.value), static_cast<std::int32_t>(note.block)};
    return note.thing == Thing::chunk && note.key == number && then != place;
  });
  const auto isOfChunk = [&](const Note& note) {
    return note.thing == Thing::cell && note.key / kChunkCells == number;
  };
  const std::array all{journal.notes(), withUndone ? journal.undone() : std::span<Note>()};
  for (const std::span<Note> notes : all)
    for (const Note& note : notes)
      if (isOfChunk(note)) lastSerial = std::max(lastSerial, held(note).lastSerial());
  for (const std::span<Note> notes : all) {
    for (Note& note : notes) {
      if (note.thing == Thing::chunk && note.key == number) note.isGivenUp = true;
      if (!isOfChunk(note)) continue;
      dropCell(note);
      note.value = moveOut(wordFor(kEmptyContent, lastSerial, {}), journal);
    }
  }
  CellMask known;
  Chunk& chunk = load(number, known);
  for (CellAt at{&chunk, 0}; at.local < kChunkCells; ++at.local) {
    drop(at.word());
    lay(at, inRange(at.cell()) ? wordFor(kEmptyContent, lastSerial, {}) : 0, 0);
  }
}

Held Ground::heldNow(std::uint32_t ref) {
  const std::uint32_t number = ref / kChunkCells, local = ref % kChunkCells;
  if (Border* border = grid.border(number)) {
    if (!isAtRim(local)) {
      const Border::Kept& kept = border->keptAt(local);
      return held(kept.word, kept.block);
    }
    wakeRim(number);
  }
  return held(CellAt{&grid.chunk(number), local});
}

// --- Awake and asleep

void Ground::wakeRim(std::uint32_t number) {
  Border& border = *grid.border(number);
  Chunk& chunk = grid.wake(number);
  if (border.isRimInChunk) return;
  border.isRimInChunk = true;
  std::uint32_t k = 0;
  for (const Border::Run& run : std::exchange(border.runs, {})) {
    for (std::uint32_t n = 0; n < run.cells; ++n) {
      if (n != 0) catalogue.use(held(run.word).content());
      lay({&chunk, rimCell(k++)}, run.word, run.block);
    }
  }
  refreshLater(number);
}

void Ground::putRimToSleep(std::uint32_t number) {
  Border& border = *grid.border(number);
  if (!border.isRimInChunk) return;
  border.isRimInChunk = false;
  Chunk& chunk = grid.chunk(number);
  for (std::uint32_t k = 0; k < kRimCells; ++k) {
    const CellAt at{&chunk, rimCell(k)};
    const CellWord word = at.word();
    const Block block = hasSole(word) ? chunk.block(at.local) : 0;
    Border::Run* last = border.runs.empty() ? nullptr : &border.runs.back();
    if (last && !isListed(word) && last->word == word && last->block == block) {
      ++last->cells;
      drop(word);
    } else {
      border.runs.push_back({1, word, block});
    }
    lay(at, 0, 0);
  }
  shrink(border.runs);
}

/// Kept cells of which no note is left are as the bytes say, unless the world rolled back since.
void Ground::trim(std::uint32_t number) {
  Border& border = *grid.border(number);
  if (border.kept.empty() || border.bytesAreStale) return;
  const CellMask noted = notedCells(number);
  std::erase_if(border.kept, [&](const Border::Kept& kept) {
    if (contains(noted, kept.local)) return false;
    border.lastSerial = std::max(border.lastSerial, held(kept.word).lastSerial());
    drop(kept.word);
    return true;
  });
  giveBackSpare(border.kept);
}

// --- The work of the next commit

void Ground::doStreaming() {
  const std::vector<std::uint32_t> streamed = byRows(std::exchange(streamed_, {}));
  for (const std::uint32_t number : streamed) {
    noteStreamed(number);
    grid.wake(number);
    refreshAround(number);
  }
  std::vector<std::uint32_t> changed = byRows(std::exchange(rims_, {}));
  for (const std::uint32_t number : changed) refreshRim(number);
  rims_.clear();  // those that were woken just now
  changed.insert(changed.end(), streamed.begin(), streamed.end());
  for (const std::uint32_t number : byRows(std::move(changed)))
    if (grid.stateOf(number) != ChunkState::asleep) touchAll(grid.chunk(number));
  for (const std::uint32_t number : byRows(std::exchange(spare_, {})))
    if (grid.border(number)) trim(number);
}

/// The outline of a chunk changes by what is loaded, and is another one after a roll-back beyond that.
void Ground::noteStreamed(std::uint32_t number) {
  if (journal.isOn()) journal.addOnce(Thing::streamed, number);
}

void Ground::refreshAround(std::uint32_t number) {
  if (grid.unloadedCount() == 0) return;
  const auto [ci, cj] = *grid.placeOf(number);
  grid.forEachAround(ci, cj, [this](std::uint32_t there, std::size_t) {
    if (grid.border(there)) refreshLater(there);
  });
}

/// The cells at the rim of an unloaded chunk hold what they held, if somebody needs that, or nothing.
void Ground::refreshRim(std::uint32_t number) {
  const Border* border = grid.border(number);
  if (!border) return;
  if (grid.hasLoadedBeside(*border)) {
    wakeRim(number);
  } else {
    putRimToSleep(number);
    sleepy_.push_back(number);
  }
  if (grid.stateOf(number) != ChunkState::asleep) noteStreamed(number);
}

std::vector<std::uint32_t> Ground::sleep() {
  std::vector<std::uint32_t> asleep = std::exchange(sleepy_, {});
  std::erase_if(asleep, [&](std::uint32_t number) {
    return grid.stateOf(number) != ChunkState::awake || grid.border(number)->isRimInChunk;
  });
  for (const std::uint32_t number : asleep) grid.sleep(number);
  return asleep;
}

}  // namespace lgs::detail
