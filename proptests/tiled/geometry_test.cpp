// The importer's plane geometry by itself. All cases of tiny lattices are compared with slow rules.
#include "lattice.h"
#include "lib/tiled/src/fraction.h"
#include "lib/tiled/src/pixel_grid.h"
#include "lib/tiled/src/rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lgs::tiled {
namespace {

TEST(TiledGeometry, FractionsCompareAsTheirProducts) {
  constexpr std::int64_t kMost = 12;
  for (std::int64_t a = -kMost; a <= kMost; ++a) {
    for (std::int64_t b = 1; b <= kMost; ++b) {
      for (std::int64_t c = -kMost; c <= kMost; ++c) {
        for (std::int64_t d = 1; d <= kMost; ++d) {
          ASSERT_EQ(fraction(a, b) < fraction(c, d), a * d < c * b) << a << "/" << b << " " << c << "/" << d;
          ASSERT_EQ(fraction(a, b) == fraction(c, d), a * d == c * b) << a << "/" << b << " " << c << "/" << d;
        }
      }
    }
  }
}

TEST(TiledGeometry, FractionsOfProductsThatDoNotFit) {
  constexpr std::int64_t kMost = std::int64_t{1} << 40;
  for (const std::int64_t less : {1, 2, 1'000}) {
    // n · (n - less) / (n + less) = n - 2 · less + 2 · less² / (n + less)
    for (const std::int64_t n : {std::int64_t{4'321}, kMost / 3, kMost - less}) {
      const Fraction f = fractionOfProduct(n, n - less, n + less);
      EXPECT_EQ(f, (Fraction{n - 2 * less + 2 * less * less / (n + less), 2 * less * less % (n + less), n + less}));
      const Fraction negative = fractionOfProduct(-n, n - less, n + less);
      EXPECT_LT(negative, Fraction{-f.whole});
      EXPECT_LT(Fraction{-f.whole - 1}, negative);
      EXPECT_EQ(negative.rest, f.divisor - f.rest);
    }
  }
  // As near to each other as two fractions with such divisors can be.
  EXPECT_LT(fraction(kMost - 2, kMost - 1), fraction(kMost - 1, kMost));
  EXPECT_LT(fraction(1 - kMost, kMost), fraction(2 - kMost, kMost - 1));
  EXPECT_EQ(fraction(kMost - 2, kMost), fraction(kMost / 2 - 1, kMost / 2));
}

TEST(TiledGeometry, SimpleRings) {
  struct Exhausted {
    std::size_t length;
    std::int64_t side;
    int good;  ///< in all their rotations, in both orientations
  };
  for (const Exhausted& e :
       {Exhausted{0, 3, 0}, Exhausted{1, 3, 0}, Exhausted{2, 3, 0}, Exhausted{3, 3, 456}, Exhausted{3, 4, 3'096},
        Exhausted{4, 3, 1'136}, Exhausted{4, 4, 18'320}, Exhausted{5, 3, 2'400}, Exhausted{6, 3, 3'312}}) {
    int good = 0;
    forAllRings(e.length, e.side, 1, [&](const Polygon& ring) {
      good += isSimple(ring);
      ASSERT_EQ(isSimple(ring), isSimpleByRule(ring)) << text(ring);
    });
    EXPECT_EQ(good, e.good) << e.length << " points of " << e.side << "×" << e.side;
  }
}

/// Whether no vertex comes twice and none lies straight between its neighbours.
bool isTidy(const Polygon& loop) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (orientation(loop[i], loop[(i + 1) % n], loop[(i + 2) % n]) == 0) return false;
  }
  return n >= 3 && std::set<Point>(loop.begin(), loop.end()).size() == n;
}

/// How often a ring goes around a place. The place is on no edge.
int winding(const Polygon& ring, Point at) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if (a.y <= at.y && b.y > at.y && orientation(a, b, at) > 0) ++turns;
    if (a.y > at.y && b.y <= at.y && orientation(a, b, at) < 0) --turns;
  }
  return turns;
}

TEST(TiledGeometry, TidyLoopsKeepWhatTheRingGoesAround) {
  // Places on no line through two points of the lattice.
  constexpr std::int64_t kStep = 1'000;
  std::vector<Point> places;
  for (std::int64_t x = 37; x < 2 * kStep; x += 331) {
    for (std::int64_t y = 71; y < 2 * kStep; y += 283) places.push_back({x, y});
  }
  for (std::size_t length = 1; length <= 6; ++length) {
    forAllRings(length, 3, kStep, [&](const Polygon& ring) {
      if (length == 6 && (ring[0] != Point{0, 0} || ring[1].x != 0)) return;  // a part is enough
      const std::vector<Polygon> loops = tidyLoops(ring);
      std::int64_t area = 0;
      for (const Polygon& loop : loops) {
        ASSERT_TRUE(isTidy(loop)) << text(loop) << " of " << text(ring);
        area += doubleArea(loop);
      }
      ASSERT_EQ(area, doubleArea(ring)) << text(ring);
      for (Point at : places) {
        int turns = 0;
        for (const Polygon& loop : loops) turns += winding(loop, at);
        ASSERT_EQ(turns, winding(ring, at)) << text(ring);
      }
    });
  }
}

TEST(TiledGeometry, NearlyInsideIsUpToTwoUnitsBeyondAnEdge) {
  const Polygon square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  // A needle from the middle beyond each side, and beyond each corner.
  for (const Point way : {Point{0, -1}, Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{1, 1}, Point{-1, -1}}) {
    const auto needle = [&](std::int64_t beyond) {
      return Polygon{{50, 50}, {50 + way.x * (50 + beyond), 50 + way.y * (50 + beyond)}, {51, 52}};
    };
    for (const std::int64_t beyond : {-1, 0, 1, 2}) EXPECT_TRUE(nearlyInside(needle(beyond), square)) << beyond;
    for (const std::int64_t beyond : {3, 4}) EXPECT_FALSE(nearlyInside(needle(beyond), square)) << beyond;
  }
}

TEST(TiledGeometry, RelationsAreAQuestionOfCommonArea) {
  const std::vector<Polygon> rings = simpleRings(5, 3, 60);
  for (const Polygon& a : rings) {
    const double all = static_cast<double>(doubleArea(a)) / 2;
    for (const Polygon& b : rings) {
      const double area = commonArea(a, b);  // it differs by steps that are far larger than rounding errors
      const Relation expected = area < 1e-3         ? Relation::apart
                                : area > all - 1e-3 ? Relation::inside
                                                    : Relation::overlap;
      ASSERT_EQ(relation(a, b), expected) << text(a) << " to " << text(b);
    }
  }
}

TEST(TiledGeometry, HalvesAreWhatLiesLeftAndRight) {
  constexpr std::int64_t kStep = 32'760;  // a multiple of 1 to 8: every cut is on the lattice, and nothing is rounded
  const std::vector<Polygon> rings = simpleRings(6, 3, kStep);
  std::size_t most = 0;
  forAllRings(2, 3, kStep, [&](const Polygon& line) {
    const Point from = line[0], to = line[1];
    if (from == to) return;
    for (const Polygon& ring : rings) {
      const Halves halves = split(ring, {from, {to.x - from.x, to.y - from.y}});
      std::int64_t left = 0, right = 0;
      for (const Polygon& piece : halves.left) {
        left += doubleArea(piece);
        ASSERT_TRUE(isSimpleByRule(piece) && doubleArea(piece) > 0);
        ASSERT_TRUE(std::all_of(piece.begin(), piece.end(), [&](Point p) { return orientation(from, to, p) >= 0; }));
      }
      for (const Polygon& piece : halves.right) {
        right += doubleArea(piece);
        ASSERT_TRUE(isSimpleByRule(piece) && doubleArea(piece) > 0);
        ASSERT_TRUE(std::all_of(piece.begin(), piece.end(), [&](Point p) { return orientation(from, to, p) <= 0; }));
      }
      ASSERT_NEAR(static_cast<double>(left), 2 * areaOf(leftOf(realRing(ring), from, to)), 10);
      ASSERT_EQ(left + right, doubleArea(ring));
      most = std::max({most, halves.left.size(), halves.right.size()});
    }
  });
  EXPECT_EQ(most, 2U);
}

TEST(TiledGeometry, NoHalvesOfWhatIsNotSimple) {
  const Line upright{{10, 0}, {0, 1}};
  const Polygon clockwise{{0, 0}, {0, 20}, {20, 20}, {20, 0}};
  const Polygon twiceAround{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 5}, {15, 5}, {15, 15}, {5, 15}};
  for (const Polygon& ring : {clockwise, twiceAround}) {
    const Halves halves = split(ring, upright);
    EXPECT_TRUE(halves.left.empty()) << text(ring);
    EXPECT_TRUE(halves.right.empty()) << text(ring);
  }
  // A polygon that the line does not cut comes back unchanged.
  EXPECT_EQ(split(clockwise, {{20, 0}, {0, 1}}).left, (std::vector<Polygon>{clockwise}));
  EXPECT_EQ(split(clockwise, {{0, 0}, {0, 1}}).right, (std::vector<Polygon>{clockwise}));
}

}  // namespace
}  // namespace lgs::tiled
