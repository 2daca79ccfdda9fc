#include "linking.h"

#include "fan.h"
#include "radial_match.h"
#include "side_walk.h"
#include "wide_row.h"

#include <algorithm>

namespace lgs::detail {

Linking::Linking(World::Impl& world, std::vector<Spoke>& fan)
    : world_(world), grid_(world.grid), links_(world), fan_(fan) {
  constexpr std::size_t kAlongSides = 8;  // two in each of four directions
  fan_.resize(4 * std::size_t{world.catalogue.widestFan()} + kAlongSides + 1);
}

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

inline void Linking::match(std::span<const Spoke> fan) {
  if (!world_.preserve) {
    radialMatchAlternating(fan, [&](std::uint32_t incoming, std::uint32_t outgoing) {
      links_.setSuccessor(incoming, outgoing);
      links_.setPredecessor(outgoing, incoming);
    });
    return;
  }
  radialMatch(
      fan, kNoSegment, [&](std::uint32_t s, std::uint32_t other) { links_.setPredecessor(s, other); },
      [&](std::uint32_t s, std::uint32_t other) { links_.setSuccessor(s, other); });
}

/// Adds the spokes at corner q of a cell. Side q leaves the corner, the side before arrives there.
template <unsigned q>
inline void Linking::addQuadrant(Fan& fan, const CellRecord& r) const {
  constexpr unsigned leaving = q, arriving = (q + 3) % kSides;
  const std::uint32_t* ids = r.ids();
  const unsigned leaves = r.touching >> leaving & 1u, arrives = r.touching >> (4 + arriving) & 1u;
  const auto first = [&](unsigned side) -> unsigned { return r.end[partOf(side) - 1]; };
  const auto last = [&](unsigned side) { return r.end[partOf(side)] - 1u; };
  const auto idIf = [ids](unsigned present, unsigned index) { return ids[index & (0u - present)]; };
  const Content& content = world_.catalogue.content(Grid::content(r));
  fan.add(idIf(leaves, runsForward(leaving) ? first(leaving) : last(leaving)), q * kStretch, 1, leaves);
  fan.addInterior(content, content.corners[q], ids, q);
  fan.add(idIf(arrives, runsForward(arriving) ? last(arriving) : first(arriving)), (q + 1) % 4 * kStretch, 0, arrives);
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
  Fan fan(fan_);
  if (r0) addQuadrant<0>(fan, *r0);
  if (r1) addQuadrant<1>(fan, *r1);
  if (r2) addQuadrant<2>(fan, *r2);
  if (r3) addQuadrant<3>(fan, *r3);
  match(fan.spokes());
}

void Linking::linkSides(CellAt at) {
  const unsigned here = at.chunk->facts[at.local];
  const FactsAround around = factsAround(at);
  if (((here | around.south) & kRimPoints) != 0) linkSide(at, kSouth);
  if (((here | around.east) & kRimPoints) != 0) linkSide(at, kEast);
  if (((here | around.north) & kRimPoints) != 0) linkSide(at, kNorth);
  if (((here | around.west) & kRimPoints) != 0) linkSide(at, kWest);
}

/// Links at all vertices in the open side of a cell.
void Linking::linkSide(CellAt at, unsigned side) {
  SideWalk mine(world_, at, side), theirs(world_, across(at, side), opposite(side));
  const bool forward = runsForward(side);
  while (!mine.done() || !theirs.done()) {
    const std::int32_t vertex = std::min(mine.next(), theirs.next());
    // Counter-clockwise: the direction in which my edges run, my half-edges, the other direction, theirs.
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

}  // namespace lgs::detail
