// Edges as plain values, and a copy of them that is kept by the reported changes alone.
#pragma once

#include "naive_edges.h"

#include <gtest/gtest.h>
#include <lgs/box2d/edges.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <vector>

namespace lgs::box2d_test {

using box2d::Edge;
using box2d::EdgeChanges;
using box2d::EdgeId;
using box2d::EdgeSet;

inline PlainEdge plain(const EdgeSet& set, EdgeId id) {
  const Edge& e = set.edge(id);
  return {e.first, e.last, set.chunk(e.chunk), e.start, e.end, e.ghost1, e.ghost2};
}

inline std::vector<PlainEdge> plain(const EdgeSet& set) {
  std::vector<PlainEdge> edges;
  for (const EdgeId id : set.edges()) edges.push_back(plain(set, id));
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Expects the edges that the rules say, and no others.
inline void expectEdgesOf(const World& world, const EdgeSet& set) {
  const NaiveEdges naive = NaiveBuilder(world, set.options()).build();
  EXPECT_EQ(plain(set), naive.edges);
  EXPECT_EQ(set.counts(), naive.counts);
  EXPECT_EQ(set.version(), world.version());
  for (const EdgeId id : set.edges()) EXPECT_EQ(set.edge(id).block, world.segment(set.edge(id).first)->block);
}

/// Whether two ghosts beside a place are different to an engine that knows directions alone. Coordinates are small
/// here.
inline bool isTurned(const std::optional<Point>& a, const std::optional<Point>& b, Point from, double shortest) {
  if (a == b) return false;
  if (!a || !b) return true;
  const double ax = static_cast<double>(a->x - from.x), ay = static_cast<double>(a->y - from.y);
  const double bx = static_cast<double>(b->x - from.x), by = static_cast<double>(b->y - from.y);
  if (std::hypot(ax, ay) < shortest || std::hypot(bx, by) < shortest) return true;
  return ax * by != ay * bx || ax * bx + ay * by <= 0;
}

/// A copy of the edges that is kept by the reported changes alone.
class Copy {
 public:
  /// After a roll-back an id may name another segment, with the same ends. Its edge is made anew.
  enum class Ids { fresh, mayReturn };

  void apply(const EdgeSet& set, const EdgeChanges& changes, Ids ids = Ids::fresh) {
    std::set<std::tuple<SegmentId, Point, Point>> gone;
    for (const EdgeId id : changes.removed) {
      ASSERT_TRUE(edges_.contains(id.value));
      gone.emplace(set.edge(id).first, set.edge(id).start, set.edge(id).end);
      const Edge& was = edges_.at(id.value);
      EXPECT_EQ(std::pair(was.start, was.end), std::pair(set.edge(id).start, set.edge(id).end));
      edges_.erase(id.value);
    }
    for (const EdgeId id : changes.added) {
      const Edge& edge = set.edge(id);
      EXPECT_TRUE(edges_.emplace(id.value, edge).second);
      if (ids == Ids::fresh) {
        EXPECT_FALSE(gone.contains({edge.first, edge.start, edge.end}));  // such an edge should have stayed
      }
    }
    std::vector<EdgeId> turned;
    for (const EdgeId id : changes.relinked) {
      ASSERT_TRUE(edges_.contains(id.value));
      Edge& edge = edges_.at(id.value);
      const Edge& now = set.edge(id);
      const double shortest = static_cast<double>(set.options().shortest);
      if (isTurned(edge.ghost1, now.ghost1, edge.start, shortest) ||
          isTurned(edge.ghost2, now.ghost2, edge.end, shortest))
        turned.push_back(id);
      EXPECT_NE(std::pair(edge.ghost1, edge.ghost2), std::pair(set.edge(id).ghost1, set.edge(id).ghost2));
      edge.ghost1 = set.edge(id).ghost1;
      edge.ghost2 = set.edge(id).ghost2;
    }
    EXPECT_EQ(changes.turned, turned);
    ASSERT_EQ(edges_.size(), set.edges().size());
    for (const EdgeId id : set.edges()) {
      ASSERT_TRUE(edges_.contains(id.value));
      Edge expected = set.edge(id);
      expected.last = edges_.at(id.value).last;  // another segment with the same end may have taken its place
      EXPECT_EQ(edges_.at(id.value), expected);
    }
  }

 private:
  std::map<std::uint32_t, Edge> edges_;
};

}  // namespace lgs::box2d_test
