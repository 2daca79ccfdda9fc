// Phase 1 by itself, exhausted: all pairs of side profiles on a side of four units, with up to two polygons on each and
// all vertices that there can be besides, under all 16 relations between those polygons.
#include "boundary.h"
#include "scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace lgs::detail {
namespace {

using engine_test::exhausted;
using engine_test::exhaustStride;

constexpr int kUnits = 4;
constexpr std::int32_t kUnit = kUnitsPerCell / kUnits;
constexpr int kNobody = 2;  ///< who covers a unit: slot 0, slot 1 or nobody

struct Profile {
  std::array<int, kUnits> cover{};
  std::array<bool, kUnits + 1> vertex{};  ///< at 1 … 3
  Side side;
};

/// All profiles: a vertex must be wherever the cover changes, and may be elsewhere.
std::vector<Profile> allProfiles() {
  std::vector<Profile> profiles;
  for (int code = 0; code < 81 * 8; ++code) {
    Profile p;
    int rest = code / 8;
    for (int& cover : p.cover) {
      cover = rest % 3;
      rest /= 3;
    }
    bool possible = true;
    for (std::size_t k = 1; k < kUnits; ++k) {
      p.vertex[k] = (code >> (k - 1) & 1) != 0;
      possible &= p.vertex[k] || p.cover[k - 1] == p.cover[k];
    }
    if (!possible) continue;
    for (std::size_t k = 0; k < kUnits; ++k) {
      const auto at = static_cast<std::int32_t>(k) * kUnit;
      if (p.vertex[k]) p.side.points.push_back({at, {}});
      if (p.cover[k] == kNobody) continue;
      if (k > 0 && !p.vertex[k] && p.cover[k - 1] == p.cover[k])
        p.side.covered.back().end += kUnit;
      else
        p.side.covered.push_back({at, at + kUnit, static_cast<Slot>(p.cover[k])});
    }
    profiles.push_back(std::move(p));
  }
  return profiles;
}

using Part = std::tuple<std::int32_t, std::int32_t, Slot>;

/// Law 1, unit by unit; neighbouring units join where there is no vertex.
std::vector<Part> slowlyExposed(const Profile& mine, const Profile& theirs, unsigned relation) {
  std::vector<Part> parts;
  for (std::size_t k = 0; k < kUnits; ++k) {
    if (mine.cover[k] == kNobody) continue;
    const auto slot = static_cast<Slot>(mine.cover[k]);
    const bool kept = theirs.cover[k] != kNobody && (relation >> (2 * mine.cover[k] + theirs.cover[k]) & 1U) != 0;
    if (theirs.cover[k] != kNobody && !kept) continue;
    const auto at = static_cast<std::int32_t>(k) * kUnit;
    const bool cut = mine.vertex[k] || theirs.vertex[k];
    if (!parts.empty() && std::get<1>(parts.back()) == at && !cut)
      std::get<1>(parts.back()) += kUnit;
    else
      parts.emplace_back(at, at + kUnit, slot);
  }
  return parts;
}

TEST(Exposure, IsLaw1OnAllPairsOfSideProfiles) {
  const std::vector<Profile> profiles = allProfiles();
  ASSERT_EQ(profiles.size(), 192U);
  std::int64_t pairs = 0, tried = 0;
  std::vector<Part> parts;
  for (const Profile& mine : profiles) {
    for (const Profile& theirs : profiles) {
      if (pairs++ % exhaustStride() != 0) continue;
      for (unsigned relation = 0; relation < 16; ++relation, ++tried) {
        parts.clear();
        exposedIntervals(
            mine.side, theirs.side, [&](Slot a, Slot b) { return (relation >> (2 * a + b) & 1U) != 0; },
            [&](std::int32_t begin, std::int32_t end, Slot slot) { parts.emplace_back(begin, end, slot); });
        ASSERT_EQ(parts, slowlyExposed(mine, theirs, relation)) << "pair " << pairs - 1 << ", relation " << relation;
      }
    }
  }
  EXPECT_EQ(pairs, 36'864);
  EXPECT_EQ(tried, 16 * exhausted(36'864));
}

}  // namespace
}  // namespace lgs::detail
