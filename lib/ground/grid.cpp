#include "ground/grid.h"

#include <lgs/world.h>

#include <algorithm>
#include <functional>

namespace lgs::detail {
namespace {

std::uint64_t hashOf(std::uint64_t seed, std::int32_t ci, std::int32_t cj) {
  return mix(seed, std::uint64_t{static_cast<std::uint32_t>(ci)} << 32 | static_cast<std::uint32_t>(cj));
}

}  // namespace

Grid::Grid(const Grid& other) : chunks_(other.chunks_), free_(other.free_), count_(other.count_), index_(other.index_) {
  for (Chunk* chunk : chunks())
    for (Chunk*& beside : chunk->around)
      if (beside) beside = chunks_[beside->index].get();
  if (other.last_) last_ = chunks_[other.last_->index].get();
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

std::uint32_t Grid::indexOf(std::int32_t ci, std::int32_t cj) const {
  return index_.find(hashOf(index_.seed(), ci, cj),
                     [&](std::uint32_t k) { return chunks_[k]->ci == ci && chunks_[k]->cj == cj; });
}

Chunk* Grid::findChunk(Cell cell) const {
  const std::uint32_t found = indexOf(cell.i >> 5, cell.j >> 5);
  return found == HashIndex::kNone ? nullptr : chunks_[found].get();
}

Chunk* Grid::obtainChunk(Cell cell) {
  if (Chunk* found = findChunk(cell)) return remember(found);
  auto chunk = std::make_unique<Chunk>();
  chunk->ci = cell.i >> 5;
  chunk->cj = cell.j >> 5;
  chunk->index = freeNumber();
  link(*chunk);
  index_.insert(hashOf(index_.seed(), chunk->ci, chunk->cj), chunk->index);
  ++count_;
  if (chunk->index == chunks_.size()) chunks_.emplace_back();
  Owned<Chunk>& there = chunks_[chunk->index];
  there = Owned(std::move(chunk));
  return remember(there.get());
}

/// The least one. Takes it off the list.
std::uint32_t Grid::freeNumber() {
  if (!free_.empty() && free_.front() >= chunks_.size()) free_.clear();  // all are beyond the last chunk
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
      const std::uint32_t found = indexOf(chunk.ci + di, chunk.cj + dj);
      if (found == HashIndex::kNone) continue;
      const auto there = 3 * static_cast<std::size_t>(dj + 1) + static_cast<std::size_t>(di + 1);
      chunk.around[there] = chunks_[found].get();
      chunks_[found]->around[8 - there] = &chunk;
    }
  }
}

void Grid::forget(std::uint32_t number) {
  const Chunk& chunk = *chunks_[number];
  for (std::size_t k = 0; k < chunk.around.size(); ++k)
    if (Chunk* beside = chunk.around[k]; beside && beside != &chunk) beside->around[8 - k] = nullptr;
  if (last_ == &chunk) last_ = nullptr;
  index_.erase(hashOf(index_.seed(), chunk.ci, chunk.cj), number);
  chunks_[number] = {};
  --count_;
  free_.push_back(number);
  std::push_heap(free_.begin(), free_.end(), std::greater());
  while (count_ < highest() && !chunks_.back()) chunks_.pop_back();
  giveBackSpare(chunks_);
}

std::uint64_t Grid::bytes() const {
  std::uint64_t sum = chunks_.capacity() * sizeof chunks_[0] + free_.capacity() * sizeof free_[0] + index_.bytes();
  for (const Chunk* chunk : chunks()) sum += sizeof(Chunk) + (chunk->blocks ? kChunkCells * sizeof(Block) : 0);
  return sum;
}

}  // namespace lgs::detail
