#include "exposure.h"

#include <algorithm>

namespace lgs::detail {

/// The next segment of the world.
inline std::uint32_t Exposure::create(std::uint32_t cellRef, const PackedEnds& ends, Placed placed) {
  const std::uint32_t id = pool_.take();
  pool_[id] = newSegment(cellRef, ends, placed);
  world_.changes.added.push_back({id});
  return id;
}

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
  const Facts facts = at.chunk->facts[at.local];
  if (facts == 0) {
    if (grid_.hasSegments(at)) removeAll(at);
    return;
  }
  const Facing sides = exposed_.facing(at);
  const InternedContent& content = exposed_.contentOf(at);
  if (sides.isSimple && !grid_.hasSegments(at) && content.polygons.size() == 1)
    createAll(at, content, facts & sides.free);
  else
    update(at, content, sides, kAllParts);
}

/// The segments on one side of a cell whose polygons stay, against a cell with these facts. As a rule one runs along all
/// of it, or none.
void Exposure::renewSide(CellAt at, unsigned side, unsigned facing) {
  const unsigned facts = at.chunk->facts[at.local];
  if (facts == 0) return;
  const unsigned part = partOf(side), both = bothCorners(side);
  const CellRecord* r = grid_.record(at);
  const std::uint32_t begin = r ? r->begin(part) : 0, before = r ? r->end[part] - begin : 0;
  if (world_.preserve || ((facts | facing) & kRimPoints) != 0 || before > 1 ||
      (before == 1 && (r->touching & both) != both)) {
    update(at, exposed_.contentOf(at), exposed_.facing(at), 1u << part);
    return;
  }
  const std::uint32_t now = facts >> side & ~(facing >> opposite(side)) & 1u;
  if (now == before) return;
  std::uint32_t id = 0;
  if (now != 0)
    id = create(at.chunk->ref(at.local), kSideEnds[side], grid_.placed(at, exposed_.contentOf(at).wholeSlot[side]));
  else
    world_.changes.removed.push_back({r->ids()[begin]});
  CellRecord* changed = grid_.spliceSegments(at, begin, before, now);
  if (!changed) return;
  if (now != 0) changed->ids()[begin] = id;
  changed->touching = static_cast<std::uint8_t>(changed->touching ^ both);
  for (unsigned p = part; p < kParts; ++p) changed->end[p] = static_cast<std::uint16_t>(changed->end[p] + now - before);
}

/// All segments of a cell with one polygon that has none yet: those inside, and one along each of `sides`.
void Exposure::createAll(CellAt at, const InternedContent& content, unsigned sides) {
  const std::uint32_t count = countSimple(content, sides);
  if (count == 0) return;
  const Placed placed = grid_.placed(at, 0);
  const std::uint32_t ref = at.chunk->ref(at.local);
  CellRecord* r = grid_.spliceSegments(at, 0, 0, count);
  fillSimple(*r, content, sides, [&](const PackedEnds& ends) { return create(ref, ends, placed); });
}

/// Merges the exposed edges of one part, which come in order, with the segments that are there.
class Exposure::PartUpdate {
 public:
  PartUpdate(Exposure& exposure, CellAt at, std::span<const std::uint32_t> old)
      : exposure_(exposure), at_(at), old_(old) {}

  void operator()(const PackedEnds& ends, Slot slot) {
    auto& ids = exposure_.ids_;
    const Placed placed = exposure_.grid_.placed(at_, slot);
    const auto edge = std::pair(ends.start(), ends.end());
    for (; !old_.empty(); dropFirst()) {
      const SegmentRecord& first = exposure_.pool_[old_.front()];
      const auto order = std::pair(first.start(), first.end()) <=> edge;
      if (order > 0) break;
      if (order == 0 && first.serial == placed.serial) {
        ids.push_back(old_.front());
        old_ = old_.subspan(1);
        return;
      }
    }
    ids.push_back(exposure_.create(at_.chunk->ref(at_.local), ends, placed));
    changed_ = true;
  }

  /// After the last edge: drops what is left. Whether anything changed.
  bool finish() {
    while (!old_.empty()) dropFirst();
    return changed_;
  }

 private:
  void dropFirst() {
    exposure_.world_.changes.removed.push_back({old_.front()});
    old_ = old_.subspan(1);
    changed_ = true;
  }

  Exposure& exposure_;
  CellAt at_;
  std::span<const std::uint32_t> old_;
  bool changed_ = false;
};

void Exposure::removeAll(CellAt at) {
  for (const std::uint32_t id : grid_.segments(at)) world_.changes.removed.push_back({id});
  const CellRecord* r = grid_.record(at);
  if (CellRecord* changed = grid_.spliceSegments(at, 0, r->count(), 0)) {
    changed->end = {};
    changed->touching = 0;
  }
}

/// The general case: what is there merged with what shows.
void Exposure::update(CellAt at, const InternedContent& content, Facing facing, unsigned parts) {
  const CellRecord* old = grid_.record(at);
  ids_.clear();
  PartEnds ends{};
  unsigned touches = 0;
  bool changed = false;
  for (unsigned part = 0; part < kParts; ++part) {
    const std::span<const std::uint32_t> before = old ? old->ids(part) : std::span<const std::uint32_t>{};
    if ((parts >> part & 1u) == 0) {
      ids_.insert(ids_.end(), before.begin(), before.end());
      if (old && part != kInterior) touches |= old->touching & bothCorners(part - 1);
    } else {
      PartUpdate merge(*this, at, before);
      exposed_.forEach(at, content, facing, part, [&](const PackedEnds& e, Slot slot, std::uint8_t touch) {
        merge(e, slot);
        touches |= touch;
      });
      changed |= merge.finish();
    }
    ends[part] = static_cast<std::uint16_t>(ids_.size());
  }
  if (!changed) return;
  CellRecord* r = grid_.spliceSegments(at, 0, old ? old->count() : 0, static_cast<std::uint32_t>(ids_.size()));
  if (!r) return;
  std::copy(ids_.begin(), ids_.end(), r->ids());
  r->end = ends;
  r->touching = static_cast<std::uint8_t>(touches);
}

}  // namespace lgs::detail
