// Law 7: whether a ring is simple. The sweep against all pairs of edges, on rings that touch, fold and repeat.
#include "geometry/simple.h"
#include "oracle/calls/random.h"
#include "proptests/support/scale.h"

#include <gtest/gtest.h>

#include <vector>

namespace lgs::test {
namespace {

using detail::findSelfIntersection;
using detail::isSimple;
using oracle::Random;
using Ring = std::vector<LocalPoint>;

std::int32_t below(Random& random, std::int32_t count) { return static_cast<std::int32_t>(random.below(count)); }

bool isSimpleByPairs(const Ring& ring) { return ring.size() >= 3 && !findSelfIntersection(ring); }

/// A ring of any points of a small lattice. Sometimes they are sorted by their angle or by their place first, so that
/// long rings are simple now and then too.
Ring anyRing(Random& random) {
  const std::int32_t side = 2 + below(random, 7);
  Ring ring(static_cast<std::size_t>(3 + below(random, 14)));
  for (LocalPoint& p : ring) p = {below(random, side), below(random, side)};
  if (below(random, 2) == 0) {
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    const auto half = ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2);
    std::stable_partition(half, ring.end(), [&](LocalPoint p) { return p.y < side / 2; });
    std::reverse(half, ring.end());
  }
  return ring;
}

TEST(FindDefect, TheSweepAgreesWithAllPairsOfEdges) {
  Random random(testSeed());
  std::int64_t simple = 0;
  const std::int64_t tries = scaled(400'000);
  for (int k = 0; k < tries; ++k) {
    const Ring ring = anyRing(random);
    simple += isSimpleByPairs(ring);
    ASSERT_EQ(isSimple(ring), isSimpleByPairs(ring)) << testing::PrintToString(ring.size());
  }
  EXPECT_GT(simple, tries / 50);
}

}  // namespace
}  // namespace lgs::test
