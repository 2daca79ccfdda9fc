// Which segments each cell shows, as of the last commit: a list of ids for each cell that shows some.
#pragma once

#include "ground/chunk.h"
#include "outline/layout.h"
#include "storage/pages.h"
#include "storage/record_arena.h"

#include <array>
#include <cstdint>
#include <vector>

namespace lgs::detail {

class SegmentLists {
 public:
  /// Empty for a cell without chunk.
  CellSegments of(CellAt at) const {
    const ShownChunk* shown = at ? shownBy(*at.chunk) : nullptr;
    return shown ? of(shown->lists[at.local]) : CellSegments(kNothing.data());
  }
  /// The same for the four cells around the corner below and left of column x and row y, 0 … 32 each, of a chunk:
  /// counter-clockwise, the cell in this column and row first. To cell q of them the vertex is its corner q.
  std::array<CellSegments, 4> aroundCorner(const Chunk& chunk, std::int32_t x, std::int32_t y) const {
    const ShownChunk* shown = shownBy(chunk);
    if (shown && x > 0 && x < kChunkSize && y > 0 && y < kChunkSize) {
      const RecordArena::Ref* at = &shown->lists[localOf({x, y})];
      return {of(at[0]), of(at[-1]), of(at[-1 - kChunkSize]), of(at[-kChunkSize])};
    }
    return {of(cellAt(chunk, x, y)), of(cellAt(chunk, x - 1, y)), of(cellAt(chunk, x - 1, y - 1)),
            of(cellAt(chunk, x, y - 1))};
  }
  bool isLive(CellAt at) const { return (liveRow(*at.chunk, at.row()) & at.bit()) != 0; }
  /// The cells in a row of a chunk that show segments.
  RowMask liveRow(const Chunk& chunk, std::uint32_t row) const {
    const ShownChunk* shown = shownBy(chunk);
    return shown ? shown->live[row] : 0;
  }

  /// Calls visit(address) for where the lists of a cell and of the eight around it are noted, unless it is at the
  /// boundary of its chunk.
  template <class Visit>
  void forEachPlaceAround(std::uint32_t cellRef, Visit&& visit) const {
    const ShownChunk* shown = shownBy(cellRef / kChunkCells);
    const std::uint32_t at = cellRef % kChunkCells;
    if (!shown || !isInner(at)) return;
    visit(&shown->live[at / kChunkSize]);
    for (std::uint32_t row = at - kChunkSize; row <= at + kChunkSize; row += kChunkSize) visit(&shown->lists[row]);
  }
  /// Calls visit(list) for these lists.
  template <class Visit>
  void forEachAround(std::uint32_t cellRef, Visit&& visit) const {
    const ShownChunk* shown = shownBy(cellRef / kChunkCells);
    const std::uint32_t at = cellRef % kChunkCells;
    if (!shown || !isInner(at)) return;
    for (std::uint32_t row = at - kChunkSize; row <= at + kChunkSize; row += kChunkSize)
      for (std::uint32_t local = row - 1; local <= row + 1; ++local) visit(of(shown->lists[local]));
  }

  /// Takes `removed` ids out of a cell's list, from index `begin` on, and makes room for `added` there. Returns the
  /// words of the list, into which the caller writes these ids and the new layout; null if the cell shows nothing now.
  std::uint32_t* splice(CellAt at, std::uint32_t begin, std::uint32_t removed, std::uint32_t added);
  /// The words of a list that is there.
  std::uint32_t* words(CellAt at) { return arena_.at(shownBy(*at.chunk)->lists[at.local]); }

  /// What a chunk shows, which is nothing. Its number may name another chunk from now on.
  void forget(std::uint32_t chunk);

  std::uint64_t bytes() const { return chunks_.bytes() + arena_.bytes(); }

 private:
  /// What a chunk shows. Only chunks that show segments, or did, have one.
  struct ShownChunk {
    std::array<RowMask, kChunkSize> live{};             ///< cells that have a list
    std::array<RecordArena::Ref, kChunkCells> lists{};  ///< 0 if the cell has none
  };
  static constexpr std::array<std::uint32_t, Layout::kWords + 1> kNothing{};

  CellSegments of(RecordArena::Ref list) const { return CellSegments(list != 0 ? arena_.at(list) : kNothing.data()); }
  ShownChunk* shownBy(std::uint32_t chunk) const { return chunk < chunks_.size() ? chunks_.get(chunk) : nullptr; }
  ShownChunk* shownBy(const Chunk& chunk) const { return shownBy(chunk.index); }
  ShownChunk& make(const Chunk& chunk);

  Pages<ShownChunk> chunks_;  ///< by Chunk::index
  RecordArena arena_;
};

}  // namespace lgs::detail
