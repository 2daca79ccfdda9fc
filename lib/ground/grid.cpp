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
      unloadedPlaces_(other.unloadedPlaces_),
      free_(other.free_),
      count_(other.count_),
      seed_(other.seed_),
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
  blocks.assign(kChunkCells, static_cast<Block>(commonBlock));
  commonBlock = kNoBlock;
}

std::uint32_t Grid::numberAt(std::int32_t ci, std::int32_t cj) const {
  // The chunk itself is not read: in a large world it is in no cache, and what an edit needs of it is fetched at once.
  return static_cast<std::uint32_t>(index_.find(hashOf(seed_, ci, cj)));
}

std::optional<std::pair<std::int32_t, std::int32_t>> Grid::placeOf(std::uint32_t number) const {
  if (number >= chunks_.size()) return {};
  if (const Chunk* chunk = chunks_.get(number)) return std::pair(chunk->ci, chunk->cj);
  if (const Border* known = border(number)) return std::pair(known->ci, known->cj);
  return {};
}

Chunk* Grid::findChunk(Cell cell) const {
  const std::uint32_t found = numberAt(cell.i >> 5, cell.j >> 5);
  return found == kNone ? nullptr : chunks_.get(found);
}

Chunk* Grid::obtainChunk(Cell cell) {
  if (Chunk* found = findChunk(cell)) return remember(found);
  assert(!isFull() && !isUnloaded(cell));
  const std::uint32_t number = freeNumber();
  if (number == chunks_.size()) chunks_.addMissing();
  index_.set(hashOf(seed_, cell.i >> 5, cell.j >> 5), number);
  ++count_;
  return remember(&make(number, cell.i >> 5, cell.j >> 5));
}

Chunk& Grid::make(std::uint32_t number, std::int32_t ci, std::int32_t cj) {
  Chunk& chunk = chunks_.make(number);
  chunk.ci = ci;
  chunk.cj = cj;
  chunk.index = number;
  forEachAround(ci, cj, [&](std::uint32_t beside, std::size_t k) {
    if (!chunks_.has(beside)) return;
    chunk.around[k] = &chunks_[beside];
    chunks_[beside].around[8 - k] = &chunk;
  });
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

void Grid::forget(std::uint32_t number) {
  assert(placeOf(number));
  const auto [ci, cj] = *placeOf(number);
  index_.erase(hashOf(seed_, ci, cj));
  sleep(number);
  if (border(number)) takeBorder(number);
  --count_;
  free_.push_back(number);
  std::push_heap(free_.begin(), free_.end(), std::greater());
  auto last = static_cast<std::uint32_t>(highest());
  while (count_ < last && stateOf(last) == ChunkState::none) --last;
  chunks_.shorten(last + 1);
}

void Grid::unload(Chunk& chunk, Border border) {
  assert(!chunk.isUnloaded);
  if (last_ == &chunk) last_ = nullptr;
  chunk.isUnloaded = true;
  border.ci = chunk.ci;
  border.cj = chunk.cj;
  borders_.emplace(chunk.index, std::move(border));
  unloadedPlaces_.emplace(chunk.cj, chunk.ci);
}

Border Grid::load(Chunk& chunk) {
  assert(chunk.isUnloaded);
  chunk.isUnloaded = false;
  return takeBorder(chunk.index);
}

Border Grid::takeBorder(std::uint32_t number) {
  Border border = std::move(borders_.extract(number).mapped());
  unloadedPlaces_.erase({border.cj, border.ci});
  giveBackBuckets(borders_);
  return border;
}

Chunk& Grid::wake(std::uint32_t number) {
  assert(placeOf(number));
  if (!chunks_.has(number)) make(number, border(number)->ci, border(number)->cj).isUnloaded = true;
  return chunks_[number];
}

void Grid::sleep(std::uint32_t number) {
  if (!chunks_.has(number)) return;
  const Chunk& chunk = chunks_[number];
  for (std::size_t k = 0; k < chunk.around.size(); ++k)
    if (Chunk* beside = chunk.around[k]) beside->around[8 - k] = nullptr;
  if (last_ == &chunk) last_ = nullptr;
  chunks_.drop(number);
}

std::optional<std::pair<std::int32_t, std::int32_t>> Grid::firstUnloaded(const CellRect& cells) const {
  const ChunkRect in(cells);
  for (auto at = unloadedPlaces_.lower_bound({in.j0, in.i0}); at != unloadedPlaces_.end() && at->first <= in.j1;) {
    const auto [cj, ci] = *at;
    if (in.contains(ci, cj)) return std::pair(ci, cj);
    at = unloadedPlaces_.lower_bound({ci < in.i0 ? cj : cj + 1, in.i0});
  }
  return std::nullopt;
}

bool Grid::hasLoadedBeside(const Border& border) const {
  bool has = false;
  forEachAround(border.ci, border.cj, [&](std::uint32_t number, std::size_t) { has |= !this->border(number); });
  return has;
}

std::uint64_t Grid::bytes() const {
  std::uint64_t sum = chunks_.bytes() + heldBytes(free_) + index_.bytes();
  sum += tableBytes(borders_) + unloadedPlaces_.size() * (sizeof *unloadedPlaces_.begin() + 4 * sizeof(void*));
  for (const auto& [number, border] : borders_) sum += heldBytes(border.runs, border.kept);
  forEachChunk([&](const Chunk& chunk) { sum += heldBytes(chunk.blocks); });
  return sum;
}

}  // namespace lgs::detail
