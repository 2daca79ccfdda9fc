// Law 1, exposure: cut every polygon edge at every vertex that lies on it; a cut edge u→v is an output segment, unless
// another polygon has v→u and their overlap is not preserved.
#include "outline/boundary.h"
#include "proptests/support/exhaust.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace lgs::test {
namespace {

// --- The pure function for a side between two cells: all pairs of profiles of a side of four units, with up to two
// polygons on each and all vertices that there can be besides, under all 16 relations between those polygons.

using detail::Side;
using detail::Slot;

constexpr int kUnits = 4;
constexpr std::int32_t kUnit = kUnitsPerCell / kUnits;
constexpr int kNobody = 2;  ///< who covers a unit: slot 0, slot 1 or nobody

struct Profile {
  std::array<int, kUnits> cover{};
  std::array<bool, kUnits + 1> vertex{};  ///< at 1 … 3
  std::vector<detail::Interval> covered;
  std::vector<detail::RimPoint> points;
  Side side() const { return {covered, points}; }
};

/// All profiles: a vertex must be wherever the cover changes, and may be elsewhere.
std::vector<Profile> allProfiles() {
  std::vector<Profile> profiles;
  Exhaust all;
  while (all.next()) {
    Profile p;
    for (int& cover : p.cover) cover = all.below(3);
    for (std::size_t k = 1; k < kUnits; ++k) p.vertex[k] = p.cover[k - 1] != p.cover[k] || all.coin();
    for (std::size_t k = 0; k < kUnits; ++k) {
      const auto at = static_cast<std::int32_t>(k) * kUnit;
      if (p.vertex[k]) p.points.push_back({at, {}});
      if (p.cover[k] == kNobody) continue;
      if (k > 0 && !p.vertex[k] && p.cover[k - 1] == p.cover[k])
        p.covered.back().end += kUnit;
      else
        p.covered.push_back({at, at + kUnit, static_cast<Slot>(p.cover[k])});
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
  std::int64_t tried = 0;
  std::vector<Part> parts;
  Exhaust all;
  while (all.next()) {
    const Profile& mine = all.pick(profiles);
    const Profile& theirs = all.pick(profiles);
    if (all.isLeftOut()) continue;
    for (unsigned relation = 0; relation < 16; ++relation, ++tried) {
      parts.clear();
      detail::exposedIntervals(
          mine.side(), theirs.side(), [&](Slot a, Slot b) { return (relation >> (2 * a + b) & 1U) != 0; },
          [&](std::int32_t begin, std::int32_t end, Slot slot) { parts.emplace_back(begin, end, slot); });
      ASSERT_EQ(parts, slowlyExposed(mine, theirs, relation))
          << "profiles " << &mine - &profiles[0] << " and " << &theirs - &profiles[0] << ", relation " << relation;
    }
  }
  EXPECT_EQ(tried, 16 * exhausted(192 * 192));
}

}  // namespace
}  // namespace lgs::test
