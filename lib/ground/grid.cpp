#include "ground/grid.h"

#include <lgs/world.h>

#include <algorithm>
#include <cassert>
#include <functional>

namespace lgs::detail {
namespace {

/// No two places have the same one: mix() makes different hashes of different words.
std::uint64_t hashOf(std::uint64_t seed, std::int32_t ci, std::int32_t cj) {
  return mix(seed, std::uint64_t{static_cast<std::uint32_t>(ci)} << 32 | static_cast<std::uint32_t>(cj));
}

}  // namespace

Grid::Grid(const Grid& other)
    : chunks_(other.chunks_),
      borders_(other.borders_),
      free_(other.free_),
      count_(other.count_),
      unloaded_(other.unloaded_),
      unloadedRows_(other.unloadedRows_),
      index_(other.index_) {
  forEachChunk([this](Chunk& chunk) {
    for (Chunk*& beside : chunk.around)
      if (beside) beside = &chunks_[beside->index];
  });
  if (other.last_) last_ = &chunks_[other.last_->index];
}

bool Grid::isFull() const { return count_ == kMaxChunks; }

// The block of an empty cell means nothing. So one number does until a polygon with another block comes.
void Chunk::makeRoomForBlock(Block block) {
  if (commonBlock == kNoBlock) {
    commonBlock = block;
    return;
  }
  blocks = Owned(std::make_unique_for_overwrite<std::array<Block, kChunkCells>>());
  blocks->fill(static_cast<Block>(commonBlock));
  commonBlock = kNoBlock;
}

std::uint32_t Grid::numberAt(std::int32_t ci, std::int32_t cj) const {
  // The chunk itself is not read: in a large world it is in no cache, and what an edit needs of it is fetched at once.
  return index_.find(hashOf(index_.seed(), ci, cj), [&]([[maybe_unused]] std::uint32_t k) {
    assert(placeOf(k) == std::pair(ci, cj));
    return true;
  });
}

std::optional<std::pair<std::int32_t, std::int32_t>> Grid::placeOf(std::uint32_t number) const {
  if (number >= chunks_.size()) return {};
  if (const Chunk* chunk = chunks_.get(number)) return std::pair(chunk->ci, chunk->cj);
  if (const Border* known = border(number)) return std::pair(known->ci, known->cj);
  return {};
}

Chunk* Grid::findChunk(Cell cell) const {
  const std::uint32_t found = numberAt(cell.i >> 5, cell.j >> 5);
  return found == kNoNumber ? nullptr : chunks_.get(found);
}

Chunk* Grid::obtainChunk(Cell cell) {
  if (Chunk* found = findChunk(cell)) return remember(found);
  assert(!isFull() && !isUnloaded(cell));
  const std::uint32_t number = freeNumber();
  if (number == chunks_.size()) chunks_.addMissing();
  Chunk& chunk = make(number, cell.i >> 5, cell.j >> 5);
  index_.insert(hashOf(index_.seed(), chunk.ci, chunk.cj), number);
  ++count_;
  return remember(&chunk);
}

Chunk& Grid::make(std::uint32_t number, std::int32_t ci, std::int32_t cj) {
  Chunk& chunk = chunks_.make(number);
  chunk.ci = ci;
  chunk.cj = cj;
  chunk.index = number;
  link(chunk);
  return chunk;
}

/// The least one; at most one beyond the last chunk, as all numbers from there on that were ever given out are free.
/// Takes it off the list.
std::uint32_t Grid::freeNumber() {
  if (free_.empty()) return static_cast<std::uint32_t>(chunks_.size());
  std::pop_heap(free_.begin(), free_.end(), std::greater());
  const std::uint32_t number = free_.back();
  free_.pop_back();
  return number;
}

void Grid::link(Chunk& chunk) {
  chunk.around[4] = &chunk;
  for (std::int32_t dj = -1; dj <= 1; ++dj) {
    for (std::int32_t di = -1; di <= 1; ++di) {
      const std::uint32_t found = numberAt(chunk.ci + di, chunk.cj + dj);
      if (found == kNoNumber || !chunks_.has(found)) continue;
      const auto there = 3 * static_cast<std::size_t>(dj + 1) + static_cast<std::size_t>(di + 1);
      chunk.around[there] = &chunks_[found];
      chunks_[found].around[8 - there] = &chunk;
    }
  }
}

void Grid::unlink(const Chunk& chunk) {
  for (std::size_t k = 0; k < chunk.around.size(); ++k)
    if (Chunk* beside = chunk.around[k]; beside && beside != &chunk) beside->around[8 - k] = nullptr;
  if (last_ == &chunk) last_ = nullptr;
}

void Grid::forget(std::uint32_t number) {
  assert(placeOf(number));
  const auto [ci, cj] = *placeOf(number);
  index_.erase(hashOf(index_.seed(), ci, cj), number);
  sleep(number);
  if (border(number)) {
    borders_[number] = {};
    --unloaded_;
    unloadedRows_.erase(ci, cj);
  }
  --count_;
  free_.push_back(number);
  std::push_heap(free_.begin(), free_.end(), std::greater());
  auto last = static_cast<std::uint32_t>(highest());
  while (count_ < last && stateOf(last) == ChunkState::none) --last;
  chunks_.shorten(last + 1);
  while (!borders_.empty() && !borders_.back()) borders_.pop_back();
  giveBackSpare(borders_);
}

void Grid::unload(Chunk& chunk, Border border) {
  assert(!chunk.isUnloaded);
  if (last_ == &chunk) last_ = nullptr;
  chunk.isUnloaded = true;
  if (borders_.size() <= chunk.index) borders_.resize(std::size_t{chunk.index} + 1);
  border.ci = chunk.ci;
  border.cj = chunk.cj;
  borders_[chunk.index] = Owned(std::make_unique<Border>(std::move(border)));
  ++unloaded_;
  unloadedRows_.insert(chunk.ci, chunk.cj);
}

Border Grid::load(Chunk& chunk) {
  assert(chunk.isUnloaded);
  Border border = std::move(*borders_[chunk.index]);
  borders_[chunk.index] = {};
  --unloaded_;
  unloadedRows_.erase(chunk.ci, chunk.cj);
  chunk.isUnloaded = false;
  return border;
}

Chunk& Grid::wake(std::uint32_t number) {
  assert(placeOf(number));
  if (!chunks_.has(number)) make(number, borders_[number]->ci, borders_[number]->cj).isUnloaded = true;
  return chunks_[number];
}

void Grid::sleep(std::uint32_t number) {
  if (!chunks_.has(number)) return;
  unlink(chunks_[number]);
  chunks_.drop(number);
}

std::optional<std::pair<std::int32_t, std::int32_t>> Grid::firstUnloaded(const CellRect& cells) const {
  constexpr std::uint64_t kFew = 16;
  const ChunkRect reach(cells);
  if (unloaded_ == 0) return std::nullopt;
  if (reach.count() > kFew) return unloadedRows_.first(reach);
  for (std::int32_t cj = reach.j0; cj <= reach.j1; ++cj)
    for (std::int32_t ci = reach.i0; ci <= reach.i1; ++ci)
      if (border(numberAt(ci, cj))) return std::pair(ci, cj);
  return std::nullopt;
}

bool Grid::hasLoadedBeside(const Border& border) const {
  for (std::int32_t dj = -1; dj <= 1; ++dj) {
    for (std::int32_t di = -1; di <= 1; ++di) {
      const std::uint32_t there = numberAt(border.ci + di, border.cj + dj);
      if (there != kNoNumber && !this->border(there)) return true;
    }
  }
  return false;
}

std::uint64_t Grid::bytes() const {
  std::uint64_t sum = chunks_.bytes() + free_.capacity() * sizeof free_[0] + index_.bytes() + unloadedRows_.bytes();
  sum += borders_.capacity() * sizeof borders_[0];
  for (const Owned<Border>& border : borders_) sum += border ? border->bytes() : 0;
  forEachChunk([&](const Chunk& chunk) { sum += chunk.blocks ? kChunkCells * sizeof(Block) : 0; });
  return sum;
}

}  // namespace lgs::detail
