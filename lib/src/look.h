// What a cell shows: law 1 inside it and on its four sides. Reads only.
#pragma once

#include "boundary.h"
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

/// Fills the record of a cell that shows what is inside and one edge along each of `sides`, all of one polygon.
template <class Create>
void fillSimple(CellRecord& r, const Content& content, unsigned sides, Placed placed, Create& create) {
  const auto inside = static_cast<std::uint16_t>(content.interior.size());
  for (unsigned part = 0; part < kParts; ++part)
    r.end[part] = static_cast<std::uint16_t>(kSideCounts[sides][part] + inside);
  r.touching = static_cast<std::uint8_t>(sides | sides << 4);
  std::uint32_t* id = r.ids();
  for (const InteriorSegment& s : content.interior) *id++ = create(s.ends, placed);
  for (; sides != 0; sides &= sides - 1)
    *id++ = create(kSideEnds[static_cast<unsigned>(std::countr_zero(sides))], placed);
}

/// A cell with all that decides what it shows: its content, and what lies across its sides.
class Look {
 public:
  Look(const World::Impl& world, CellAt at) : world_(world), at_(at), content_(world.contentOf(at)) {
    const unsigned here = at.chunk->facts[at.local];
    const FactsAround around = factsAround(at);
    const unsigned all = here | around.south | around.east | around.north | around.west;
    hasWholeSides_ = !world.preserve && (all & kRimPoints) == 0;
    sides_ = here & kWholeSides & ~hiddenSides(around.south, around.east, around.north, around.west);
  }

  CellAt at() const { return at_; }

  /// One polygon of which each side shows as a whole or not at all. Most cells are like that.
  bool isSimple() const { return hasWholeSides_ && content_.polygons.size() == 1; }

  /// How many segments the cell shows.
  std::uint32_t count() const {
    if (isSimple()) return static_cast<std::uint32_t>(content_.interior.size()) + kSideCounts[sides_].back();
    std::uint32_t count = 0;
    for (unsigned part = 0; part < kParts; ++part) forEach(part, [&](auto&&...) { ++count; });
    return count;
  }

  /// Fills the cell's record, which has room for them all; create(ends, placed) returns the next segment's id.
  template <class Create>
  void fill(CellRecord& r, Create&& create) const {
    if (isSimple())
      fillSimple(r, content_, sides_, Grid::placed(at_, &r)[0], create);
    else
      fillMerged(r, create);
  }

  /// What one part of the cell shows, in order: emit(ends, slot, touching).
  template <class Emit>
  void forEach(unsigned part, Emit&& emit) const {
    if (part == kInterior) {
      for (const InteriorSegment& s : content_.interior) emit(s.ends, s.slot, std::uint8_t{0});
      return;
    }
    const unsigned side = part - 1;
    if (hasWholeSides_) {
      if ((sides_ >> side & 1u) != 0) emit(kSideEnds[side], content_.wholeSlot(side), bothCorners(side));
    } else if (!content_.sides[side].covered.empty()) {
      forEachOnSide(side, emit);
    }
  }

 private:
  template <class Emit>
  void forEachOnSide(unsigned side, Emit&& emit) const {
    const CellAt beyond = across(at_, side);
    exposedIntervals(
        content_.sides[side], world_.contentOf(beyond).sides[opposite(side)],
        [&](Slot a, Slot b) {
          return world_.preserve && world_.keeps(world_.grid.placed(at_)[a].block, world_.grid.placed(beyond)[b].block);
        },
        [&](std::int32_t begin, std::int32_t end, Slot slot) {
          const LocalPoint low = pointAt(side, begin), high = pointAt(side, end);
          emit(runsForward(side) ? PackedEnds::of(low, high) : PackedEnds::of(high, low), slot,
               touching(side, begin, end));
        });
  }

  template <class Create>
  void fillMerged(CellRecord& r, Create& create) const {
    const PlacedBySlot placed = Grid::placed(at_, &r);
    std::uint32_t* id = r.ids();
    r.touching = 0;
    for (unsigned part = 0; part < kParts; ++part) {
      forEach(part, [&](const PackedEnds& ends, Slot slot, std::uint8_t touching) {
        *id++ = create(ends, placed[slot]);
        r.touching |= touching;
      });
      r.end[part] = static_cast<std::uint16_t>(id - r.ids());
    }
  }

  const World::Impl& world_;
  CellAt at_;
  const InternedContent& content_;
  unsigned sides_ = 0;          ///< those that show as a whole, if
  bool hasWholeSides_ = false;  ///< each side shows as a whole or not at all
};

}  // namespace lgs::detail
