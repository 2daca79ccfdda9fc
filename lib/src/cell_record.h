// What a cell keeps where one word is not enough: its polygons and its segments.
#pragma once

#include "content.h"
#include "segment_pool.h"

#include <lgs/ids.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace lgs::detail {

/// A polygon of a cell.
struct Placed {
  std::uint32_t serial = 0;
  Block block = 0;
};

/// The polygons of a cell by slot. Valid until the cell changes.
struct PlacedBySlot {
  const Placed* listed = nullptr;  ///< null where the cell has one polygon at most
  Placed sole;                     ///< that one
  Placed operator[](Slot slot) const { return listed ? listed[slot] : sole; }
};

/// The record of a segment that has no links yet.
inline SegmentRecord newSegment(std::uint32_t cellRef, const PackedEnds& ends, Placed placed) {
  return {.predecessor = kUnlinked,
          .successor = kUnlinked,
          .listed = 0,
          .cellRef = cellRef,
          .block = placed.block,
          .serial = placed.serial & kMaxSerial,
          .high = ends.high & 0xfu,
          .from = ends.from,
          .to = ends.to};
}

/// The parts of a cell's segments, in the order in which its record lists them.
enum Part : unsigned { kInterior, kSouthPart, kEastPart, kNorthPart, kWestPart, kParts };
inline constexpr unsigned kAllParts = (1u << kParts) - 1;
constexpr unsigned partOf(unsigned side) { return side + 1; }

/// In memory followed by, if `polygons` is not kCompact, the last serial given out and `polygons` × Placed in order of
/// slots; then by the segment ids, part after part, each part in order of start.
using PartEnds = std::array<std::uint16_t, kParts>;  ///< where each part ends in a list of ids

struct CellRecord {
  static constexpr std::uint8_t kCompact = 0xff;
  std::uint32_t state = 0;  ///< as the word of a cell without record
  PartEnds end{};
  std::uint8_t polygons = kCompact;
  std::uint8_t touching =
      0;  ///< bit s: a segment on side s starts where the side does; bit 4 + s: one ends where it does

  std::uint32_t prefixWords() const {
    return sizeof(CellRecord) / sizeof(std::uint32_t) + (polygons == kCompact ? 0u : 1u + 2u * polygons);
  }
  /// Room for one id at least, so that ids()[0] can be read in any record.
  std::uint32_t sizeWords() const { return prefixWords() + std::max<std::uint32_t>(count(), 1); }
  std::uint32_t begin(unsigned part) const { return part == 0 ? 0u : end[part - 1]; }
  std::uint32_t count() const { return end[kWestPart]; }
  std::uint32_t* words() { return reinterpret_cast<std::uint32_t*>(this); }
  const std::uint32_t* words() const { return reinterpret_cast<const std::uint32_t*>(this); }
  std::uint32_t* ids() { return words() + prefixWords(); }
  const std::uint32_t* ids() const { return words() + prefixWords(); }
  std::span<const std::uint32_t> ids(unsigned part) const { return {ids() + begin(part), end[part] - begin(part)}; }
};
static_assert(sizeof(CellRecord) == 16);

}  // namespace lgs::detail
