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
    // What is dirty in another chunk is renewed with that one.
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
      const FactsAround facts = factsAround(at);
      if (bit(below)) renewSide(at, kSouth, facts.south);
      if (bit(here >> 1)) renewSide(at, kEast, facts.east);
      if (bit(above)) renewSide(at, kNorth, facts.north);
      if (bit(here << 1)) renewSide(at, kWest, facts.west);
    });
  });
}

/// The only dirty cell of its chunk, and those beside it that are not renewed with another chunk.
void Exposure::renewCell(CellAt at) {
  renewAll(at);
  for (unsigned side = 0; side < kSides; ++side) {
    const CellAt beyond = across(at, side);
    if (beyond && (beyond.chunk->dirty[beyond.row()] & beyond.bit()) == 0)
      renewSide(beyond, opposite(side), at.chunk->facts[at.local]);
  }
}

void Exposure::renewAll(CellAt at) {
  const bool isLive = grid_.hasSegments(at);
  if (at.chunk->facts[at.local] == 0) {
    if (isLive) removeAll(at);
    return;
  }
  const Look look(world_, at);
  if (isLive || !look.isSimple()) {
    update(at, kAllParts);
  } else if (const std::uint32_t count = look.count(); count != 0) {
    const std::uint32_t ref = at.chunk->ref(at.local);
    look.fill(*grid_.spliceSegments(at, 0, 0, count),
              [&](const PackedEnds& ends, Placed placed) { return create(ref, ends, placed); });
  }
}

/// The segments on one side of a cell whose polygons stay, against a cell with these facts. As a rule one runs along all
/// of it, or none.
void Exposure::renewSide(CellAt at, unsigned side, unsigned beyond) {
  const unsigned facts = at.chunk->facts[at.local];
  if (facts == 0) return;
  const unsigned part = partOf(side), both = bothCorners(side);
  const CellRecord* r = grid_.record(at);
  const std::uint32_t begin = r ? r->begin(part) : 0, before = r ? r->end[part] - begin : 0;
  if (world_.preserve || ((facts | beyond) & kRimPoints) != 0 || before > 1 ||
      (before == 1 && (r->touching & both) != both)) {
    update(at, 1u << part);
    return;
  }
  const std::uint32_t now = facts >> side & ~(beyond >> opposite(side)) & 1u;
  if (now == before) return;
  std::uint32_t id = 0;
  if (now != 0)
    id = create(at.chunk->ref(at.local), kSideEnds[side], grid_.placed(at)[world_.contentOf(at).wholeSlot(side)]);
  else
    world_.changes.removed.push_back({r->ids()[begin]});
  CellRecord* changed = grid_.spliceSegments(at, begin, before, now);
  if (!changed) return;
  if (now != 0) changed->ids()[begin] = id;
  changed->touching = static_cast<std::uint8_t>(changed->touching ^ both);
  for (unsigned p = part; p < kParts; ++p) changed->end[p] = static_cast<std::uint16_t>(changed->end[p] + now - before);
}

/// What update() would do with a cell that is empty now, in a fifth of the instructions.
void Exposure::removeAll(CellAt at) {
  for (const std::uint32_t id : grid_.segments(at)) world_.changes.removed.push_back({id});
  const CellRecord* r = grid_.record(at);
  if (CellRecord* changed = grid_.spliceSegments(at, 0, r->count(), 0)) {
    changed->end = {};
    changed->touching = 0;
  }
}

}  // namespace lgs::detail
