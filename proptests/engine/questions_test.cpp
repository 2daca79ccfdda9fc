// Questions about places, each against the slow way: all polygons, all segments, fractions of any length.
#include "oracle/check/questions.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lgs::test {
namespace {

LGS_LAW(Questions, AreAnsweredAsTheSlowWayDoes, 200, (const AnyTrace& trace)) {
  expectNoMismatch(trace, {.naive = false, .cgal = false, .skipRefused = true, .questions = 20});
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
  for (int k = 0; k < 10; ++k)
    EXPECT_EQ(
        oracle::wrongNearest(world, oracle::segmentsOf(world), {chance.below(kSide * U), chance.below(kSide * U)}, 40),
        "");
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

TEST(QuestionsByHand, BeyondTheWorldIsRefused) {
  const World world;
  const std::int64_t beyond = kMaxCoordinate + 1, longest = std::int64_t{kMaxRay} * U;
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(world.at({beyond, 0}).where, Spot::Where::outside);
  for (const auto& answer : {world.nearest({0, beyond}, 1), world.nearest({}, -0.5), world.nearest({}, 4096.5),
                             world.nearest({}, notANumber)})
    EXPECT_EQ(refusal(answer).code, ErrorCode::outOfReach);
  for (const auto& answer : {world.rayCast({}, {0, -beyond}), world.rayCast({}, {0, longest + 1}),
                             world.rayCast({longest / 2 + 1, 0}, {-longest / 2, 0})})
    EXPECT_EQ(refusal(answer).code, ErrorCode::outOfReach);
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
