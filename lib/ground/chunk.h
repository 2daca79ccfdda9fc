// A chunk of 32×32 cells, and the ways from one cell to the next.
#pragma once

#include "ground/cell.h"

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

namespace lgs::detail {

inline constexpr std::int32_t kChunkSize = 32;
inline constexpr std::uint32_t kChunkCells = kChunkSize * kChunkSize;

/// The place of a cell in its chunk.
constexpr std::uint32_t localOf(Cell cell) {
  return static_cast<std::uint32_t>((cell.j & (kChunkSize - 1)) * kChunkSize + (cell.i & (kChunkSize - 1)));
}

/// The cell in that place of a chunk, whose place is given in chunks.
constexpr Cell cellIn(std::int32_t ci, std::int32_t cj, std::uint32_t local) {
  return {ci * kChunkSize + static_cast<std::int32_t>(local % kChunkSize),
          cj * kChunkSize + static_cast<std::int32_t>(local / kChunkSize)};
}

/// Whether all eight cells around a cell are in its chunk.
constexpr bool isInner(std::uint32_t local) {
  const std::uint32_t x = local % kChunkSize, y = local / kChunkSize;
  return x - 1 < kChunkSize - 2 && y - 1 < kChunkSize - 2;
}

using RowMask = std::uint32_t;  ///< a bit for each cell in a row of a chunk

/// Calls visit(k) for each bit k that is set.
template <class Bits, class Visit>
void forEachBit(Bits bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

struct Chunk {
  std::int32_t ci = 0;  ///< coordinates in chunks: those of any of its cells >> 5
  std::int32_t cj = 0;
  std::uint32_t index = 0;
  RowMask dirtyRows = 0;                    ///< the rows that have a dirty cell
  Facts everFacts = 0;                      ///< of all contents that any of its cells has or had
  bool isUnloaded = false;                  ///< its cells have what the chunks beside it need: see border.h
  std::array<Chunk*, 9> around{};           ///< row by row from the lower left; null where there is none
  std::array<RowMask, kChunkSize> dirty{};  ///< cells whose segments may be out of date
  std::uint64_t commonBlock = kNoBlock;     ///< of all cells that list no polygons, while `blocks` is empty
  std::vector<Block> blocks;
  std::array<Facts, kChunkCells> facts{};          ///< of each cell's content
  std::array<std::uint32_t, kChunkCells> cells{};  ///< the word of each cell: see cell.h

  static constexpr std::uint64_t kNoBlock = std::uint64_t{1} << 32;
  /// The chunk di columns and dj rows away, each -1 … 1.
  Chunk* neighbour(std::int32_t di, std::int32_t dj) const {
    const std::int32_t there = 3 * dj + di + 4;
    return around[static_cast<std::size_t>(there)];
  }
  Chunk* self() const { return around[4]; }
  /// Of a cell that has a word and no list.
  Block block(std::uint32_t local) const { return blocks.empty() ? static_cast<Block>(commonBlock) : blocks[local]; }
  bool hasRoomFor(Block block) const { return !blocks.empty() || commonBlock == block; }
  void setBlock(std::uint32_t local, Block block) {
    if (!hasRoomFor(block)) makeRoomForBlock(block);
    if (!blocks.empty()) blocks[local] = block;
  }
  Cell cell(std::uint32_t local) const { return cellIn(ci, cj, local); }
  std::uint32_t ref(std::uint32_t local) const { return index * kChunkCells + local; }

 private:
  void makeRoomForBlock(Block block);
};

/// A cell of a chunk; or none, if there is no such chunk.
struct CellAt {
  Chunk* chunk = nullptr;
  std::uint32_t local = 0;

  CellWord& word() const {
    assert(chunk);
    return chunk->cells[local];
  }
  std::uint32_t ref() const { return chunk->ref(local); }
  Cell cell() const { return chunk->cell(local); }
  std::uint32_t row() const { return local / kChunkSize; }
  RowMask bit() const { return RowMask{1} << local % kChunkSize; }
  explicit operator bool() const { return chunk != nullptr; }
};

/// The cell in column x and row y of a chunk, -32 … 63 each: it may be in a chunk beside this one. If there is no such
/// chunk, the result has none.
inline CellAt cellAt(const Chunk& chunk, std::int32_t x, std::int32_t y) {
  assert(x >= -kChunkSize && x < 2 * kChunkSize && y >= -kChunkSize && y < 2 * kChunkSize);
  return {chunk.neighbour(x >> 5, y >> 5), localOf({x, y})};
}

/// The cell across a side.
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

inline constexpr CellRect kWholeWorld{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// The chunks that have cells of a rectangle, which is not empty.
struct ChunkRect {
  explicit ChunkRect(const CellRect& r) : i0(r.min.i >> 5), j0(r.min.j >> 5), i1(r.max.i >> 5), j1(r.max.j >> 5) {}
  std::int32_t i0, j0, i1, j1;
  bool contains(std::int32_t ci, std::int32_t cj) const { return ci >= i0 && ci <= i1 && cj >= j0 && cj <= j1; }
  bool contains(const Chunk& c) const { return contains(c.ci, c.cj); }
  std::uint64_t count() const {
    return (static_cast<std::uint64_t>(i1 - i0) + 1) * (static_cast<std::uint64_t>(j1 - j0) + 1);
  }
  /// Calls visit(ci, cj) for each, by rows.
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (std::int32_t cj = j0; cj <= j1; ++cj)
      for (std::int32_t ci = i0; ci <= i1; ++ci) visit(ci, cj);
  }
};

}  // namespace lgs::detail
