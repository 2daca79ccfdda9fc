// Rocks that stand on a tip: Box2D lets them sleep there, and they must not become ground in balance.
#include "crowd.h"
#include "oracle/calls/random.h"
#include "proptests/support/law.h"

#include <gtest/gtest.h>
#include <lgs/box2d/ground.h>

#include <cmath>
#include <vector>

namespace lgs::box2d_test {
namespace {

constexpr Block kFallen = 1, kFloor = 9;
constexpr double kTip = 3;  // of the tip

Ring ringOf(const std::vector<DoublePoint>& corners) {
  Ring ring;
  for (const DoublePoint p : corners) ring.push_back(latticePoint(p));
  return ring;
}

/// A rock above a tip, whose weight is right above it but for `aside`; in cells.
class OnATip {
 public:
  OnATip(double half, const std::vector<DoublePoint>& rock) {
    EXPECT_TRUE(ground.edit([&](World& world) -> Expected<void> {
      if (const auto done = world.fill({{-20, -1}, {20, -1}}, world.shape(kUnitSquare).value(), kFloor); !done)
        return tl::unexpected(done.error());
      if (const auto done = paint(world, {{-half, 0}, {half, 0}, {0, kTip}}, kFloor); !done) return done;
      return paint(world, rock, kFallen);
    }));
    EXPECT_EQ(rockCount(), 1);
  }
  /// Until it is ground. Whether that was soon.
  bool play() {
    for (int k = 0; k < 1'800 && rockCount() > 0; ++k) ground.step([&] { crowd.step(); });
    return rockCount() == 0;
  }
  int rockCount() const {
    int count = 0;
    ground.forEachRock([&](auto, const auto&) { ++count; });
    return count;
  }
  /// The middle of what it became.
  DoublePoint middle() const {
    std::vector<BodyPolygon> polygons;
    ground.world().forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
      if (p.block == kFallen) polygons.push_back({cell, p.block, {p.vertices.begin(), p.vertices.end()}});
    });
    return massOf(polygons).centroid;
  }

 private:
  static Expected<void> paint(World& world, const std::vector<DoublePoint>& corners, Block block) {
    const auto done = lgs::paint(world, {.rings = {ringOf(corners)}}, block, PaintMode::fill);
    if (!done) return tl::unexpected(done.error());
    return {};
  }

  Crowd crowd;
  box2d::Ground ground{{.isAnchor = [](Block block, Cell) { return block == kFloor; }}, crowd.physics};
};

/// Convex: as wide as it may be half way up, with a point or a side below and above.
std::vector<DoublePoint> anyRock(oracle::Random& random) {
  const double width = 0.3 + 0.1 * random.below(12), height = 0.3 + 0.1 * random.below(12);
  const double foot = width * random.below(4) / 3, top = width * random.below(4) / 3;
  const double x = 0.004 * (random.below(9) - 4), y = kTip + 0.02;
  std::vector<DoublePoint> corners{{x + foot, y}, {x + width, y + height / 2}, {x + top, y + height}};
  if (top > 0) corners.push_back({x - top, y + height});
  corners.push_back({x - width, y + height / 2});
  if (foot > 0) corners.push_back({x - foot, y});
  return corners;
}

LGS_LAW(GroundOfBox2dTips, NothingBecomesGroundOnATip, 60, (std::uint64_t seed)) {
  oracle::Random random(seed);
  OnATip game(0.05 + 0.05 * random.below(8), anyRock(random));
  EXPECT_TRUE(game.play()) << "it never came to rest";
  EXPECT_LT(game.middle().y, kTip) << "it is ground in balance";
}

}  // namespace
}  // namespace lgs::box2d_test
