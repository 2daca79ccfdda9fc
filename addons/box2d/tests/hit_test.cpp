// What a fixture stands for: Terrain::hit() before and after a sync, and for fixtures that are not the terrain's.
#include "either.h"
#include "played.h"
#include "proptests/support/must.h"

#include <lgs/box2d/terrain.h>
#include <cstdlib>
#include <set>

namespace lgs::box2d_test {
namespace {

using box2d::EdgeId;
using box2d::Hit;
using box2d::Terrain;
using box2d::TerrainOptions;

using Box2dHit = EitherBox2d;

TEST_F(Box2dHit, AFixtureLeadsToSegmentPolygonBlockAndCell) {
  field.addFloor(0, 3);
  const PolygonHandle ramp = field.add({4, -1}, below(8, 0), 7);
  field.world.commit();
  Terrain terrain(physics, field.world);
  for (const SegmentId id : field.world.segments()) {
    const Segment s = *field.world.segment(id);
    const Hit hit = test::must(terrain.hit(*terrain.fixture(id)));
    EXPECT_EQ(std::tie(hit.segment, hit.polygon, hit.block, hit.cell), std::tie(s.id, s.polygon, s.block, s.cell));
    if (hit.block == 7) {
      EXPECT_EQ(hit.polygon, ramp);
    }
  }
  const b2BodyDef definition;
  b2CircleShape circle;
  circle.m_radius = 0.35F;
  b2Fixture& foreign = *physics.CreateBody(&definition)->CreateFixture(&circle, 1);
  EXPECT_FALSE(terrain.hit(foreign));
  EXPECT_FALSE(terrain.hit(foreign, {1, 2}));
  for (std::uintptr_t number = 0; number < 200; ++number) {  // user data of others
    foreign.GetUserData().pointer = number;
    EXPECT_FALSE(terrain.hit(foreign));
  }
  foreign.GetUserData().pointer = ~std::uintptr_t{0};
  EXPECT_FALSE(terrain.hit(foreign));
}

TEST_F(Box2dHit, AMergedEdgeIsAskedByPoint) {
  field.addFloor(0, 9);
  field.world.commit();
  Terrain terrain(physics, field.world, {.cellSize = 2, .merge = true});
  ASSERT_EQ(terrain.edges().counts().edges, 4U);
  struct Callback : b2RayCastCallback {
    float ReportFixture(b2Fixture* f, const b2Vec2& p, const b2Vec2&, float fraction) override {
      fixture = f;
      point = p;
      return fraction;
    }
    b2Fixture* fixture = nullptr;
    b2Vec2 point = {0, 0};
  } callback;
  physics.RayCast(&callback, {13, 5}, {13, -5});
  ASSERT_NE(callback.fixture, nullptr);
  const Hit hit = test::must(terrain.hit(*callback.fixture, callback.point));
  EXPECT_EQ(hit.cell, (Cell{6, -1}));
}

// Each slope lies in one chunk, as merged edges end with theirs.
TEST_F(Box2dHit, AMergedSlopeIsAskedByPoint) {
  for (std::int32_t k = 0; k < 10; ++k) {
    field.add({k, k}, below(0, 8));
    field.add({48 + k, 12 - k}, below(8, 0));
  }
  field.world.commit();
  const Terrain terrain(physics, field.world, {.cellSize = 2, .merge = true});
  for (const SegmentId id : field.world.segments()) {
    const Segment s = *field.world.segment(id);
    if (s.start.x == s.end.x || s.start.y == s.end.y) continue;
    for (std::int32_t k = 0; k < 10; ++k) {  // each segment of a slope leads to the one edge of all
      const bool rises = s.cell.i < 40;
      const Cell cell = rises ? Cell{k, k} : Cell{48 + k, 12 - k};
      for (const float along : {0.25F, 0.5F, 0.75F}) {
        const b2Vec2 point(2 * (static_cast<float>(cell.i) + along),
                           2 * (static_cast<float>(cell.j) + (rises ? along : 1 - along)));
        const Hit hit = test::must(terrain.hit(*terrain.fixture(id), point));
        EXPECT_EQ(hit.cell, cell);
      }
    }
  }
}

bool isParallel(const Segment& s, const box2d::Edge& edge) {
  return (s.end.x - s.start.x) * (edge.end.y - edge.start.y) == (s.end.y - s.start.y) * (edge.end.x - edge.start.x);
}

// A float tells the middle of a segment from its ends.
bool isLong(const Segment& s) {
  constexpr std::int64_t kLong = 64;  // lattice units
  return std::abs(s.end.x - s.start.x) + std::abs(s.end.y - s.start.y) >= kLong;
}

// Each segment is hit at its middle, unless it is too short to tell. Where segments are welded, one of them is hit.
void expectHits(const World& world, const Terrain& terrain) {
  const box2d::EdgeSet& edges = terrain.edges();
  std::set<EdgeId> bent;
  for (const SegmentId id : world.segments())
    if (const EdgeId edge = edges.edgeOf(id); edge && !isParallel(*world.segment(id), edges.edge(edge)))
      bent.insert(edge);
  for (const SegmentId id : world.segments()) {
    const EdgeId edge = edges.edgeOf(id);
    if (!edge) continue;  // left out
    const Segment s = *world.segment(id);
    const Point middle{s.start.x + (s.end.x - s.start.x) / 2, s.start.y + (s.end.y - s.start.y) / 2};
    const Hit hit = test::must(terrain.hit(*terrain.fixture(id), terrain.position(middle)));
    const Segment behind = *world.segment(hit.segment);
    EXPECT_EQ(edges.edgeOf(behind.id), edge);
    EXPECT_EQ(std::tie(hit.polygon, hit.block, hit.cell), std::tie(behind.polygon, behind.block, behind.cell));
    if (isLong(s) && !bent.contains(edge)) {
      EXPECT_EQ(hit.segment, id);
    }
  }
}

TEST_F(Box2dHit, EachSegmentIsHitAtItsMiddle) {
  forAllEdits(400, [](const Trace& trace, Chance random) {
    TerrainOptions options{.cellSize = random.chance(50) ? 1.0 : 3.0, .chunkCells = 1 + random.below(6)};
    options.merge = random.chance(80);
    if (!trace.calls.empty()) options.origin = test::boundsOf(trace).min;  // near enough for floats
    oracle::Player player(trace.preserve);
    b2World still({0, 0});
    Terrain terrain(still, player.world(), options);
    playAll(trace, player, [&] {
      terrain.sync(player.commit());
      expectHits(player.world(), terrain);
    });
  });
}

TEST_F(Box2dHit, BeforeTheSyncWhatIsGoneIsNotHit) {
  field.addFloor(0, 9);
  field.world.commit();
  for (const bool merge : {false, true}) {
    SCOPED_TRACE(merge);
    Terrain terrain(physics, field.world, {.merge = merge});
    for (const std::int32_t dug : {0, 4, 9}) {  // the first, the last and one between, of each merged edge
      std::map<b2Fixture*, std::set<SegmentId>> behind;
      for (const SegmentId id : field.world.segments()) behind[terrain.fixture(id)].insert(id);
      ASSERT_TRUE(field.world.remove(field.world.polygons({dug, -1})[0].handle));
      const Changes changes = field.world.commit();
      ASSERT_FALSE(changes.removed.empty());
      for (const auto& [fixture, segments] : behind) {
        const bool gone = std::any_of(changes.removed.begin(), changes.removed.end(),
                                      [&, &among = segments](SegmentId id) { return among.contains(id); });
        const std::optional<Hit> first = terrain.hit(*fixture);
        const std::optional<Hit> nearest = terrain.hit(*fixture, {static_cast<float>(dug), 0});
        EXPECT_EQ(nearest.has_value(), !gone);
        if (segments.size() == 1) {
          EXPECT_EQ(first.has_value(), !gone);
        }
        for (const auto& hit : {first, nearest}) {
          EXPECT_TRUE(!hit || segments.contains(hit->segment));
        }
      }
      terrain.sync(changes);
      for (const EdgeId id : terrain.edges().edges()) EXPECT_TRUE(terrain.hit(*terrain.fixture(id), {0, 0}));
      field.add({dug, -1}, kSquare);
      terrain.sync(field.world.commit());
    }
  }
}

// A crumb on the corner of a block is welded to the edge after it. Without the block it is a ring, and a walk along its
// links never comes to that edge.
TEST_F(Box2dHit, BeforeTheSyncARingIsWalkedOnce) {
  const PolygonHandle block = field.add({0, 0}, {{0, 0}, {U, 0}, {U, U}, {U - 200, U}, {U - 400, U - 10}, {0, U - 10}});
  field.add({1, 1}, {{0, 0}, {100, 0}, {0, 100}});
  field.world.commit();
  Terrain terrain(physics, field.world);
  SegmentId crumb;
  for (const SegmentId id : field.world.segments()) {
    if (field.world.segment(id)->end == Point{U + 100, U}) crumb = id;
  }
  b2Fixture* welded = terrain.fixture(crumb);
  ASSERT_NE(welded, nullptr);
  EXPECT_EQ(terrain.edges().counts().welded, 5U);
  ASSERT_TRUE(terrain.hit(*welded, {1, 1}));
  ASSERT_TRUE(field.world.remove(block));
  const Changes changes = field.world.commit();
  EXPECT_EQ(field.world.loops(Collinear::keep).size(), 1U);
  EXPECT_FALSE(terrain.hit(*welded, {1, 1}));
  terrain.sync(changes);
  EXPECT_EQ(terrain.edges().counts().leftOut, 3U);
}

// A seam that two blocks preserve is two cells high. When a third block covers its upper half, the lower half leads
// nowhere.
TEST_F(Box2dHit, BeforeTheSyncALinkMayBeGone) {
  World world([](Block a, Block b) { return a == 1 && b == 2; });
  const auto put = [&](Cell cell, Block block) { return *world.add(cell, *world.shape(kUnitSquare), block); };
  put({0, 0}, 1);
  put({1, 0}, 2);
  const PolygonHandle upper[] = {put({0, 1}, 1), put({1, 1}, 2)};
  world.commit();
  Terrain terrain(physics, world, {.merge = true});
  SegmentId lower;
  for (const SegmentId id : world.segments()) {
    if (world.segment(id)->start == Point{U, 0} && world.segment(id)->end == Point{U, U}) lower = id;
  }
  b2Fixture* const seam = terrain.fixture(lower);
  ASSERT_NE(seam, nullptr);
  ASSERT_EQ(terrain.edges().edge(terrain.edges().edgeOf(lower)).end, (Point{U, 2 * U}));
  EXPECT_EQ(terrain.hit(*seam, {1, 1.5F})->cell, (Cell{0, 1}));
  for (const PolygonHandle handle : upper) ASSERT_TRUE(world.remove(handle));
  put({0, 1}, 3);
  put({1, 1}, 3);
  const Changes changes = world.commit();
  ASSERT_FALSE(world.segment(lower)->successor);
  EXPECT_FALSE(terrain.hit(*seam, {1, 0.5F}));
  terrain.sync(changes);
  EXPECT_EQ(terrain.hit(*terrain.fixture(lower), {1, 0.5F})->segment, lower);
}

TEST_F(Box2dHit, OfNothingThereIsNoFixture) {
  const Terrain terrain(physics, field.world);
  EXPECT_EQ(terrain.fixture(EdgeId{}), nullptr);
  EXPECT_EQ(terrain.fixture(SegmentId{}), nullptr);
}

}  // namespace
}  // namespace lgs::box2d_test
