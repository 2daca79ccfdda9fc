// What stays known of a chunk that is unloaded: the cells at its rim, which the chunks beside it need. Their segments
// end on that rim, and so do the segments of the rim's cells that they are linked to. The cells further inside have no
// say.
#pragma once

#include "ground/cell.h"
#include "ground/chunk.h"

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

struct Border {
  /// Cells in a row that hold the same. The word is 0 if they hold nothing.
  struct Run {
    std::uint32_t cells : 8;
    std::uint32_t facts : 8;
    CellWord word;
    Block block;
  };

  std::int32_t ci = 0;  ///< where the chunk is, as in Chunk
  std::int32_t cj = 0;
  std::uint32_t checksum = 0;    ///< of the bytes with which it comes back
  std::uint32_t lastSerial = 0;  ///< the greatest one that any of its cells gave out
  std::vector<Run> runs;

  /// Calls visit(local, run) for each cell.
  template <class Visit>
  void forEachCell(Visit&& visit) const {
    std::uint32_t k = 0;
    for (const Run& run : runs)
      for (std::uint32_t n = 0; n < run.cells; ++n) visit(rimCell(k++), run);
  }
  std::uint64_t bytes() const { return sizeof *this + runs.capacity() * sizeof runs[0]; }
};

}  // namespace lgs::detail
