// The chunks of a world: only those that an edit has touched. A hash index finds a chunk by its place, and a chunk knows
// the eight around it.
#pragma once

#include "ground/chunk.h"
#include "storage/hash_index.h"
#include "storage/owned.h"

#include <lgs/lattice.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lgs::detail {

class Grid {
 public:
  Grid() { chunks_.emplace_back(std::make_unique<Chunk>()); }
  Grid(const Grid& other);
  Grid& operator=(const Grid&) = delete;
  ~Grid() = default;

  /// Without chunk if there is none yet.
  CellAt find(Cell cell) const { return {isLast(cell) ? last_ : findChunk(cell), localOf(cell)}; }
  /// Without chunk, too, unless it is the one of the last edit. All cells of that chunk are in range.
  CellAt findLast(Cell cell) const { return {isLast(cell) ? last_ : nullptr, localOf(cell)}; }
  /// As find(), for who edits there: the chunk is remembered.
  CellAt seek(Cell cell) { return {isLast(cell) ? last_ : remember(findChunk(cell)), localOf(cell)}; }
  /// Makes the chunk if there is none yet. The caller has seen that the grid is not full, or has the chunk.
  CellAt obtain(Cell cell) { return {isLast(cell) ? last_ : obtainChunk(cell), localOf(cell)}; }
  /// Whether there are as many chunks as there can be.
  bool isFull() const;
  /// The cell that a handle or a segment names. Without chunk if the number is none of ours.
  CellAt find(std::uint32_t cellRef) const {
    const std::uint32_t index = cellRef / kChunkCells;
    if (index == 0 || index >= chunks_.size()) return {};
    return {chunks_[index].get(), cellRef % kChunkCells};
  }
  Cell cellOf(std::uint32_t cellRef) const { return chunks_[cellRef / kChunkCells]->cell(cellRef % kChunkCells); }
  /// In the order in which edits first reached them. Chunk::index is the place in this list, from 1 on.
  std::span<const Owned<Chunk>> chunks() const { return std::span(chunks_).subspan(1); }

  /// Calls visit(CellAt, Cell) for the cells of a rectangle that have a chunk: chunk by chunk, each by rows. Cost: in
  /// proportion to those cells, and to the chunks in the rectangle or in the world, whichever are fewer.
  template <class Visit>
  void forEachCell(const CellRect& cells, Visit&& visit) const {
    const auto visitChunk = [&](Chunk& chunk) {
      const std::int32_t i = chunk.ci * kChunkSize, j = chunk.cj * kChunkSize;
      const std::int32_t lastI = std::min(i + kChunkSize - 1, cells.max.i);
      const std::int32_t lastJ = std::min(j + kChunkSize - 1, cells.max.j);
      for (Cell c{0, std::max(j, cells.min.j)}; c.j <= lastJ; ++c.j)
        for (c.i = std::max(i, cells.min.i); c.i <= lastI; ++c.i) visit(CellAt{&chunk, localOf(c)}, c);
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

  /// For tests of the limit: so many chunks count as made, and are not there.
  void passOver(std::size_t chunks) { chunks_.resize(chunks_.size() + chunks); }

  /// Takes away the chunks made last, down to a count. Their cells must be as new.
  void forgetChunks(std::size_t count);

  std::uint64_t bytes() const;

 private:
  std::uint32_t indexOf(std::int32_t ci, std::int32_t cj) const;
  Chunk* findChunk(Cell cell) const;
  Chunk* obtainChunk(Cell cell);
  void link(Chunk& chunk);
  Chunk* remember(Chunk* chunk) {
    if (chunk && inRange(chunk->cell(kChunkCells - 1))) last_ = chunk;
    return chunk;
  }
  bool isLast(Cell cell) const { return last_ && last_->ci == cell.i >> 5 && last_->cj == cell.j >> 5; }

  // Index 0 is no chunk of the world. A segment that is not alive says that it is in cell 0, and that is there. So a
  // link to one, should there ever be such a link, can be followed: the harness then reports it, where a crash says
  // little.
  std::vector<Owned<Chunk>> chunks_;
  HashIndex index_;
  // Edits come in neighbourhoods, so the chunk of the last one is tried first. It has no cell out of range, so who finds
  // a cell there need not ask.
  Chunk* last_ = nullptr;
};

}  // namespace lgs::detail
