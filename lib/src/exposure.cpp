#include "exposure.h"

#include "boundary.h"

#include <algorithm>

namespace lgs::detail {
namespace {

/// CellRecord::touching for a segment along a whole side.
constexpr std::uint8_t bothCorners(unsigned side) { return static_cast<std::uint8_t>(0x11u << side); }

std::uint8_t touching(unsigned side, std::int32_t begin, std::int32_t end) {
  const bool low = begin == 0, high = end == kUnitsPerCell;
  const bool starts = runsForward(side) ? low : high, ends = runsForward(side) ? high : low;
  return static_cast<std::uint8_t>((starts ? 0x01u : 0u) << side | (ends ? 0x10u : 0u) << side);
}

}  // namespace

void Exposure::renewChunk(const Chunk& chunk) {
  forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
    const bool ownRow = y >= 0 && y < kChunkSize;
    const WideRow here = dirtyRow(chunk, y), below = dirtyRow(chunk, y - 1), above = dirtyRow(chunk, y + 1);
    WideRow near = here | below | above | here << 1 | here >> 1;
    if (isCrowded(near)) {
      // What is dirty in another chunk is renewed with that one.
      near &= ~wideRow<&Chunk::dirty>(chunk, y) | (ownRow ? kOwnColumns : 0);
      if (ownRow && !world_.preserve) near &= ~buried(chunk, y);
    }
    forEachColumn(near, [&](std::int32_t x) {
      const CellAt at = cellAt(chunk, x, y);
      if (!at) return;
      const InternedContent& content = contentOf(at);
      const auto bit = [x](WideRow row) { return static_cast<unsigned>(row >> (x + 1) & 1u); };
      const unsigned parts = bit(here) ? kAllParts
                                       : bit(below) << kSouthPart | bit(here >> 1) << kEastPart |
                                             bit(above) << kNorthPart | bit(here << 1) << kWestPart;
      if (parts == kAllParts && !grid_.hasSegments(at))
        createAll(at, content);
      else
        update(at, content, parts);
    });
  });
}

/// Cells without segments that cover themselves and are enclosed by such: nothing can be exposed.
WideRow Exposure::buried(const Chunk& chunk, std::int32_t y) const {
  const WideRow covered = wideRow<&Chunk::covered>(chunk, y);
  const WideRow enclosed = covered & covered << 1 & covered >> 1 & wideRow<&Chunk::covered>(chunk, y - 1) &
                           wideRow<&Chunk::covered>(chunk, y + 1);
  return enclosed & ~wideRow<&Chunk::live>(chunk, y) & kOwnColumns;
}

/// The exposed edges on one side, in order: emit(ends, slot, touching, exposed). In the usual case, an edge from corner
/// to corner against a side that is whole or free, it is called once with `exposed` true or false, so that there is no
/// branch to be mispredicted.
template <class Emit>
void Exposure::exposeSide(CellAt at, const Content& content, unsigned side, Emit&& emit) {
  const CellAt beyond = across(at, side);
  const Content& facing = contentOf(beyond);
  const Cover theirs = facing.cover[opposite(side)];
  if (content.cover[side] == Cover::whole && theirs != Cover::mixed && !world_.preserve) {
    emit(kWholeSides[side], content.wholeSlot[side], bothCorners(side), theirs == Cover::none);
    return;
  }
  exposedParts(
      content.sides[side], facing.sides[opposite(side)],
      [&](Slot a, Slot b) {
        return world_.preserve && world_.keeps(grid_.placed(at, a).block, grid_.placed(beyond, b).block);
      },
      [&](std::int32_t begin, std::int32_t end, Slot slot) {
        const LocalPoint low = pointAt(side, begin), high = pointAt(side, end);
        emit(runsForward(side) ? PackedEnds::of(low, high) : PackedEnds::of(high, low), slot,
             touching(side, begin, end), true);
      });
}

/// All segments of a cell that has none yet.
void Exposure::createAll(CellAt at, const InternedContent& content) {
  if (content.polygons.empty()) return;
  const std::uint32_t ref = at.chunk->ref(at.local);
  const bool single = content.polygons.size() == 1;
  const Placed first = grid_.placed(at, 0);
  const auto placed = [&](Slot slot) { return single ? first : grid_.placed(at, slot); };

  const std::size_t begin = scratch_.addedCount;
  std::array<std::uint16_t, kParts> counts{};
  for (const InteriorSegment& s : content.interior) create(ref, s.ends, placed(s.slot), true);
  counts[kInterior] = static_cast<std::uint16_t>(scratch_.addedCount - begin);
  unsigned touches = 0;
  for (unsigned k = 0; k < content.usedSideCount; ++k) {
    const unsigned side = content.usedSides[k];
    const std::size_t before = scratch_.addedCount;
    exposeSide(at, content, side, [&](const PackedEnds& ends, Slot slot, std::uint8_t touch, bool exposed) {
      create(ref, ends, placed(slot), exposed);
      touches |= exposed ? touch : 0u;
    });
    counts[partOf(side)] = static_cast<std::uint16_t>(scratch_.addedCount - before);
  }
  for (unsigned part = 1; part < kParts; ++part)
    counts[part] = static_cast<std::uint16_t>(counts[part] + counts[part - 1]);
  grid_.setSegments(at, scratch_.added.data() + begin, counts, static_cast<std::uint8_t>(touches));
}

/// Merges the exposed edges of one part, which come in order, with the segments that are there.
class Exposure::PartUpdate {
 public:
  PartUpdate(Exposure& exposure, CellAt at, std::span<const std::uint32_t> old)
      : exposure_(exposure), at_(at), old_(old) {}

  void operator()(const PackedEnds& ends, Slot slot) {
    auto& ids = exposure_.scratch_.ids;
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
    ids.push_back(exposure_.create(at_.chunk->ref(at_.local), ends, placed, true));
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

/// These parts of a cell that may have segments; the others stay as they are.
void Exposure::update(CellAt at, const InternedContent& content, unsigned parts) {
  const CellRecord* old = grid_.record(at);
  if (content.polygons.empty() && !old) return;
  auto& ids = scratch_.ids;
  ids.clear();
  std::array<std::uint16_t, kParts> ends{};
  unsigned touches = 0;
  bool changed = false;
  for (unsigned part = 0; part < kParts; ++part) {
    const std::span<const std::uint32_t> before = old ? old->ids(part) : std::span<const std::uint32_t>{};
    if ((parts >> part & 1u) == 0) {
      ids.insert(ids.end(), before.begin(), before.end());
      if (old && part != kInterior) touches |= old->touching & bothCorners(part - 1);
    } else {
      PartUpdate merge(*this, at, before);
      if (part == kInterior) {
        for (const InteriorSegment& s : content.interior) merge(s.ends, s.slot);
      } else if (content.cover[part - 1] != Cover::none) {
        exposeSide(at, content, part - 1, [&](const PackedEnds& e, Slot slot, std::uint8_t touch, bool exposed) {
          if (!exposed) return;
          merge(e, slot);
          touches |= touch;
        });
      }
      changed |= merge.finish();
    }
    ends[part] = static_cast<std::uint16_t>(ids.size());
  }
  if (changed) grid_.setSegments(at, ids.data(), ends, static_cast<std::uint8_t>(touches));
}

/// Writes a new segment where the next one goes, and takes the place only if it is exposed.
std::uint32_t Exposure::create(std::uint32_t cellRef, const PackedEnds& ends, Placed placed, bool exposed) {
  const std::uint32_t id = pool_.next();
  SegmentRecord& s = pool_[id];
  s = SegmentRecord{};
  s.fresh = 1;
  s.cellRef = exposed ? cellRef : 0;
  s.block = placed.block;
  s.serial = placed.serial & kMaxSerial;
  s.high = ends.high & 0xfu;
  s.from = ends.from;
  s.to = ends.to;
  pool_.take(exposed);
  if (scratch_.addedCount == scratch_.added.size()) scratch_.added.resize(2 * scratch_.added.size() + 64);
  scratch_.added[scratch_.addedCount] = id;
  scratch_.addedCount += exposed;
  return id;
}

void Exposure::finish() {
  std::vector<SegmentId>& added = world_.changes.added;
  added.resize(scratch_.addedCount);
  for (std::size_t k = 0; k < scratch_.addedCount; ++k) added[k] = {scratch_.added[k]};
  scratch_.addedCount = 0;
}

}  // namespace lgs::detail
