// Law 3, loops: without a preserve relation links are mutual, and following them gives closed loops. Where two solids
// touch in one point the chain turns through the free wedge, from one solid to the other.
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace lgs::test {
namespace {

LGS_LAW(Loops, LinksAreMutualAndMeet, 2'000, (const PlainTrace& trace)) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  const World& world = player.world();
  for (const SegmentId id : world.segments()) {
    const Segment s = *world.segment(id);
    const auto before = world.segment(s.predecessor), after = world.segment(s.successor);
    failUnless(before && after, "a segment has no neighbour");
    failUnless(before->successor == id && after->predecessor == id, "a link is not mutual");
    failUnless(before->end == s.start && s.end == after->start, "neighbours do not meet");
  }
}

using Cycle = std::vector<SegmentId>;

Cycle fromItsLeast(Cycle cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

/// From each segment its successors, as long as each says that it comes from the one before.
std::set<Cycle> cyclesOfMutualLinks(const World& world) {
  std::set<Cycle> cycles;
  const std::vector<SegmentId> ids = world.segments();
  for (const SegmentId first : ids) {
    Cycle cycle;
    SegmentId at = first;
    do {
      cycle.push_back(at);
      const SegmentId next = world.segment(at)->successor;
      if (!next || world.segment(next)->predecessor != at) break;
      at = next;
    } while (at != first && cycle.size() <= ids.size());
    if (at == first && world.segment(first)->predecessor == cycle.back()) cycles.insert(fromItsLeast(cycle));
  }
  return cycles;
}

// Under a preserve relation too, where some links are mutual and some are not.
LGS_LAW(Loops, AreTheCyclesOfMutualLinks, 6'000, (const GoodTrace& trace)) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  std::set<Cycle> loops;
  for (const Loop& loop : player.world().loops())
    failUnless(loops.insert(fromItsLeast(loop.segments)).second, "a loop is there twice");
  failUnless(loops == cyclesOfMutualLinks(player.world()), "the loops are not the cycles of mutual links");
}

}  // namespace
}  // namespace lgs::test
