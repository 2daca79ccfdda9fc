// Law 2 without the grid (lgs/radial_match.h), where no random edges lead (oracle/check/laws/edges.cpp has those).
#include <lgs/radial_match.h>

#include <gtest/gtest.h>

#include <span>
#include <utility>
#include <vector>

namespace lgs::test {
namespace {

TEST(RadialMatchOfEdges, RefusesWhatHasNoDirectionOrIsTooLong) {
  const Point points[] = {{0, 0},
                          {5, 5},
                          {0, 0},
                          {kMaxEdgeLength + 1, 0},
                          {kMaxCoordinate + 1, 0},
                          {INT64_MIN, 0},
                          {0, -kMaxEdgeLength - 1}};
  for (const DirectedEdge bad : {DirectedEdge{1, 1}, {0, 2}, {0, 7}, {7, 0}, {0, 3}, {0, 6}, {1, 4}, {1, 5}}) {
    const DirectedEdge edges[] = {{0, 1}, bad};
    const auto links = radialMatch(points, edges);
    ASSERT_FALSE(links) << bad.from << " to " << bad.to;
    EXPECT_EQ(links.error().code, ErrorCode::outOfReach);
    EXPECT_EQ(links.error().index, 1);
  }
  EXPECT_TRUE(radialMatch({}, {}).value().empty());
  EXPECT_TRUE(loopsOf({}).empty());
}

TEST(RadialMatchOfEdges, IsExactAtTheEndsOfTheRange) {
  constexpr std::int64_t kEnd = kMaxCoordinate, kLong = kMaxEdgeLength;
  // Two edges that leave a corner of the world nearly in one direction, and one that comes in between them.
  const Point points[] = {{-kEnd, -kEnd},
                          {-kEnd + kLong, -kEnd + kLong - 1},
                          {-kEnd + kLong - 1, -kEnd + kLong},
                          {-kEnd + kLong, -kEnd + kLong}};
  const DirectedEdge edges[] = {{0, 1}, {0, 2}, {3, 0}};
  const std::vector<EdgeLinks> links = radialMatch(points, edges).value();
  EXPECT_EQ(links[2].successor, 1U) << "counter-clockwise from the diagonal comes the steeper one";
  EXPECT_EQ(links[0].predecessor, 2U);
  EXPECT_EQ(links[1].predecessor, 2U);
}

TEST(RadialMatchOfEdges, AStarOfManyEdgesTakesNoSquareOfTime) {
  std::vector<Point> points{{0, 0}};
  std::vector<DirectedEdge> edges;
  for (std::int64_t k = 1; k <= 200'000; ++k) {
    points.push_back({k, 1'000'000});
    edges.push_back({0, static_cast<std::uint32_t>(k)});  // one comes in, all others go out
  }
  std::swap(edges.back().from, edges.back().to);
  const std::vector<EdgeLinks> links = radialMatch(points, edges).value();
  for (const EdgeLinks& l : std::span(links).first(links.size() - 1)) ASSERT_EQ(l.predecessor, edges.size() - 1);
}

}  // namespace
}  // namespace lgs::test
