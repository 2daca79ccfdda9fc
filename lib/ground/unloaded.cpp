// Chunks that leave memory, and come back. Of an unloaded chunk the border stays known (border.h). While a loaded chunk
// is beside it, its cells at the rim hold what they held, so that a commit can show and link them as ever: what is
// loaded gets the segments and ghosts that it has in the whole world (law 14). Otherwise its cells hold nothing, and it
// need not be a Chunk.
//
// Cells are emptied and filled by put(), as edits do it. So marks go back across it.
#include "geometry/sort.h"
#include "ground/ground.h"

#include <algorithm>
#include <cassert>
#include <iterator>
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

bool isAtRim(std::uint32_t local) { return !isInner(local); }

}  // namespace

// --- Which chunks

std::vector<std::uint32_t> Ground::chunksWithin(const CellRect& cells, bool areUnloaded) const {
  constexpr std::int32_t kHalf = 1 << 26;  // columns and rows of chunks are less far from 0
  std::vector<std::uint64_t> places;       // row and column: they sort as numbers
  const auto take = [&](std::int32_t ci, std::int32_t cj) {
    if (isWithin(cells, ci, cj))
      places.push_back(static_cast<std::uint64_t>(cj + kHalf) << 32 | static_cast<std::uint64_t>(ci + kHalf));
  };
  if (areUnloaded)
    grid.forEachUnloaded(cells, [&](std::uint32_t k) { take(grid.border(k)->ci, grid.border(k)->cj); });
  else
    grid.forEachChunk(cells, [&](const Chunk& c) {
      if (!c.isUnloaded) take(c.ci, c.cj);
    });
  detail::sort(places);
  std::vector<std::uint32_t> numbers;
  for (const std::uint64_t place : places)
    numbers.push_back(grid.numberAt(static_cast<std::int32_t>(place & 0xffff'ffff) - kHalf,
                                    static_cast<std::int32_t>(place >> 32) - kHalf));
  return numbers;
}

std::optional<Cell> Ground::firstUnloaded(const CellRect& cells) const {
  std::optional<Cell> first;
  grid.forEachUnloaded(cells, [&](std::uint32_t number) {
    const Border& border = *grid.border(number);
    const Cell here{std::max(border.ci * kChunkSize, cells.min.i), std::max(border.cj * kChunkSize, cells.min.j)};
    if (!first || std::pair(here.j, here.i) < std::pair(first->j, first->i)) first = here;
  });
  return first;
}

std::vector<std::uint32_t> Ground::forget(const CellRect& cells) {
  assert(changedChunks().empty());
  std::vector<std::uint32_t> gone;
  for (const std::uint32_t number : chunksWithin(cells, false))
    if (std::ranges::all_of(grid.chunk(number).cells, [&](CellWord word) { return holdsNothing(word); }))
      gone.push_back(number);
  for (const std::uint32_t number : gone) {
    const Chunk& chunk = grid.chunk(number);
    for (const Chunk* beside : chunk.around)
      if (beside && beside->isUnloaded) stale_.push_back(beside->index);
    for (const CellWord word : chunk.cells) drop(word);
    grid.forget(number);
  }
  for (const std::uint32_t number : chunksWithin(cells, true)) {
    const Border& border = *grid.border(number);
    if (!grid.isAsleep(number) || grid.hasLoadedBeside(border)) continue;
    for (const Border::Run& run : border.runs) drop(run.word);
    grid.forget(number);
    gone.push_back(number);
  }
  return gone;
}

// --- Leaving and coming back

void Ground::unload(std::uint32_t number, std::uint32_t checksum) {
  Chunk& chunk = grid.chunk(number);
  std::uint32_t lastSerial = 0;
  for (CellAt at{&chunk, 0}; at.local < kChunkCells; ++at.local)
    lastSerial = std::max(lastSerial, this->lastSerial(at));
  if (journal.isOn() && !journal.isNoted(Thing::border, number)) journal.add(Thing::border, number);
  Border border = borderOf(chunk);
  border.checksum = checksum;
  border.lastSerial = lastSerial;
  grid.unload(chunk, std::move(border));
  for (CellAt at{&chunk, 0}; at.local < kChunkCells; ++at.local) {
    if (isAtRim(at.local) && !holdsNothing(at.word()))
      touchAgain(at);  // its segments are hidden from now on
    else if (at.word() != 0)
      put(at, 0, 0, 0);
  }
  if (chunk.dirtyRows == 0) touchAgain({&chunk, 0});
  refreshRim(number);
  refreshRimsAround(chunk);
}

Chunk& Ground::load(std::uint32_t number) {
  Chunk& chunk = grid.wake(number);
  const Border border = grid.load(chunk);
  if (journal.isOn() && !journal.isNoted(Thing::border, number)) {
    journal.add(Thing::border, number).value = keep(border);
  } else {
    for (const Border::Run& run : border.runs) drop(run.word);
  }
  if (chunk.dirtyRows == 0) touchAgain({&chunk, 0});
  return chunk;
}

void Ground::loadEmpty(std::uint32_t number) {
  const std::uint32_t lastSerial = grid.border(number)->lastSerial;
  Chunk& chunk = load(number);
  for (CellAt at{&chunk, 0}; at.local < kChunkCells; ++at.local)
    if (inRange(at.cell()) && (at.word() != 0 || lastSerial != 0)) set(at, kEmptyContent, lastSerial, {});
  refreshRimsAround(chunk);
}

/// A cell counts as changed, and holds what it held.
void Ground::touchAgain(CellAt at) {
  if (journal.isOn() && !journal.isNoted(Thing::cell, at.ref())) {
    const CellWord again = copyOf(at.word());
    noteOrDrop(at);
    at.word() = again;
  }
  touch(at, at.chunk->facts[at.local]);
}

// --- What an unloaded chunk holds

/// The cells at its rim hold what they held, if somebody needs that, or nothing.
void Ground::setRim(std::uint32_t number, bool isNeeded) {
  sleepy_.push_back(number);
  if (!isNeeded && grid.isAsleep(number)) return;
  Chunk& chunk = grid.wake(number);
  grid.border(number)->forEachCell([&](std::uint32_t local, const Border::Run& run) {
    const CellAt at{&chunk, local};
    if (run.word == 0 || (at.word() != 0) == isNeeded) return;
    if (isNeeded)
      put(at, copyOf(run.word), run.block, static_cast<Facts>(run.facts));
    else
      put(at, 0, 0, 0);
  });
}

/// Of a number that may be none, or that of a loaded chunk.
void Ground::refreshRim(std::uint32_t number) {
  if (number == Grid::kNoNumber) return;
  if (const Border* border = grid.border(number)) setRim(number, grid.hasLoadedBeside(*border));
}

void Ground::refreshRimsAround(const Chunk& chunk) {
  if (grid.unloadedCount() == 0) return;
  for (std::int32_t dj = -1; dj <= 1; ++dj)
    for (std::int32_t di = -1; di <= 1; ++di)
      if (di != 0 || dj != 0) refreshRim(grid.numberAt(chunk.ci + di, chunk.cj + dj));
}

void Ground::refreshStaleRims() {
  for (const std::uint32_t number : std::exchange(stale_, {})) refreshRim(number);
}

// --- Chunks that are no Chunk

void Ground::sleepLater() {
  areSleepyUnknown_ = true;
  sleepy_.clear();
}

std::vector<std::uint32_t> Ground::sleep() {
  if (std::exchange(areSleepyUnknown_, false)) {
    sleepy_.clear();
    grid.forEachUnloaded(kWholeWorld, [&](std::uint32_t number) { sleepy_.push_back(number); });
  }
  std::vector<std::uint32_t> asleep;
  for (const std::uint32_t number : sleepy_) {
    if (!grid.border(number) || !grid.isAsleep(number)) continue;
    grid.sleep(number);
    asleep.push_back(number);
  }
  sleepy_.clear();
  return asleep;
}

}  // namespace lgs::detail
