#include "rim.h"

#include "radial_match.h"
#include "side_walk.h"

#include <algorithm>

namespace lgs::detail {

Rim::Rim(World::Impl& world, Links& links, std::vector<Spoke>& fan) : world_(world), links_(links), fan_(fan) {
  constexpr std::size_t kAlongSides = 8;  // two in each of four directions
  fan_.resize(4 * std::size_t{world.catalogue.widestFan()} + kAlongSides + 1);
}

void Rim::match(std::span<const Spoke> fan) {
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

void Rim::linkCorner(const std::array<const CellRecord*, 4>& quadrants) {
  Fan fan(fan_);
  for (unsigned q = 0; q < 4; ++q) {
    const CellRecord* r = quadrants[q];
    if (!r) continue;
    const Content& content = world_.catalogue.content(Grid::content(*r));
    const unsigned leaving = q, arriving = sideBefore(q);
    const std::span leave = r->ids(partOf(leaving)), arrive = r->ids(partOf(arriving));
    if ((r->touching >> leaving & 1u) != 0)
      fan.add(runsForward(leaving) ? leave.front() : leave.back(), q * kStretch, 1, 1);
    fan.addInterior(content, content.corners[q], r->ids(), q);
    if ((r->touching >> (4 + arriving) & 1u) != 0)
      fan.add(runsForward(arriving) ? arrive.back() : arrive.front(), (q + 1) % 4 * kStretch, 0, 1);
  }
  match(fan.spokes());
}

void Rim::linkSide(CellAt at, unsigned side) {
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
