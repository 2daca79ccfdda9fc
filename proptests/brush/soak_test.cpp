// Law 11 on a world of 100×100 cells: random brushes, one after the other, and none is refused.
#include "oracle/calls/random.h"
#include "proptests/brush/strokes.h"
#include "proptests/support/scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace lgs::test {
namespace {

constexpr std::int64_t kSide = 100;  // cells

class Painter {
 public:
  explicit Painter(std::uint64_t seed) : random_(seed) {}

  BrushStroke next() {
    constexpr Deed kDeeds[] = {Deed::carve, Deed::fill, Deed::replace};
    return {kDeeds[random_.below(3)], static_cast<Block>(1 + random_.below(4)), region()};
  }

 private:
  std::int64_t between(std::int64_t least, std::int64_t most) {
    return least + static_cast<std::int64_t>(random_.below(static_cast<std::uint64_t>(most - least + 1)));
  }
  Point near(Point p, std::int64_t reach) { return {p.x + between(-reach, reach), p.y + between(-reach, reach)}; }

  Region region() {
    constexpr std::int64_t kEnd = kSide * kUnitsPerCell;
    const Point at{between(0, kEnd), between(0, kEnd)};
    const std::int64_t size = kUnitsPerCell >> random_.below(8);  // from two cells down to a hundredth
    switch (random_.below(4)) {
      case 0:
        return circle(at, size, 32);
      case 1:
        return rectangle(at, near({0, 0}, 1'000), size, between(1, size));
      case 2: {
        const Point line[]{at, near(at, 2 * size)};
        return thickLine(line, between(1, size / 2), 16);
      }
      default: {  // crosses itself, as a rule
        Ring ring;
        for (std::int64_t k = between(3, 7); k > 0; --k) ring.push_back(near(at, size));
        return {{std::move(ring)}, FillRule::evenOdd};
      }
    }
  }

  oracle::Random random_;
};

TEST(BrushSoak, Law11ManyBrushesOnALargeWorld) {
  World world;
  const ShapeId square = world.shape(kUnitSquare).value();
  ASSERT_TRUE(world.fill({{0, 0}, {kSide - 1, kSide - 1}}, square, 1).has_value());
  Painter painter(testSeed());
  const auto edits = static_cast<std::int64_t>(4'000 * testScale());
  std::size_t bent = 0;
  for (std::int64_t k = 0; k < edits; ++k) {
    const BrushStroke stroke = painter.next();
    const auto result = brush(world, stroke);
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
