// Rides in Box2D 2.4: the terrain is as smooth as chains built from CGAL's union of the whole world, wherever cells and
// chunks end. A fixture for each polygon is not.
#include "addons/box2d/ride/ride.h"

#include "fields.h"

#include <algorithm>
#include <cmath>

namespace lgs::box2d_test {
namespace {

using bench::Deviation;
using bench::RideOptions;
using bench::Rider;
using bench::Track;
using bench::Way;

constexpr Rider kRiders[] = {Rider::circle, Rider::box, Rider::capsule, Rider::polygon};

// The most that speed and height change after the body has settled.
struct Unrest {
  float along = 0;
  float vertical = 0;
  float height = 0;
};

Unrest unrestOf(const Track& track, float speed) {
  constexpr std::size_t kSettled = 60;
  Unrest most;
  float low = track.samples[kSettled].position.y;
  float high = low;
  for (std::size_t k = kSettled; k < track.samples.size(); ++k) {
    const bench::Sample& s = track.samples[k];
    most.along = std::max(most.along, std::abs(s.velocity.x - speed));
    most.vertical = std::max(most.vertical, std::abs(s.velocity.y));
    low = std::min(low, s.position.y);
    high = std::max(high, s.position.y);
  }
  most.height = high - low;
  return most;
}

RideOptions slide(Rider rider, float speed) {
  RideOptions options;
  options.rider = rider;
  options.size = 0.8;
  options.start = {1, 0.47F};
  options.velocity = {speed, 0};
  options.steps = static_cast<int>(60 * 200 / speed);
  options.fixedRotation = rider != Rider::circle;
  return options;
}

TEST(Box2dRide, AFrictionlessFloorOfCellsIsAsSmoothAsOneLongEdge) {
  const Field field = floorOf200Cells();
  for (const Rider rider : kRiders) {
    for (const float speed : {3.0F, 10.0F}) {
      RideOptions options = slide(rider, speed);
      const Unrest edge = unrestOf(ride(field.world, field.scene, Way::straight, options), speed);
      for (const std::int32_t chunk : {1, 5, 16, 512}) {
        for (const Way way : {Way::terrain, Way::merged}) {
          SCOPED_TRACE(testing::Message()
                       << name(rider) << ' ' << speed << " m/s, chunks of " << chunk << ", " << name(way));
          options.terrain.chunkCells = chunk;
          const Track track = ride(field.world, field.scene, way, options);
          const Unrest cells = unrestOf(track, speed);
          EXPECT_LE(cells.along, edge.along + 1e-5F);
          EXPECT_LE(cells.vertical, edge.vertical + 1e-5F);
          EXPECT_LE(cells.height, edge.height + 2e-4F);
          EXPECT_TRUE(track.kicks.empty());
          EXPECT_GT(track.samples.back().position.x, 199);
        }
      }
    }
  }
}

// The control. If there were no bumps here, the other rides would prove nothing.
TEST(Box2dRide, AFixtureForEachPolygonBumps) {
  const Field field = floorOf200Cells();
  for (const Way way : {Way::polygons, Way::loose}) {
    SCOPED_TRACE(name(way));
    const Track track = ride(field.world, field.scene, way, slide(Rider::circle, 3));
    const Unrest cells = unrestOf(track, 3);
    EXPECT_GT(static_cast<double>(track.kicks.size()) / track.length, 0.2);  // a kick every five cells
    EXPECT_GT(cells.along, 0.5F);
    EXPECT_GT(cells.vertical, 0.2F);
    EXPECT_LT(track.samples.back().position.x, 180);
  }
}

// --- Floor, slopes and map, compared with CGAL -----------------------------------------------------------------------

// Compares the terrain with CGAL's chains: the contacts are the same, and the path is the same within rounding.
void expectSamePath(const Field& field, RideOptions options, float tolerance) {
  const Track chains = ride(field.world, field.scene, Way::chains, options);
  for (const std::int32_t chunk : {3, 16}) {
    SCOPED_TRACE(testing::Message() << name(options.rider) << ", chunks of " << chunk);
    options.terrain.chunkCells = chunk;
    const Track terrain = ride(field.world, field.scene, Way::terrain, options);
    const Deviation apart = deviation(terrain, chains);
    EXPECT_LE(apart.position, tolerance);
    EXPECT_LE(apart.contacts, terrain.samples.size() / 50);  // rounding decides when a touch begins
    EXPECT_EQ(terrain.kicks.size(), chains.kicks.size());
    EXPECT_GT(terrain.length, 15);
  }
}

TEST(Box2dRide, AFloorOfCellsIsAsWithCgal) {
  const Field field = floorOf200Cells();
  for (const Rider rider : kRiders) {
    for (const float speed : {3.0F, 10.0F}) {
      SCOPED_TRACE(speed);
      expectSamePath(field, slide(rider, speed), 1e-3F);
    }
  }
}

TEST(Box2dRide, SlopesAndTransitionsAreAsWithCgal) {
  for (const Profile& profile : profiles()) {
    for (const bool ceiling : {false, true}) {
      SCOPED_TRACE(testing::Message() << profile.name << (ceiling ? ", as a ceiling" : ""));
      const Field field = hilly(profile, ceiling);
      for (const Rider rider : kRiders) {
        RideOptions options;
        options.rider = rider;
        options.start = ceiling ? b2Vec2(0.3F, -0.6F) : b2Vec2(0.7F, 1.6F);
        options.velocity = {ceiling ? -3.0F : 3.0F, 0};
        options.gravity = {0, ceiling ? 10.0F : -10.0F};
        options.drive = ceiling ? -3 : 3;
        options.friction = rider == Rider::circle ? 0.5F : 0;
        options.fixedRotation = rider != Rider::circle;
        options.steps = 900;
        options.terrain.material = [](Block) { return box2d::Material{.friction = 0.5F}; };
        expectSamePath(field, options, 1e-3F);
      }
    }
  }
}

TEST(Box2dRide, TheProjectsMapIsAsWithCgal) {
  const Field field = landscape();
  for (const Rider rider : kRiders) {
    for (const float speed : {3.0F, 8.0F}) {
      SCOPED_TRACE(speed);
      RideOptions options;
      options.rider = rider;
      options.start = {6, -10};
      options.velocity = {speed, 0};
      options.drive = speed;
      options.friction = 0.5F;
      // These two tumble over their ends and double the rounding at each fall.
      options.fixedRotation = rider == Rider::polygon || rider == Rider::capsule;
      options.steps = 1'200;
      expectSamePath(field, options, 5e-3F);
    }
  }
}

}  // namespace
}  // namespace lgs::box2d_test
