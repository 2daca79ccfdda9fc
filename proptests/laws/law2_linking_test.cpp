// Law 2, linking: a segment's predecessor is the incoming segment met first when turning clockwise from it around its
// start, its successor the outgoing one met first when turning counter-clockwise around its end. A coincident direction
// is skipped; where there is no candidate there is no link.
#include "geometry/radial_match.h"
#include "proptests/support/exhaust.h"
#include "proptests/support/fan.h"
#include "proptests/support/law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace lgs::test {
namespace {

using oracle::operator-;

// --- The pure functions for the half-edges around one vertex ---------------------------------------------------------

using detail::Spoke;
constexpr std::uint32_t kNone = 0xffff'ffff;

/// By the number that a half-edge has in its fan.
struct Links {
  std::map<std::uint32_t, std::uint32_t> predecessor, successor;
  friend bool operator==(const Links&, const Links&) = default;
};

Links linksByLaw(const HalfEdges& fan) {
  Links links;
  for (std::uint32_t k = 0; k < fan.size(); ++k) {
    const auto first = metFirst(fan, fan[k]);
    const auto number = first ? std::find(fan.begin(), fan.end(), *first) - fan.begin() : kNone;
    (fan[k].isOutgoing ? links.predecessor : links.successor)[k] = static_cast<std::uint32_t>(number);
  }
  return links;
}

/// A fan as the engine has it.
std::vector<Spoke> spokesOf(const HalfEdges& fan) {
  std::vector<Spoke> spokes;
  for (const HalfEdge& edge : fan) {
    const auto alike = std::ranges::find_if(fan, [&](const HalfEdge& e) { return pointAlike(e, edge); });
    const auto direction = static_cast<std::uint32_t>(alike - fan.begin());
    const auto number = static_cast<std::uint32_t>(spokes.size());
    spokes.push_back({number, direction & detail::kMaxDirection, edge.isOutgoing ? 1U : 0U});
  }
  return spokes;
}

Links linksByEngine(const HalfEdges& fan) {
  Links links;
  detail::radialMatch(
      spokesOf(fan), kNone, [&](std::uint32_t s, std::uint32_t other) { links.predecessor[s] = other; },
      [&](std::uint32_t s, std::uint32_t other) { links.successor[s] = other; });
  return links;
}

LGS_LAW(RadialMatch, IsLaw2OnAnyFan, 20'000, (const Fan& fan)) {
  failUnless(linksByEngine(fan.edges) == linksByLaw(fan.edges), "other links than law 2 says");
}

/// Counter-clockwise; unequal angles on purpose.
constexpr oracle::Vector kRing[] = {{1, 0}, {5, 1}, {1, 3}, {0, 1}, {-2, 1}, {-1, 0}, {-1, -3}, {3, -1}};

// In each direction nothing, one incoming, one outgoing, or both in either order; under a preserve relation all of
// these occur.
TEST(RadialMatch, IsLaw2OnAllFans) {
  std::int64_t tried = 0, rotations = 0;
  Exhaust all;
  while (all.next()) {
    int kinds[std::size(kRing)];
    for (int& kind : kinds) kind = all.below(5);
    if (all.isLeftOut()) continue;
    HalfEdges fan;
    for (std::size_t k = 0; k < std::size(kRing); ++k) {
      if (kinds[k] == 1 || kinds[k] == 3) fan.push_back({kRing[k], false});
      if (kinds[k] >= 2) fan.push_back({kRing[k], true});
      if (kinds[k] == 4) fan.push_back({kRing[k], false});
    }
    ++tried;
    ASSERT_EQ(linksByEngine(fan), linksByLaw(fan)) << rc::toString(Fan{fan});
    if (std::ranges::any_of(fan, [](const HalfEdge& e) { return e.towards == kRing[0] || e.towards == kRing[1]; }))
      continue;
    // It may begin anywhere, even between two that are alike.
    for (std::size_t k = 1; k < fan.size(); ++k, ++rotations) {
      std::rotate(fan.begin(), fan.begin() + 1, fan.end());
      ASSERT_EQ(linksByEngine(fan), linksByLaw(fan)) << rc::toString(Fan{fan});
    }
  }
  EXPECT_EQ(tried, exhausted(390'625));  // 5^8
  if (exhaustStride() == 1) {
    EXPECT_EQ(rotations, 96'876);
  }
}

TEST(RadialMatch, AlternatingIsLaw2OnAllAlternatingFans) {
  int fans = 0;
  Exhaust all;
  while (all.next()) {
    HalfEdges fan;
    bool isOutgoing = all.coin();
    for (const oracle::Vector& towards : kRing) {
      if (!all.coin()) continue;
      fan.push_back({towards, isOutgoing});
      isOutgoing = !isOutgoing;
    }
    if (fan.size() % 2 != 0) continue;
    ++fans;
    Links links;
    detail::radialMatchAlternating(spokesOf(fan), [&](std::uint32_t incoming, std::uint32_t outgoing) {
      EXPECT_TRUE(links.successor.emplace(incoming, outgoing).second);
      EXPECT_TRUE(links.predecessor.emplace(outgoing, incoming).second);
    });
    ASSERT_EQ(links, linksByLaw(fan)) << rc::toString(Fan{fan});
  }
  EXPECT_EQ(fans, 2 * 128);  // the even subsets
}

}  // namespace
}  // namespace lgs::test
