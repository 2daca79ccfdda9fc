// The cells: sparse chunks of 32×32, found through a hash index and linked to their eight neighbours.
//
// What a cell costs follows from what it holds. One word (4 bytes) names the content of a cell with at most one polygon
// and no segments, buried or empty; the blocks of a chunk are one number while they are all the same, and an array (4
// bytes a cell) from then on. A cell with segments, with several polygons, or that was given more than 255 has a
// CellRecord.
#pragma once

#include "catalogue.h"
#include "cell_record.h"
#include "chunk.h"
#include "hash_index.h"
#include "record_arena.h"

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

class Grid {
 public:
  Grid();

  /// No chunk where there is none yet.
  CellAt find(Cell cell) const { return {isLast(cell) ? last_ : findChunk(cell), localOf(cell)}; }
  /// Makes the chunk if need be; no chunk when there are kMaxChunks already.
  CellAt obtain(Cell cell) { return {isLast(cell) ? last_ : obtainChunk(cell), localOf(cell)}; }
  /// No chunk where it is not the one that obtain() found last; never the cell of a chunk that is not in range as a whole.
  CellAt findQuickly(Cell cell) const { return {isLast(cell) ? last_ : nullptr, localOf(cell)}; }
  /// The cell that a handle or a segment names; no chunk where the number is none of ours.
  CellAt find(std::uint32_t cellRef) const {
    const std::uint32_t index = cellRef / kChunkCells;
    if (index == 0 || index >= chunks_.size()) return {};
    return {chunks_[index].get(), cellRef % kChunkCells};
  }
  Cell cellOf(std::uint32_t cellRef) const { return chunks_[cellRef / kChunkCells]->cell(cellRef % kChunkCells); }
  std::span<const std::unique_ptr<Chunk>> chunks() const { return std::span(chunks_).subspan(1); }

  /// Calls visit(CellAt, Cell) for the cells of a rectangle whose chunks exist: chunk by chunk, each by rows. Cost: in
  /// proportion to those cells and to the chunks in the rectangle or in the world, whichever are fewer.
  template <class Visit>
  void forEachCell(const CellRect& cells, Visit&& visit) const {
    forEachRow(cells, [&](CellAt at, Cell cell, std::uint32_t count) {
      for (; count != 0; --count, ++at.local, ++cell.i) visit(at, cell);
    });
  }
  /// The same for the rows that these cells make in each chunk: visit(first CellAt, first Cell, how many).
  template <class Visit>
  void forEachRow(const CellRect& cells, Visit&& visit) const {
    const auto visitChunk = [&](Chunk& chunk) {
      const std::int32_t i = chunk.ci * kChunkSize, j = chunk.cj * kChunkSize;
      const std::int32_t first = std::max(i, cells.min.i), last = std::min(i + kChunkSize - 1, cells.max.i);
      if (first > last) return;
      for (Cell c{first, std::max(j, cells.min.j)}; c.j <= std::min(j + kChunkSize - 1, cells.max.j); ++c.j)
        visit(CellAt{&chunk, localOf(c)}, c, static_cast<std::uint32_t>(last - first + 1));
    };
    const ChunkRect reach(cells);
    if (reach.count() > chunks().size()) {
      for (const auto& chunk : chunks()) visitChunk(*chunk);
      return;
    }
    for (std::int32_t cj = reach.j0; cj <= reach.j1; ++cj)
      for (std::int32_t ci = reach.i0; ci <= reach.i1; ++ci)
        if (const CellAt at = find(Cell{ci * kChunkSize, cj * kChunkSize})) visitChunk(*at.chunk);
  }

  // --- The polygons of a cell

  ContentId content(CellAt cell) const { return state(cell) >> kSerialBits; }
  static ContentId content(const CellRecord& r) { return r.state >> kSerialBits; }
  PlacedBySlot placed(CellAt cell) const { return placed(cell, record(cell)); }
  /// The same of a cell with this record, or null.
  static PlacedBySlot placed(CellAt cell, const CellRecord* r) {
    if (r && r->polygons != CellRecord::kCompact) return {listed(r), {}};
    return {nullptr, {(r ? r->state : cell.word()) & kSerialMask, cell.chunk->block(cell.local)}};
  }
  /// The last serial given out in the cell.
  std::uint32_t lastSerial(CellAt cell) const;

  /// Makes `content`, of one polygon, that of a cell that is empty and had few polygons before. Returns the polygon's
  /// serial, or 0 and does nothing if the cell is not like that.
  std::uint32_t placeSole(CellAt cell, ContentId content, Block block) {
    std::uint32_t* state = compactState(cell);
    if (!state || *state >= kSerialMask) return 0;
    makeRoomForBlock(*cell.chunk, block);
    return place(cell, *state, content, block);
  }
  /// The same without looking further: 0 also if the cell has a record, or if its chunk has no room for the block yet.
  static std::uint32_t placeQuickly(CellAt cell, ContentId content, Block block) {
    return place(cell, cell.word(), content, block);
  }
  /// The same for `count` cells of a row without records, all or none; whether it did.
  static bool placeRow(CellAt first, std::uint32_t count, ContentId content, Block block) {
    const std::span states(&first.word(), count);
    if (std::any_of(states.begin(), states.end(), [](std::uint32_t state) { return state >= kSerialMask; }))
      return false;
    makeRoomForBlock(*first.chunk, block);
    if (first.chunk->blocks) std::fill_n(&first.chunk->blocks[first.local], count, block);
    for (std::uint32_t& state : states) state = stateOf(content, state + 1);
    return true;
  }
  /// Empties a cell that holds one polygon, this one. Returns the content it had, or kEmptyContent and does nothing if the
  /// cell is not like that, or keeps a list of its polygons.
  ContentId removeSole(CellAt cell, std::uint32_t serial) {
    std::uint32_t* state = compactState(cell);
    if (!state || (*state & kSerialMask) != serial) return kEmptyContent;
    return std::exchange(*state, serial) >> kSerialBits;
  }
  /// Makes `content` that of a cell, its slots filled by `polygons`; or empties it.
  void setPolygons(CellAt cell, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons);

  // --- The segments of a cell, as of the last commit

  bool hasSegments(CellAt cell) const { return (cell.chunk->live[cell.row()] & cell.bit()) != 0; }
  /// All of them, part by part. The view is valid until the cell changes.
  std::span<const std::uint32_t> segments(CellAt cell) const {
    const CellRecord* r = record(cell);
    return r ? std::span(r->ids(), r->count()) : std::span<const std::uint32_t>{};
  }
  /// The same with where the parts end; null in a cell without segments.
  const CellRecord* record(CellAt cell) const { return recordOf(cell.word()); }
  const CellRecord* recordOf(std::uint32_t word) const {
    return word & kRecordBit ? reinterpret_cast<const CellRecord*>(records_.at(word & ~kRecordBit)) : nullptr;
  }
  /// That of a cell with segments, to be written.
  CellRecord& liveRecord(CellAt cell) { return *writable(cell); }
  /// Replaces `removed` of the ids, from the one at `begin` on, by room for `added`, which the caller fills and tells the
  /// record of: where its parts end and what they touch. Null if the cell has no record any more.
  CellRecord* spliceSegments(CellAt cell, std::uint32_t begin, std::uint32_t removed, std::uint32_t added);

  std::uint64_t bytes() const;

 private:
  static constexpr std::uint32_t kRecordBit = 1u << 31;  // in a cell's word: the rest is a reference to a CellRecord
  static constexpr std::uint32_t kSerialBits = 8;        // in a state: the last serial; above it the content
  static constexpr std::uint32_t kSerialMask = (1u << kSerialBits) - 1;

  CellRecord* writable(CellAt cell) { return const_cast<CellRecord*>(record(cell)); }  // NOLINT
  /// Null if the cell lists its polygons.
  std::uint32_t* compactState(CellAt cell) {
    CellRecord* r = writable(cell);
    if (!r) return &cell.word();
    return r->polygons == CellRecord::kCompact ? &r->state : nullptr;
  }
  std::uint32_t state(CellAt cell) const {
    const CellRecord* r = record(cell);
    return r ? r->state : cell.word();
  }
  bool isExplicit(CellAt cell) const {
    const CellRecord* r = record(cell);
    return r && r->polygons != CellRecord::kCompact;
  }
  /// Of a record that lists its polygons: the last serial, and the polygons by slot.
  static std::uint32_t listedSerial(const CellRecord* r) { return r->words()[sizeof(CellRecord) / 4]; }
  static const Placed* listed(const CellRecord* r) {
    return reinterpret_cast<const Placed*>(r->words() + sizeof(CellRecord) / 4 + 1);
  }

  static constexpr std::uint32_t stateOf(ContentId content, std::uint32_t lastSerial) {
    return content << kSerialBits | lastSerial;
  }
  static std::uint32_t place(CellAt cell, std::uint32_t& state, ContentId content, Block block) {
    const std::uint32_t lastSerial = state;  // if the cell is empty
    if (lastSerial >= kSerialMask) return 0;
    if (cell.chunk->commonBlock != block) {
      if (!cell.chunk->blocks) return 0;
      cell.chunk->blocks[cell.local] = block;
    }
    state = stateOf(content, lastSerial + 1);
    return lastSerial + 1;
  }
  static void makeRoomForBlock(Chunk& chunk, Block block) {
    if (chunk.commonBlock != block && !chunk.blocks) makeRoomForFirstBlock(chunk, block);
  }
  static void makeRoomForFirstBlock(Chunk& chunk, Block block);
  Chunk* findChunk(Cell cell) const;
  Chunk* obtainChunk(Cell cell);
  void link(Chunk& chunk);
  Chunk* remember(Chunk* chunk) {
    if (inRange(chunk->cell(kChunkCells - 1))) last_ = chunk;
    return chunk;
  }
  bool isLast(Cell cell) const { return last_->ci == cell.i >> 5 && last_->cj == cell.j >> 5; }

  // Index 0 is no chunk of the world. Cell 0, where a segment that is not alive says it is, can be read there: a dangling
  // link, should there ever be one, is wrong and not a crash, and the harness can report it.
  std::vector<std::unique_ptr<Chunk>> chunks_;
  HashIndex index_;
  RecordArena records_;
  Chunk* last_ =
      nullptr;  // found by the last edit that was not at the end of the world, or chunk 0: edits come in neighbourhoods
};

}  // namespace lgs::detail
