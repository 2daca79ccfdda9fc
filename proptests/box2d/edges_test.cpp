// The core of the Box2D adapters: rules 1 to 3 of <lgs/box2d/edges.h>, and that edits change nothing but what changed.
#include "oracle/check/generator.h"
#include "oracle/check/random.h"
#include "oracle/reference/canonical.h"
#include "oracle/trace/player.h"

#include "naive_edges.h"

#include <gtest/gtest.h>
#include <lgs/box2d/edges.h>
#include <algorithm>
#include <map>
#include <set>

namespace lgs::box2d {
namespace {

using oracle::Player;
using oracle::Random;

constexpr std::int32_t U = kUnitsPerCell;

using box2d_test::NaiveBuilder;
using box2d_test::NaiveEdges;
using Plain = box2d_test::PlainEdge;

Plain plain(const EdgeSet& set, EdgeId id) {
  const Edge& e = set.edge(id);
  return {e.first, e.last, set.chunk(e.chunk), e.start, e.end, e.ghost1, e.ghost2};
}

std::vector<Plain> plain(const EdgeSet& set) {
  std::vector<Plain> edges;
  for (const EdgeId id : set.edges()) edges.push_back(plain(set, id));
  std::sort(edges.begin(), edges.end());
  return edges;
}

// A copy of the edges that is kept by the reported changes alone.
class Copy {
 public:
  void apply(const EdgeSet& set, const EdgeChanges& changes) {
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
      EXPECT_FALSE(gone.contains({edge.first, edge.start, edge.end}));  // then it should not have been touched
    }
    for (const EdgeId id : changes.relinked) {
      ASSERT_TRUE(edges_.contains(id.value));
      Edge& edge = edges_.at(id.value);
      EXPECT_NE(std::pair(edge.ghost1, edge.ghost2), std::pair(set.edge(id).ghost1, set.edge(id).ghost2));
      edge.ghost1 = set.edge(id).ghost1;
      edge.ghost2 = set.edge(id).ghost2;
    }
    ASSERT_EQ(edges_.size(), set.edges().size());
    for (const EdgeId id : set.edges()) {
      ASSERT_TRUE(edges_.contains(id.value));
      Edge expected = set.edge(id);
      expected.last = edges_.at(id.value).last;  // may be another of the same end
      EXPECT_EQ(edges_.at(id.value), expected);
    }
  }

 private:
  std::map<std::uint32_t, Edge> edges_;
};

// What holds of any set of edges, whatever the options.
void expectLaws(const World& world, const EdgeSet& set) {
  const EdgeCounts counts = set.counts();
  EXPECT_EQ(counts.segments, world.segments().size());
  EXPECT_EQ(counts.edges, set.edges().size());
  std::size_t covered = 0;
  for (const EdgeId id : set.edges()) {
    const Edge& e = set.edge(id);
    const std::int64_t x = e.end.x - e.start.x;
    const std::int64_t y = e.end.y - e.start.y;
    EXPECT_GE(x * x + y * y, set.options().shortest * set.options().shortest);
    Segment s = *world.segment(e.first);
    EXPECT_EQ(s.start, e.start);
    EXPECT_EQ(s.block, e.block);
    EXPECT_EQ((Frame{1, {}, set.options().chunkCells}.chunkOf(s.cell)), set.chunk(e.chunk));
    for (++covered; s.id != e.last; ++covered) {
      EXPECT_EQ(set.edgeOf(s.id), id);
      s = *world.segment(s.successor);
    }
    EXPECT_EQ(set.edgeOf(s.id), id);
    EXPECT_EQ(s.end, e.end);
  }
  EXPECT_EQ(covered + counts.leftOut, counts.segments);
}

EdgeOptions randomOptions(Random& random) {
  constexpr std::int64_t kShortest[] = {0, 1, 400, U / 8, U / 2, U + 1, std::int64_t{2} * U};
  EdgeOptions options;
  options.chunkCells = 1 + random.below(5);
  options.shortest = random.chance(40) ? 0 : kShortest[random.below(std::size(kShortest))];
  options.merge = random.chance(60);
  if (random.chance(50)) options.material = [](Block block) { return block % 2; };
  return options;
}

TEST(Box2dEdges, UpdatesEqualTheRulesAndChangesAreExact) {
  constexpr std::uint64_t kCases = 300;
  EdgeCounts seen;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const EdgeOptions options = randomOptions(random);
    const oracle::Trace trace = oracle::randomCase({.width = 5, .height = 4, .edits = 60}, seed);
    Player player(trace.preserve);
    EdgeSet set(options);
    Copy copy;
    copy.apply(set, set.load(player.world()));
    const auto update = [&] {
      const Changes& changes = player.commit();
      copy.apply(set, set.update(player.world(), changes));
      EdgeSet fresh(options);
      fresh.load(player.world());
      EXPECT_EQ(plain(set), plain(fresh));
      EXPECT_EQ(set.counts(), fresh.counts());
      const NaiveEdges naive = NaiveBuilder(player.world(), options).build();
      EXPECT_EQ(plain(set), naive.edges);
      EXPECT_EQ(set.counts(), naive.counts);
      expectLaws(player.world(), set);
      seen.merged += set.counts().merged;
      seen.welded += set.counts().welded;
      seen.leftOut += set.counts().leftOut;
    };
    for (const oracle::Edit& edit : trace.edits) {
      if (edit.kind == oracle::Edit::Kind::commit) {
        update();
      } else {
        (void)player.apply(edit);  // some are there to be refused
      }
      if (HasFailure()) return;
    }
    update();
  }
  // The cases are of use only if they get there.
  EXPECT_GT(seen.merged, 1'000U);
  EXPECT_GT(seen.welded, 1'000U);
  EXPECT_GT(seen.leftOut, 1'000U);
}

TEST(Box2dEdges, WithoutMergingEverySegmentIsAnEdge) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const oracle::Trace trace = oracle::randomCase({.width = 4, .height = 4, .edits = 60}, seed);
    Player player(trace.preserve);
    for (const oracle::Edit& edit : trace.edits) (void)player.apply(edit);
    player.commit();
    EdgeSet set({});
    set.load(player.world());
    ASSERT_EQ(set.counts().single, player.world().segments().size());
    for (const SegmentId id : player.world().segments()) {
      const Segment s = *player.world().segment(id);
      const Edge& e = set.edge(set.edgeOf(id));
      EXPECT_EQ(std::pair(e.start, e.end), std::pair(s.start, s.end));
      EXPECT_EQ(e.ghost1, s.predecessor ? std::optional(s.ghost1) : std::nullopt);
      EXPECT_EQ(e.ghost2, s.successor ? std::optional(s.ghost2) : std::nullopt);
    }
  }
}

TEST(Box2dEdges, MergedInOneChunkTheyAreTheMergedLoops) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const oracle::Trace trace = oracle::randomCase({.width = 4, .height = 4, .edits = 60}, seed);
    if (!trace.preserve.empty()) continue;
    Player player(trace.preserve);
    for (const oracle::Edit& edit : trace.edits) {
      oracle::Edit near = edit;  // cases may lie anywhere; here all is to be in one chunk
      near.polygon.cell = {near.polygon.cell.i & 1023, near.polygon.cell.j & 1023};
      (void)player.apply(near);
    }
    player.commit();
    EdgeSet set({.chunkCells = 4'096, .merge = true});
    set.load(player.world());
    std::vector<std::pair<Point, Point>> expected;
    for (const Loop& loop : player.world().loops(Collinear::merge)) {
      for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
        expected.emplace_back(loop.vertices[k], loop.vertices[(k + 1) % loop.vertices.size()]);
      }
    }
    std::vector<std::pair<Point, Point>> actual;
    for (const EdgeId id : set.edges()) actual.emplace_back(set.edge(id).start, set.edge(id).end);
    std::sort(expected.begin(), expected.end());
    std::sort(actual.begin(), actual.end());
    // loops() keeps vertices where chains touch; merging an edge straight through one is right all the same.
    EXPECT_LE(actual.size(), expected.size());
    if (actual.size() == expected.size()) {
      EXPECT_EQ(actual, expected);
    }
  }
}

TEST(Box2dEdges, AnIdThatNeverWasHasNoEdge) {
  World world;
  ASSERT_TRUE(world.add({0, 0}, *world.shape(kUnitSquare), 1));
  world.commit();
  EdgeSet set({});
  set.load(world);
  EXPECT_TRUE(set.edgeOf({world.maxSegmentId()}));
  EXPECT_FALSE(set.edgeOf({world.maxSegmentId() + 1}));
  EXPECT_FALSE(set.edgeOf({0xffff'ffff}));
}

// --- By hand -----------------------------------------------------------------------------------------------------------

class Hand : public testing::Test {
 protected:
  void add(Cell cell, const std::vector<LocalPoint>& polygon, Block block = 1) {
    ASSERT_TRUE(world.add(cell, std::span<const LocalPoint>(polygon), block).has_value());
  }
  void addSquare(Cell cell, Block block = 1) { ASSERT_TRUE(world.add(cell, *world.shape(kUnitSquare), block)); }
  World world;
};

using Box2dEdgesByHand = Hand;

TEST_F(Box2dEdgesByHand, ALongFloorIsOneEdgeAChunkAndMaterial) {
  for (std::int32_t i = 0; i < 8; ++i) addSquare({i, 0}, i < 6 ? 1 : 2);
  world.commit();
  EdgeSet one({.chunkCells = 4, .merge = true});
  one.load(world);
  EXPECT_EQ(one.counts().edges, 6U);  // top and bottom in two chunks, and the sides
  EdgeSet two({.chunkCells = 4, .merge = true, .material = [](Block block) { return block; }});
  two.load(world);
  EXPECT_EQ(two.counts().edges, 8U);  // the second chunk has two materials
}

TEST_F(Box2dEdgesByHand, AHoleSplitsAnEdgeAndFillingJoinsItAgain) {
  for (std::int32_t i = 0; i < 5; ++i) addSquare({i, 0});
  world.commit();
  EdgeSet set({.merge = true});
  set.load(world);
  EXPECT_EQ(set.counts().edges, 4U);
  const auto handle = world.polygons({2, 0})[0].handle;
  ASSERT_TRUE(world.remove(handle));
  const EdgeChanges& dug = set.update(world, world.commit());
  EXPECT_EQ(dug.removed.size(), 2U);
  EXPECT_EQ(set.counts().edges, 8U);
  addSquare({2, 0});
  set.update(world, world.commit());
  EXPECT_EQ(set.counts().edges, 4U);
}

TEST_F(Box2dEdgesByHand, AShortStepIsLeftOutAndGhostsLookAcross) {
  add({0, 0}, {{0, 0}, {U, 0}, {U, 100}, {0, 100}});  // sides of 100 units
  world.commit();
  EdgeSet set({.shortest = 328});
  set.load(world);
  EXPECT_EQ(set.counts().leftOut, 2U);
  ASSERT_EQ(set.counts().edges, 2U);
  for (const EdgeId id : set.edges()) {
    const Edge& e = set.edge(id);
    const std::int64_t other = 100 - e.start.y;
    EXPECT_EQ(e.ghost1, std::optional(Point{e.end.x, other}));
    EXPECT_EQ(e.ghost2, std::optional(Point{e.start.x, other}));
  }
}

TEST_F(Box2dEdgesByHand, ManyShortOnesAreWelded) {
  std::vector<LocalPoint> polygon{{0, 0}, {U, 0}, {U, U / 2}};
  for (std::int32_t k = 1; k < 10; ++k) polygon.push_back({U - 200 * k, U / 2 + (k % 2)});
  polygon.push_back({0, U / 2});
  add({0, 0}, polygon);
  world.commit();
  EdgeSet set({.shortest = 328});
  set.load(world);
  EXPECT_EQ(set.counts().welded, 8U);   // two at a time
  EXPECT_EQ(set.counts().leftOut, 1U);  // the ninth
  EXPECT_EQ(set.counts().single, 4U);
  EXPECT_EQ(set.counts().edges, 8U);
}

TEST_F(Box2dEdgesByHand, WhatIsTooSmallAltogetherIsLeftOut) {
  add({0, 0}, {{0, 0}, {100, 0}, {0, 100}});
  world.commit();
  EdgeSet set({.shortest = 328});
  set.load(world);
  EXPECT_EQ(set.counts(), (EdgeCounts{.segments = 3, .leftOut = 3}));
}

}  // namespace
}  // namespace lgs::box2d
