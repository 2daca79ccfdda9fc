// The importer's plane geometry by itself. All cases of tiny lattices are compared with slow rules.
#include "addons/tiled/src/pixel_grid.h"
#include "lattice.h"

#include <map>
#include <set>

namespace lgs::tiled {
namespace {

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

/// Whether no vertex lies straight between its neighbours.
bool isTidy(const Polygon& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; n >= 3 && i < n; ++i) {
    if (orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) == 0) return false;
  }
  return true;
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

TEST(TiledGeometry, TidiedRingsKeepWhatTheyGoAround) {
  // Places on no line through two points of the lattice.
  constexpr std::int64_t kStep = 1'000;
  std::vector<Point> places;
  for (std::int64_t x = 37; x < 2 * kStep; x += 331) {
    for (std::int64_t y = 71; y < 2 * kStep; y += 283) places.push_back({x, y});
  }
  for (std::size_t length = 1; length <= 6; ++length) {
    forAllRings(length, 3, kStep, [&](const Polygon& ring) {
      if (length == 6 && (ring[0] != Point{0, 0} || ring[1].x != 0)) return;  // a part is enough
      const Polygon tidy = tidied(ring);
      ASSERT_TRUE(isTidy(tidy)) << text(tidy) << " of " << text(ring);
      ASSERT_EQ(doubleArea(tidy), doubleArea(ring)) << text(ring);
      for (Point at : places) ASSERT_EQ(winding(tidy, at), winding(ring, at)) << text(ring);
    });
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

TEST(TiledGeometry, PartsAreWhatLiesInEachCell) {
  constexpr double kRounding = 8.0 * kUnitsPerCell;  // an edge can move by less than a unit along its length
  std::size_t most = 0;
  for (Polygon ring : simpleRings(5, 3, 50'000)) {
    for (Point& p : ring) p = {p.x - 30'000, p.y - 40'000};
    std::map<Cell, double> areas;
    const auto parts = cutAlongGrid(ring, [&](Cell shift, const Polygon& part) {
      EXPECT_TRUE(isSimpleByRule(part)) << text(part) << " of " << text(ring);
      const Box box = boundingBox(part);
      EXPECT_TRUE(box.min.x >= 0 && box.min.y >= 0 && box.max.x <= kUnitsPerCell && box.max.y <= kUnitsPerCell);
      areas[shift] += tiled::areaOf(realRing(part));
    });
    ASSERT_TRUE(parts) << text(ring);
    for (std::int64_t j = -1; j <= 1; ++j) {
      for (std::int64_t i = -1; i <= 1; ++i) {
        const Point low{i * kUnitsPerCell, j * kUnitsPerCell}, high{low.x + kUnitsPerCell, low.y + kUnitsPerCell};
        const Polygon square{low, {high.x, low.y}, high, {low.x, high.y}};
        const Cell cell{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
        ASSERT_NEAR(areas[cell], commonArea(ring, square), kRounding) << text(ring);
      }
    }
    most = std::max(most, *parts);
    std::reverse(ring.begin(), ring.end());
    ASSERT_EQ(cutAlongGrid(ring, [](Cell, const Polygon&) {}), parts) << "it may run either way: " << text(ring);
  }
  EXPECT_GE(most, 4U);
}

}  // namespace
}  // namespace lgs::tiled
