// Questions about places, each against the slow way: all polygons, all segments, fractions of any length.
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace lgs::test {
namespace {

using Exact = boost::multiprecision::cpp_rational;

struct ExactPoint {
  Exact x, y;
};

Exact cross(const ExactPoint& a, const ExactPoint& b) { return a.x * b.y - a.y * b.x; }
Exact dot(const ExactPoint& a, const ExactPoint& b) { return a.x * b.x + a.y * b.y; }
ExactPoint operator-(const ExactPoint& a, const ExactPoint& b) { return {a.x - b.x, a.y - b.y}; }
ExactPoint exact(Point p) { return {p.x, p.y}; }

std::tuple<Point, Point, Block> nameOf(const Segment& s) { return {s.start, s.end, s.block}; }

Point inTheWorld(Point p) {
  return {std::clamp(p.x, -kMaxCoordinate, kMaxCoordinate), std::clamp(p.y, -kMaxCoordinate, kMaxCoordinate)};
}

/// A point in or near the polygons: as a rule one where something happens.
Point somePoint(const World& world, oracle::Random& random) {
  const auto ids = world.segments();
  const Point origin = toWorld(world.bounds().value_or(CellRect{}).min, {});
  if (ids.empty() || random.chance(20))
    return inTheWorld({origin.x + random.below(6 * U) - U, origin.y + random.below(6 * U) - U});
  const Segment s = *world.segment(random.pick(ids));
  Point p = random.chance(50) ? s.start : Point{(s.start.x + s.end.x) / 2, (s.start.y + s.end.y) / 2};
  const std::int64_t spread = random.chance(50) ? 1 : U;
  if (random.chance(70)) p = {p.x + random.below(2 * spread + 1) - spread, p.y + random.below(2 * spread + 1) - spread};
  return inTheWorld(p);
}

/// The winding number, or nothing on the outline: another way than counting crossings.
std::optional<int> winding(std::span<const LocalPoint> polygon, Cell cell, Point p) {
  int turns = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ExactPoint a = exact(toWorld(cell, polygon[k])) - exact(p);
    const ExactPoint b = exact(toWorld(cell, polygon[(k + 1) % polygon.size()])) - exact(p);
    const Exact side = cross(a, b);
    if (side == 0 && dot(a, b) <= 0) return std::nullopt;
    if (a.y <= 0 && b.y > 0 && side > 0) ++turns;
    if (a.y > 0 && b.y <= 0 && side < 0) --turns;
  }
  return turns;
}

Spot slowSpot(const World& world, Point p) {
  Spot spot;
  spot.cell = cellAt(p);
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) {
    const auto turns = winding(polygon.vertices, cell, p);
    if (turns == 0) return;
    const Spot here{turns ? Spot::Where::inside : Spot::Where::edge, polygon.handle, polygon.block, cell};
    const auto order = [](const Spot& s) {
      return std::tuple(s.where != Spot::Where::inside, s.cell.j, s.cell.i, s.polygon);
    };
    if (spot.where == Spot::Where::outside || order(here) < order(spot)) spot = here;
  });
  return spot;
}

struct SlowNearest {
  std::optional<Segment> segment;
  Exact squared = 0;
};

SlowNearest slowNearest(const World& world, Point p, const Exact& reach) {
  SlowNearest best;
  for (const SegmentId id : world.segments()) {
    const Segment s = *world.segment(id);
    const ExactPoint along = exact(s.end) - exact(s.start), to = exact(p) - exact(s.start);
    const Exact part = std::clamp<Exact>(dot(to, along) / dot(along, along), 0, 1);
    const ExactPoint rest = to - ExactPoint{along.x * part, along.y * part};
    const Exact squared = dot(rest, rest);
    if (squared > reach * reach) continue;
    if (!best.segment || std::tuple(squared, nameOf(s)) < std::tuple(best.squared, nameOf(*best.segment)))
      best = {s, squared};
  }
  return best;
}

struct SlowHit {
  std::optional<Segment> segment;
  Exact fraction = 1;
};

SlowHit slowRay(const World& world, Point from, Point to) {
  SlowHit best;
  const ExactPoint ray = exact(to) - exact(from);
  for (const SegmentId id : world.segments()) {
    const Segment s = *world.segment(id);
    const ExactPoint along = exact(s.end) - exact(s.start), start = exact(s.start) - exact(from);
    const Exact turn = cross(ray, along);
    if (turn >= 0) continue;  // from behind, or along it
    const Exact fraction = cross(start, along) / turn, part = cross(start, ray) / turn;
    if (fraction < 0 || fraction > 1 || part < 0 || part > 1) continue;
    if (!best.segment || std::tuple(fraction, nameOf(s)) < std::tuple(best.fraction, nameOf(*best.segment)))
      best = {s, fraction};
  }
  return best;
}

/// Asks about the world of a trace, some times over.
template <class Ask>
void askAbout(const oracle::Trace& trace, Chance& chance, Ask&& ask) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  for (int k = 0; k < 20 && !testing::Test::HasFailure(); ++k) ask(player.world(), chance);
}

LGS_LAW(Questions, WhatIsAtAPoint, 200, (const GoodTrace& trace, Chance chance)) {
  askAbout(trace, chance, [](const World& world, oracle::Random& random) {
    const Point p = somePoint(world, random);
    const Spot actual = world.at(p), expected = slowSpot(world, p);
    EXPECT_EQ(actual.where, expected.where) << p.x << ' ' << p.y;
    EXPECT_EQ(actual.polygon, expected.polygon);
    EXPECT_EQ(actual.block, expected.block);
    EXPECT_EQ(actual.cell, expected.cell);
  });
}

void expectNearest(const World& world, Point p, double radius) {
  const auto actual = must(world.nearest(p, radius));
  const SlowNearest expected = slowNearest(world, p, std::llround(radius * U));
  ASSERT_EQ(bool{actual.segment}, expected.segment.has_value()) << p.x << ' ' << p.y << " within " << radius;
  if (!expected.segment) return;
  EXPECT_EQ(nameOf(*world.segment(actual.segment)), nameOf(*expected.segment)) << p.x << ' ' << p.y;
  EXPECT_DOUBLE_EQ(actual.distance, std::sqrt(expected.squared.convert_to<double>()) / U);
  const double dx = actual.point.x - static_cast<double>(p.x) / U, dy = actual.point.y - static_cast<double>(p.y) / U;
  EXPECT_NEAR(std::hypot(dx, dy), actual.distance, 1e-6);
}

LGS_LAW(Questions, WhichSegmentIsNearest, 200, (const GoodTrace& trace, Chance chance)) {
  askAbout(trace, chance, [](const World& world, oracle::Random& random) {
    const Point p = somePoint(world, random);
    expectNearest(world, p, random.pick<double>({0, 1.0 / U, 0.25, 1, 3, 40}));
  });
}

// A search that goes from the near to the far may end too soon only where little is near.
LGS_LAW(Questions, WhichOfAFewFarApartIsNearest, 500, (Chance chance)) {
  constexpr std::int32_t kSide = 7, kSize = U / 8;
  World world;
  for (int k = 0; k < 3; ++k) {
    const Cell cell{chance.below(kSide), chance.below(kSide)};
    const std::int32_t x = chance.below(8) * kSize, y = chance.below(8) * kSize;
    if (world.isEmpty(cell)) place(world, cell, {{x, y}, {x + kSize, y}, {x, y + kSize}});
  }
  world.commit();
  for (int k = 0; k < 10; ++k) expectNearest(world, {chance.below(kSide * U), chance.below(kSide * U)}, 40);
}

LGS_LAW(Questions, WhatARayHits, 200, (const GoodTrace& trace, Chance chance)) {
  askAbout(trace, chance, [](const World& world, oracle::Random& random) {
    const Point from = somePoint(world, random);
    Point to = somePoint(world, random);
    if (random.chance(20)) to = {from.x, to.y};
    if (random.chance(20)) to = {to.x, from.y};
    const auto actual = must(world.rayCast(from, to));
    const SlowHit expected = slowRay(world, from, to);
    ASSERT_EQ(bool{actual.segment}, expected.segment.has_value())
        << from.x << ' ' << from.y << " to " << to.x << ' ' << to.y;
    EXPECT_DOUBLE_EQ(actual.fraction, expected.fraction.convert_to<double>());
    if (!expected.segment) return;
    EXPECT_EQ(nameOf(*world.segment(actual.segment)), nameOf(*expected.segment));
    EXPECT_EQ(actual.normal.x, expected.segment->normal().x);
    EXPECT_EQ(actual.normal.y, expected.segment->normal().y);
  });
}

TEST(QuestionsByHand, FarApartAndFarAway) {
  World world;
  const std::int64_t far = std::int64_t{kMaxCell} * U;
  for (const std::int64_t at : {std::int64_t{0}, far, -far}) {
    const Cell cell = cellAt({at, at});
    place(world, cell, unitSquare(), 3);
    world.commit();
    const auto nearest =
        must(world.nearest({at - 4096 * std::int64_t{U} * (at < far ? 0 : 1), at + U / 2}, kMaxRadius));
    EXPECT_TRUE(nearest.segment);
    const std::int64_t away = at > 0 ? -std::int64_t{kMaxRay} * U : std::int64_t{kMaxRay} * U;
    const auto hit = must(world.rayCast({at + away, at + U / 2}, {at, at + U / 2}));
    ASSERT_TRUE(hit.segment);
    EXPECT_EQ(world.segment(hit.segment)->cell, cell);
    EXPECT_EQ(hit.normal.x, at > 0 ? -1 : 1);
    EXPECT_EQ(hit.normal.y, 0);
    EXPECT_EQ(world.at({at + 1, at + 1}).where, Spot::Where::inside);
    EXPECT_EQ(world.at({at + U, at + U}).where, Spot::Where::edge);
  }
  EXPECT_EQ(world.bounds(), (CellRect{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}));
}

TEST(QuestionsByHand, APointThatIsNearlyOnASegmentIsNearIt) {
  World world;
  place(world, {0, 0}, {{0, 0}, {5, 0}, {5, 3}});
  world.commit();
  const auto nearest = must(world.nearest({3, 2}, 1));  // twice the area with the long side is 1
  ASSERT_TRUE(nearest.segment);
  EXPECT_NEAR(nearest.distance * U, 1 / std::sqrt(34.0), 1e-9);
}

TEST(QuestionsByHand, APlaceBeyondTheWorldIsNoLatticePoint) {
  constexpr Point kBeyond{kMaxCoordinate + 1, kMaxCoordinate + 1};
  constexpr auto kLast = static_cast<double>(kMaxCoordinate) / kUnitsPerCell;
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(latticePoint({kLast, -kLast}), (Point{kMaxCoordinate, -kMaxCoordinate}));
  EXPECT_EQ(latticePoint({kLast + 1, -kLast - 1}), kBeyond);
  EXPECT_EQ(latticePoint({1e300, -1e300}), kBeyond);
  EXPECT_EQ(latticePoint({notANumber, notANumber}), kBeyond);
}

TEST(QuestionsByHand, BeyondTheWorldIsRefused) {
  const World world;
  const std::int64_t beyond = kMaxCoordinate + 1, longest = std::int64_t{kMaxRay} * U;
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(world.at({beyond, 0}).where, Spot::Where::outside);
  for (const auto& answer : {world.nearest({0, beyond}, 1), world.nearest({}, -0.5), world.nearest({}, 4096.5),
                             world.nearest({}, notANumber)}) {
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::outOfReach);
  }
  for (const auto& answer : {world.rayCast({}, {0, -beyond}), world.rayCast({}, {0, longest + 1}),
                             world.rayCast({longest / 2 + 1, 0}, {-longest / 2, 0})}) {
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::outOfReach);
  }
  EXPECT_TRUE(world.nearest({kMaxCoordinate, -kMaxCoordinate}, kMaxRadius));
  EXPECT_FALSE(world.rayCast({}, {longest, -longest})->segment);
}

TEST(QuestionsByHand, PolygonsOfAShapeAndOfTheWorld) {
  World world;
  const std::vector<LocalPolygon> halves = shapeNamed("two halves");
  const ShapeId shape = shapeOf(world, halves);
  const auto polygons = must(world.polygonsOf(shape));
  ASSERT_EQ(polygons.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_TRUE(std::ranges::equal(polygons[k], halves[k]));
  EXPECT_EQ(world.polygonsOf(ShapeId{9}).error().code, ErrorCode::unknownShape);

  EXPECT_EQ(world.bounds(), std::nullopt);
  ASSERT_TRUE(world.add({-40, 3}, shape, 5));
  ASSERT_TRUE(world.fill({{0, 0}, {2, 2}}, shapeOf(world, {unitSquare()}), 6));
  EXPECT_EQ(world.bounds(), (CellRect{{-40, 0}, {2, 3}}));
  EXPECT_FALSE(world.isEmpty({-40, 3}));
  EXPECT_TRUE(world.isEmpty({-41, 3}));
  EXPECT_TRUE(world.isEmpty({kMaxCell, kMaxCell}));
  int all = 0, some = 0;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    ++all;
    EXPECT_EQ(*world.cellOf(p.handle), cell);
  });
  world.forEachPolygon({{-40, 0}, {1, 3}}, [&](Cell, const PlacedPolygon&) { ++some; });
  EXPECT_EQ(all, 11) << "the buried one too";
  EXPECT_EQ(some, 8);
}

}  // namespace
}  // namespace lgs::test
