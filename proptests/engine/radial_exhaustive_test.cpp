// Phase 2 by itself, exhausted: all fans of half-edges over eight directions, against law 2 on integer vectors.
#include "radial_match.h"
#include "scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace lgs::detail {
namespace {

using engine_test::exhausted;
using engine_test::exhaustStride;

constexpr std::uint32_t kNone = 0xffff'ffff;
constexpr std::uint32_t kDirections = 8;

struct Direction {
  std::int64_t x, y;
};
/// Counter-clockwise; unequal angles on purpose.
constexpr std::array<Direction, kDirections> kRing{
    {{1, 0}, {5, 1}, {1, 3}, {0, 1}, {-2, 1}, {-1, 0}, {-1, -3}, {3, -1}}};

/// Whether turning counter-clockwise from `from`, `a` is met before `b`; by angles in (0, 2π), so what coincides with
/// `from` is met last.
bool metBefore(Direction from, Direction a, Direction b) {
  const auto cross = [](Direction u, Direction v) { return u.x * v.y - u.y * v.x; };
  const auto dot = [](Direction u, Direction v) { return u.x * v.x + u.y * v.y; };
  const auto half = [&](Direction d) {  // 0: less than half a turn, 1: half a turn or more, 2: coincident
    if (cross(from, d) > 0) return 0;
    return cross(from, d) == 0 && dot(from, d) > 0 ? 2 : 1;
  };
  if (half(a) != half(b)) return half(a) < half(b);
  return cross(a, b) > 0;
}

struct Links {
  std::map<std::uint32_t, std::uint32_t> predecessor, successor;
  friend bool operator==(const Links&, const Links&) = default;
};

/// Law 2 word for word.
Links slowlyMatched(const std::vector<Spoke>& fan) {
  Links links;
  for (const Spoke& spoke : fan) {
    const Direction from = kRing[spoke.direction];
    const Spoke* first = nullptr;
    for (const Spoke& other : fan) {
      if (other.outgoing == spoke.outgoing || other.direction == spoke.direction) continue;
      const Direction d = kRing[other.direction];
      // An outgoing one looks clockwise, so that what is met first is met last counter-clockwise.
      if (!first ||
          (spoke.outgoing ? metBefore(from, kRing[first->direction], d) : metBefore(from, d, kRing[first->direction])))
        first = &other;
    }
    (spoke.outgoing ? links.predecessor : links.successor)[spoke.segment] = first ? first->segment : kNone;
  }
  return links;
}

Links matched(const std::vector<Spoke>& fan) {
  Links links;
  radialMatch(
      fan, kNone, [&](std::uint32_t s, std::uint32_t other) { links.predecessor[s] = other; },
      [&](std::uint32_t s, std::uint32_t other) { links.successor[s] = other; });
  return links;
}

// In each direction nothing, one incoming, one outgoing, or both in either order; under a preserve relation all of
// these occur. The collection may start anywhere, even between two that coincide.
TEST(RadialMatch, IsLaw2OnAllFans) {
  std::int64_t fans = 0, tried = 0, rotations = 0;
  const std::int64_t total = 390'625;  // 5^8
  for (std::int64_t code = 0; code < total; ++code) {
    ++fans;
    if (code % exhaustStride() != 0) continue;
    ++tried;
    std::vector<Spoke> fan;
    std::int64_t rest = code;
    for (std::uint32_t d = 0; d < kDirections; ++d, rest /= 5) {
      const auto add = [&](std::uint32_t outgoing) {
        fan.push_back({static_cast<std::uint32_t>(100 + fan.size()), d & kMaxDirection, outgoing & 1U});
      };
      const std::int64_t kind = rest % 5;
      if (kind == 1 || kind == 3) add(0);
      if (kind >= 2) add(1);
      if (kind == 4) add(0);
    }
    const Links expected = slowlyMatched(fan);
    ASSERT_EQ(matched(fan), expected) << "fan " << code;
    if (code % 25 != 0) continue;  // rotations of those that leave two directions free
    for (std::size_t k = 1; k < fan.size(); ++k) {
      std::rotate(fan.begin(), fan.begin() + 1, fan.end());
      ASSERT_EQ(matched(fan), expected) << "fan " << code << ", rotated by " << k;
      ++rotations;
    }
  }
  EXPECT_EQ(fans, total);
  EXPECT_EQ(tried, exhausted(total));
  if (exhaustStride() == 1) {
    EXPECT_EQ(rotations, 96'876);
  }
}

TEST(RadialMatch, AlternatingIsLaw2OnAllAlternatingFans) {
  int fans = 0;
  for (unsigned subset = 0; subset < 1U << kDirections; ++subset) {
    for (std::uint32_t firstOutgoing = 0; firstOutgoing < 2; ++firstOutgoing) {
      std::vector<Spoke> fan;
      for (std::uint32_t d = 0; d < kDirections; ++d) {
        if ((subset >> d & 1U) == 0) continue;
        const auto k = static_cast<std::uint32_t>(fan.size());
        fan.push_back({100 + k, d & kMaxDirection, (k + firstOutgoing) & 1U});
      }
      if (fan.size() % 2 != 0) continue;
      ++fans;
      Links links;
      radialMatchAlternating(fan, [&](std::uint32_t incoming, std::uint32_t outgoing) {
        EXPECT_TRUE(links.successor.emplace(incoming, outgoing).second);
        EXPECT_TRUE(links.predecessor.emplace(outgoing, incoming).second);
      });
      ASSERT_EQ(links, slowlyMatched(fan)) << "directions " << subset << ", first outgoing " << firstOutgoing;
    }
  }
  EXPECT_EQ(fans, 2 * 128);  // the even subsets
}

}  // namespace
}  // namespace lgs::detail
