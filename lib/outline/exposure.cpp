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
    id = outline_.create(at.ref(), kSideEnds[side], ground_.placed(at)[content.wholeSlot(side)]);
  else
    outline_.remove(shown.ids()[place]);
  std::uint32_t* words = outline_.splice(at, place, before, now);
  if (!words) return;
  if (now != 0) words[Layout::kWords + place] = id;
  layoutOfSides(sides ^ 1u << side, inside, content.cornerEnds).write(words);
}

/// Walks along the segments that are there, part by part, and along the edges that show now. Both are in the same
/// order. Equal edges of the same polygon keep their id.
class Exposure::Merge {
 public:
  Merge(Outline& outline, std::uint32_t ref, std::vector<std::uint32_t>& ids)
      : outline_(outline), ref_(ref), ids_(ids) {}

  /// Takes up the next part.
  void begin(std::span<const std::uint32_t> old) { old_ = old; }

  /// The next edge that shows. Its segment is there already, or is made.
  void show(const PackedEnds& ends, Placed placed) {
    const auto edge = std::pair(ends.start(), ends.end());
    for (; !old_.empty(); dropFirst()) {
      const SegmentRecord& first = outline_.segments[old_.front()];
      const auto order = std::pair(first.start(), first.end()) <=> edge;
      if (order > 0) break;
      if (order == 0 && first.serial == placed.serial && first.block == placed.block) {
        ids_.push_back(old_.front());
        old_ = old_.subspan(1);
        return;
      }
    }
    ids_.push_back(outline_.create(ref_, ends, placed));
    changed_ = true;
  }

  /// After the last edge: drops what is left.
  void finish() {
    while (!old_.empty()) dropFirst();
  }

  bool changed() const { return changed_; }

 private:
  void dropFirst() {
    outline_.remove(old_.front());
    old_ = old_.subspan(1);
    changed_ = true;
  }

  Outline& outline_;
  std::uint32_t ref_;
  std::vector<std::uint32_t>& ids_;
  std::span<const std::uint32_t> old_;
  bool changed_ = false;
};

/// Some parts of a cell, whatever they show and showed.
void Exposure::merge(CellAt at, unsigned parts) {
  const Look look(ground_, at);
  const CellSegments shown = outline_.lists.of(at);
  Merge merge(outline_, at.ref(), ids_);
  PartEnds ends{};
  Touching touches = 0;
  ids_.clear();
  for (unsigned part = 0; part < kParts; ++part) {
    const auto before = shown ? shown.part(part) : std::span<const std::uint32_t>();  // quicker than five empty parts
    if ((parts >> part & 1u) == 0) {
      ids_.insert(ids_.end(), before.begin(), before.end());
      if (part != kInterior) touches |= shown.layout().touching() & bothEnds(1u << (part - 1));
    } else {
      merge.begin(before);
      look.forEach(part, [&](const PackedEnds& edge, Slot slot, Touching touching) {
        merge.show(edge, ground_.placed(at)[slot]);
        touches |= touching;
      });
      merge.finish();
    }
    ends[part] = static_cast<std::uint16_t>(ids_.size());
  }
  if (!merge.changed()) return;
  std::uint32_t* words = outline_.splice(at, 0, shown.count(), static_cast<std::uint32_t>(ids_.size()));
  if (!words) return;
  std::copy(ids_.begin(), ids_.end(), words + Layout::kWords);
  Layout(ends, touches, look.content().cornerEnds).write(words);
}

}  // namespace lgs::detail
