// The chunks of a world: only those that an edit has touched, and that were not forgotten since. A hash index finds a
// chunk by its place, and a chunk knows the eight around it.
//
// Chunks have numbers. A new one takes the least that is free. So the numbers in use say which one comes next, and
// nothing else has to be saved.
//
// An unloaded chunk keeps its number, and has a border (border.h). It is a Chunk, too, unless it is asleep.
#pragma once

#include "ground/border.h"
#include "ground/chunk.h"
#include "storage/hash_index.h"
#include "storage/pages.h"
#include "storage/vectors.h"

#include <lgs/lattice.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lgs::detail {

/// What is known of a place: `none`, where no edit ever was, or that was forgotten. An unloaded chunk is `awake` if it
/// has a Chunk: after a commit that is so while a loaded one is beside it. If it is `asleep` its border alone is left.
enum class ChunkState : std::uint8_t { none, loaded, awake, asleep };

class Grid {
 public:
  Grid() { chunks_.add(); }
  Grid(const Grid& other);
  Grid& operator=(const Grid&) = delete;
  ~Grid() = default;

  /// Without chunk if there is none yet.
  CellAt find(Cell cell) const { return {isLast(cell) ? last_ : findChunk(cell), localOf(cell)}; }
  /// Without chunk, too, unless it is the one of the last edit. All cells of that chunk are in range.
  CellAt findLast(Cell cell) const { return {isLast(cell) ? last_ : nullptr, localOf(cell)}; }
  /// Like find(), and caches the chunk for the next edit.
  CellAt seek(Cell cell) { return {isLast(cell) ? last_ : remember(findChunk(cell)), localOf(cell)}; }
  /// Makes the chunk if there is none yet. The caller has seen that the grid is not full, or has the chunk.
  CellAt obtain(Cell cell) { return {isLast(cell) ? last_ : obtainChunk(cell), localOf(cell)}; }
  /// Whether a cell is in an unloaded chunk. Then it may be without chunk, and must not be obtained.
  bool isUnloaded(Cell cell) const {
    return !borders_.empty() && !isLast(cell) && border(numberAt(cell.i >> 5, cell.j >> 5)) != nullptr;
  }
  /// Whether there are as many chunks as there can be.
  bool isFull() const;
  /// The cell that a handle or a segment names. Without chunk if the number is none of ours.
  CellAt find(std::uint32_t cellRef) const {
    const std::uint32_t index = cellRef / kChunkCells;
    if (index == 0 || index >= chunks_.size()) return {};
    return {chunks_.get(index), cellRef % kChunkCells};
  }
  /// What names a cell in find(); of no chunk, if there is none in its place.
  std::uint32_t refOf(Cell cell) const { return numberAt(cell.i >> 5, cell.j >> 5) * kChunkCells + localOf(cell); }
  /// Of a chunk that is not asleep.
  Cell cellOf(std::uint32_t cellRef) const { return chunks_[cellRef / kChunkCells].cell(cellRef % kChunkCells); }
  /// The same of any chunk with a number that is in use.
  Cell cellOfAny(std::uint32_t cellRef) const {
    const auto [ci, cj] = *placeOf(cellRef / kChunkCells);
    return cellIn(ci, cj, cellRef % kChunkCells);
  }
  static constexpr std::uint32_t kNone = 0;
  /// The number of the chunk in a place, given in chunks, loaded or not; kNone if there is none.
  std::uint32_t numberAt(std::int32_t ci, std::int32_t cj) const;
  /// Where a chunk is, in chunks, loaded or not; nothing if the number is not in use.
  std::optional<std::pair<std::int32_t, std::int32_t>> placeOf(std::uint32_t number) const;
  ChunkState stateOf(std::uint32_t number) const {
    if (number >= chunks_.size()) return ChunkState::none;
    if (border(number)) return chunks_.has(number) ? ChunkState::awake : ChunkState::asleep;
    return chunks_.has(number) ? ChunkState::loaded : ChunkState::none;
  }
  /// Of a chunk that is not asleep.
  Chunk& chunk(std::uint32_t number) const {
    assert(number != 0);
    return chunks_[number];
  }

  // --- Unloaded chunks, by their numbers

  /// Null if the chunk is loaded, or the number is none of ours.
  const Border* border(std::uint32_t number) const {
    const auto found = borders_.find(number);
    return found == borders_.end() ? nullptr : &found->second;
  }
  Border* border(std::uint32_t number) { return const_cast<Border*>(std::as_const(*this).border(number)); }
  std::size_t unloadedCount() const { return borders_.size(); }
  /// A chunk is unloaded from now on.
  void unload(Chunk& chunk, Border border);
  /// It is loaded from now on.
  Border load(Chunk& chunk);
  /// The Chunk of a number in use. It is made, if that is asleep: then its cells hold nothing.
  Chunk& wake(std::uint32_t number);
  /// Takes the Chunk of an unloaded one away. The border stays.
  void sleep(std::uint32_t number);
  bool hasLoadedBeside(const Border& border) const;
  /// The first unloaded chunk with cells of a rectangle, by rows: its column and row of chunks.
  std::optional<std::pair<std::int32_t, std::int32_t>> firstUnloaded(const CellRect& cells) const;

  // --- Visits

  /// Calls visit(number, k) for the chunk in a place and those around it, loaded or not; k is as in Chunk::around.
  template <class Visit>
  void forEachAround(std::int32_t ci, std::int32_t cj, Visit&& visit) const {
    for (std::size_t k = 0; k < 9; ++k) {
      const auto di = static_cast<std::int32_t>(k % 3) - 1, dj = static_cast<std::int32_t>(k / 3) - 1;
      if (const std::uint32_t number = numberAt(ci + di, cj + dj); number != kNone) visit(number, k);
    }
  }
  /// Calls visit(number) for the chunks with cells of a rectangle, which is not empty, loaded or not.
  template <class Visit>
  void forEachNumber(const CellRect& cells, Visit&& visit) const {
    const ChunkRect reach(cells);
    if (reach.count() > count()) {
      for (std::uint32_t number = 1; number < chunks_.size(); ++number)
        if (const auto at = placeOf(number); at && reach.contains(at->first, at->second)) visit(number);
    } else {
      reach.forEach([&](std::int32_t ci, std::int32_t cj) {
        if (const std::uint32_t number = numberAt(ci, cj); number != kNone) visit(number);
      });
    }
  }
  /// Calls visit(Chunk&) for those that are not asleep, by number.
  template <class Visit>
  void forEachChunk(Visit&& visit) const {
    for (std::size_t number = 1; number < chunks_.size(); ++number)
      if (chunks_.has(number)) visit(chunks_[number]);
  }
  /// How many there are, with those that are unloaded.
  std::size_t count() const { return count_; }
  /// The greatest number in use.
  std::size_t highest() const { return chunks_.size() - 1; }

  /// Calls visit(CellAt, Cell) for the cells of a rectangle that have a chunk: chunk by chunk, each by rows. Cost: in
  /// proportion to those cells, and to the chunks in the rectangle or in the world, whichever are fewer.
  template <class Visit>
  void forEachCell(const CellRect& cells, Visit&& visit) const {
    forEachChunk(cells, [&](Chunk& chunk) {
      const std::int32_t i = chunk.ci * kChunkSize, j = chunk.cj * kChunkSize;
      const std::int32_t lastI = std::min(i + kChunkSize - 1, cells.max.i);
      const std::int32_t lastJ = std::min(j + kChunkSize - 1, cells.max.j);
      for (Cell c{0, std::max(j, cells.min.j)}; c.j <= lastJ; ++c.j)
        for (c.i = std::max(i, cells.min.i); c.i <= lastI; ++c.i) visit(CellAt{&chunk, localOf(c)}, c);
    });
  }
  /// Calls visit(Chunk&) for those of forEachNumber() that are not asleep.
  template <class Visit>
  void forEachChunk(const CellRect& cells, Visit&& visit) const {
    forEachNumber(cells, [&](std::uint32_t number) {
      if (Chunk* chunk = chunks_.get(number)) visit(*chunk);
    });
  }

  /// For tests of the limit: so many chunks count as made, and are not there.
  void passOver(std::size_t chunks) {
    chunks_.addMissing(chunks);
    count_ += chunks;
  }
  /// For loading: the next number stays free. Once all chunks are there setFree() says which ones did, in increasing
  /// order.
  void leaveOut() { chunks_.addMissing(); }
  void setFree(std::vector<std::uint32_t> numbers) { free_ = std::move(numbers); }

  /// Takes a chunk away that nothing refers to any more, or the border of one.
  void forget(std::uint32_t number);

  std::uint64_t bytes() const;

 private:
  Chunk* findChunk(Cell cell) const;
  Chunk* obtainChunk(Cell cell);
  /// The Chunk of a number that has none.
  Chunk& make(std::uint32_t number, std::int32_t ci, std::int32_t cj);
  Border takeBorder(std::uint32_t number);
  std::uint32_t freeNumber();
  Chunk* remember(Chunk* chunk) {
    if (chunk && !chunk->isUnloaded && inRange(chunk->cell(kChunkCells - 1))) last_ = chunk;
    return chunk;
  }
  bool isLast(Cell cell) const { return last_ && last_->ci == cell.i >> 5 && last_->cj == cell.j >> 5; }

  // Index 0 is no chunk of the world. A segment that is not alive says that it is in cell 0, and that is there. So a
  // link to one, should there ever be such a link, can be followed: the harness then reports it, where a crash says
  // little.
  Pages<Chunk> chunks_;  ///< by number; null where it is free, or asleep. The last one is in use.
  std::unordered_map<std::uint32_t, Border> borders_;               ///< by number; of those that are unloaded
  std::set<std::pair<std::int32_t, std::int32_t>> unloadedPlaces_;  ///< where these are: rows and columns
  std::vector<std::uint32_t> free_;                                 ///< numbers, as a heap with the least first
  std::size_t count_ = 0;                                           ///< of numbers in use
  std::uint64_t seed_ = anySeed(this);
  HashIndex index_;  ///< numbers by place
  // Edits come in neighbourhoods, so the chunk of the last one is tried first. It has no cell out of range, so
  // what finds a cell there need not ask.
  Chunk* last_ = nullptr;
};

}  // namespace lgs::detail
