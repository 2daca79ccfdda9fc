// What a cell shows by law 1, inside and on its four sides. Nothing here changes anything.
#pragma once

#include "ground/ground.h"
#include "outline/boundary.h"
#include "outline/layout.h"

#include <bit>
#include <cstdint>

namespace lgs::detail {

/// Two things decide it: the cell's content, and what lies across its sides.
class Look {
 public:
  Look(const Ground& ground, CellAt at) : ground_(ground), at_(at), content_(ground.content(at)) {
    const unsigned here = at.chunk->facts[at.local];
    const FactsAround around = factsAround(at);
    const unsigned all = here | around.south | around.east | around.north | around.west;
    hasWholeSides_ = !ground.preserve && (all & kRimPoints) == 0;
    sides_ = here & kWholeSides & ~hiddenSides(around.south, around.east, around.north, around.west);
  }

  /// Most cells have one polygon, and each of their sides shows as a whole or not at all.
  bool isSimple() const { return hasWholeSides_ && content_.polygons.size() == 1; }

  /// How many segments the cell shows.
  std::uint32_t count() const {
    auto count = static_cast<std::uint32_t>(content_.interior.size());
    if (hasWholeSides_) return count + kSideCounts[sides_][kSides];
    for (unsigned part = kSouthPart; part < kParts; ++part)
      forEach(part, [&count](const PackedEnds&, Slot, Touching) { ++count; });
    return count;
  }

  /// Fills a list that has room for `count` segments, as count() said. create(ends, placed) returns the id of the next
  /// one. If an inconsistent relation yields a different count, extra edges are dropped and missing slots repeat the
  /// last edge, so that no memory is touched that is not the list's.
  template <class Create>
  void fill(std::uint32_t* words, std::uint32_t count, Create&& create) const {
    if (isSimple())
      fillSimple(words, create);
    else
      fillParts(words, count, create);
  }

  /// Calls emit(ends, slot, touching) for the edges that one part of the cell shows, in order of start.
  template <class Emit>
  void forEach(unsigned part, Emit&& emit) const {
    if (part == kInterior) {
      for (const InteriorEdge& e : content_.interior) emit(e.ends, e.slot, Touching{0});
      return;
    }
    const unsigned side = part - 1;
    if (hasWholeSides_) {
      if ((sides_ >> side & 1u) != 0) emit(kSideEnds[side], content_.wholeSlot(side), bothEnds(1u << side));
    } else if (!content_.sides[side].covered.empty()) {
      forEachOnSide(side, emit);
    }
  }

  const Content& content() const { return content_; }

 private:
  template <class Emit>
  void forEachOnSide(unsigned side, Emit&& emit) const {
    const CellAt beyond = across(at_, side);
    exposedIntervals(
        content_.sides[side], ground_.content(beyond).sides[opposite(side)],
        [&](Slot a, Slot b) {
          return ground_.preserve && ground_.keeps(ground_.held(at_)[a].block, ground_.held(beyond)[b].block);
        },
        [&](std::int32_t begin, std::int32_t end, Slot slot) {
          const LocalPoint low = pointAt(side, begin), high = pointAt(side, end);
          emit(runsForward(side) ? PackedEnds::of(low, high) : PackedEnds::of(high, low), slot,
               touching(side, begin, end));
        });
  }

  template <class Create>
  void fillSimple(std::uint32_t* words, Create& create) const {
    const Placed sole = ground_.held(at_)[0];
    const std::size_t inside = content_.interior.size();
    layoutOfSides(sides_, inside, content_.cornerEnds).write(words);
    std::uint32_t* id = words + Layout::kWords;
    for (const InteriorEdge& e : content_.interior) *id++ = create(e.ends, sole);
    for (unsigned left = sides_; left != 0; left &= left - 1)
      *id++ = create(kSideEnds[static_cast<unsigned>(std::countr_zero(left))], sole);
  }

  template <class Create>
  void fillParts(std::uint32_t* words, std::uint32_t count, Create& create) const {
    const Held placed = ground_.held(at_);
    std::uint32_t* const ids = words + Layout::kWords;
    std::uint32_t* id = ids;
    PartEnds ends{};
    Touching touches = 0;
    PackedEnds last = kSideEnds[kSouth];
    for (unsigned part = 0; part < kParts; ++part) {
      forEach(part, [&](const PackedEnds& edge, Slot slot, Touching touching) {
        if (id == ids + count) return;
        *id++ = create(edge, placed[slot]);
        touches |= touching;
        last = edge;
      });
      ends[part] = static_cast<std::uint16_t>(id - ids);
    }
    while (id != ids + count) *id++ = create(last, placed[0]);
    ends[kWestPart] = static_cast<std::uint16_t>(count);
    Layout(ends, touches, content_.cornerEnds).write(words);
  }

  const Ground& ground_;
  CellAt at_;
  const Content& content_;
  bool hasWholeSides_ = false;  ///< each side shows as a whole or not at all
  unsigned sides_ = 0;          ///< then these show
};

}  // namespace lgs::detail
