// The view of loops: exact areas, and what an update costs. law15_views_test.cpp has the law.
#include "proptests/support/worlds.h"

#include <lgs/loops.h>

#include <gtest/gtest.h>

#include <cmath>

namespace lgs::test {
namespace {

TEST(LoopViewByHand, AreasAreExactAtTheEndsOfTheWorld) {
  World world;
  place(world, {-kMaxCell, -kMaxCell}, {{0, 0}, {1, 0}, {0, 1}});
  place(world, {kMaxCell, kMaxCell}, unitSquare());
  world.commit();
  const Loops loops(world);
  for (const LoopId id : loops.all()) {
    const LoopFacts f = *loops.loop(id);
    EXPECT_EQ(f.doubleArea, f.min.x < 0 ? Int128(1) : Int128(std::int64_t{2} * kUnitsPerCell * kUnitsPerCell));
  }
}

TEST(Int128, IsRoundedToTheNearestDouble) {
  const auto power = [](int n) {
    return n < 64 ? Int128{0, std::uint64_t{1} << n} : Int128{std::int64_t{1} << (n - 64), 0};
  };
  for (int n = 0; n < 127; ++n) {
    EXPECT_EQ(power(n).toDouble(), std::ldexp(1.0, n));
    EXPECT_EQ((-power(n)).toDouble(), -std::ldexp(1.0, n));
    if (n < 54) continue;
    const Int128 half = power(n - 53);  // of the last place
    EXPECT_EQ((power(n) + half).toDouble(), std::ldexp(1.0, n)) << "half-way: to the even one";
    EXPECT_EQ((power(n) + half + Int128(1)).toDouble(), std::ldexp(1.0, n) + std::ldexp(1.0, n - 52));
    EXPECT_EQ((power(n) + half - Int128(1)).toDouble(), std::ldexp(1.0, n));
    EXPECT_EQ((power(n) + half + power(n - 52)).toDouble(), std::ldexp(1.0, n) + std::ldexp(1.0, n - 51));
  }
  EXPECT_EQ(multiply(INT64_MIN, INT64_MIN), power(126));
  EXPECT_EQ(multiply(-3, INT64_MAX), Int128(INT64_MIN) + Int128(INT64_MIN) + Int128(INT64_MIN) + Int128(3));
}

/// How many nodes of trees it takes to cut a bar of so many cells in the middle.
std::uint64_t visitsToCut(std::int32_t length) {
  World world;
  fill(world, {{0, 0}, {length - 1, 0}});
  world.commit();
  Loops loops(world);
  std::uint64_t most = 0;
  for (std::int32_t k = 1; k <= 5; ++k) {
    const Cell cell{length * k / 6, 0};
    for (const bool cut : {true, false}) {
      if (cut)
        removeAll(world, cell);
      else
        place(world, cell, unitSquare());
      const std::uint64_t before = loops.visited();
      EXPECT_TRUE(loops.update(world, world.commit()));
      most = std::max(most, loops.visited() - before);
    }
  }
  return most;
}

TEST(LoopViewByHand, ACutVisitsNodesAsTheLogarithmOfTheLoop) {
  for (const std::int32_t length : {100, 1'000, 10'000, 100'000})
    EXPECT_LT(static_cast<double>(visitsToCut(length)), 60 * std::log2(length)) << length;
}

}  // namespace
}  // namespace lgs::test
