#include "unloaded.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test {

World rowOfChunks(std::int32_t chunks) {
  World world;
  fill(world, {{0, 0}, {32 * chunks - 1, 31}});
  world.commit();
  return world;
}

Seen seen(const Segment& segment, bool withHandle) {
  const SegmentFields s = fieldsOf(segment);
  return {s.start, s.end, s.block, s.cell, s.ghost1, s.ghost2, withHandle ? s.polygon : PolygonHandle{}};
}

std::multiset<Seen> seen(const World& world, const std::vector<SegmentId>& ids, bool withHandles) {
  std::multiset<Seen> out;
  for (const SegmentId id : ids) out.insert(seen(must(world.segment(id)), withHandles));
  return out;
}

}  // namespace lgs::test
