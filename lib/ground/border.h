// What stays known of a chunk that is unloaded: the cells at its rim, which the chunks beside it need, and the cells
// that there are notes of. Segments of loaded chunks end on the rim, and so do those of the rim's cells that they are
// linked to. The other cells have no say.
#pragma once

#include "ground/cell.h"
#include "ground/chunk.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <vector>

namespace lgs::detail {

inline constexpr std::uint32_t kRimCells = 4 * (kChunkSize - 1);

/// The places of the cells at the rim, 0 … kRimCells - 1: the lowest row, the highest, then the columns between.
constexpr std::uint32_t rimCell(std::uint32_t k) {
  constexpr std::uint32_t kRow = kChunkSize, kColumn = kChunkSize - 2;
  assert(k < kRimCells);
  if (k < kRow) return k;
  if (k < 2 * kRow) return kChunkCells - kRow + (k - kRow);
  k -= 2 * kRow;
  return k < kColumn ? (k + 1) * kRow : (k - kColumn + 2) * kRow - 1;
}

constexpr bool isAtRim(std::uint32_t local) { return !isInner(local); }

/// Cells of a chunk, a bit each.
using CellMask = std::array<RowMask, kChunkSize>;
inline bool contains(const CellMask& cells, std::uint32_t local) {
  return (cells[local / kChunkSize] >> local % kChunkSize & 1u) != 0;
}
inline void insert(CellMask& cells, std::uint32_t local) {
  cells[local / kChunkSize] |= RowMask{1} << local % kChunkSize;
}

struct Border {
  /// Cells at the rim, in a row, that hold the same; several have no list.
  struct Run {
    std::uint32_t cells = 0;
    CellWord word = 0;
    Block block = 0;
  };
  /// A cell of which this is known, and not what its bytes say. At the rim `word` is unused.
  struct Kept {
    std::uint32_t local = 0;
    CellWord word = 0;
    Block block = 0;
  };

  std::int32_t ci = 0;  ///< where the chunk is, as in Chunk
  std::int32_t cj = 0;
  std::uint32_t checksum = 0;    ///< of the bytes with which it comes back
  std::uint32_t lastSerial = 0;  ///< the greatest that cells gave out which are not in `kept`
  bool isRimInChunk = true;      ///< the Chunk has the cells at the rim; otherwise `runs` has them
  bool bytesAreStale = false;    ///< a roll-back or redo came since: of the cells in `kept` the bytes are wrong
  std::vector<Run> runs;
  std::vector<Kept> kept;  ///< by cell: those that there are notes of, and maybe some of before

  Kept& keptAt(std::uint32_t local) {
    const auto found = std::ranges::lower_bound(kept, local, {}, &Kept::local);
    assert(found != kept.end() && found->local == local);
    return *found;
  }
};

}  // namespace lgs::detail
