// How the segments of a cell are set out in its list of ids.
#pragma once

#include "content.h"

#include <array>
#include <cstdint>

namespace lgs::detail {

/// The segments of a cell come in parts: those inside it, then those on each side.
enum Part : unsigned { kInterior, kSouthPart, kEastPart, kNorthPart, kWestPart, kParts };
inline constexpr unsigned kAllParts = (1u << kParts) - 1;
constexpr unsigned partOf(unsigned side) { return side + 1; }

using PartEnds = std::array<std::uint16_t, kParts>;  ///< where each part ends in a list of ids

/// With which segments the fans of a cell's corners begin and end. `ends` are of its parts, `inside` is of its content.
/// Bit s of `touching`: a segment on side s starts where the side starts. Bit 4 + s: one ends where the side ends.
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

/// The parts of a cell with these ends. `touching` and `inside` are as for cornerEnds().
Parts partsOf(const PartEnds& ends, unsigned touching, CornerEnds inside);

constexpr Parts workOutPartsOfSides(unsigned sides, unsigned inside) {
  PartEnds ends{};
  for (unsigned part = 0; part < kParts; ++part)
    ends[part] = static_cast<std::uint16_t>(inside + kSideCounts[sides][part]);
  return {ends, cornerEnds(ends, sides | sides << 4, {})};
}
/// By how many segments are inside, and which sides.
inline constexpr auto kPartsOfSides = [] {
  std::array<std::array<Parts, 16>, 2> parts;
  for (unsigned inside = 0; inside < 2; ++inside)
    for (unsigned sides = 0; sides < 16; ++sides) parts[inside][sides] = workOutPartsOfSides(sides, inside);
  return parts;
}();

Parts partsOfManyInside(unsigned sides, unsigned inside);

/// The parts of a cell that shows one segment along each of these sides, after `inside` others.
inline Parts partsOfSides(unsigned sides, unsigned inside) {
  return inside < kPartsOfSides.size() ? kPartsOfSides[inside][sides] : partsOfManyInside(sides, inside);
}

}  // namespace lgs::detail
