// What a cell shows: phase 1 (boundary.h) on the four sides of a cell of the world. Reads only.
#pragma once

#include "boundary.h"
#include "wide_row.h"
#include "world_impl.h"

#include <array>
#include <bit>

namespace lgs::detail {

/// CellRecord::touching for a segment along a whole side.
constexpr std::uint8_t bothCorners(unsigned side) { return static_cast<std::uint8_t>(0x11u << side); }

/// The same for one along a part of it.
constexpr std::uint8_t touching(unsigned side, std::int32_t begin, std::int32_t end) {
  const bool low = begin == 0, high = end == kUnitsPerCell;
  const bool starts = runsForward(side) ? low : high, ends = runsForward(side) ? high : low;
  return static_cast<std::uint8_t>((starts ? 0x01u : 0u) << side | (ends ? 0x10u : 0u) << side);
}

/// CellRecord::end of a cell that has one segment along each of a set of sides.
inline constexpr auto kSideCounts = [] {
  std::array<PartEnds, 16> counts{};
  for (unsigned sides = 0; sides < 16; ++sides)
    for (unsigned part = kSouthPart; part < kParts; ++part)
      counts[sides][part] = static_cast<std::uint16_t>(std::popcount(sides & ((1u << part) - 1)));
  return counts;
}();

/// How many segments a cell has that shows what is inside and one edge along each of `sides`.
inline std::uint32_t countSimple(const Content& content, unsigned sides) {
  return static_cast<std::uint32_t>(content.interior.size()) + kSideCounts[sides].back();
}

/// Fills the record of such a cell; create(ends) returns the next segment's id.
template <class Create>
void fillSimple(CellRecord& r, const Content& content, unsigned sides, Create&& create) {
  const auto inside = static_cast<std::uint16_t>(content.interior.size());
  for (unsigned part = 0; part < kParts; ++part)
    r.end[part] = static_cast<std::uint16_t>(kSideCounts[sides][part] + inside);
  r.touching = static_cast<std::uint8_t>(sides | sides << 4);
  std::uint32_t* id = r.ids();
  for (const InteriorSegment& s : content.interior) *id++ = create(s.ends);
  for (; sides != 0; sides &= sides - 1) *id++ = create(kSideEnds[static_cast<unsigned>(std::countr_zero(sides))]);
}

class ExposedEdges {
 public:
  explicit ExposedEdges(const World::Impl& world) : world_(world), grid_(world.grid) {}

  /// What hides the sides of a cell.
  struct Facing {
    unsigned free = 0;      ///< bit s: side s is not hidden as a whole by one edge
    bool isSimple = false;  ///< the others of these sides are free as a whole
  };

  Facing facing(CellAt at) const {
    const FactsAround facts = factsAround(at);
    const unsigned all = at.chunk->facts[at.local] | facts.south | facts.east | facts.north | facts.west;
    return {kWholeSides & ~hiddenSides(facts.south, facts.east, facts.north, facts.west),
            !world_.preserve && (all & kRimPoints) == 0};
  }

  /// The exposed edges of one part of a cell with this content, in order: emit(ends, slot, touching).
  template <class Emit>
  void forEach(CellAt at, const Content& content, Facing facing, unsigned part, Emit&& emit) const {
    if (part == kInterior) {
      for (const InteriorSegment& s : content.interior) emit(s.ends, s.slot, std::uint8_t{0});
    } else if (content.cover[part - 1] != Cover::none) {
      forEachOnSide(at, content, facing, part - 1, emit);
    }
  }

  const InternedContent& contentOf(CellAt at) const {
    return world_.catalogue.content(at ? grid_.content(at) : kEmptyContent);
  }

 private:
  template <class Emit>
  void forEachOnSide(CellAt at, const Content& content, Facing facing, unsigned side, Emit&& emit) const {
    if (facing.isSimple) {
      if ((facing.free >> side & 1u) != 0) emit(kSideEnds[side], content.wholeSlot[side], bothCorners(side));
      return;
    }
    const CellAt beyond = across(at, side);
    exposedParts(
        content.sides[side], contentOf(beyond).sides[opposite(side)],
        [&](Slot a, Slot b) {
          return world_.preserve && world_.keeps(grid_.placed(at, a).block, grid_.placed(beyond, b).block);
        },
        [&](std::int32_t begin, std::int32_t end, Slot slot) {
          const LocalPoint low = pointAt(side, begin), high = pointAt(side, end);
          emit(runsForward(side) ? PackedEnds::of(low, high) : PackedEnds::of(high, low), slot,
               touching(side, begin, end));
        });
  }

  const World::Impl& world_;
  const Grid& grid_;
};

}  // namespace lgs::detail
