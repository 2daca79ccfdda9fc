#include "grid.h"

#include <lgs/world.h>

#include <algorithm>
#include <cstring>

namespace lgs::detail {
namespace {

std::uint64_t hashOf(std::int32_t ci, std::int32_t cj) {
  return mix(0, std::uint64_t{static_cast<std::uint32_t>(ci)} << 32 | static_cast<std::uint32_t>(cj));
}

}  // namespace

Grid::Grid() {
  chunks_.emplace_back(std::make_unique<Chunk>());
  last_ = chunks_[0].get();
  last_->ci = last_->cj = INT32_MIN / kChunkSize;  // none of its cells is in range
}

Grid::Grid(const Grid& other) : chunks_(other.chunks_), index_(other.index_), records_(other.records_) {
  for (const auto& chunk : chunks_)
    for (Chunk*& beside : chunk->around)
      if (beside) beside = chunks_[beside->index].get();
  last_ = chunks_[other.last_->index].get();
  remembers_ = other.remembers_;
}

Chunk* Grid::findChunk(Cell cell) const {
  const std::int32_t ci = cell.i >> 5, cj = cell.j >> 5;
  const std::uint32_t found =
      index_.find(hashOf(ci, cj), [&](std::uint32_t k) { return chunks_[k]->ci == ci && chunks_[k]->cj == cj; });
  return found == HashIndex::kNone ? nullptr : chunks_[found].get();
}

Chunk* Grid::obtainChunk(Cell cell) {
  if (Chunk* found = findChunk(cell)) return remember(found);
  if (chunks_.size() > kMaxChunks) return nullptr;
  auto chunk = std::make_unique<Chunk>();
  chunk->ci = cell.i >> 5;
  chunk->cj = cell.j >> 5;
  chunk->index = static_cast<std::uint32_t>(chunks_.size());
  link(*chunk);
  index_.insert(hashOf(chunk->ci, chunk->cj), chunk->index);
  chunks_.emplace_back(std::move(chunk));
  return remember(chunks_.back().get());
}

void Grid::link(Chunk& chunk) {
  chunk.around[4] = &chunk;
  for (std::int32_t dj = -1; dj <= 1; ++dj) {
    for (std::int32_t di = -1; di <= 1; ++di) {
      const std::int32_t ci = chunk.ci + di, cj = chunk.cj + dj;
      const std::uint32_t found =
          index_.find(hashOf(ci, cj), [&](std::uint32_t k) { return chunks_[k]->ci == ci && chunks_[k]->cj == cj; });
      if (found == HashIndex::kNone) continue;
      const auto there = 3 * static_cast<std::size_t>(dj + 1) + static_cast<std::size_t>(di + 1);
      chunk.around[there] = chunks_[found].get();
      chunks_[found]->around[8 - there] = &chunk;
    }
  }
}

// The block of an empty cell means nothing. So one number does until a polygon with another block comes.
void Grid::makeRoomForFirstBlock(Chunk& chunk, Block block) {
  if (chunk.commonBlock == Chunk::kNoBlock) {
    chunk.commonBlock = block;
    return;
  }
  chunk.blocks = Owned(std::make_unique_for_overwrite<std::array<Block, kChunkCells>>());
  chunk.blocks->fill(static_cast<Block>(chunk.commonBlock));
  chunk.commonBlock = Chunk::kNoBlock;
}

std::uint32_t Grid::lastSerial(CellAt cell) const {
  const CellRecord* r = record(cell);
  return r && !r->isCompact() ? r->lastSerial() : state(cell) & kSerialMask;
}

void Grid::setPolygons(CellAt cell, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons,
                       bool isListed) {
  if (!isListed && !polygons.empty()) {
    makeRoomForBlock(*cell.chunk, polygons[0].block);
    if (cell.chunk->blocks) (*cell.chunk->blocks)[cell.local] = polygons[0].block;
  }
  if (std::uint32_t* state = compactState(cell); state && !isListed) {
    *state = stateOf(content, lastSerial);
    return;
  }
  const CellRecord* old = record(cell);
  const RecordArena::Ref oldRef = cell.word() & ~kRecordBit;
  CellRecord header = old ? *old : CellRecord{};
  header.state = stateOf(content, isListed ? 0 : lastSerial);
  header.polygons = isListed ? static_cast<std::uint8_t>(polygons.size()) : CellRecord::kCompact;
  if (!isListed && header.count() == 0) {
    cell.word() = header.state;
  } else {
    const RecordArena::Ref ref = records_.allocate(header.sizeWords());
    auto* r = reinterpret_cast<CellRecord*>(records_.at(ref));
    *r = header;
    if (isListed) writeList(*r, lastSerial, polygons);
    if (old) std::copy_n(old->ids(), old->count(), r->ids());
    cell.word() = kRecordBit | ref;
  }
  if (old) records_.release(oldRef, old->sizeWords());
}

void Grid::writeList(CellRecord& r, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  std::uint32_t* out = r.words() + CellRecord::kHeaderWords;
  *out++ = lastSerial;
  for (const Placed& placed : polygons) {
    *out++ = placed.serial;
    *out++ = placed.block;
  }
}

void Grid::forgetChunks(std::size_t count) {
  while (chunks().size() > count) {
    const Chunk& chunk = *chunks_.back();
    for (std::size_t k = 0; k < chunk.around.size(); ++k)
      if (Chunk* beside = chunk.around[k]; beside && beside != &chunk) beside->around[8 - k] = nullptr;
    if (last_ == &chunk) last_ = chunks_[0].get();
    index_.erase(hashOf(chunk.ci, chunk.cj), chunk.index);
    chunks_.pop_back();
  }
}

CellRecord* Grid::spliceSegments(CellAt cell, std::uint32_t begin, std::uint32_t removed, std::uint32_t added) {
  CellRecord* const old = writable(cell);
  const std::uint32_t before = old ? old->count() : 0, count = before - removed + added;
  RowMask& live = cell.chunk->live[cell.row()];
  live = count == 0 ? live & ~cell.bit() : live | cell.bit();
  const RecordArena::Ref oldRef = cell.word() & ~kRecordBit;
  if (!old) {
    if (count == 0) return nullptr;
    const RecordArena::Ref ref = records_.allocate(CellRecord{}.prefixWords() + count);
    auto* r = reinterpret_cast<CellRecord*>(records_.at(ref));
    *r = CellRecord{};
    r->state = cell.word();
    cell.word() = kRecordBit | ref;
    return r;
  }
  const std::uint32_t prefix = old->prefixWords(), oldSize = old->sizeWords(), newSize = prefix + std::max(count, 1u);
  if (count == 0 && old->isCompact()) {
    cell.word() = old->state;
    records_.release(oldRef, oldSize);
    return nullptr;
  }
  CellRecord* r = old;
  const bool moves = !RecordArena::sameSize(newSize, oldSize);
  if (moves) {
    const RecordArena::Ref ref = records_.allocate(newSize);
    r = reinterpret_cast<CellRecord*>(records_.at(ref));
    std::copy_n(old->words(), prefix + begin, r->words());
    cell.word() = kRecordBit | ref;
  }
  const std::uint32_t* rest = old->ids() + begin + removed;
  std::memmove(r->ids() + begin + added, rest, (before - begin - removed) * sizeof *rest);
  if (moves) records_.release(oldRef, oldSize);
  return r;
}

std::uint64_t Grid::bytes() const {
  std::uint64_t sum = chunks_.capacity() * sizeof chunks_[0] + index_.bytes() + records_.bytes();
  for (const auto& chunk : chunks()) sum += sizeof(Chunk) + (chunk->blocks ? kChunkCells * sizeof(Block) : 0);
  return sum;
}

}  // namespace lgs::detail
