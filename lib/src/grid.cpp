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

CellAt Grid::find(Cell cell) const {
  const std::int32_t ci = cell.i >> 5, cj = cell.j >> 5;
  if (!last_ || last_->ci != ci || last_->cj != cj) {
    const std::uint32_t found = index_.find(
        hashOf(ci, cj), [&](std::uint32_t k) { return chunks_[k]->ci == ci && chunks_[k]->cj == cj; });
    if (found == HashIndex::kNone) return {};
    last_ = chunks_[found].get();
  }
  return {last_, localOf(cell)};
}

CellAt Grid::obtain(Cell cell) {
  if (const CellAt found = find(cell)) return found;
  if (chunks_.size() > kMaxChunks) return {};
  auto chunk = std::make_unique<Chunk>();
  chunk->ci = cell.i >> 5;
  chunk->cj = cell.j >> 5;
  chunk->index = static_cast<std::uint32_t>(chunks_.size());
  link(*chunk);
  index_.insert(hashOf(chunk->ci, chunk->cj), chunk->index);
  last_ = chunk.get();
  chunks_.push_back(std::move(chunk));
  return {last_, localOf(cell)};
}

void Grid::link(Chunk& chunk) {
  chunk.around[4] = &chunk;
  for (std::int32_t dj = -1; dj <= 1; ++dj) {
    for (std::int32_t di = -1; di <= 1; ++di) {
      const std::int32_t ci = chunk.ci + di, cj = chunk.cj + dj;
      const std::uint32_t found = index_.find(
          hashOf(ci, cj), [&](std::uint32_t k) { return chunks_[k]->ci == ci && chunks_[k]->cj == cj; });
      if (found == HashIndex::kNone) continue;
      const auto there = static_cast<std::size_t>(3 * (dj + 1) + di + 1);
      chunk.around[there] = chunks_[found].get();
      chunks_[found]->around[8 - there] = &chunk;
    }
  }
}

// The block of an empty cell means nothing, so a chunk keeps one block for all as long as it can: until the first
// polygon with another one comes while there is a polygon already.
void Grid::setFirstOtherBlock(Chunk& chunk, std::uint32_t local, Block block) {
  if (!chunk.hasBlock) {
    chunk.hasBlock = true;
    chunk.commonBlock = block;
    return;
  }
  chunk.blocks = std::make_unique_for_overwrite<Block[]>(kChunkCells);
  std::fill_n(chunk.blocks.get(), kChunkCells, chunk.commonBlock);
  chunk.blocks[local] = block;
}

std::uint32_t Grid::lastSerial(CellAt cell) const {
  return isExplicit(cell) ? words(record(cell))[kHeaderWords] : state(cell) & kSerialMask;
}

void Grid::setPolygons(CellAt cell, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  CellRecord* old = record(cell);
  const bool wasExplicit = isExplicit(cell);
  if (!wasExplicit && polygons.empty()) {
    stateWord(cell) = content << kSerialBits | lastSerial;
    return;
  }
  const std::span<const std::uint32_t> ids = segments(cell);
  const auto prefix = static_cast<std::uint32_t>(kHeaderWords + 1 + 2 * polygons.size());
  const auto size = static_cast<std::uint32_t>(prefix + ids.size());
  const RecordArena::Ref ref = records_.allocate(size);
  auto* r = reinterpret_cast<CellRecord*>(records_.at(ref));
  *r = CellRecord{content << kSerialBits, partEnds(cell), static_cast<std::uint16_t>(polygons.size())};
  words(r)[kHeaderWords] = lastSerial;
  if (!polygons.empty()) std::memcpy(words(r) + kHeaderWords + 1, polygons.data(), polygons.size_bytes());
  if (!ids.empty()) std::memcpy(words(r) + prefix, ids.data(), ids.size_bytes());
  if (old) records_.release(cell.word() & ~kRecordBit, static_cast<std::uint32_t>(prefixWords(old) + ids.size()));
  cell.word() = kRecordBit | ref;
}

std::span<const std::uint32_t> Grid::segments(CellAt cell) const {
  const CellRecord* r = record(cell);
  if (!r) return {};
  return {words(r) + prefixWords(r), r->end[kWestPart]};
}

std::span<const std::uint32_t> Grid::segments(CellAt cell, unsigned part) const {
  const CellRecord* r = record(cell);
  if (!r) return {};
  const std::uint32_t begin = part == 0 ? 0u : r->end[part - 1];
  return {words(r) + prefixWords(r) + begin, r->end[part] - begin};
}

PartEnds Grid::partEnds(CellAt cell) const {
  const CellRecord* r = record(cell);
  return r ? r->end : PartEnds{};
}

void Grid::setSegments(CellAt cell, std::span<const std::uint32_t> ids, const PartEnds& ends) {
  RowMask& live = cell.chunk->live[cell.row()];
  live = ids.empty() ? live & ~cell.bit() : live | cell.bit();
  CellRecord* r = record(cell);
  const std::uint32_t prefix = r ? prefixWords(r) : kHeaderWords;
  const auto size = static_cast<std::uint32_t>(prefix + ids.size());
  if (!r) {
    if (ids.empty()) return;
    const CellRecord fresh{cell.word(), {}, CellRecord::kCompact};
    const RecordArena::Ref ref = records_.allocate(size);
    r = reinterpret_cast<CellRecord*>(records_.at(ref));
    *r = fresh;
    cell.word() = kRecordBit | ref;
  } else {
    const RecordArena::Ref oldRef = cell.word() & ~kRecordBit;
    const std::uint32_t oldSize = prefix + r->end[kWestPart];
    if (ids.empty() && r->polygons == CellRecord::kCompact) {
      cell.word() = r->state;
      records_.release(oldRef, oldSize);
      return;
    }
    if (!RecordArena::sameSize(size, oldSize)) {
      const RecordArena::Ref ref = records_.allocate(size);
      std::memcpy(records_.at(ref), r, prefix * sizeof(std::uint32_t));
      records_.release(oldRef, oldSize);
      r = reinterpret_cast<CellRecord*>(records_.at(ref));
      cell.word() = kRecordBit | ref;
    }
  }
  r->end = ends;
  if (!ids.empty()) std::memcpy(words(r) + prefix, ids.data(), ids.size_bytes());
}

std::uint64_t Grid::bytes() const {
  std::uint64_t sum = chunks_.capacity() * sizeof chunks_[0] + index_.bytes() + records_.bytes();
  for (const auto& chunk : chunks()) sum += sizeof(Chunk) + (chunk->blocks ? kChunkCells * sizeof(Block) : 0);
  return sum;
}

}  // namespace lgs::detail
