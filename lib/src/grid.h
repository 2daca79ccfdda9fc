// The cells: sparse chunks of 32×32, found through a hash index and linked to their eight neighbours.
//
// What a cell costs follows from what it holds. One word (4 bytes) names the content of a cell with at most one polygon
// and no segments, buried or empty; the blocks of a chunk are one number while they are all the same, and an array (4
// bytes a cell) from then on. A cell with segments, with several polygons, or that was given more than 255 has a
// CellRecord.
#pragma once

#include "catalogue.h"
#include "hash_index.h"
#include "record_arena.h"

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lgs::detail {

inline constexpr std::int32_t kChunkSize = 32;
inline constexpr std::uint32_t kChunkCells = kChunkSize * kChunkSize;

/// The place of a cell in its chunk.
constexpr std::uint32_t localOf(Cell cell) {
  return static_cast<std::uint32_t>((cell.j & (kChunkSize - 1)) * kChunkSize + (cell.i & (kChunkSize - 1)));
}

/// Whether the cells around a cell are all in its chunk.
constexpr bool isInner(std::uint32_t local) {
  const std::uint32_t x = local % kChunkSize, y = local / kChunkSize;
  return x - 1 < kChunkSize - 2 && y - 1 < kChunkSize - 2;
}

using RowMask = std::uint32_t;  ///< one bit a cell of a row of a chunk

struct Chunk {
  std::int32_t ci = 0;  ///< chunk coordinates: cell >> 5
  std::int32_t cj = 0;
  std::uint32_t index = 0;
  RowMask dirtyRows = 0;                    ///< rows with a dirty cell
  Facts everFacts = 0;                      ///< of all contents that any cell has, or had
  std::array<Chunk*, 9> around{};           ///< row by row from the lower left; null where there is none
  std::array<RowMask, kChunkSize> dirty{};  ///< edited since the last commit
  std::array<RowMask, kChunkSize> live{};   ///< has segments
  std::uint64_t commonBlock = kNoBlock;     ///< of all compact cells, while `blocks` is null
  std::unique_ptr<Block[]> blocks;
  std::array<Facts, kChunkCells> facts{};  ///< of each cell's content
  std::array<std::uint32_t, kChunkCells> cells{};

  static constexpr std::uint64_t kNoBlock = std::uint64_t{1} << 32;
  /// The chunk di columns and dj rows away, each -1 … 1.
  Chunk* neighbour(std::int32_t di, std::int32_t dj) const {
    const std::int32_t there = 3 * dj + di + 4;
    return around[static_cast<std::size_t>(there)];
  }
  Block block(std::uint32_t local) const { return blocks ? blocks[local] : static_cast<Block>(commonBlock); }
  Cell cell(std::uint32_t local) const {
    return {ci * kChunkSize + static_cast<std::int32_t>(local % kChunkSize),
            cj * kChunkSize + static_cast<std::int32_t>(local / kChunkSize)};
  }
  std::uint32_t ref(std::uint32_t local) const { return index * kChunkCells + local; }
};

/// A polygon of a cell.
struct Placed {
  std::uint32_t serial = 0;
  Block block = 0;
};

/// The polygons of a cell by slot. Valid until the cell changes.
struct PlacedBySlot {
  const Placed* listed = nullptr;  ///< null where the cell has one polygon at most
  Placed sole;                     ///< that one
  Placed operator[](Slot slot) const { return listed ? listed[slot] : sole; }
};

/// The record of a segment that has no links yet.
inline SegmentRecord newSegment(std::uint32_t cellRef, const PackedEnds& ends, Placed placed) {
  return {.predecessor = kUnlinked,
          .successor = kUnlinked,
          .listed = 0,
          .cellRef = cellRef,
          .block = placed.block,
          .serial = placed.serial & kMaxSerial,
          .high = ends.high & 0xfu,
          .from = ends.from,
          .to = ends.to};
}

/// The parts of a cell's segments, in the order in which its record lists them.
enum Part : unsigned { kInterior, kSouthPart, kEastPart, kNorthPart, kWestPart, kParts };
inline constexpr unsigned kAllParts = (1u << kParts) - 1;
constexpr unsigned partOf(unsigned side) { return side + 1; }

/// In memory followed by, if `polygons` is not kCompact, the last serial given out and `polygons` × Placed in order of
/// slots; then by the segment ids, part after part, each part in order of start.
using PartEnds = std::array<std::uint16_t, kParts>;  ///< where each part ends in a list of ids

struct CellRecord {
  static constexpr std::uint8_t kCompact = 0xff;
  std::uint32_t state = 0;  ///< as the word of a cell without record
  PartEnds end{};
  std::uint8_t polygons = kCompact;
  std::uint8_t touching =
      0;  ///< bit s: a segment on side s starts where the side does; bit 4 + s: one ends where it does

  std::uint32_t prefixWords() const {
    return sizeof(CellRecord) / sizeof(std::uint32_t) + (polygons == kCompact ? 0u : 1u + 2u * polygons);
  }
  /// Room for one id at least, so that ids()[0] can be read in any record.
  std::uint32_t sizeWords() const { return prefixWords() + std::max<std::uint32_t>(count(), 1); }
  std::uint32_t begin(unsigned part) const { return part == 0 ? 0u : end[part - 1]; }
  std::uint32_t count() const { return end[kWestPart]; }
  std::uint32_t* words() { return reinterpret_cast<std::uint32_t*>(this); }
  const std::uint32_t* words() const { return reinterpret_cast<const std::uint32_t*>(this); }
  std::uint32_t* ids() { return words() + prefixWords(); }
  const std::uint32_t* ids() const { return words() + prefixWords(); }
  std::span<const std::uint32_t> ids(unsigned part) const { return {ids() + begin(part), end[part] - begin(part)}; }
};
static_assert(sizeof(CellRecord) == 16);

/// A cell of an existing chunk.
struct CellAt {
  Chunk* chunk = nullptr;
  std::uint32_t local = 0;

  std::uint32_t& word() const { return chunk->cells[local]; }
  std::uint32_t row() const { return local / kChunkSize; }
  RowMask bit() const { return RowMask{1} << local % kChunkSize; }
  explicit operator bool() const { return chunk != nullptr; }
};

/// The cell in column x and row y of a chunk; both may be off by one chunk. Without chunk where there is none.
inline CellAt cellAt(const Chunk& chunk, std::int32_t x, std::int32_t y) {
  return {chunk.neighbour(x >> 5, y >> 5), localOf({x, y})};
}

/// The cell across one side.
inline CellAt across(CellAt at, unsigned side) {
  constexpr std::array<std::int32_t, 4> di{0, 1, 0, -1}, dj{-1, 0, 1, 0};
  if (isInner(at.local)) return {at.chunk, at.local + static_cast<std::uint32_t>(dj[side] * kChunkSize + di[side])};
  return cellAt(*at.chunk, static_cast<std::int32_t>(at.local % kChunkSize) + di[side],
                static_cast<std::int32_t>(at.local / kChunkSize) + dj[side]);
}

/// The facts of the four cells across the sides.
struct FactsAround {
  Facts south, east, north, west;
};
inline FactsAround factsAround(CellAt at) {
  if (isInner(at.local)) {
    const Facts* here = at.chunk->facts.data() + at.local;
    return {here[-kChunkSize], here[1], here[kChunkSize], here[-1]};
  }
  const auto facts = [&](unsigned side) {
    const CellAt beyond = across(at, side);
    return beyond ? beyond.chunk->facts[beyond.local] : Facts{0};
  };
  return {facts(0), facts(1), facts(2), facts(3)};
}

/// The chunks that a rectangle of cells (not empty) reaches.
struct ChunkRect {
  explicit ChunkRect(const CellRect& r) : i0(r.min.i >> 5), j0(r.min.j >> 5), i1(r.max.i >> 5), j1(r.max.j >> 5) {}
  std::int32_t i0, j0, i1, j1;
  bool contains(const Chunk& c) const { return c.ci >= i0 && c.ci <= i1 && c.cj >= j0 && c.cj <= j1; }
  std::uint64_t count() const {
    return (static_cast<std::uint64_t>(i1 - i0) + 1) * (static_cast<std::uint64_t>(j1 - j0) + 1);
  }
};

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
    CellRecord* r = writable(cell);
    std::uint32_t& word = r ? r->state : cell.word();
    if (word >= kSerialMask || (r && r->polygons != CellRecord::kCompact)) return 0;
    word = content << kSerialBits | (word + 1);
    setBlock(*cell.chunk, cell.local, block);
    return word & kSerialMask;
  }
  /// The same without looking further: 0 also if the cell has a record, or if its block has no place yet.
  static std::uint32_t placeQuickly(CellAt cell, ContentId content, Block block) {
    Chunk& chunk = *cell.chunk;
    const std::uint32_t lastSerial = cell.word();
    if (lastSerial >= kSerialMask) return 0;
    if (chunk.commonBlock != block) {
      if (!chunk.blocks) return 0;
      chunk.blocks[cell.local] = block;
    }
    cell.word() = content << kSerialBits | (lastSerial + 1);
    return lastSerial + 1;
  }
  /// The same for `count` cells of a row, all or none; whether it did.
  static bool placeRow(CellAt first, std::uint32_t count, ContentId content, Block block) {
    const std::span words(&first.word(), count);
    if (std::any_of(words.begin(), words.end(), [](std::uint32_t word) { return word >= kSerialMask; })) return false;
    for (std::uint32_t k = 0; k < count; ++k) setBlock(*first.chunk, first.local + k, block);
    for (std::uint32_t& word : words) word = content << kSerialBits | (word + 1);
    return true;
  }
  /// Empties a cell that holds one polygon, this one. Returns the content it had, or kEmptyContent and does nothing if the
  /// cell is not like that, or keeps a list of its polygons.
  ContentId removeSole(CellAt cell, std::uint32_t serial) {
    CellRecord* r = writable(cell);
    std::uint32_t& word = r ? r->state : cell.word();
    if ((word & kSerialMask) != serial || (r && r->polygons != CellRecord::kCompact)) return kEmptyContent;
    const ContentId content = word >> kSerialBits;
    word = serial;
    return content;
  }
  /// Makes `content` that of a cell, its slots filled by `polygons`; or empties it. `isListed` says whether the record
  /// lists them: see mustList().
  void setPolygons(CellAt cell, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons,
                   bool isListed);
  /// Whether the cell's record lists its polygons. Once it does, it always will: their serials must never come back.
  bool listsPolygons(CellAt cell) const {
    const CellRecord* r = record(cell);
    return r && r->polygons != CellRecord::kCompact;
  }
  /// Whether it has to, if these are to be the polygons.
  bool mustList(CellAt cell, std::uint32_t lastSerial, std::span<const Placed> polygons) const {
    const bool fits = polygons.empty() || (polygons.size() == 1 && polygons[0].serial == lastSerial);
    return listsPolygons(cell) || !fits || lastSerial > kMaxCompactSerial;
  }
  static constexpr std::uint32_t kMaxCompactSerial = 255;  ///< of a cell that does not list its polygons

  /// Takes away the chunks made last, down to a count of chunks(). Their cells must be as new.
  void forgetChunks(std::size_t count);

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
  static constexpr std::uint32_t kSerialMask = kMaxCompactSerial;

  CellRecord* writable(CellAt cell) { return const_cast<CellRecord*>(record(cell)); }  // NOLINT
  std::uint32_t& stateWord(CellAt cell) {
    CellRecord* r = writable(cell);
    return r ? r->state : cell.word();
  }
  std::uint32_t state(CellAt cell) const {
    const CellRecord* r = record(cell);
    return r ? r->state : cell.word();
  }
  /// Of a record that lists its polygons: the last serial, and the polygons by slot.
  static std::uint32_t listedSerial(const CellRecord* r) { return r->words()[sizeof(CellRecord) / 4]; }
  static const Placed* listed(const CellRecord* r) {
    return reinterpret_cast<const Placed*>(r->words() + sizeof(CellRecord) / 4 + 1);
  }

  static void setBlock(Chunk& chunk, std::uint32_t local, Block block) {
    if (chunk.commonBlock == block) return;
    if (chunk.blocks)
      chunk.blocks[local] = block;
    else
      setFirstOtherBlock(chunk, local, block);
  }
  static void setFirstOtherBlock(Chunk& chunk, std::uint32_t local, Block block);
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
