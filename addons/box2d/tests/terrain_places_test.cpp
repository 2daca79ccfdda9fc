// What is near a place, and places after the origin moved: for whichever Box2D there is.
#include "distances.h"
#include "either.h"
#include "played.h"
#include "proptests/support/scale.h"

#include <tuple>

namespace lgs::box2d_test {
namespace {

using box2d::Terrain;
using box2d::TerrainOptions;

using Box2dPlaces = EitherBox2d;

TEST_F(Box2dPlaces, NearestIsTheLeastOfAllDistances) {
  forAllEdits(60, [&](const Trace& trace, Chance random) {
    TerrainOptions options{.cellSize = random.pick(std::vector<double>{0.3, 1, 7}), .merge = random.chance(50)};
    options.origin = firstCell(trace);
    oracle::Player player(trace.preserve);
    Terrain terrain(physics, player.world(), options);
    const auto size = static_cast<float>(options.cellSize);
    playAll(trace, player, [&] {
      terrain.commit(player.world());
      const Position p{between(random, -3, 8) * size, between(random, -3, 8) * size};
      const float radius = between(random, 0, 4) * size;
      if (!inRange(box2d::Frame{options.cellSize, options.origin}.latticePoint(placeOf(p)))) {
        EXPECT_FALSE(terrain.nearest(p, radius));
        return;
      }
      double least = std::numeric_limits<double>::infinity();
      for (const SegmentId id : player.world().segments())
        least = std::min(least, distanceTo(terrain, *player.world().segment(id), placeOf(p)));
      const double slack = 1e-3 * options.cellSize;
      if (std::abs(least - radius) < slack) return;
      const auto nearest = terrain.nearest(p, radius);
      ASSERT_EQ(nearest.has_value(), least < radius);
      if (!nearest) return;
      EXPECT_NEAR(nearest->distance, least, slack);
      EXPECT_NEAR(std::hypot(nearest->point.x - p.x, nearest->point.y - p.y), least, slack);
      const Segment s = *player.world().segment(nearest->hit.segment);
      EXPECT_NEAR(distanceTo(terrain, s, placeOf(nearest->point)), 0, slack);
      EXPECT_EQ(std::tie(nearest->hit.polygon, nearest->hit.block, nearest->hit.cell),
                std::tie(s.polygon, s.block, s.cell));
      EXPECT_NEAR(nearest->normal.x, s.normal().x, 1e-6);
      EXPECT_NEAR(nearest->normal.y, s.normal().y, 1e-6);
    });
  });
}

TEST_F(Box2dPlaces, NearestFarAwayAndOutOfReach) {
  constexpr Cell kRemote{1 << 29, -(1 << 29)};
  field.add(kRemote, kSquare, 5);
  field.world.commit();
  const Terrain terrain(physics, field.world, {.cellSize = 0.5, .origin = kRemote});
  const auto nearest = terrain.nearest({0.25F, 0.75F}, 1'000'000);  // more than kMaxRadius cells
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->point.x, 0.25F);
  EXPECT_EQ(nearest->point.y, 0.5F);
  EXPECT_EQ(nearest->normal.x, 0);
  EXPECT_EQ(nearest->normal.y, 1);
  EXPECT_EQ(nearest->distance, 0.25F);
  EXPECT_EQ(nearest->hit.block, 5U);
  EXPECT_FALSE(terrain.nearest({0.25F, 0.75F}, 0.2F));
  EXPECT_FALSE(terrain.nearest({0.25F, 0.75F}, -1));
  const float notANumber = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(terrain.nearest({0.25F, notANumber}, 1));
  EXPECT_FALSE(terrain.nearest({0.25F, 0.75F}, notANumber));
  EXPECT_FALSE(terrain.nearest({1e30F, 0}, 1));
}

TEST_F(Box2dPlaces, AfterTheOriginMovedAllIsAsInATerrainMadeThere) {
  forAllEdits(40, [&](const Trace& trace, Chance random) {
    TerrainOptions options{.cellSize = random.chance(50) ? 1 : 0.3, .chunkCells = 1 + random.below(5)};
    options.origin = firstCell(trace);
    oracle::Player player(trace.preserve);
    Terrain terrain(physics, player.world(), options);
    playAll(trace, player, [&] {
      terrain.commit(player.world());
      const Cell first = firstCell(trace);
      options.origin = {first.i - random.below(1'000), first.j + random.below(1'000)};
      terrain.moveOrigin(options.origin);
      expectEdges(terrain, options);
      if (inRange(options.origin)) {  // another cell is none of the world
        EXPECT_EQ(terrain.cellAt({0, 0}), options.origin);
      } else {
        EXPECT_FALSE(inRange(terrain.cellAt({0, 0})));
      }
    });
  });
}

// Within 100 cells of the origin a float tells all lattice points apart.
TEST_F(Box2dPlaces, TheLatticePointOfAPositionIsThePoint) {
  test::forAll(100, [&](Chance random) {
    const auto coordinate = [&](std::int32_t most) { return random.below(2 * most + 1) - most; };
    const double size = random.pick(std::vector<double>{0.01, 0.3, 0.5, 1, 7});
    Cell origin{coordinate(kMaxCell - 1'000), coordinate(kMaxCell - 1'000)};
    Terrain terrain(physics, field.world, {.cellSize = size, .origin = origin});
    for (const bool moves : {false, true}) {
      if (moves) {
        origin = {origin.i + coordinate(1'000), origin.j + coordinate(1'000)};
        terrain.moveOrigin(origin);
      }
      for (int k = 0; k < 20; ++k) {
        const Cell cell{origin.i + coordinate(99), origin.j + coordinate(99)};
        const Point p = toWorld(cell, {random.below(U + 1), random.below(U + 1)});
        EXPECT_EQ(terrain.latticePoint(terrain.position(p)), p) << "cells of " << size << " m";
      }
    }
  });
}

TEST_F(Box2dPlaces, AClickLeadsToThePolygonThere) {
  field.addFloor(0, 5);
  const PolygonHandle ramp = field.add({2, 0}, below(0, 8), 7);
  field.world.commit();
  Terrain terrain(physics, field.world, {.cellSize = 0.5});
  const auto clicked = [&](float x, float y) { return field.world.at(terrain.latticePoint({x, y})); };
  EXPECT_EQ(clicked(1.4F, 0.1F).polygon, ramp);
  EXPECT_EQ(clicked(1.4F, 0.1F).block, 7U);
  EXPECT_EQ(clicked(1.1F, 0.4F).where, Spot::Where::outside);  // above the ramp
  terrain.moveOrigin({2, -1});
  EXPECT_EQ(clicked(0.4F, 0.6F).polygon, ramp);
  EXPECT_EQ(clicked(1.4F, 0.1F).cell, (Cell{4, -1}));
  EXPECT_FALSE(inRange(terrain.latticePoint({1e30F, 0})));
  EXPECT_FALSE(inRange(terrain.latticePoint({0, std::numeric_limits<float>::quiet_NaN()})));
}

}  // namespace
}  // namespace lgs::box2d_test
