// Rows of bits over the cells of a chunk. With them a commit finds what it must visit without a look at every cell.
#pragma once

#include "ground/chunk.h"
#include "outline/segment_lists.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace lgs::detail {

/// A row of a chunk, and a column of its neighbours at either end: bit x + 1 stands for column x, -1 … 32.
using WideRow = std::uint64_t;
inline constexpr WideRow kOwnColumns = WideRow{0xffff'ffff} << 1;

/// Row y (-1 … 32) of a bitmap, continued into the chunks around. bitsOf(chunk, row) are those of one chunk.
template <class Bits>
WideRow wideRow(const Chunk& chunk, std::int32_t y, Bits&& bitsOf) {
  const auto row = static_cast<std::uint32_t>(y & (kChunkSize - 1));
  const auto bits = [&](const Chunk* c) { return c ? WideRow{bitsOf(*c, row)} : 0; };
  const std::int32_t dj = y >> 5;
  return bits(chunk.neighbour(-1, dj)) >> 31 | bits(chunk.neighbour(0, dj)) << 1 |
         (bits(chunk.neighbour(1, dj)) & 1) << 33;
}
inline WideRow wideDirtyRow(const Chunk& chunk, std::int32_t y) {
  return wideRow(chunk, y, [](const Chunk& c, std::uint32_t row) { return c.dirty[row]; });
}
/// The cells that have segments.
inline WideRow wideLiveRow(const SegmentLists& lists, const Chunk& chunk, std::int32_t y) {
  return wideRow(chunk, y, [&](const Chunk& c, std::uint32_t row) { return lists.liveRow(c, row); });
}

/// The chunk's own dirty cells in row y, none outside.
inline WideRow dirtyRow(const Chunk& chunk, std::int32_t y) {
  return y >= 0 && y < kChunkSize ? WideRow{chunk.dirty[static_cast<std::size_t>(y)]} << 1 : 0;
}

/// The dirty cell of a chunk that has only one; without chunk if there are more. Games commit single edits. Then the
/// rows around a cell are all set-up and no use: without a way of its own such a commit takes a quarter more
/// instructions.
inline CellAt onlyDirtyCell(const Chunk& chunk) {
  const auto row = static_cast<std::uint32_t>(std::countr_zero(chunk.dirtyRows));
  const RowMask cells = chunk.dirty[row];
  if ((chunk.dirtyRows & (chunk.dirtyRows - 1)) != 0 || (cells & (cells - 1)) != 0) return {};
  return {chunk.self(), row * kChunkSize + static_cast<std::uint32_t>(std::countr_zero(cells))};
}

/// Calls visit(y) for y from -1 to 32 if row y has a dirty cell, or a row beside it.
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

/// Bit k of the result says whether byte k, the one at bit 8k, is not zero. No byte may be above 0x80.
constexpr std::uint64_t nonZeroBytes(std::uint64_t bytes) {
  // Adding 0x7f sets the top bit of a byte that is not zero, and carries nothing into the next byte: 0x80 + 0x7f =
  // 0xff.
  const std::uint64_t isSet = (bytes + 0x7f7f'7f7f'7f7f'7f7f) >> 7 & 0x0101'0101'0101'0101;
  // Now bit 8k speaks for byte k. The factor has the bits 7m for m = 1 … 8, so the product sums bits 8k + 7m. No two of
  // these are the same, so nothing carries. In the top byte are those with k + m = 8, at 56 + k, and no others.
  return isSet * 0x0102'0408'1020'4080 >> 56;
}
static_assert(nonZeroBytes(0x8000'0100'0000'007f) == 0b1010'0001);
static_assert(kAllFacts <= 0x80, "showingRow() counts the bytes that are not zero");

/// The cells of row y (0 … 31) that may show something. The others show nothing, if no relation preserves anything.
inline WideRow showingRow(const Chunk& chunk, std::int32_t y) {
  static constexpr std::array<Facts, kChunkSize> kNoFacts{};
  const auto row = [&](std::int32_t di, std::int32_t yOfRow) {
    const Chunk* c = chunk.neighbour(di, yOfRow >> 5);
    return c ? &c->facts[localOf({0, yOfRow})] : kNoFacts.data();
  };
  // Both arrays are filled at once. NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
  std::array<Facts, kChunkSize + 2> wide;  // with a column of the neighbours at either end
  wide.front() = row(-1, y)[kChunkSize - 1];
  std::copy_n(row(0, y), kChunkSize, wide.data() + 1);
  wide.back() = row(1, y)[0];
  const Facts *below = row(0, y - 1), *above = row(0, y + 1);
  std::array<Facts, kChunkSize> shows;  // NOLINTEND(cppcoreguidelines-pro-type-member-init)
  for (std::size_t x = 0; x < kChunkSize; ++x)
    shows[x] = static_cast<Facts>(wide[x + 1] & ~hiddenSides(below[x], wide[x + 2], above[x], wide[x]));
  WideRow bits = 0;
  for (std::size_t x = 0; x < kChunkSize; x += 8) {
    // Shifts put cell x + k at byte k on machines of either byte order. Compilers make them one load.
    std::uint64_t eight = 0;
    for (std::size_t k = 0; k < 8; ++k) eight |= std::uint64_t{shows[x + k]} << 8 * k;
    bits |= nonZeroBytes(eight) << x;
  }
  return bits << 1;
}

/// Whether it pays to find out which bits of a row can be skipped. A rule of thumb: they span more than eight columns.
inline bool isCrowded(WideRow row) { return row >> std::countr_zero(row | WideRow{1} << 63) >= 256; }

}  // namespace lgs::detail
