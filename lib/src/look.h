// What a cell shows by law 1, inside and on its four sides. Nothing here changes the world.
#pragma once

#include "boundary.h"
#include "world_impl.h"

#include <array>
#include <bit>

namespace lgs::detail {

/// CellRecord::touching of a segment along a whole side.
constexpr std::uint8_t bothCorners(unsigned side) { return static_cast<std::uint8_t>(0x11u << side); }

/// The same of a segment along a part of the side.
constexpr std::uint8_t touching(unsigned side, std::int32_t begin, std::int32_t end) {
  const bool low = begin == 0, high = end == kUnitsPerCell;
  const bool starts = runsForward(side) ? low : high, ends = runsForward(side) ? high : low;
  return static_cast<std::uint8_t>((starts ? 0x01u : 0u) << side | (ends ? 0x10u : 0u) << side);
}

/// What a simple cell shows: the edges inside, and one along each of these sides. All are of one polygon.
struct SimpleLook {
  const Content& content;
  unsigned sides = 0;

  std::uint32_t count() const {
    return static_cast<std::uint32_t>(content.interior.size()) + kSideCounts[sides][kSides];
  }

  /// Fills the cell's record, which has room for all. create(ends) returns the id of the next segment.
  template <class Create>
  void fill(CellRecord& r, Create&& create) const {
    r.setWholeSides(sides, static_cast<std::uint32_t>(content.interior.size()), content.cornerEnds);
    std::uint32_t* id = r.ids();
    for (const InteriorSegment& s : content.interior) *id++ = create(s.ends);
    for (unsigned left = sides; left != 0; left &= left - 1)
      *id++ = create(kSideEnds[static_cast<unsigned>(std::countr_zero(left))]);
  }
};

/// What any cell shows. Two things decide it: the cell's content, and what lies across its sides.
class Look {
 public:
  Look(const World::Impl& world, CellAt at) : world_(world), at_(at), content_(world.contentOf(at)) {
    const unsigned here = at.chunk->facts[at.local];
    const FactsAround around = factsAround(at);
    const unsigned all = here | around.south | around.east | around.north | around.west;
    hasWholeSides_ = !world.preserve && (all & kRimPoints) == 0;
    sides_ = here & kWholeSides & ~hiddenSides(around.south, around.east, around.north, around.west);
  }

  /// Most cells are simple: they have one polygon, and each of their sides shows as a whole or not at all.
  bool isSimple() const { return hasWholeSides_ && content_.polygons.size() == 1; }
  SimpleLook simple() const { return {content_, sides_}; }

  /// How many segments the cell shows.
  std::uint32_t count() const {
    if (isSimple()) return simple().count();
    auto count = static_cast<std::uint32_t>(content_.interior.size());
    for (unsigned part = kSouthPart; part < kParts; ++part)
      forEach(part, [&count](const PackedEnds&, Slot, std::uint8_t) { ++count; });
    return count;
  }

  /// Fills the cell's record, which has room for all. create(ends, placed) returns the id of the next segment.
  template <class Create>
  void fill(CellRecord& r, Create&& create) const {
    const PlacedBySlot placed = Grid::placed(at_, &r);
    if (!isSimple()) {
      fillParts(r, placed, create);
      return;
    }
    const Placed sole = placed[0];
    simple().fill(r, [&](const PackedEnds& ends) { return create(ends, sole); });
  }

  /// Calls emit(ends, slot, touching) for the edges that one part of the cell shows, in order of start.
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
  void fillParts(CellRecord& r, const PlacedBySlot& placed, Create& create) const {
    std::uint32_t* id = r.ids();
    PartEnds ends{};
    unsigned touches = 0;
    for (unsigned part = 0; part < kParts; ++part) {
      forEach(part, [&](const PackedEnds& edge, Slot slot, std::uint8_t touching) {
        *id++ = create(edge, placed[slot]);
        touches |= touching;
      });
      ends[part] = static_cast<std::uint16_t>(id - r.ids());
    }
    r.parts = partsOf(ends, touches, content_.cornerEnds);
    r.touching = static_cast<std::uint8_t>(touches);
  }

  const World::Impl& world_;
  CellAt at_;
  const InternedContent& content_;
  bool hasWholeSides_ = false;  ///< each side shows as a whole or not at all
  unsigned sides_ = 0;          ///< then these show
};

}  // namespace lgs::detail
