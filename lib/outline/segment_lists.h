// Which segments each cell shows, as of the last commit: a list of ids for each cell that shows some.
//
// A chunk has a reference to a list for each cell. But if most of its cells hold an edge inside when it first shows
// something, it has room for a short list instead, and only what is too long for that is elsewhere: so among millions of
// cells there is no reference to wait for before the list.
#pragma once

#include "ground/chunk.h"
#include "outline/layout.h"
#include "storage/pages.h"
#include "storage/record_arena.h"

#include <array>
#include <cstdint>

namespace lgs::detail {

class SegmentLists {
 public:
  /// Empty for a cell without chunk.
  CellSegments of(CellAt at) const {
    if (at && at.chunk->index < short_.size()) {
      if (const ShortLists* shortLists = short_.get(at.chunk->index)) return of(shortLists->lists[at.local]);
      if (const Refs* refs = refs_.get(at.chunk->index)) return of(refs->lists[at.local]);
    }
    return CellSegments(kNothing.data());
  }
  /// The same for the four cells around the corner below and left of column x and row y, 0 … 32 each, of a chunk:
  /// counter-clockwise, the cell in this column and row first. To cell q of them the vertex is its corner q.
  std::array<CellSegments, 4> aroundCorner(const Chunk& chunk, std::int32_t x, std::int32_t y) const {
    if (x > 0 && x < kChunkSize && y > 0 && y < kChunkSize && chunk.index < short_.size()) {
      const auto around = [&](const auto* at) -> std::array<CellSegments, 4> {
        return {of(at[0]), of(at[-1]), of(at[-1 - kChunkSize]), of(at[-kChunkSize])};
      };
      if (const ShortLists* shortLists = short_.get(chunk.index)) return around(&shortLists->lists[localOf({x, y})]);
      if (const Refs* refs = refs_.get(chunk.index)) return around(&refs->lists[localOf({x, y})]);
    }
    return {of(cellAt(chunk, x, y)), of(cellAt(chunk, x - 1, y)), of(cellAt(chunk, x - 1, y - 1)),
            of(cellAt(chunk, x, y - 1))};
  }
  bool isLive(CellAt at) const { return (liveRow(*at.chunk, at.row()) & at.bit()) != 0; }
  /// The cells in a row of a chunk that show segments.
  RowMask liveRow(const Chunk& chunk, std::uint32_t row) const {
    const Live* live = liveOf(chunk.index);
    return live ? live->rows[row] : 0;
  }

  /// Calls visit(address) for where the lists of a cell and of the eight around it are or are noted, unless it is at the
  /// boundary of its chunk.
  template <class Visit>
  void forEachPlaceAround(std::uint32_t cellRef, Visit&& visit) const {
    const std::uint32_t number = cellRef / kChunkCells, at = cellRef % kChunkCells;
    const Live* live = liveOf(number);
    if (!live || !isInner(at)) return;
    visit(&live->rows[at / kChunkSize]);
    for (std::uint32_t row = at - kChunkSize; row <= at + kChunkSize; row += kChunkSize) {
      if (!short_.has(number)) {
        visit(&refs_[number].lists[row]);
      } else {
        visit(&short_[number].lists[row - 1]);
        visit(&short_[number].lists[row + 1].back());
      }
    }
  }
  /// Calls visit(list) for these lists.
  template <class Visit>
  void forEachAround(std::uint32_t cellRef, Visit&& visit) const {
    const std::uint32_t number = cellRef / kChunkCells, at = cellRef % kChunkCells;
    if (!liveOf(number) || !isInner(at)) return;
    const auto visitAll = [&](const auto& lists) {
      for (std::uint32_t row = at - kChunkSize; row <= at + kChunkSize; row += kChunkSize)
        for (std::uint32_t local = row - 1; local <= row + 1; ++local) visit(of(lists[local]));
    };
    short_.has(number) ? visitAll(short_[number].lists) : visitAll(refs_[number].lists);
  }
  /// Whether there is no reference to wait for.
  bool hasShortLists(std::uint32_t number) const { return number < short_.size() && short_.has(number); }

  /// Takes `removed` ids out of a cell's list, from index `begin` on, and makes room for `added` there. Returns the
  /// words of the list, into which the caller writes these ids and the new layout; null if the cell shows nothing now.
  std::uint32_t* splice(CellAt at, std::uint32_t begin, std::uint32_t removed, std::uint32_t added);
  /// The words of a list that is there.
  std::uint32_t* words(CellAt at) {
    if (!hasShortLists(at.chunk->index)) return arena_.at(refs_[at.chunk->index].lists[at.local]);
    ShortList& list = short_[at.chunk->index].lists[at.local];
    return isElsewhere(list) ? arena_.at(list[0]) : list.data();
  }

  /// What a chunk shows, which is nothing. Its number may name another chunk from now on.
  void forget(std::uint32_t chunk);

  std::uint64_t bytes() const { return refs_.bytes() + short_.bytes() + arena_.bytes(); }

 private:
  static constexpr std::uint32_t kMostShort = 3;
  /// A list; or the bit kElsewhere in the last word of a layout, and first a reference to the list.
  using ShortList = std::array<std::uint32_t, Layout::kWords + kMostShort>;
  static constexpr std::uint32_t kElsewhere = 1u << 31;
  static bool isElsewhere(const ShortList& list) { return (list[Layout::kWords - 1] & kElsewhere) != 0; }
  struct Live {
    std::array<RowMask, kChunkSize> rows{};  ///< cells that have a list
  };
  struct ShortLists : Live {
    std::array<ShortList, kChunkCells> lists{};
  };
  struct Refs : Live {
    std::array<RecordArena::Ref, kChunkCells> lists{};  ///< 0 if a cell has none
  };
  static constexpr std::array<std::uint32_t, Layout::kWords + 1> kNothing{};

  CellSegments of(RecordArena::Ref list) const { return CellSegments(list != 0 ? arena_.at(list) : kNothing.data()); }
  CellSegments of(const ShortList& list) const {
    return CellSegments(isElsewhere(list) ? arena_.at(list[0]) : list.data());
  }
  Live* liveOf(std::uint32_t number) const {
    if (number >= short_.size()) return nullptr;
    if (ShortLists* shortLists = short_.get(number)) return shortLists;
    return refs_.get(number);
  }
  void make(const Chunk& chunk);
  std::uint32_t* spliceShort(CellAt at, std::uint32_t begin, std::uint32_t removed, std::uint32_t added);

  // By number of a chunk. Only chunks that show segments, or did, have one or the other.
  Pages<ShortLists> short_;
  Pages<Refs> refs_;
  RecordArena arena_;
};

}  // namespace lgs::detail
