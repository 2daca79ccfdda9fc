// Which polygons a brush may meet, which of its changes are blamed on it (law 9), and where it cuts rims (law 10).
#include "oracle/check/reach.h"
#include "oracle/check/rims.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <utility>

namespace lgs::oracle::reaching {
namespace {

using test::U;
using Ring = std::vector<Point>;  // in eighths of a cell

Ring box(std::int64_t left, std::int64_t bottom, std::int64_t right, std::int64_t top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

BrushEdit brush(std::vector<Ring> rings, bool isEvenOdd = true) {
  for (Ring& ring : rings)
    for (Point& p : ring) p = {p.x * U / 8, p.y * U / 8};
  return {.rings = std::move(rings), .isEvenOdd = isEvenOdd};
}

const ScenePolygon kSquare{{0, 0}, 1, test::eighths({{2, 2}, {6, 2}, {6, 6}, {2, 6}})};

// Whether they meet, whichever vertex each of the two begins with, and whichever way the ring runs around.
void expectMeets(Ring ring, bool meets, const std::string& what) {
  for (std::size_t k = 0; k < 2 * ring.size(); ++k) {
    if (k == ring.size()) std::reverse(ring.begin(), ring.end());
    ScenePolygon square = kSquare;
    for (int corner = 0; corner < 4; ++corner) {
      EXPECT_EQ(mayMeet(brush({ring}), square), meets) << what << ", from vertex " << k << ", corner " << corner;
      std::rotate(square.vertices.begin(), square.vertices.begin() + 1, square.vertices.end());
    }
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  }
}

TEST(CheckReach, OfOneRing) {
  expectMeets(box(7, 7, 8, 8), false, "beside it");
  expectMeets(box(0, 0, 1, 8), false, "along it");
  expectMeets(box(6, 6, 8, 8), true, "corner to corner");
  expectMeets(box(6, 3, 8, 5), true, "side to side");
  expectMeets(box(3, 0, 5, 8), true, "across it");
  expectMeets(box(3, 3, 5, 5), true, "within it");
  expectMeets(box(0, 0, 8, 8), true, "around it");
  expectMeets({{8, 4}, {8, 0}, {4, 0}}, true, "a corner on a slanted edge");
  expectMeets({{8, 3}, {8, 0}, {5, 0}}, false, "a corner near a slanted edge");
  expectMeets({{0, 0}, {8, 0}, {7, 2}, {8, 8}, {0, 8}}, true, "around it, with a vertex as high as its lower side");
  expectMeets({{4, 0}, {4, 2}}, true, "two vertices, which enclose nothing");
  expectMeets({{4, 0}, {4, 1}}, false, "two vertices below");
}

TEST(CheckReach, OfSeveralRings) {
  const std::vector<Ring> withAHole{box(0, 0, 8, 8), box(1, 1, 7, 7)}, twice{box(0, 0, 8, 8), box(0, 0, 7, 7)};
  EXPECT_FALSE(mayMeet(brush(withAHole), kSquare));
  EXPECT_TRUE(mayMeet(brush(withAHole, false), kSquare));
  EXPECT_TRUE(mayMeet(brush({{}, box(7, 7, 8, 8), box(5, 5, 7, 7)}), kSquare));
  EXPECT_FALSE(mayMeet(brush({{}, box(7, 7, 8, 8), box(7, 0, 8, 1)}), kSquare));
  EXPECT_FALSE(mayMeet(brush({box(7, 7, 8, 8)}, false), kSquare));
  EXPECT_FALSE(mayMeet(brush({}), kSquare));
}

TEST(CheckReach, BlamesWhatIsNeitherReachedNorBent) {
  Brushed done;
  done.edits = {Call::remove("a"), Call::add("b", {{0, 0}, 1, test::eighths({{6, 2}, {6, 6}, {2, 6}, {2, 2}})})};
  done.removed["a"] = kSquare;
  EXPECT_EQ(wrongReach(brush({box(5, 5, 8, 8)}), done), "a polygon of cell (0, 0) is as it was, but for its handle");
  done.edits[1].comes[0].shape[0][0].x -= 1;
  EXPECT_EQ(wrongReach(brush({box(7, 7, 8, 8)}), done), "'a' has changed, but is not reached");
  EXPECT_EQ(wrongReach(brush({box(5, 5, 8, 8)}), done), "");
  done.rounded = {"a"};
  EXPECT_EQ(wrongReach(brush({box(7, 7, 8, 8)}), done), "");
  BrushEdit over = brush({box(5, 5, 8, 8)});
  EXPECT_EQ(wrongReach(over, done), "'a' is said to be bent alone, but is reached");
  EXPECT_EQ(wrongReach(brush({box(6, 3, 8, 5)}), done), "") << "no vertex of it is inside";
  EXPECT_EQ(wrongReach(brush({box(5, 6, 7, 8)}), done), "") << "one is on the edge";
  over.staying = {1};
  EXPECT_EQ(wrongReach(over, done), "");
}

// An edge of the region crosses the line between two full cells a third of a unit below 3,001.
TEST(CheckRims, AreCutWhereTheRegionCrosses) {
  const auto edgeAt = [](std::int64_t x, std::int64_t y) { return Point{U + x, 3'000 + y}; };
  const BrushEdit stroke{.rings = {{edgeAt(-30, -10), edgeAt(15, 6), edgeAt(-20, 900)}}};
  const Scene full{{{{0, 0}, 1, test::unitSquare()}, {{1, 0}, 1, test::unitSquare()}}, {}};
  const auto isWrong = [&](std::int32_t y, Scene before) {
    const Scene after{{{{0, 0}, 1, {{0, 0}, {U, 0}, {U, y}, {U - 30, 2'990}}}}, {}};
    return !wrongRim(stroke, before, after).empty();
  };
  EXPECT_FALSE(isWrong(3'001, full));
  EXPECT_TRUE(isWrong(3'000, full));
  EXPECT_TRUE(isWrong(3'002, full));
  EXPECT_FALSE(isWrong(U, full)) << "a corner was there";
  Scene other = full;
  other.polygons.push_back({{0, 0}, 1, {{0, 2'999}, {U, 3'002}, {0, 4'000}}});
  EXPECT_FALSE(isWrong(3'002, other)) << "a vertex was there";
  other.polygons.back().vertices[1] = {U - 1, 3'002};
  EXPECT_FALSE(isWrong(3'002, other)) << "another edge comes near";
}

}  // namespace
}  // namespace lgs::oracle::reaching
