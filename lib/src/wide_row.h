// Bit rows over the cells of a chunk, by which a commit finds its way without looking at every cell.
#pragma once

#include "grid.h"

#include <bit>
#include <cstdint>

namespace lgs::detail {

/// A row of a chunk with a column of its neighbours at either end: bit x + 1 is column x, -1 … 32.
using WideRow = std::uint64_t;
inline constexpr WideRow kOwnColumns = WideRow{0xffff'ffff} << 1;

/// Row y (-1 … 32) of one of the chunk's bitmaps, continued into the chunks around.
template <auto Bitmap>
WideRow wideRow(const Chunk& chunk, std::int32_t y) {
  const auto row = static_cast<std::size_t>(y & (kChunkSize - 1));
  const auto bits = [&](const Chunk* c) { return c ? WideRow{(c->*Bitmap)[row]} : 0; };
  const std::int32_t dj = y >> 5;
  return bits(chunk.neighbour(-1, dj)) >> 31 | bits(chunk.neighbour(0, dj)) << 1 |
         (bits(chunk.neighbour(1, dj)) & 1) << 33;
}

/// The chunk's own dirty cells in row y, none outside.
inline WideRow dirtyRow(const Chunk& chunk, std::int32_t y) {
  return y >= 0 && y < kChunkSize ? WideRow{chunk.dirty[static_cast<std::size_t>(y)]} << 1 : 0;
}

/// The dirty cell of a chunk that has one only; none if there are more.
inline CellAt onlyDirtyCell(const Chunk& chunk) {
  const auto row = static_cast<std::uint32_t>(std::countr_zero(chunk.dirtyRows));
  const RowMask cells = chunk.dirty[row];
  if ((chunk.dirtyRows & (chunk.dirtyRows - 1)) != 0 || (cells & (cells - 1)) != 0) return {};
  return {chunk.around[4], row * kChunkSize + static_cast<std::uint32_t>(std::countr_zero(cells))};
}

/// Calls visit(y) for y from -1 to 32 where row y, or one beside it, has a dirty cell.
template <class Visit>
void forEachRowNear(RowMask dirtyRows, Visit&& visit) {
  const WideRow rows = WideRow{dirtyRows} << 1;
  for (WideRow near = rows | rows << 1 | rows >> 1; near != 0; near &= near - 1) visit(std::countr_zero(near) - 1);
}

/// Calls visit(x) for every bit of a wide row.
template <class Visit>
void forEachColumn(WideRow row, Visit&& visit) {
  for (; row != 0; row &= row - 1) visit(std::countr_zero(row) - 1);
}

/// The cells of row y (0 … 31) of which anything may show where nothing is preserved; none of the others shows anything.
inline WideRow showingRow(const Chunk& chunk, std::int32_t y) {
  static constexpr std::array<Facts, kChunkSize> kNoFacts{};
  const auto row = [&](std::int32_t di, std::int32_t yOfRow) {
    const Chunk* c = chunk.neighbour(di, yOfRow >> 5);
    return c ? &c->facts[localOf({0, yOfRow})] : kNoFacts.data();
  };
  std::array<Facts, kChunkSize + 2> wide;  // with a column of the neighbours at either end
  wide.front() = row(-1, y)[kChunkSize - 1];
  std::copy_n(row(0, y), kChunkSize, wide.data() + 1);
  wide.back() = row(1, y)[0];
  const Facts *below = row(0, y - 1), *above = row(0, y + 1);
  std::array<Facts, kChunkSize> shows;
  for (std::size_t x = 0; x < kChunkSize; ++x)
    shows[x] = static_cast<Facts>(wide[x + 1] & ~hiddenSides(below[x], wide[x + 2], above[x], wide[x]));
  WideRow bits = 0;
  for (std::size_t x = 0; x < kChunkSize; x += 8) {
    WideRow eight = 0;  // compilers make this one load
    for (std::size_t k = 0; k < 8; ++k) eight |= WideRow{shows[x + k]} << 8 * k;
    const WideRow isSet = (eight + 0x7f7f'7f7f'7f7f'7f7f) >> 7 & 0x0101'0101'0101'0101;
    bits |= (isSet * 0x0102'0408'1020'4080 >> 56) << x;
  }
  return bits << 1;
}

/// Whether a row may have so many bits that finding out which of them can be skipped pays. A rule of thumb: they span more
/// than eight columns.
inline bool isCrowded(WideRow row) { return row >> std::countr_zero(row | WideRow{1} << 63) >= 256; }

}  // namespace lgs::detail
