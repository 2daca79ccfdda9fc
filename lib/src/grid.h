// The cells of a world, in chunks of 32×32. There are only the chunks that an edit has touched. A hash index finds a
// chunk, and a chunk knows the eight around it.
//
// A cell costs what it holds. Each has a word of 4 bytes. That is its *state*, a content and the serial given out last,
// as long as the cell has no segments and at most one polygon, and was given 255 polygons at most. Otherwise the word
// refers to a CellRecord. Blocks cost one number for the whole chunk while they are all equal, and 4 bytes a cell from
// then on.
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
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

class Grid {
 public:
  Grid();
  Grid(const Grid& other);
  Grid& operator=(const Grid&) = delete;
  ~Grid() = default;

  /// Without chunk if there is none yet.
  CellAt find(Cell cell) const { return {isLast(cell) ? last_ : findChunk(cell), localOf(cell)}; }
  /// Makes the chunk if there is none yet. Without chunk if there are kMaxChunks already.
  CellAt obtain(Cell cell) { return {isLast(cell) ? last_ : obtainChunk(cell), localOf(cell)}; }
  /// Without chunk unless it is the one that obtain() found last. All cells of that chunk are in range.
  CellAt findQuickly(Cell cell) const { return {isLast(cell) ? last_ : nullptr, localOf(cell)}; }
  /// Whether obtain() remembers a chunk for findQuickly(). If it does not, every edit takes the long way.
  void setRemembers(bool remembers) {
    remembers_ = remembers;
    if (!remembers) last_ = chunks_[0].get();
  }
  /// The cell that a handle or a segment names. Without chunk if the number is none of ours.
  CellAt find(std::uint32_t cellRef) const {
    const std::uint32_t index = cellRef / kChunkCells;
    if (index == 0 || index >= chunks_.size()) return {};
    return {chunks_[index].get(), cellRef % kChunkCells};
  }
  Cell cellOf(std::uint32_t cellRef) const { return chunks_[cellRef / kChunkCells]->cell(cellRef % kChunkCells); }
  std::span<const Owned<Chunk>> chunks() const { return std::span(chunks_).subspan(1); }

  /// Calls visit(CellAt, Cell) for the cells of a rectangle that have a chunk: chunk by chunk, each by rows. Cost: in
  /// proportion to those cells, and to the chunks in the rectangle or in the world, whichever are fewer.
  template <class Visit>
  void forEachCell(const CellRect& cells, Visit&& visit) const {
    forEachRow(cells, [&](CellAt at, Cell cell, std::uint32_t count) {
      for (; count != 0; --count, ++at.local, ++cell.i) visit(at, cell);
    });
  }
  /// The same row by row of each chunk: calls visit(first CellAt, first Cell, how many).
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
  /// The same, if the cell's record is known already; null if it has none.
  static PlacedBySlot placed(CellAt cell, const CellRecord* r) {
    if (r && !r->isCompact()) return {r->placed(), {}};
    return {nullptr, {(r ? r->state : cell.word()) & kSerialMask, cell.chunk->block(cell.local)}};
  }
  /// The serial given out last in the cell.
  std::uint32_t lastSerial(CellAt cell) const;

  /// Whether placeSole(), or removeSole() of this serial, will do something.
  bool takesSole(CellAt cell) const {
    const CellRecord* r = record(cell);
    return (!r || r->isCompact()) && state(cell) < kSerialMask;
  }
  bool holdsSole(CellAt cell, std::uint32_t serial) const {
    return !listsPolygons(cell) && content(cell) != kEmptyContent && (state(cell) & kSerialMask) == serial;
  }
  /// Gives a cell this content, which has one polygon. The cell must be empty and keep no list, and its state must have
  /// room for another serial. Returns the polygon's serial; 0, and nothing is done, if the cell is not like that.
  std::uint32_t placeSole(CellAt cell, ContentId content, Block block) {
    std::uint32_t* state = compactState(cell);
    if (!state || *state >= kSerialMask) return 0;
    makeRoomForBlock(*cell.chunk, block);
    return place(cell, *state, content, block);
  }
  /// The same on the way of most edits. Returns 0 also if the cell has a record, or its chunk no room for the block
  /// yet.
  static std::uint32_t placeQuickly(CellAt cell, ContentId content, Block block) {
    return place(cell, cell.word(), content, block);
  }
  /// The same in two steps, so that the first one can be taken back: the cell's state, then its block. Whether the first
  /// was done: not if the cell has a record.
  static bool stake(CellAt cell, ContentId content) {
    if (cell.word() >= kSerialMask) return false;
    cell.word() = stateOf(content, cell.word() + 1);
    return true;
  }
  static void takeBackStake(CellAt cell) { cell.word() = (cell.word() & kSerialMask) - 1; }
  /// Returns the polygon's serial.
  static std::uint32_t setStakedBlock(CellAt cell, Block block) {
    makeRoomForBlock(*cell.chunk, block);
    if (cell.chunk->blocks) (*cell.chunk->blocks)[cell.local] = block;
    return cell.word() & kSerialMask;
  }
  /// The same for `count` cells of a row, for all of them or for none. Whether it was done: not if one has a record.
  static bool placeRow(CellAt first, std::uint32_t count, ContentId content, Block block) {
    const std::span states(&first.word(), count);
    if (std::any_of(states.begin(), states.end(), [](std::uint32_t state) { return state >= kSerialMask; }))
      return false;
    makeRoomForBlock(*first.chunk, block);
    if (first.chunk->blocks) std::fill_n(&(*first.chunk->blocks)[first.local], count, block);
    for (std::uint32_t& state : states) state = stateOf(content, state + 1);
    return true;
  }
  /// Empties a cell that keeps no list and holds the polygon of this serial. Returns the content that it had;
  /// kEmptyContent, and nothing is done, if the cell is not like that.
  ContentId removeSole(CellAt cell, std::uint32_t serial) {
    std::uint32_t* state = compactState(cell);
    if (!state || (*state & kSerialMask) != serial) return kEmptyContent;
    return std::exchange(*state, serial) >> kSerialBits;
  }
  /// Gives a cell this content and these polygons, by slot, or empties it if there are none. Its record lists them if
  /// `isListed`: see mustList().
  void setPolygons(CellAt cell, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons,
                   bool isListed);
  /// Whether the cell's record lists its polygons.
  bool listsPolygons(CellAt cell) const {
    const CellRecord* r = record(cell);
    return r && !r->isCompact();
  }
  /// Whether it has to, if these are to be the polygons. Once a cell keeps a list it always will.
  bool mustList(CellAt cell, std::uint32_t lastSerial, std::span<const Placed> polygons) const {
    const bool fits = polygons.empty() || (polygons.size() == 1 && polygons[0].serial == lastSerial);
    return !fits || lastSerial > kMaxCompactSerial || listsPolygons(cell);
  }
  static constexpr std::uint32_t kMaxCompactSerial = 255;  ///< the last one of a cell without a list

  /// Takes away the chunks made last, down to a count. Their cells must be as new.
  void forgetChunks(std::size_t count);

  // --- The segments of a cell, as of the last commit

  bool hasSegments(CellAt cell) const { return (cell.chunk->live[cell.row()] & cell.bit()) != 0; }
  /// All of them, part by part. Valid until the cell changes.
  std::span<const std::uint32_t> segments(CellAt cell) const {
    const CellRecord* r = record(cell);
    return r ? std::span(r->ids(), r->count()) : std::span<const std::uint32_t>{};
  }
  /// Where the parts end stands there too. Null if the cell has none, and so no segments.
  const CellRecord* record(CellAt cell) const { return recordOf(cell.word()); }
  const CellRecord* recordOf(std::uint32_t word) const {
    return word & kRecordBit ? reinterpret_cast<const CellRecord*>(records_.at(word & ~kRecordBit)) : nullptr;
  }
  /// The record of a cell with segments, to be written.
  CellRecord& liveRecord(CellAt cell) { return *writable(cell); }
  /// Takes `removed` ids out of a cell's list, from index `begin` on, and makes room for `added` there. The caller
  /// writes these ids, where the parts end now, and what they touch. Null if the cell needs no record any more.
  CellRecord* spliceSegments(CellAt cell, std::uint32_t begin, std::uint32_t removed, std::uint32_t added);

  std::uint64_t bytes() const;

 private:
  static constexpr std::uint32_t kRecordBit = 1u << 31;  // in a word: the rest refers to a CellRecord
  static constexpr std::uint32_t kSerialBits = 8;        // in a state: above them is the content
  static constexpr std::uint32_t kSerialMask = (1u << kSerialBits) - 1;
  static_assert(kSerialMask == kMaxCompactSerial);

  CellRecord* writable(CellAt cell) { return const_cast<CellRecord*>(record(cell)); }  // NOLINT
  /// Null if the cell lists its polygons.
  std::uint32_t* compactState(CellAt cell) {
    CellRecord* r = writable(cell);
    if (!r) return &cell.word();
    return r->isCompact() ? &r->state : nullptr;
  }
  std::uint32_t state(CellAt cell) const {
    const CellRecord* r = record(cell);
    return r ? r->state : cell.word();
  }

  static constexpr std::uint32_t stateOf(ContentId content, std::uint32_t lastSerial) {
    return content << kSerialBits | lastSerial;
  }
  /// Returns the serial; 0, and nothing is done, if the state is not that of an empty cell or has no room for a serial,
  /// or if the chunk has no room for the block.
  static std::uint32_t place(CellAt cell, std::uint32_t& state, ContentId content, Block block) {
    const std::uint32_t lastSerial = state;  // of an empty cell; all others have higher bits
    if (lastSerial >= kSerialMask) return 0;
    if (cell.chunk->commonBlock != block) {
      if (!cell.chunk->blocks) return 0;
      (*cell.chunk->blocks)[cell.local] = block;
    }
    state = stateOf(content, lastSerial + 1);
    return lastSerial + 1;
  }
  static void writeList(CellRecord& r, std::uint32_t lastSerial, std::span<const Placed> polygons);
  static void makeRoomForBlock(Chunk& chunk, Block block) {
    if (chunk.commonBlock != block && !chunk.blocks) makeRoomForFirstBlock(chunk, block);
  }
  static void makeRoomForFirstBlock(Chunk& chunk, Block block);
  Chunk* findChunk(Cell cell) const;
  Chunk* obtainChunk(Cell cell);
  void link(Chunk& chunk);
  Chunk* remember(Chunk* chunk) {
    if (remembers_ && inRange(chunk->cell(kChunkCells - 1))) last_ = chunk;
    return chunk;
  }
  bool isLast(Cell cell) const { return last_->ci == cell.i >> 5 && last_->cj == cell.j >> 5; }

  // Index 0 is no chunk of the world. A segment that is not alive says that it is in cell 0, and that is there. So a
  // link to one, should there ever be such a link, can be followed: the harness then reports it, where a crash says
  // little.
  std::vector<Owned<Chunk>> chunks_;
  HashIndex index_;
  RecordArena records_;
  // Edits come in neighbourhoods, so the chunk that obtain() found last is tried first. It is never a chunk with cells
  // out of range: so findQuickly() need not ask. Chunk 0 if there is none.
  Chunk* last_ = nullptr;
  bool remembers_ = true;
};

}  // namespace lgs::detail
