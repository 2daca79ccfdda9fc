// Law 11 on a world of 100×100 cells: random brushes, one after the other, and none is refused.
#include "oracle/calls/random.h"
#include "proptests/brush/strokes.h"
#include "proptests/support/scale.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

constexpr std::int64_t kSide = 100;  // cells

Point near(oracle::Random& random, Point p, std::int64_t reach) {
  return {p.x + random.between(-reach, reach), p.y + random.between(-reach, reach)};
}

Region region(oracle::Random& random) {
  constexpr std::int64_t kEnd = kSide * kUnitsPerCell;
  const Point at = near(random, {kEnd / 2, kEnd / 2}, kEnd / 2);
  const std::int64_t size = kUnitsPerCell >> random.below(8);  // from two cells down to a hundredth
  switch (random.below(4)) {
    case 0:
      return circle(at, size, 32);
    case 1:
      return rectangle(at, near(random, {0, 0}, 1'000), size, random.between<std::int64_t>(1, size));
    case 2: {
      const Point line[]{at, near(random, at, 2 * size)};
      return thickLine(line, random.between<std::int64_t>(1, size / 2), 16);
    }
    default: {  // crosses itself, as a rule
      Ring ring;
      for (int k = random.between(3, 7); k > 0; --k) ring.push_back(near(random, at, size));
      return {{std::move(ring)}, FillRule::evenOdd};
    }
  }
}

TEST(BrushSoak, Law11ManyBrushesOnALargeWorld) {
  World world;
  const ShapeId square = world.shape(kUnitSquare).value();
  ASSERT_TRUE(world.fill({{0, 0}, {kSide - 1, kSide - 1}}, square, 1).has_value());
  oracle::Random random(testSeed());
  const auto edits = static_cast<std::int64_t>(4'000 * testScale());
  std::size_t bent = 0;
  for (std::int64_t k = 0; k < edits; ++k) {
    constexpr Deed kDeeds[] = {Deed::carve, Deed::fill, Deed::replace};
    const Deed deed = kDeeds[random.below(3)];
    const Block block = 1 + random.below(4U);
    const auto [rings, rule] = region(random);
    const auto result = stroke(world, {deed, block, rings, rule == FillRule::evenOdd});
    ASSERT_TRUE(result.has_value()) << "edit " << k << ": " << message(result.error());
    bent += result->bent.size();
    world.commit();
  }
  std::size_t most = 0, vertices = 0;
  for (std::int32_t i = 0; i < kSide; ++i) {
    for (std::int32_t j = 0; j < kSide; ++j) {
      const auto polygons = world.polygons({i, j});
      most = std::max(most, polygons.size());
      std::size_t count = 0;
      for (const PlacedPolygon& p : polygons) count += p.vertices.size();
      vertices = std::max(vertices, count);
    }
  }
  std::printf("%lld edits; at most %zu polygons and %zu vertices in a cell; %zu polygons bent against law 9\n",
              static_cast<long long>(edits), most, vertices, bent);
}

}  // namespace
}  // namespace lgs::test
