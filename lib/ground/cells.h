// What stands where: the polygons in each cell, and which cells changed since the last commit. What cells held before is
// kept by their notes.
#pragma once

#include "ground/catalogue.h"
#include "ground/cell.h"
#include "ground/grid.h"
#include "storage/journal.h"
#include "storage/record_arena.h"

#include <lgs/error.h>
#include <lgs/world.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

class Cells {
 public:
  explicit Cells(PreserveRelation relation) : preserve(std::move(relation)) {}
  Cells(const Cells& other);
  Cells& operator=(const Cells&) = delete;
  ~Cells() = default;

  PreserveRelation preserve;
  Catalogue catalogue;
  Grid grid;

  // --- Reading

  /// What a cell holds: nothing, if it is without chunk.
  Held held(CellAt at) const { return at ? held(at.word(), at.chunk->block(at.local)) : Held(); }
  Held held(CellWord word, Block block = 0) const {
    return {word, block, isListed(word) ? lists_.at(word & ~kListBit) : nullptr};
  }
  ContentId contentId(CellAt at) const { return held(at).content(); }
  const Content& content(CellAt at) const { return catalogue.content(contentId(at)); }
  bool keeps(Block a, Block b) const { return preserve && (a < b ? preserve(a, b) : preserve(b, a)); }

  struct Found {
    CellAt at;
    Slot slot = 0;
  };
  /// Where a polygon is. Refused: staleHandle; unloaded.
  Expected<Found> find(PolygonHandle handle) const;
  /// The polygons of a cell with this reference, by handle, behind what is in `out`. Valid until the next edit.
  void read(std::uint32_t ref, const Held& held, std::vector<PlacedPolygon>& out) const;

  // --- What changed since the last commit

  /// The chunks with changed cells, in the order of their first change. Chunk::dirty says which cells these are.
  std::span<Chunk* const> changedChunks() const { return changed_; }
  /// The changed cells of a chunk.
  struct ChangedCells {
    std::uint32_t chunk = 0;  ///< its number
    RowMask rows = 0;
    std::array<RowMask, kChunkSize> cells{};  ///< by row
  };
  std::vector<ChangedCells> changedCells() const;

  std::uint64_t bytes() const;

 protected:  // for the ground, whose primitive goes through them
  void touch(CellAt at, Facts facts) {
    if (at.chunk->dirtyRows == 0) changed_.push_back(at.chunk);
    setDirty(at, facts);
  }
  void touchAll(Chunk& chunk) {
    if (chunk.dirtyRows == 0) changed_.push_back(&chunk);
    chunk.dirtyRows = ~RowMask{0};
    chunk.dirty.fill(~RowMask{0});
  }
  /// In a chunk that has changed already.
  static void setDirty(CellAt at, Facts facts) {
    Chunk& chunk = *at.chunk;
    chunk.dirtyRows |= RowMask{1} << at.row();
    chunk.dirty[at.row()] |= at.bit();
    chunk.facts[at.local] = facts;
    chunk.everFacts |= facts;
  }
  /// An edit is undone before which a cell had not changed. Edits are undone in reverse order: so a chunk without
  /// changed cells is the last of changedChunks().
  void setClean(CellAt at);
  /// No cell has changed; from now on these have.
  void setChangedCells(const std::vector<ChangedCells>& changed);
  /// From now on no cell has changed.
  void clearChanges() {
    for (Chunk* chunk : changed_) {
      forEachBit(std::exchange(chunk->dirtyRows, 0), [&](std::uint32_t row) { chunk->dirty[row] = 0; });
    }
    changed_.clear();
  }

  // --- The words of cells, and what they stand for: a content in use, and a list

  CellWord makeList(ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons);
  /// Lets go of what a word stands for.
  void drop(CellWord word) {
    if (word <= kLowMask) return;  // it had no polygons
    catalogue.release(held(word).content());
    if (isListed(word)) releaseList(word);
  }
  /// A cell gets a word instead of the one that it has. The block is that of a word with a polygon.
  void write(CellAt at, CellWord word, Block block, Facts facts) {
    at.word() = word;
    if (hasSole(word)) at.chunk->setBlock(at.local, block);
    touch(at, facts);
  }
  /// The same, but the old word is not dropped, and the cell does not count as changed.
  void lay(CellAt at, CellWord word, Block block);
  /// A cell comes to hold nothing, in the same way.
  void empty(CellAt at) {
    drop(at.word());
    lay(at, 0, 0);
  }
  /// What a note of a cell says instead of its word: a list is among the words that the journal keeps. The content
  /// stays in use. The cell must get another word.
  CellWord moveOut(CellWord word, Journal& journal);
  /// The word for what was moved out.
  CellWord moveIn(CellWord moved, Journal& journal);

 private:
  void releaseList(CellWord word);

  RecordArena lists_;
  std::vector<Chunk*> changed_;
};

}  // namespace lgs::detail
