// The core of the Box2D adapters: rules 1 to 3 of <lgs/box2d/edges.h>, and that an update reports no more than what
// changed.
#include "oracle/calls/random.h"
#include "oracle/check/isolated.h"
#include "oracle/trace/player.h"

#include "edge_copy.h"
#include "naive_edges.h"
#include "played.h"
#include "proptests/support/scale.h"
#include "proptests/support/worlds.h"

#include <lgs/box2d/edges.h>

namespace lgs::box2d {
namespace {

using oracle::Player;
using oracle::Random;

using test::U;

using box2d_test::Copy;
using box2d_test::expectEdgesOf;
using box2d_test::plain;

// Expects what holds for any set of edges and any options.
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

std::string inWords(const EdgeOptions& options) {
  return fmt::format("chunks of {} cells, shortest {}, merge {}, {}", options.chunkCells, options.shortest,
                     options.merge, options.material ? "materials by blocks modulo 2" : "one material");
}

TEST(Box2dEdges, UpdatesEqualTheRulesAndChangesAreExact) {
  const oracle::Shared<EdgeCounts> seen;
  const auto law = [&](const oracle::Trace& trace, box2d_test::Chance random) {
    const EdgeOptions options = randomOptions(random);
    SCOPED_TRACE(inWords(options));
    Player player(trace.preserve);
    EdgeSet set(options);
    Copy copy;
    std::set<Chunk> before;    // the chunks that had an edge before the last update
    std::size_t numbered = 0;  // and how many had one before or after the same update: at most so many
    copy.apply(set, set.load(player.world()));
    const auto update = [&] {
      const Changes& changes = player.commit();
      copy.apply(set, set.update(player.world(), changes));
      std::set<Chunk> after;
      for (const EdgeId id : set.edges()) after.insert(set.chunk(set.edge(id).chunk));
      before.insert(after.begin(), after.end());
      numbered = std::max(numbered, before.size());
      EXPECT_EQ(set.chunkCount(), numbered);
      before = std::move(after);
      EdgeSet fresh(options);
      fresh.load(player.world());
      EXPECT_EQ(plain(set), plain(fresh));
      EXPECT_EQ(set.counts(), fresh.counts());
      expectEdgesOf(player.world(), set);
      expectLaws(player.world(), set);
      seen->merged += set.counts().merged;
      seen->welded += set.counts().welded;
      seen->leftOut += set.counts().leftOut;
    };
    box2d_test::playAll(trace, player, update);
  };
  box2d_test::forAllEdits(300, law);
  if (HasFailure() || test::testScale() < 1) return;
  // The cases are of use only if they get there.
  EXPECT_GT(seen->merged, 1'000U);
  EXPECT_GT(seen->welded, 1'000U);
  EXPECT_GT(seen->leftOut, 1'000U);
}

// What a roll-back reports may name an id twice: removed, then added. Edges follow it as they follow a commit.
LGS_LAW(Box2dEdges, FollowAWorldThatGoesBack, 100, (const box2d_test::Edits& trace, box2d_test::Chance random)) {
  const EdgeOptions options = randomOptions(random);
  SCOPED_TRACE(inWords(options));
  Player player(trace.preserve);
  World& world = player.world();
  const ShapeId square = world.shape(kUnitSquare).value();
  EdgeSet set(options);
  Copy copy;
  copy.apply(set, set.load(world));
  box2d_test::playAll(trace, player, [&] {
    copy.apply(set, set.update(world, player.commit()));
    const Mark mark = world.mark();
    for (int guesses = random.below(4); guesses > 0; --guesses) {
      const CellRect all = world.bounds().value_or(CellRect{});
      const Cell cell{std::min(all.min.i + random.below(4), kMaxCell), std::min(all.min.j + random.below(4), kMaxCell)};
      if (random.chance(50)) {
        EXPECT_TRUE(world.replace(cell, square, 7));
      } else {
        EXPECT_TRUE(world.clear(cell));
      }
      copy.apply(set, set.update(world, world.commit()));
    }
    ASSERT_TRUE(world.rollBack(mark));
    ASSERT_TRUE(world.forget(mark));
    copy.apply(set, set.update(world, world.changesOfRollBack()), Copy::Ids::mayReturn);
    expectEdgesOf(world, set);
  });
}

// An edge that leads into what is unloaded has the ghost of its last segment.
LGS_LAW(Box2dEdges, FollowAWorldWhoseChunksComeAndGo, 100,
        (const box2d_test::Edits& trace, box2d_test::Chance random)) {
  const EdgeOptions options = randomOptions(random);
  SCOPED_TRACE(inWords(options));
  Player player(trace.preserve);
  World& world = player.world();
  EdgeSet set(options);
  Copy copy;
  copy.apply(set, set.load(world));
  const auto update = [&](const Changes& changes) {
    copy.apply(set, set.update(world, changes));
    expectEdgesOf(world, set);
  };
  box2d_test::playAll(trace, player, [&] {
    update(player.commit());
    const Cell last = world.bounds().value_or(CellRect{}).max, corner{last.i & ~31, last.j & ~31};
    std::vector<std::vector<std::byte>> chunks;
    EXPECT_TRUE(
        world.unload({corner, {std::min(corner.i + 31, kMaxCell), std::min(corner.j + 31, kMaxCell)}},
                     [&](Cell, std::span<const std::byte> bytes) { chunks.emplace_back(bytes.begin(), bytes.end()); }));
    update(world.commit());
    for (const auto& chunk : chunks) EXPECT_TRUE(world.reload(chunk));
    update(world.commit());
  });
}

LGS_LAW(Box2dEdges, WithoutMergingEverySegmentIsAnEdge, 60, (const box2d_test::Edits& trace)) {
  Player player(trace.preserve);
  box2d_test::playAll(trace, player, [&] {
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
  });
}

// loops() keeps the vertices where chains touch, even on a straight line. An edge goes through there.
std::vector<Point> cornersOf(const std::vector<Point>& loop) {
  std::vector<Point> corners;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point a = loop[(k + loop.size() - 1) % loop.size()], b = loop[k], c = loop[(k + 1) % loop.size()];
    if ((b.x - a.x) * (c.y - b.y) != (b.y - a.y) * (c.x - b.x)) corners.push_back(b);
  }
  return corners;
}

TEST(Box2dEdges, MergedInOneChunkTheyAreTheMergedLoops) {
  const oracle::Shared<std::size_t> compared;
  box2d_test::forAllEdits(80, [&](oracle::Trace trace, box2d_test::Chance) {
    if (!trace.preserve.empty()) return;      // there are no loops then
    for (oracle::Call& edit : trace.calls) {  // cases may lie anywhere; here all is to be in one chunk
      if (edit.comes.empty()) continue;
      Cell& cell = edit.comes[0].cell;
      cell = {cell.i & 1023, cell.j & 1023};
    }
    Player player({});
    box2d_test::playAll(trace, player, [&] {
      player.commit();
      EdgeSet set({.chunkCells = 4'096, .merge = true});
      set.load(player.world());
      std::vector<std::pair<Point, Point>> expected;
      for (const Loop& loop : player.world().loops(Collinear::merge)) {
        const std::vector<Point> corners = cornersOf(loop.vertices);
        for (std::size_t k = 0; k < corners.size(); ++k) {
          expected.emplace_back(corners[k], corners[(k + 1) % corners.size()]);
        }
      }
      std::vector<std::pair<Point, Point>> actual;
      for (const EdgeId id : set.edges()) actual.emplace_back(set.edge(id).start, set.edge(id).end);
      std::sort(expected.begin(), expected.end());
      std::sort(actual.begin(), actual.end());
      EXPECT_EQ(actual, expected);
      *compared += expected.size();
    });
  });
  if (HasFailure() || test::testScale() < 1) return;
  EXPECT_GT(*compared, 50'000U);
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

// --- By hand ---------------------------------------------------------------------------------------------------------

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
  EXPECT_EQ(one.counts().edges, 6U);  // top and bottom of two chunks, and the sides
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
  EXPECT_EQ(set.counts().welded, 9U);  // two at a time, and the ninth to the last two
  EXPECT_EQ(set.counts().leftOut, 0U);
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
