#include "outline/linking.h"

#include "geometry/radial_match.h"
#include "outline/fan.h"
#include "outline/side_walk.h"
#include "outline/turn.h"
#include "outline/wide_row.h"

#include <algorithm>

namespace lgs::detail {

Linking::Linking(const Ground& ground, Outline& outline, std::vector<Spoke>& fan)
    : ground_(ground), outline_(outline), fan_(fan) {
  constexpr std::size_t kAlongSides = 8;  // two in each of four directions
  fan_.resize(4 * std::size_t{ground.catalogue.widestFan()} + kAlongSides + 1);
}

// --- Which vertices

void Linking::linkChunk(const Chunk& chunk) {
  if (const CellAt only = onlyDirtyCell(chunk)) {
    linkAround(only);
    return;
  }
  const bool nearRimPoints = std::any_of(chunk.around.begin(), chunk.around.end(),
                                         [](const Chunk* c) { return c && (c->everFacts & kRimPoints) != 0; });
  forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
    if (y < 0) return;  // the corners above row -1 are those below row 0
    const WideRow here = dirtyRow(chunk, y);
    if (y < kChunkSize) {
      if ((chunk.everFacts & kLinkedInside) != 0)
        forEachColumn(here, [&](std::int32_t x) { linkInterior(cellAt(chunk, x, y)); });
      if (nearRimPoints)
        forEachColumn(here, [&](std::int32_t x) {
          const auto isDone = [x](WideRow row) { return (row >> (x + 1) & 1u) != 0; };  // the cell there was before
          linkSides(cellAt(chunk, x, y), isDone(dirtyRow(chunk, y - 1)), isDone(here << 1));
        });
    }
    // The corners below row y: corner x lies between columns x - 1 and x.
    const WideRow dirty = here | dirtyRow(chunk, y - 1);
    WideRow corners = dirty | dirty << 1;
    if (isCrowded(corners)) {
      const WideRow live = wideLiveRow(outline_.lists, chunk, y) | wideLiveRow(outline_.lists, chunk, y - 1);
      corners &= live | live << 1;
      if (y == kChunkSize) {  // corners at a dirty cell of the chunk above are linked with that chunk
        const WideRow above = wideDirtyRow(chunk, y) & kOwnColumns;
        corners &= ~(above | above << 1);
      }
    }
    forEachColumn(corners, [&](std::int32_t x) { linkCorner(chunk, x, y); });
  });
}

/// In and around the only changed cell of its chunk.
void Linking::linkAround(CellAt at) {
  linkInterior(at);
  linkSides(at, false, false);
  const auto x = static_cast<std::int32_t>(at.local % kChunkSize), y = static_cast<std::int32_t>(at.local / kChunkSize);
  linkCorner(*at.chunk, x, y);
  linkCorner(*at.chunk, x + 1, y);
  linkCorner(*at.chunk, x, y + 1);
  linkCorner(*at.chunk, x + 1, y + 1);
}

// --- Inside a cell: the content knows the links. Its interior edges always show, and are the first in the cell's list.

void Linking::linkInterior(CellAt at) {
  if ((at.chunk->facts[at.local] & kLinkedInside) == 0) return;
  const Content& content = ground_.content(at);
  const std::uint32_t* ids = outline_.lists.of(at).ids();
  const auto idOf = [&](std::uint32_t k) { return k == InteriorEdge::kNone ? kNoSegment : ids[k]; };
  for (std::size_t k = 0; k < content.interior.size(); ++k) {
    const InteriorEdge& e = content.interior[k];
    if (e.predecessor != InteriorEdge::kRim) setPredecessor(ids[k], idOf(e.predecessor));
    if (e.successor != InteriorEdge::kRim) setSuccessor(ids[k], idOf(e.successor));
  }
}

// --- At a corner of the grid

/// Links at the vertex where columns x - 1, x and rows y - 1, y meet.
void Linking::linkCorner(const Chunk& chunk, std::int32_t x, std::int32_t y) {
  const Quadrants shown = outline_.lists.aroundCorner(chunk, x, y);
  if (ground_.preserve || !CellSegments::areFew(shown)) {
    linkCornerBySpokes(
        {cellAt(chunk, x, y), cellAt(chunk, x - 1, y), cellAt(chunk, x - 1, y - 1), cellAt(chunk, x, y - 1)}, shown);
    return;
  }
  Turn turn;
  if (shown[0]) turn.pass<0>(shown[0]);
  if (shown[1]) turn.pass<1>(shown[1]);
  if (shown[2]) turn.pass<2>(shown[2]);
  if (shown[3]) turn.pass<3>(shown[3]);
  turn.close([&](std::uint32_t incoming, std::uint32_t outgoing) { link(incoming, outgoing); });
}

/// The same by all half-edges around the vertex, counter-clockwise: if something is preserved, or a cell shows many
/// segments. Quadrant q is the cell whose corner q lies here. In it come the side that leaves that corner, the edges
/// inside, and the side that arrives.
void Linking::linkCornerBySpokes(const std::array<CellAt, 4>& cells, const Quadrants& shown) {
  Fan fan(fan_);
  for (unsigned q = 0; q < 4; ++q) {
    if (!shown[q]) continue;
    const Layout layout = shown[q].layout();
    const Content& content = ground_.content(cells[q]);
    const unsigned leaving = q, arriving = sideBefore(q);
    const std::span leave = shown[q].part(partOf(leaving)), arrive = shown[q].part(partOf(arriving));
    if ((layout.touching() >> leaving & 1u) != 0)
      fan.add(runsForward(leaving) ? leave.front() : leave.back(), q * kStretch, 1, 1);
    fan.addInterior(content, content.corners[q], shown[q].ids(), q);
    if ((layout.touching() >> (4 + arriving) & 1u) != 0)
      fan.add(runsForward(arriving) ? arrive.back() : arrive.front(), (q + 1) % 4 * kStretch, 0, 1);
  }
  match(fan.spokes());
}

// --- In the open sides of a cell

void Linking::linkSides(CellAt at, bool isSouthDone, bool isWestDone) {
  const unsigned here = at.chunk->facts[at.local];
  const FactsAround around = factsAround(at);
  if (!isSouthDone && ((here | around.south) & kRimPoints) != 0) linkSide(at, kSouth);
  if (((here | around.east) & kRimPoints) != 0) linkSide(at, kEast);
  if (((here | around.north) & kRimPoints) != 0) linkSide(at, kNorth);
  if (!isWestDone && ((here | around.west) & kRimPoints) != 0) linkSide(at, kWest);
}

void Linking::linkSide(CellAt at, unsigned side) {
  SideWalk mine(ground_, outline_, at, side), theirs(ground_, outline_, across(at, side), opposite(side));
  const bool forward = runsForward(side);
  while (!mine.done() || !theirs.done()) {
    const std::int32_t vertex = std::min(mine.next(), theirs.next());
    // Counter-clockwise: the edges of both cells in one direction of the side, those inside my cell, the edges of both
    // in the other direction, those inside theirs.
    Fan fan(fan_);
    mine.addSideSpokes(fan, vertex, forward, 0);
    theirs.addSideSpokes(fan, vertex, forward, 0);
    mine.addInteriorSpokes(fan, vertex, 0);
    mine.addSideSpokes(fan, vertex, !forward, 1);
    theirs.addSideSpokes(fan, vertex, !forward, 1);
    theirs.addInteriorSpokes(fan, vertex, 1);
    match(fan.spokes());
    mine.pass(vertex);
    theirs.pass(vertex);
  }
}

void Linking::change(std::uint32_t id, std::uint32_t before, std::uint32_t now, bool isGhostStart) {
  outline_.note(id);
  const SegmentRecord &a = outline_.segments[before], &b = outline_.segments[now];
  const auto ghost = [&](const SegmentRecord& s) { return isGhostStart ? s.start() : s.end(); };
  const auto place = [&](const SegmentRecord& s) { return toWorld(ground_.grid.cellOf(s.cellRef), ghost(s)); };
  const bool same = a.cellRef == b.cellRef ? ghost(a) == ghost(b) : place(a) == place(b);
  if (before == kNoSegment || now == kNoSegment || !same) outline_.listRelinked(id);
}

void Linking::match(std::span<const Spoke> fan) {
  if (!ground_.preserve) {
    radialMatchAlternating(fan, [&](std::uint32_t incoming, std::uint32_t outgoing) { link(incoming, outgoing); });
    return;
  }
  radialMatch(
      fan, kNoSegment, [&](std::uint32_t s, std::uint32_t other) { setPredecessor(s, other); },
      [&](std::uint32_t s, std::uint32_t other) { setSuccessor(s, other); });
}

}  // namespace lgs::detail
