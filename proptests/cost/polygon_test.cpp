// Cost of a polygon that was never seen: it grows with its vertices, and not with their square. And of more polygons
// than a cell may have.
#include "ground.h"

#include <gtest/gtest.h>

namespace lgs::cost_test {
namespace {

using Polygon = std::vector<LocalPoint>;

/// What it costs to place a polygon and to take its edges apart. A refusal costs something, too.
std::uint64_t costOf(const Polygon& polygon, bool isGood) {
  World world;
  return visitsOf([&] {
    EXPECT_EQ(world.add({0, 0}, polygon, 1).has_value(), isGood);
    world.commit();
  });
}

TEST(Cost, OfANewPolygonGrowsHardlyFasterThanItsVertices) {
  constexpr std::int32_t kFew = 60, kMany = 16 * kFew;
  EXPECT_LT(costOf(comb(kMany), true), 16 * 2 * costOf(comb(kFew), true));
}

TEST(Cost, OfARefusedPolygonGrowsHardlyFasterIfItOnlyRunsClockwise) {
  constexpr std::int32_t kFew = 60, kMany = 16 * kFew;
  const auto turned = [](Polygon polygon) { return Polygon(polygon.rbegin(), polygon.rend()); };
  EXPECT_LT(costOf(turned(comb(kMany)), false), 16 * 2 * costOf(turned(comb(kFew)), false));
}

TEST(Cost, OfAnExchangeWithMoreThanACellHoldsIsThatOfARefusal) {
  const std::vector<NewPolygon> many(100 * kMaxPolygonsPerCell, {kUnitSquare, 1});
  World world;
  const auto cost = visitsOf([&] {
    const auto done = world.exchange({0, 0}, {}, many);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::capacity);
  });
  EXPECT_LT(cost, 200);
}

}  // namespace
}  // namespace lgs::cost_test
