#include "linking.h"

#include "turn.h"
#include "wide_row.h"

#include <algorithm>

namespace lgs::detail {

Linking::Linking(World::Impl& world, std::vector<Spoke>& fan)
    : world_(world), grid_(world.grid), links_(world), rim_(world, links_, fan) {}

/// Links at the only dirty cell of its chunk.
void Linking::linkCell(CellAt at) {
  const Chunk& chunk = *at.chunk;
  if ((chunk.facts[at.local] & kLinkedInside) != 0) linkInterior(at);
  linkSides(at);
  const auto x = static_cast<std::int32_t>(at.local % kChunkSize), y = static_cast<std::int32_t>(at.local / kChunkSize);
  linkCorner(chunk, x, y);
  linkCorner(chunk, x + 1, y);
  linkCorner(chunk, x, y + 1);
  linkCorner(chunk, x + 1, y + 1);
}

void Linking::linkChunk(const Chunk& chunk) {
  if (const CellAt only = onlyDirtyCell(chunk)) {
    linkCell(only);
    return;
  }
  const bool nearRimPoints = std::any_of(chunk.around.begin(), chunk.around.end(),
                                         [](const Chunk* c) { return c && (c->everFacts & kRimPoints) != 0; });
  forEachRowNear(chunk.dirtyRows, [&](std::int32_t y) {
    if (y < 0) return;
    const WideRow here = dirtyRow(chunk, y);
    if (y < kChunkSize) {
      const WideRow live = wideRow<&Chunk::live>(chunk, y);
      if ((chunk.everFacts & kLinkedInside) != 0)
        forEachColumn(here & live, [&](std::int32_t x) { linkInterior(cellAt(chunk, x, y)); });
      if (nearRimPoints) forEachColumn(here, [&](std::int32_t x) { linkSides(cellAt(chunk, x, y)); });
    }
    // The corners below row y: corner x lies between columns x - 1 and x.
    const WideRow dirty = here | dirtyRow(chunk, y - 1);
    WideRow corners = dirty | dirty << 1;
    if (isCrowded(corners)) {
      const WideRow live = wideRow<&Chunk::live>(chunk, y) | wideRow<&Chunk::live>(chunk, y - 1);
      corners &= live | live << 1;
      if (y == kChunkSize) {  // corners at a dirty cell of the chunk above are linked with that chunk
        const WideRow above = wideRow<&Chunk::dirty>(chunk, y) & kOwnColumns;
        corners &= ~(above | above << 1);
      }
    }
    forEachColumn(corners, [&](std::int32_t x) { linkCorner(chunk, x, y); });
  });
}

void Linking::linkInterior(CellAt at) {
  const InternedContent& content = world_.contentOf(at);
  if ((content.facts & kLinkedInside) == 0) return;
  const std::span<const std::uint32_t> ids = grid_.record(at)->ids(kInterior);
  const auto idOf = [&](std::uint32_t k) { return k == InteriorSegment::kNone ? kNoSegment : ids[k]; };
  for (std::size_t k = 0; k < content.interior.size(); ++k) {
    const InteriorSegment& s = content.interior[k];
    if (s.predecessor != InteriorSegment::kRim) links_.setPredecessor(ids[k], idOf(s.predecessor));
    if (s.successor != InteriorSegment::kRim) links_.setSuccessor(ids[k], idOf(s.successor));
  }
}

/// Links at the vertex where columns x - 1, x and rows y - 1, y meet. To the cell of quadrant q it is corner q.
void Linking::linkCorner(const Chunk& chunk, std::int32_t x, std::int32_t y) {
  const CellRecord *r0 = nullptr, *r1 = nullptr, *r2 = nullptr, *r3 = nullptr;
  if (x > 0 && x < kChunkSize && y > 0 && y < kChunkSize) {
    const std::uint32_t* cell = &chunk.cells[localOf({x, y})];
    r0 = grid_.recordOf(cell[0]);
    r1 = grid_.recordOf(cell[-1]);
    r2 = grid_.recordOf(cell[-1 - kChunkSize]);
    r3 = grid_.recordOf(cell[-kChunkSize]);
  } else {
    const auto recordAt = [&](std::int32_t cx, std::int32_t cy) {
      const CellAt at = cellAt(chunk, cx, cy);
      return at ? grid_.record(at) : nullptr;
    };
    r0 = recordAt(x, y);
    r1 = recordAt(x - 1, y);
    r2 = recordAt(x - 1, y - 1);
    r3 = recordAt(x, y - 1);
  }
  const auto isCrowded = [](const CellRecord* r) { return r && !r->parts.areFew(); };
  if (world_.preserve || isCrowded(r0) || isCrowded(r1) || isCrowded(r2) || isCrowded(r3)) {
    rim_.linkCorner({r0, r1, r2, r3});
    return;
  }
  Turn turn;
  if (r0) turn.pass<0>(*r0);
  if (r1) turn.pass<1>(*r1);
  if (r2) turn.pass<2>(*r2);
  if (r3) turn.pass<3>(*r3);
  turn.close([&](std::uint32_t incoming, std::uint32_t outgoing) {
    links_.setSuccessor(incoming, outgoing);
    links_.setPredecessor(outgoing, incoming);
  });
}

void Linking::linkSides(CellAt at) {
  const unsigned here = at.chunk->facts[at.local];
  const FactsAround around = factsAround(at);
  if (((here | around.south) & kRimPoints) != 0) rim_.linkSide(at, kSouth);
  if (((here | around.east) & kRimPoints) != 0) rim_.linkSide(at, kEast);
  if (((here | around.north) & kRimPoints) != 0) rim_.linkSide(at, kNorth);
  if (((here | around.west) & kRimPoints) != 0) rim_.linkSide(at, kWest);
}

}  // namespace lgs::detail
