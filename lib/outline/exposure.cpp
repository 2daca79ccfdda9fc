#include "outline/exposure.h"

#include "outline/wide_row.h"

#include <algorithm>

namespace lgs::detail {

// --- Which cells

void Exposure::renewChunk(const Chunk& chunk) {
  if (const CellAt only = onlyDirtyCell(chunk)) {
    renewAround(only);
    return;
  }
  forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
    const bool ownRow = y >= 0 && y < kChunkSize;
    const WideRow here = dirtyRow(chunk, y), below = dirtyRow(chunk, y - 1), above = dirtyRow(chunk, y + 1);
    WideRow near = here | below | above | here << 1 | here >> 1;
    // A cell that is dirty in another chunk is renewed with that one.
    near &= ~wideDirtyRow(chunk, y) | (ownRow ? kOwnColumns : 0);
    if (isCrowded(near) && ownRow && !ground_.preserve)
      near &= showingRow(chunk, y) | wideLiveRow(outline_.lists, chunk, y) | ~kOwnColumns;
    forEachColumn(near, [&](std::int32_t x) {
      const CellAt at = cellAt(chunk, x, y);
      if (!at) return;
      const auto bit = [x](WideRow row) { return (row >> (x + 1) & 1u) != 0; };
      if (bit(here)) {
        renew(at);
        return;
      }
      if (at.chunk->facts[at.local] == 0) return;  // it holds no polygon
      const FactsAround facts = factsAround(at);
      if (bit(below)) renewSide(at, kSouth, facts.south);
      if (bit(here >> 1)) renewSide(at, kEast, facts.east);
      if (bit(above)) renewSide(at, kNorth, facts.north);
      if (bit(here << 1)) renewSide(at, kWest, facts.west);
    });
  });
}

/// The only changed cell of its chunk, and the cells beside it. Those that changed in another chunk are renewed with
/// that.
inline void Exposure::renewAround(CellAt at) {
  renew(at);
  for (unsigned side = 0; side < kSides; ++side) {
    const CellAt beyond = across(at, side);
    if (!beyond || (beyond.chunk->dirty[beyond.row()] & beyond.bit()) != 0) continue;
    const unsigned facts = beyond.chunk->facts[beyond.local];
    if ((facts & (1u << opposite(side) | kRimPoints)) == 0) continue;  // it has no edge along the side
    renewSide(beyond, opposite(side), at.chunk->facts[at.local]);
  }
}

// --- One cell

/// A cell whose polygons changed. What it shows now is compared with what is there, if anything is.
inline void Exposure::renew(CellAt at) {
  if (outline_.lists.isLive(at))
    merge(at, kAllParts);
  else if (at.chunk->facts[at.local] != 0)  // it holds polygons
    create(at);
}

/// A cell that has no segments yet: a merge with nothing, which is quick for simple cells.
void Exposure::create(CellAt at) {
  const Look look(ground_, at);
  if (!look.isSimple()) {
    merge(at, kAllParts);
    return;
  }
  const std::uint32_t count = look.count(), ref = at.ref();
  if (count == 0) return;
  look.fill(outline_.splice(at, 0, 0, count), count,
            [&](const PackedEnds& ends, Placed placed) { return outline_.create(ref, ends, placed); });
}

/// One side of a cell whose polygons stay, given the facts of the cell beyond. As a rule there is a segment along the
/// whole side or none, before and now.
void Exposure::renewSide(CellAt at, unsigned side, unsigned beyond) {
  const unsigned facts = at.chunk->facts[at.local];
  const CellSegments shown = outline_.lists.of(at);
  const Layout layout = shown.layout();
  if (ground_.preserve || ((facts | beyond) & kRimPoints) != 0 || !layout.hasWholeSides()) {
    merge(at, 1u << partOf(side));
    return;
  }
  const unsigned sides = layout.wholeSides();
  const unsigned before = sides >> side & 1u, now = facts >> side & ~(beyond >> opposite(side)) & 1u;
  if (now == before) return;
  const Content& content = ground_.content(at);
  const std::uint32_t inside = layout.end(kInterior), place = inside + kSideCounts[sides][side];
  std::uint32_t id = 0;
  if (now != 0)
    id = outline_.create(at.ref(), kSideEnds[side], ground_.held(at)[content.wholeSlot(side)]);
  else
    outline_.remove(shown.ids()[place]);
  std::uint32_t* words = outline_.splice(at, place, before, now);
  if (!words) return;
  if (now != 0) words[Layout::kWords + place] = id;
  layoutOfSides(sides ^ 1u << side, inside, content.cornerEnds).write(words);
}

/// Some parts of a cell, whatever they show and showed. Walks along the segments that are there, part by part, and along
/// the edges that show now. Both are in the same order. Equal edges of the same polygon keep their id.
void Exposure::merge(CellAt at, unsigned parts) {
  const Look look(ground_, at);
  const Held held = ground_.held(at);
  const CellSegments shown = outline_.lists.of(at);
  PartEnds ends{};
  Touching touches = 0;
  bool hasChanged = false;
  std::span<const std::uint32_t> old;  // of the part: the segments that are not passed yet
  const auto dropFirst = [&] {
    outline_.remove(old.front());
    old = old.subspan(1);
    hasChanged = true;
  };
  const auto show = [&](const PackedEnds& edge, Placed placed) {
    const auto here = std::pair(edge.start(), edge.end());
    for (; !old.empty(); dropFirst()) {
      const std::uint32_t id = old.front();
      const SegmentRecord& first = outline_.segments[id];
      const auto order = std::pair(first.start(), first.end()) <=> here;
      if (order > 0) break;
      if (order != 0 || first.serial != placed.serial || first.block != placed.block) continue;
      old = old.subspan(1);
      return id;
    }
    hasChanged = true;
    return outline_.create(at.ref(), edge, placed);
  };
  ids_.clear();
  for (unsigned part = 0; part < kParts; ++part) {
    old = shown ? shown.part(part) : std::span<const std::uint32_t>();  // quicker than five empty parts
    if ((parts >> part & 1u) == 0) {
      ids_.insert(ids_.end(), old.begin(), old.end());
      if (part != kInterior) touches |= shown.layout().touching() & bothEnds(1u << (part - 1));
    } else {
      look.forEach(part, [&](const PackedEnds& edge, Slot slot, Touching touching) {
        ids_.push_back(show(edge, held[slot]));
        touches |= touching;
      });
      for (const std::uint32_t id : old) outline_.remove(id);
      hasChanged |= !old.empty();
    }
    ends[part] = static_cast<std::uint16_t>(ids_.size());
  }
  if (!hasChanged) return;
  std::uint32_t* words = outline_.splice(at, 0, shown.count(), static_cast<std::uint32_t>(ids_.size()));
  if (!words) return;
  std::copy(ids_.begin(), ids_.end(), words + Layout::kWords);
  Layout(ends, touches, look.content().cornerEnds).write(words);
}

}  // namespace lgs::detail
