// Law 2 without the grid (lgs/radial_match.h): on any directed edges, and on the boundaries of unions that CGAL made.
#include <lgs/radial_match.h>

#include "oracle/cgal/cgal_union.h"
#include "oracle/reference/canonical.h"
#include "proptests/support/fan.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <set>

namespace lgs::test {

using oracle::operator-;

/// Edges between places on a small lattice: many share an end, many coincide.
struct AnyEdges {
  std::vector<Point> points;
  std::vector<DirectedEdge> edges;
  static rc::Gen<AnyEdges> arbitrary();
  HalfEdge outgoing(std::uint32_t e) const { return {points[edges[e].to] - points[edges[e].from], true}; }
  HalfEdge incoming(std::uint32_t e) const { return {points[edges[e].from] - points[edges[e].to], false}; }
};

void showValue(const AnyEdges& any, std::ostream& out) {
  for (const DirectedEdge& e : any.edges)
    out << '(' << any.points[e.from].x << ", " << any.points[e.from].y << ") to (" << any.points[e.to].x << ", "
        << any.points[e.to].y << ")\n";
}

namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// Between places of a square of 4 by 4 points, by number.
AnyEdges edgesOf(const Pairs& ends) {
  AnyEdges any;
  for (int k = 0; k < 16; ++k) any.points.push_back({k % 4, k / 4});
  for (const auto& [from, to] : ends)
    if (from != to) any.edges.push_back({static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)});
  return any;
}

}  // namespace

rc::Gen<AnyEdges> AnyEdges::arbitrary() {
  const auto place = rc::gen::inRange(0, 16);
  return rc::gen::map(rc::gen::container<Pairs>(rc::gen::pair(place, place)), edgesOf);
}

namespace {

// --- Each link by itself ---------------------------------------------------------------------------------------------

/// The edge that law 2 says, of those that coincide the one with the greatest or the least index.
std::uint32_t linkByLaw(const AnyEdges& any, std::uint32_t edge, bool isPredecessor) {
  const std::uint32_t at = isPredecessor ? any.edges[edge].from : any.edges[edge].to;
  HalfEdges around;
  for (std::uint32_t e = 0; e < any.edges.size(); ++e) {
    if (isPredecessor && any.edges[e].to == at) around.push_back(any.incoming(e));
    if (!isPredecessor && any.edges[e].from == at) around.push_back(any.outgoing(e));
  }
  const auto first = metFirst(around, isPredecessor ? any.outgoing(edge) : any.incoming(edge));
  std::uint32_t found = kNoEdge;
  for (std::uint32_t e = 0; first && e < any.edges.size(); ++e) {
    const bool isThere = isPredecessor ? any.edges[e].to == at : any.edges[e].from == at;
    const HalfEdge there = isPredecessor ? any.incoming(e) : any.outgoing(e);
    if (isThere && pointAlike(there, *first) && (isPredecessor || found == kNoEdge)) found = e;
  }
  return found;
}

LGS_LAW(RadialMatch, IsLaw2OnAnyEdges, 4'000, (const AnyEdges& any)) {
  const auto links = must(radialMatch(any.points, any.edges));
  ASSERT_EQ(links.size(), any.edges.size());
  for (std::uint32_t e = 0; e < any.edges.size(); ++e) {
    EXPECT_EQ(links[e].predecessor, linkByLaw(any, e, true)) << "before edge " << e;
    EXPECT_EQ(links[e].successor, linkByLaw(any, e, false)) << "after edge " << e;
  }
}

LGS_LAW(RadialMatch, LoopsAreTheCyclesOfMutualLinks, 4'000, (const AnyEdges& any)) {
  const std::vector<EdgeLinks> links = radialMatch(any.points, any.edges).value();
  std::set<std::uint32_t> inLoops;
  std::uint32_t before = 0;
  for (const std::vector<std::uint32_t>& loop : loopsOf(links)) {
    EXPECT_EQ(loop.front(), *std::ranges::min_element(loop));
    EXPECT_TRUE(inLoops.empty() || before < loop.front()) << "not sorted";
    before = loop.front();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      EXPECT_TRUE(inLoops.insert(loop[k]).second) << "in two loops, or twice in one";
      const std::uint32_t next = loop[(k + 1) % loop.size()];
      EXPECT_EQ(links[loop[k]].successor, next);
      EXPECT_EQ(links[next].predecessor, loop[k]);
    }
  }
  for (std::uint32_t e = 0; e < links.size(); ++e) {  // whoever comes back along mutual links is in a loop
    std::uint32_t at = e;
    for (std::size_t steps = 0; steps < links.size() && at != kNoEdge; ++steps) {
      const std::uint32_t next = links[at].successor;
      at = next != kNoEdge && links[next].predecessor == at ? next : kNoEdge;
      if (at == e) break;
    }
    EXPECT_EQ(inLoops.contains(e), at == e && links[e].successor != kNoEdge);
  }
}

// --- Against the boundaries of unions --------------------------------------------------------------------------------

/// An outline's segments as edges, in any order.
AnyEdges edgesOf(const oracle::Outline& outline, Chance chance) {
  AnyEdges any;
  std::map<Point, std::uint32_t> numbers;
  const auto numberOf = [&](Point p) {
    const auto [at, isNew] = numbers.try_emplace(p, static_cast<std::uint32_t>(any.points.size()));
    if (isNew) any.points.push_back(p);
    return at->second;
  };
  for (const oracle::OutlineSegment& s : outline) any.edges.push_back({numberOf(s.start), numberOf(s.end)});
  for (std::size_t k = any.edges.size(); k > 1; --k) std::swap(any.edges[k - 1], any.edges[chance.below(k)]);
  return any;
}

LGS_LAW(RadialMatch, GivesTheFreeFacesOfAnyUnion, 400, (const PlainTrace& trace, Chance chance)) {
  oracle::Player player({});
  playAll(trace, player);
  const auto united = must(oracle::cgalUnion(player.scene()));
  const AnyEdges any = edgesOf(united.outline, chance);
  const auto links = must(radialMatch(any.points, any.edges));
  oracle::Loops loops;
  std::size_t edges = 0;
  for (const std::vector<std::uint32_t>& loop : loopsOf(links)) {
    edges += loop.size();
    loops.emplace_back();
    for (const std::uint32_t e : loop) loops.back().push_back(any.points[any.edges[e].from]);
  }
  EXPECT_EQ(edges, any.edges.size()) << "the boundary of a union has loops only";
  EXPECT_EQ(oracle::canonical(std::move(loops)), oracle::canonical(united.loops));
}

// --- What is refused, and the ends of the range ----------------------------------------------------------------------

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
