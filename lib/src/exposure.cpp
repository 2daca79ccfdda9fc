#include "exposure.h"

#include "wide_row.h"

#include <algorithm>

namespace lgs::detail {

void Exposure::renewChunk(const Chunk& chunk) {
  if (const CellAt only = onlyDirtyCell(chunk)) {
    renewCell(only);
    return;
  }
  forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
    const bool ownRow = y >= 0 && y < kChunkSize;
    const WideRow here = dirtyRow(chunk, y), below = dirtyRow(chunk, y - 1), above = dirtyRow(chunk, y + 1);
    WideRow near = here | below | above | here << 1 | here >> 1;
    // A cell that is dirty in another chunk is renewed with that one.
    near &= ~wideRow<&Chunk::dirty>(chunk, y) | (ownRow ? kOwnColumns : 0);
    if (isCrowded(near) && ownRow && !world_.preserve)
      near &= showingRow(chunk, y) | wideRow<&Chunk::live>(chunk, y) | ~kOwnColumns;
    forEachColumn(near, [&](std::int32_t x) {
      const CellAt at = cellAt(chunk, x, y);
      if (!at) return;
      const auto bit = [x](WideRow row) { return (row >> (x + 1) & 1u) != 0; };
      if (bit(here)) {
        renewAll(at);
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

/// Renews the only dirty cell of its chunk, and the cells beside it. Those dirty in another chunk are renewed with
/// that.
inline void Exposure::renewCell(CellAt at) {
  renewAll(at);
  for (unsigned side = 0; side < kSides; ++side) {
    const CellAt beyond = across(at, side);
    if (!beyond || (beyond.chunk->dirty[beyond.row()] & beyond.bit()) != 0) continue;
    const unsigned facts = beyond.chunk->facts[beyond.local];
    if ((facts & (1u << opposite(side) | kRimPoints)) == 0) continue;  // it has no edge along the side
    renewSide(beyond, opposite(side), at.chunk->facts[at.local]);
  }
}

/// Renews all segments of a cell. As a rule it had none or shows none now, and so there is nothing to merge.
void Exposure::renewAll(CellAt at) {
  const Facts facts = at.chunk->facts[at.local];
  const bool isLive = grid_.hasSegments(at);
  if (facts == 0) {  // it holds no polygon
    if (isLive) removeAll(at);
  } else if (isLive || (facts & kRimPoints) != 0 || !createSimple(at)) {  // with rim points no cell is simple
    update(at, kAllParts);
  }
}

/// Makes all segments of a cell that has none yet. False, and nothing is done, if the cell is not simple.
inline bool Exposure::createSimple(CellAt at) {
  const Look look(world_, at);
  if (!look.isSimple()) return false;
  const SimpleLook shown = look.simple();
  const std::uint32_t count = shown.count(), ref = at.chunk->ref(at.local);
  if (count == 0) return true;
  const Placed placed = grid_.placed(at)[0];
  shown.fill(*grid_.spliceSegments(at, 0, 0, count), [&](const PackedEnds& ends) { return create(ref, ends, placed); });
  return true;
}

/// Renews the segments on one side of a cell whose polygons stay, given the facts of the cell beyond. As a rule there
/// is a segment along the whole side or none, before and now.
void Exposure::renewSide(CellAt at, unsigned side, unsigned beyond) {
  const unsigned facts = at.chunk->facts[at.local];
  const CellRecord* r = grid_.record(at);
  if (world_.preserve || ((facts | beyond) & kRimPoints) != 0 || (r && !r->hasWholeSides())) {
    update(at, 1u << partOf(side));
    return;
  }
  const unsigned sides = r ? r->touching & kWholeSides : 0u, before = sides >> side & 1u;
  const unsigned now = facts >> side & ~(beyond >> opposite(side)) & 1u;
  if (now == before) return;
  const InternedContent& content = world_.contentOf(at);
  const std::uint32_t inside = r ? r->parts.end(kInterior) : 0u, place = inside + kSideCounts[sides][side];
  std::uint32_t id = 0;
  if (now != 0)
    id = create(at.chunk->ref(at.local), kSideEnds[side], grid_.placed(at)[content.wholeSlot(side)]);
  else
    world_.changes.removed.push_back({r->ids()[place]});
  CellRecord* changed = grid_.spliceSegments(at, place, before, now);
  if (!changed) return;
  if (now != 0) changed->ids()[place] = id;
  changed->setWholeSides(sides ^ 1u << side, inside, content.cornerEnds);
}

/// Removes all segments of a cell that is empty now. update() would do it too, but every second edit comes here, and
/// would take 6 % more instructions.
void Exposure::removeAll(CellAt at) {
  for (const std::uint32_t id : grid_.segments(at)) world_.changes.removed.push_back({id});
  const CellRecord* r = grid_.record(at);
  if (CellRecord* changed = grid_.spliceSegments(at, 0, r->count(), 0)) {
    changed->parts = {};
    changed->touching = 0;
  }
}

}  // namespace lgs::detail
