// The record of a cell for which one word is not enough: the polygons that it holds, and the segments that it shows.
#pragma once

#include "content.h"
#include "parts.h"
#include "segment_pool.h"

#include <lgs/ids.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace lgs::detail {

/// A polygon in a cell.
struct Placed {
  std::uint32_t serial = 0;
  Block block = 0;
};

/// The polygons of a cell by slot. Valid until the cell changes.
struct PlacedBySlot {
  const Placed* listed = nullptr;  ///< null if the cell keeps no list, as it has one polygon at most
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

/// More words follow it in memory. If the record lists the cell's polygons, these are the serial given out last and a
/// Placed for each slot. Then come the ids of the segments, part by part, each part in order of start.
struct CellRecord {
  static constexpr std::uint8_t kCompact = 0xff;
  std::uint32_t state = 0;  ///< as a cell without record has it for its word
  Parts parts;
  std::uint8_t polygons = kCompact;  ///< how many it lists; kCompact if it keeps no list
  std::uint8_t touching = 0;         ///< see cornerEnds()

  static constexpr std::uint32_t kHeaderWords = 4;

  bool isCompact() const { return polygons == kCompact; }
  std::uint32_t prefixWords() const { return kHeaderWords + (isCompact() ? 0u : 1u + 2u * polygons); }
  /// There is room for one id at least, so that ids()[0] can be read in any record.
  std::uint32_t sizeWords() const { return prefixWords() + std::max<std::uint32_t>(count(), 1); }
  std::uint32_t count() const { return parts.count(); }
  std::uint32_t* words() { return reinterpret_cast<std::uint32_t*>(this); }
  const std::uint32_t* words() const { return reinterpret_cast<const std::uint32_t*>(this); }
  std::uint32_t* ids() { return words() + prefixWords(); }
  const std::uint32_t* ids() const { return words() + prefixWords(); }
  std::span<const std::uint32_t> ids(unsigned part) const {
    return {ids() + parts.begin(part), parts.end(part) - parts.begin(part)};
  }
  /// Says that there is one segment along each of these sides, after `inside` others with these corners.
  void setWholeSides(unsigned sides, std::uint32_t inside, CornerEnds corners) {
    parts = partsOfSides(sides, inside).with(corners);
    touching = static_cast<std::uint8_t>(sides | sides << 4);
  }
  /// Whether there is one segment along each of some sides, and none along the others.
  bool hasWholeSides() const {
    const unsigned sides = touching & 0xfu;
    return touching == (sides | sides << 4) && count() == parts.end(kInterior) + kSideCounts[sides][kSides];
  }
  /// The segment at a place that is counted from 1. Place 0 can be read, and means nothing.
  std::uint32_t idAt(std::uint32_t place) const { return words()[prefixWords() - 1 + place]; }

  // Only of a record that is not compact.
  std::uint32_t lastSerial() const { return words()[kHeaderWords]; }
  const Placed* placed() const { return reinterpret_cast<const Placed*>(words() + kHeaderWords + 1); }
};
static_assert(sizeof(CellRecord) == CellRecord::kHeaderWords * sizeof(std::uint32_t));
static_assert(sizeof(Placed) == 2 * sizeof(std::uint32_t));

}  // namespace lgs::detail
