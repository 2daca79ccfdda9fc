// What judges a world's answers about places complains where the world has a segment that it was not told of, or lacks
// one. That it agrees with a right world each run of the checker shows.
#include "oracle/check/questions.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>
#include <string>

namespace lgs::oracle::asking {
namespace {

using test::place;
using test::U;

/// A square, a ramp beside it that does not touch it, and a polygon with a notch.
World someWorld() {
  World world;
  place(world, {0, 0}, test::unitSquare(), 1);
  place(world, {2, 0}, test::ramp(), 2);
  place(world, {0, 2}, test::eighths({{0, 0}, {8, 0}, {8, 8}, {5, 8}, {5, 3}, {3, 3}, {3, 8}, {0, 8}}), 3);
  world.commit();
  return world;
}

// Of two cells the left one comes first, although its polygon has the greater handle.
TEST(CheckQuestions, AgreesAboutAPlaceBetweenTwoChunks) {
  World world;
  const PolygonHandle right = place(world, {0, 0}, test::unitSquare()),
                      left = place(world, {-1, 0}, test::unitSquare());
  ASSERT_LT(right, left);
  EXPECT_EQ(world.at({0, U / 2}).polygon, left);
  EXPECT_EQ(wrongSpot(world, {0, U / 2}), "");
}

TEST(CheckQuestions, SeesASegmentTooManyAndOneTooFew) {
  const World world = someWorld(), nothing;
  const std::vector<Segment> segments = segmentsOf(world), one(segments.begin(), segments.begin() + 1);
  const std::string near = "nearest((-1, 0), 1) finds ", ray = "rayCast((-1, 1), (65536, 1)) meets ";
  EXPECT_EQ(wrongNearest(world, {}, {-1, 0}, 1), near + "a segment too many, or none");
  EXPECT_EQ(wrongNearest(nothing, segments, {-1, 0}, 1), near + "a segment too many, or none");
  EXPECT_EQ(wrongRay(world, {}, {-1, 1}, {U, 1}), ray + "a segment too many, or none");
  EXPECT_EQ(wrongRay(nothing, segments, {-1, 1}, {U, 1}), ray + "a segment too many, or none");
}

TEST(CheckQuestions, SeesAnotherSegment) {
  const World world = someWorld();
  std::vector<Segment> segments = segmentsOf(world);
  std::erase_if(segments, [](const Segment& s) { return s.start.x == 0 && s.end.x == 0; });
  EXPECT_EQ(wrongNearest(world, segments, {-1, U / 2}, 1), "nearest((-1, 32768), 1) finds another segment");
  std::erase_if(segments, [](const Segment& s) { return s.block != 2; });
  EXPECT_EQ(wrongRay(world, segments, {-1, 1}, {3 * U, 1}), "rayCast((-1, 1), (196608, 1)) meets another segment");
}

TEST(CheckQuestions, AsksWhereSomethingHappens) {
  World world;
  place(world, {0, 0}, test::unitSquare());
  world.commit();
  Random random(1);
  int onTheOutline = 0, farRight = 0, farAbove = 0;  // of the square
  for (int k = 0; k < 1'000; ++k) {
    const Point p = somePoint(world, random);
    if (world.at(p).where == Spot::Where::edge) ++onTheOutline;
    if (p.x > 2 * U) ++farRight;
    if (p.y > 2 * U) ++farAbove;
  }
  EXPECT_GT(onTheOutline, 250);
  EXPECT_GT(farRight, 50);
  EXPECT_GT(farAbove, 50);
}

}  // namespace
}  // namespace lgs::oracle::asking
