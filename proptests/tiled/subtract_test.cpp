// One polygon is taken out of another: all pairs on a tiny lattice of wide steps; then polygons that are a few units
// wide, where rounding is at its worst; and what is given up.
#include "lattice.h"
#include "oracle/generate/random.h"

#include <gtest/gtest.h>

namespace lgs::tiled {
namespace {

/// Expects what holds for every difference, whether rounding spoilt a part or not.
void expectSound(const Difference& difference, const Polygon& b) {
  for (const Polygon& part : difference.parts) {
    ASSERT_TRUE(isSimpleByRule(part)) << text(part);
    ASSERT_GT(doubleArea(part), 0) << text(part);
    ASSERT_EQ(relation(part, b), Relation::apart) << text(part);
  }
}

TEST(TiledSubtract, LeavesWhatIsNotCommon) {
  // Each cut may be off by a unit or two along its length.
  constexpr double kRounding = 8.0 * 3 * kUnitsPerCell;
  const std::vector<Polygon> rings = simpleRings(5, 3, kUnitsPerCell / 2);
  std::size_t most = 0, lost = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = i % 8; j < rings.size(); j += 8) {  // an eighth of all pairs
      const Polygon &a = rings[i], &b = rings[j];
      SCOPED_TRACE(text(a) + " without " + text(b));
      const Difference difference = subtract(a, b, {});
      ASSERT_NO_FATAL_FAILURE(expectSound(difference, b));
      double area = 0;
      for (const Polygon& part : difference.parts) {
        area += areaOf(realRing(part));
        for (const Polygon& other : difference.parts) {
          ASSERT_TRUE(&part == &other || relation(part, other) == Relation::apart);
        }
      }
      const double missing = areaOf(realRing(a)) - commonArea(a, b) - area;
      if (difference.lost) {
        ASSERT_GT(missing, kRounding);
        ++lost;
      } else {
        ASSERT_NEAR(missing, 0, kRounding);
      }
      most = std::max(most, difference.parts.size());
    }
  }
  EXPECT_GE(most, 3U);
  EXPECT_EQ(lost, 0U);
}

/// A simple counter-clockwise ring of 3 to 7 vertices in a square of side × side units.
Polygon randomRing(oracle::Random& random, std::int64_t side) {
  while (true) {
    Polygon ring(3 + random.below(std::size_t{5}));
    for (Point& p : ring) p = {random.below(side), random.below(side)};
    if (doubleArea(ring) > 0 && isSimpleByRule(ring)) return ring;
  }
}

TEST(TiledSubtract, RoundingNeverMakesAnOverlap) {
  std::size_t cut = 0, none = 0;
  for (std::uint64_t seed = 0; seed < 15'000; ++seed) {
    oracle::Random random(seed);
    const std::int64_t side = 4 + random.below(std::int64_t{24});
    const Polygon a = randomRing(random, side), b = randomRing(random, side), c = randomRing(random, side);
    const Difference difference = subtract(a, b, std::vector<Polygon>{c});
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(expectSound(difference, b));
    ASSERT_FALSE(difference.lost);  // nothing here is larger than a sliver
    cut += difference.parts.size() > 1;
    none += difference.parts.empty();
  }
  EXPECT_GT(cut, 100U);
  EXPECT_GT(none, 100U);
}

/// A comb of `teeth` teeth that point up: 2 · teeth + 2 vertices, simple and counter-clockwise.
Polygon comb(std::int64_t teeth, std::int64_t y) {
  Polygon ring{{0, y}, {16 * teeth, y}};
  for (std::int64_t k = teeth; k > 0; --k) {
    ring.push_back({16 * k - 4, y + 20'000});
    ring.push_back({16 * k - 12, y + 100});
  }
  return ring;
}

TEST(TiledSubtract, GivesUpWhatIsTooIntricate) {
  // 2,000 × 2,000 edges are just within the budget.
  const Polygon a = comb(999, 0), b = comb(999, 30'000);
  ASSERT_EQ(a.size() * b.size(), 4'000'000U);
  const Difference apart = subtract(a, b, {});
  EXPECT_EQ(apart.parts, (std::vector<Polygon>{a}));
  EXPECT_FALSE(apart.lost);
  Polygon onceMore = b;
  onceMore.insert(onceMore.begin() + 1, {8, 30'000});  // on the straight back of the comb
  const Difference tooMuch = subtract(a, onceMore, {});
  EXPECT_TRUE(tooMuch.parts.empty());
  EXPECT_TRUE(tooMuch.lost);
}

TEST(TiledSubtract, GivesUpWhatIsNotSimpleAndMentionsItIfItIsLarge) {
  const Polygon b{{60'000, 60'000}, {60'010, 60'000}, {60'000, 60'010}};
  const auto hooked = [](std::int64_t width, std::int64_t height) {  // its last edge goes back through the first
    return Polygon{{0, 0}, {width, 0}, {width, height}, {0, height}, {2, -2}, {1, -2}};
  };
  const Difference large = subtract(hooked(1'000, 1'000), b, {});
  EXPECT_TRUE(large.parts.empty());
  EXPECT_TRUE(large.lost);
  const Difference small = subtract(hooked(100, 100), b, {});
  EXPECT_TRUE(small.parts.empty());
  EXPECT_FALSE(small.lost);
  EXPECT_TRUE(subtract(hooked(530, 500), b, {}).lost) << "more than 4 lattice units across a cell";
  EXPECT_FALSE(subtract(hooked(524, 500), b, {}).lost);
}

}  // namespace
}  // namespace lgs::tiled
