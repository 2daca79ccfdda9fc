// How the segments of a cell are set out in its list of ids.
#pragma once

#include "ground/content.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace lgs::detail {

/// The segments of a cell come in parts: those inside it, then those on each side.
enum Part : unsigned { kInterior, kSouthPart, kEastPart, kNorthPart, kWestPart, kParts };
inline constexpr unsigned kAllParts = (1u << kParts) - 1;
constexpr unsigned partOf(unsigned side) { return side + 1; }

using PartEnds = std::array<std::uint16_t, kParts>;  ///< where each part ends in a list of ids

/// What the segments of a cell touch. Bit s: one on side s starts where the side starts. Bit 4 + s: one ends where the
/// side ends.
using Touching = std::uint32_t;
constexpr Touching bothEnds(unsigned sides) { return sides | sides << 4; }
constexpr Touching touching(unsigned side, std::int32_t begin, std::int32_t end) {
  const bool low = begin == 0, high = end == kUnitsPerCell;
  const bool starts = runsForward(side) ? low : high, ends = runsForward(side) ? high : low;
  return (starts ? 0x01u : 0u) << side | (ends ? 0x10u : 0u) << side;
}

/// The words at the beginning of a list, before the ids: where each part ends, what is touched, and, if the segments
/// are few, with which of them the fans of the cell's corners begin and end. That is all that a commit has to know of
/// them at a corner.
///
///            31           24 23   16 15              0
///            ┌──────────────┬───────┬────────────────┐
///   words 2  │ bit 24: whole│Touching│ count of ids  │   whole: one segment along each side that is touched
///            └──────────────┴───────┴────────────────┘
///   few      word 0: last of corner 3…0 │ first of corner 3…0   4 bits each: a place counted from 1, or 0 for none
///            word 1: the ends of the parts north, east, south, interior, 4 bits each
///   many     word 0: end of south │ end of interior   word 1: end of north │ end of east   16 bits each
///
/// The west part ends where the ids do.
class Layout {
 public:
  static constexpr std::uint32_t kWords = 3;

  constexpr Layout() = default;
  explicit constexpr Layout(const std::uint32_t* words) : words_{words[0], words[1], words[2]} {}
  /// `inside` are the ends of the corners' fans that are inside the cell.
  constexpr Layout(const PartEnds& ends, Touching touching, CornerEnds inside) {
    const unsigned sides = touching & kWholeSides;
    const bool isWhole = touching == bothEnds(sides) && ends[kWestPart] - ends[kInterior] == std::popcount(sides);
    words_[2] = ends[kWestPart] | touching << 16 | (isWhole ? kWhole : 0);
    if (areFew()) {
      const CornerEnds corners = cornerEnds(ends, touching, inside);
      words_[0] = corners.first | std::uint32_t{corners.last} << 16;
      for (unsigned part = kInterior; part < kWestPart; ++part) words_[1] |= std::uint32_t{ends[part]} << 4 * part;
    } else {
      words_[0] = ends[0] | std::uint32_t{ends[1]} << 16;
      words_[1] = ends[2] | std::uint32_t{ends[3]} << 16;
    }
  }
  /// The same with more half-edges of corners' fans, where there are none yet.
  constexpr Layout with(CornerEnds inside) const {
    Layout layout = *this;
    if (areFew()) layout.words_[0] |= inside.first | std::uint32_t{inside.last} << 16;
    return layout;
  }
  constexpr void write(std::uint32_t* words) const {
    for (std::uint32_t k = 0; k < kWords; ++k) words[k] = words_[k];
  }

  constexpr std::uint32_t count() const { return words_[2] & 0xffffu; }
  constexpr bool areFew() const { return count() <= CornerEnds::kMaxPlace; }
  constexpr std::uint32_t end(unsigned part) const {
    if (part == kWestPart) return count();
    return areFew() ? words_[1] >> 4 * part & 15u : words_[part / 2] >> part % 2 * 16 & 0xffffu;
  }
  constexpr std::uint32_t begin(unsigned part) const { return part == 0 ? 0u : end(part - 1); }
  constexpr Touching touching() const { return words_[2] >> 16 & 0xffu; }
  /// Whether there is one segment along each of some sides, and none along the others; and the sides.
  constexpr bool hasWholeSides() const { return words_[2] == 0 || (words_[2] & kWhole) != 0; }
  constexpr unsigned wholeSides() const { return words_[2] >> 16 & kWholeSides; }
  /// Of few: the places of segments, counted from 1, by corner; see CornerEnds.
  constexpr std::uint32_t firstAt(unsigned corner) const { return words_[0] >> 4 * corner & 15u; }
  constexpr std::uint32_t lastAt(unsigned corner) const { return words_[0] >> (16 + 4 * corner) & 15u; }

 private:
  static constexpr CornerEnds cornerEnds(const PartEnds& ends, Touching touching, CornerEnds inside) {
    unsigned first = inside.first, last = inside.last;
    for (unsigned side = 0; side < kSides; ++side) {  // it leaves corner `side`, and arrives at the next one
      const unsigned lowest = ends[partOf(side) - 1] + 1u, highest = ends[partOf(side)];
      const unsigned leaving = runsForward(side) ? lowest : highest, arriving = runsForward(side) ? highest : lowest;
      first |= ((0u - (touching >> side & 1u)) & leaving) << 4 * side;
      last |= ((0u - (touching >> (4 + side) & 1u)) & arriving) << 4 * ((side + 1) % kSides);
    }
    return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(last)};
  }

  static constexpr std::uint32_t kWhole = 1u << 24;
  std::array<std::uint32_t, kWords> words_{};
};

/// The segments of a cell: a list, whose memory is another's. Valid until the cell's segments change.
class CellSegments {
 public:
  explicit CellSegments(const std::uint32_t* words) : words_(words) {}

  explicit operator bool() const { return words_[2] != 0; }
  /// Whether each of these cells shows few segments.
  static bool areFew(const std::array<CellSegments, 4>& cells) {
    static_assert(std::has_single_bit(CornerEnds::kMaxPlace + 1));  // so bits tell
    const std::uint32_t bits = cells[0].words_[2] | cells[1].words_[2] | cells[2].words_[2] | cells[3].words_[2];
    return (bits & 0xffffu) <= CornerEnds::kMaxPlace;
  }
  Layout layout() const { return Layout(words_); }
  std::uint32_t count() const { return layout().count(); }
  const std::uint32_t* ids() const { return words_ + Layout::kWords; }
  std::span<const std::uint32_t> all() const { return {ids(), count()}; }
  /// With the layout.
  std::span<const std::uint32_t> words() const { return {words_, Layout::kWords + count()}; }
  std::span<const std::uint32_t> part(unsigned part) const {
    return {ids() + layout().begin(part), layout().end(part) - layout().begin(part)};
  }
  /// The segment at a place that is counted from 1. Place 0 can be read, and means nothing.
  std::uint32_t at(std::uint32_t place) const { return words_[Layout::kWords - 1 + place]; }

 private:
  const std::uint32_t* words_;
};

/// Of each set of sides: how many come before each side; and all.
inline constexpr auto kSideCounts = [] {
  std::array<std::array<std::uint8_t, kSides + 1>, 16> counts{};
  for (unsigned sides = 0; sides < 16; ++sides)
    for (unsigned side = 0; side < kSides; ++side)
      counts[sides][side + 1] = static_cast<std::uint8_t>(counts[sides][side] + (sides >> side & 1u));
  return counts;
}();

constexpr Layout workOutLayoutOfSides(unsigned sides, std::size_t inside) {
  PartEnds ends{};
  for (unsigned part = 0; part < kParts; ++part)
    ends[part] = static_cast<std::uint16_t>(inside + kSideCounts[sides][part]);
  return {ends, bothEnds(sides), {}};
}
/// With none or one inside, as most cells have it.
inline constexpr auto kLayoutsOfSides = [] {
  std::array<std::array<Layout, 16>, 2> layouts;
  for (unsigned inside = 0; inside < 2; ++inside)
    for (unsigned sides = 0; sides < 16; ++sides) layouts[inside][sides] = workOutLayoutOfSides(sides, inside);
  return layouts;
}();
/// Of a cell that shows one segment along each of these sides, after `inside` others, which have these ends of fans.
inline Layout layoutOfSides(unsigned sides, std::size_t inside, CornerEnds corners) {
  return (inside < kLayoutsOfSides.size() ? kLayoutsOfSides[inside][sides] : workOutLayoutOfSides(sides, inside))
      .with(corners);
}

}  // namespace lgs::detail
