// The record of a cell for which one word is not enough: the polygons that it holds, and the segments that it shows.
#pragma once

#include "content.h"
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

/// The segments of a cell come in parts: those inside it, then those on each side.
enum Part : unsigned { kInterior, kSouthPart, kEastPart, kNorthPart, kWestPart, kParts };
inline constexpr unsigned kAllParts = (1u << kParts) - 1;
constexpr unsigned partOf(unsigned side) { return side + 1; }

using PartEnds = std::array<std::uint16_t, kParts>;  ///< where each part ends in a list of ids

/// The corners' fans of a cell. `ends` are of its parts, `inside` is of its content. Bit s of `touching`: a segment on
/// side s starts where the side starts. Bit 4 + s: one ends where the side ends.
constexpr CornerEnds cornerEnds(const PartEnds& ends, unsigned touching, CornerEnds inside) {
  unsigned first = inside.first, last = inside.last;
  for (unsigned side = 0; side < kSides; ++side) {  // it leaves corner `side`, and arrives at the next one
    const unsigned lowest = ends[partOf(side) - 1] + 1u, highest = ends[partOf(side)];
    const unsigned leaving = runsForward(side) ? lowest : highest, arriving = runsForward(side) ? highest : lowest;
    first |= ((0u - (touching >> side & 1u)) & leaving) << 4 * side;
    last |= ((0u - (touching >> (4 + side) & 1u)) & arriving) << 4 * ((side + 1) % kSides);
  }
  return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(last)};
}

/// How a list of ids is set out. Most cells show few segments. Then there is also room to say with which of them the
/// corners' fans begin and end, and that is all that a commit has to know of them at a corner.
class Parts {
 public:
  constexpr Parts() = default;
  constexpr Parts(const PartEnds& ends, CornerEnds corners) : words_(ends) {
    if (!areFew()) return;
    words_ = {corners.first, corners.last,
              static_cast<std::uint16_t>(ends[0] | ends[1] << 4 | ends[2] << 8 | ends[3] << 12), 0, ends[kWestPart]};
  }
  /// The same with more half-edges, at other places of the corners.
  constexpr Parts with(CornerEnds corners) const {
    Parts parts = *this;
    if (!areFew()) return parts;
    parts.words_[0] |= corners.first;
    parts.words_[1] |= corners.last;
    return parts;
  }

  constexpr std::uint32_t count() const { return words_[kWestPart]; }
  constexpr bool areFew() const { return count() <= CornerEnds::kMaxPlace; }
  constexpr std::uint32_t end(unsigned part) const {
    return areFew() && part != kWestPart ? words_[2] >> 4 * part & 15u : words_[part];
  }
  constexpr std::uint32_t begin(unsigned part) const { return part == 0 ? 0u : end(part - 1); }

  /// Of few.
  CornerEnds corners() const { return {words_[0], words_[1]}; }

 private:
  /// Of few: CornerEnds; four bits for each part but the last one; nothing. Of many: where each part but the last one
  /// ends. And where that ends.
  PartEnds words_{};
};

/// Of each set of sides: how many come before each side; and all.
inline constexpr auto kSideCounts = [] {
  std::array<std::array<std::uint8_t, kSides + 1>, 16> counts{};
  for (unsigned sides = 0; sides < 16; ++sides)
    for (unsigned side = 0; side < kSides; ++side)
      counts[sides][side + 1] = static_cast<std::uint8_t>(counts[sides][side] + (sides >> side & 1u));
  return counts;
}();

/// The parts of a cell that shows one segment along each of these sides, and nothing else.
constexpr Parts partsOfSides(unsigned sides, unsigned inside) {
  PartEnds ends{};
  for (unsigned part = 0; part < kParts; ++part)
    ends[part] = static_cast<std::uint16_t>(inside + kSideCounts[sides][part]);
  return {ends, cornerEnds(ends, sides | sides << 4, {})};
}
/// The same after 0 … 3 segments inside.
inline constexpr auto kPartsOfSides = [] {
  std::array<std::array<Parts, 16>, 4> parts;
  for (unsigned inside = 0; inside < 4; ++inside)
    for (unsigned sides = 0; sides < 16; ++sides) parts[inside][sides] = partsOfSides(sides, inside);
  return parts;
}();

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
    parts = (inside < kPartsOfSides.size() ? kPartsOfSides[inside][sides] : partsOfSides(sides, inside)).with(corners);
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
