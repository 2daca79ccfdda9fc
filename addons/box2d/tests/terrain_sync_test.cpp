// A terrain that was not told all changes notices it, and resync() repairs it.
#include "either.h"
#include "played.h"
#include "proptests/support/must.h"

#include <lgs/box2d/terrain.h>

namespace lgs::box2d_test {
namespace {

using box2d::EdgeId;
using box2d::SyncError;
using box2d::Terrain;
using box2d::TerrainOptions;

// The error tells of a misuse, with assertions as without: and nothing is done.
template <class Misuse>
void expectNoticed(SyncError error, Misuse misuse) {
  EXPECT_EQ(test::refusal(misuse()), error);
}

class Box2dTerrainSync : public EitherBox2d {
 protected:
  void dig(Cell cell) { ASSERT_TRUE(field.world.clear(cell)); }
  void expectCurrent(const Terrain& terrain) {
    EXPECT_TRUE(terrain.isCurrent());
    expectEdges(terrain, {});
    box2d::EdgeSet fresh(terrain.edges().options());
    fresh.load(field.world);
    EXPECT_EQ(terrain.edges().counts(), fresh.counts());
    EXPECT_EQ(terrain.bodyCount(), fresh.chunkCount());
    EXPECT_EQ(bodyCount(), fresh.chunkCount());
  }
};

TEST_F(Box2dTerrainSync, ACommitOfTheTerrainCommitsAndSyncs) {
  field.addFloor(0, 5);
  Terrain terrain(physics, field.world);
  EXPECT_TRUE(terrain.edges().edges().empty());
  EXPECT_TRUE(terrain.commit(field.world));
  EXPECT_EQ(terrain.edges().counts().edges, 14U);
  dig({2, -1});
  EXPECT_TRUE(terrain.commit(field.world));
  EXPECT_TRUE(terrain.commit(field.world));  // of nothing
  expectCurrent(terrain);
}

TEST_F(Box2dTerrainSync, ChangesThatWereForgottenAreNoticed) {
  field.addFloor(0, 5);
  field.world.commit();
  Terrain terrain(physics, field.world);
  dig({1, -1});
  field.world.commit();
  EXPECT_FALSE(terrain.isCurrent());
  dig({3, -1});
  const Changes changes = field.world.commit();
  const std::vector<EdgeId> before = terrain.edges().edges();
  expectNoticed(SyncError::leftOut, [&] { return terrain.sync(changes); });
  EXPECT_EQ(terrain.edges().edges(), before);
  dig({0, -1});
  const std::uint64_t version = field.world.version();
  expectNoticed(SyncError::leftOut, [&] { return terrain.commit(field.world); });
  EXPECT_NE(field.world.version(), version) << "the world is committed";
  EXPECT_EQ(terrain.edges().edges(), before);
  field.world.commit();
  terrain.resync();
  expectCurrent(terrain);
  dig({5, -1});
  EXPECT_TRUE(terrain.commit(field.world));
  expectCurrent(terrain);
}

TEST_F(Box2dTerrainSync, ChangesThatAreHandedOnTwiceAreNoticed) {
  field.addFloor(0, 5);
  field.world.commit();
  Terrain terrain(physics, field.world);
  dig({1, -1});
  const Changes first = field.world.commit();
  EXPECT_TRUE(terrain.sync(first));
  expectNoticed(SyncError::shownAlready, [&] { return terrain.sync(first); });
  expectCurrent(terrain);
  dig({3, -1});
  EXPECT_TRUE(terrain.commit(field.world));
  expectNoticed(SyncError::notTheLast, [&] { return terrain.sync(first); });
  expectCurrent(terrain);
}

TEST_F(Box2dTerrainSync, ChangesOfAnotherWorldAreNoticed) {
  field.addFloor(0, 5);
  field.world.commit();
  Terrain terrain(physics, field.world);
  World other = field.world;
  for (World* world : {&field.world, &other}) ASSERT_TRUE(world->clear(Cell{1, -1}));
  expectNoticed(SyncError::notTheLast, [&] { return terrain.commit(other); });
  EXPECT_EQ(other.version(), field.world.version()) << "nothing is committed";
  EXPECT_TRUE(terrain.isCurrent());
  field.world.commit();
  expectNoticed(SyncError::notTheLast, [&] { return terrain.sync(other.commit()); });
  EXPECT_FALSE(terrain.isCurrent());
  terrain.resync();
  expectCurrent(terrain);
}

TEST_F(Box2dTerrainSync, ARollBackIsSynced) {
  field.addFloor(0, 5);
  Terrain terrain(physics, field.world);
  EXPECT_TRUE(terrain.commit(field.world));
  const Mark mark = field.world.mark();
  dig({3, -1});
  EXPECT_TRUE(terrain.commit(field.world));
  ASSERT_TRUE(field.world.rollBack(mark));
  EXPECT_TRUE(terrain.sync(field.world.changesOfRollBack()));
  expectCurrent(terrain);
}

// Each roll-back reports from the one before. So several steps are undone by one roll-back, or with a sync after each.
TEST_F(Box2dTerrainSync, TwoRollBacksWithOneSyncAreNoticed) {
  for (const bool atOnce : {true, false}) {
    Field two;
    two.addFloor(0, 5);
    Terrain terrain(physics, two.world);
    EXPECT_TRUE(terrain.commit(two.world));
    std::vector<Mark> marks;
    for (const std::int32_t i : {1, 3}) {
      marks.push_back(two.world.mark());
      ASSERT_TRUE(two.world.clear(Cell{i, -1}));
      EXPECT_TRUE(terrain.commit(two.world));
    }
    if (!atOnce) {
      ASSERT_TRUE(two.world.rollBack(marks[1]));
    }
    ASSERT_TRUE(two.world.rollBack(marks[0]));
    const auto sync = [&] { return terrain.sync(two.world.changesOfRollBack()); };
    if (atOnce) {
      EXPECT_TRUE(sync());
    } else {
      expectNoticed(SyncError::leftOut, sync);
      terrain.resync();
    }
    EXPECT_TRUE(terrain.isCurrent());
    EXPECT_EQ(terrain.edges().counts().edges, 14U);
  }
}

// What a terrain never saw it need not see undone.
TEST_F(Box2dTerrainSync, AGuessThatIsTakenBackUnseenNeedsNoSync) {
  field.addFloor(0, 5);
  Terrain terrain(physics, field.world);
  EXPECT_TRUE(terrain.commit(field.world));
  const Mark mark = field.world.mark();
  dig({3, -1});
  field.world.commit();
  EXPECT_FALSE(terrain.isCurrent());
  ASSERT_TRUE(field.world.rollBack(mark));
  expectCurrent(terrain);
  dig({4, -1});
  EXPECT_TRUE(terrain.commit(field.world));
  expectCurrent(terrain);
}

TEST_F(Box2dTerrainSync, AWorldThatIsAssignedToIsNoticed) {
  field.addFloor(0, 5);
  field.world.commit();
  Terrain terrain(physics, field.world);
  std::vector<std::byte> file;
  ASSERT_TRUE(field.world.save([&](auto bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); }));
  const World before = field.world;
  dig({1, -1});
  EXPECT_TRUE(terrain.commit(field.world));
  for (const bool loads : {true, false}) {
    field.world = loads ? World::load(file).value() : before;
    EXPECT_FALSE(terrain.isCurrent());
    dig({3, -1});
    expectNoticed(SyncError::leftOut, [&] { return terrain.commit(field.world); });
    field.world.commit();
    terrain.resync();
    expectCurrent(terrain);
  }
}

// Materials are those of the world that the terrain shows now.
TEST_F(Box2dTerrainSync, AResyncFollowsAnyWorld) {
  forAllEdits(30, [&](const Trace& trace, Chance random) {
    TerrainOptions options{.origin = firstCell(trace), .chunkCells = 1 + random.below(8), .merge = random.chance(50)};
    options.material = [](Block block) { return withFriction(static_cast<float>(block)); };
    std::vector<World> worlds(1);
    oracle::Player player(trace.preserve);
    playAll(trace, player, [&] {
      player.commit();
      worlds.push_back(player.world());
    });
    World world;
    Terrain terrain(physics, world, options);
    for (int k = 0; k < 6; ++k) {
      world = random.pick(worlds);
      terrain.resync();
      EXPECT_TRUE(terrain.isCurrent());
      expectEdges(terrain, options);
      EXPECT_EQ(bodyCount(), terrain.bodyCount());
      for (const EdgeId id : terrain.edges().edges()) {
        const Block block = world.segment(terrain.edges().edge(id).first)->block;
        EXPECT_EQ(frictionOf(terrain, id), static_cast<float>(block));
      }
    }
  });
}

TEST_F(Box2dTerrainSync, BodiesSleepOnOverAResyncThatChangesNothingBelowThem) {
  field.addFloor(0, 20);
  field.world.commit();
  Terrain terrain(physics, field.world);
  const Body ball = addBody({4.5F, 0.4F}, Form::ball, 0.5F);
  step(120);
  ASSERT_FALSE(isAwake(ball));
  dig({15, -1});
  field.world.commit();
  terrain.resync();
  EXPECT_FALSE(isAwake(ball));
  dig({4, -1});
  field.world.commit();
  terrain.resync();
  EXPECT_TRUE(isAwake(ball));
  expectEdges(terrain, {});
}

TEST_F(Box2dTerrainSync, WhoSleepsWhereATerrainIsMadeWakes) {
  field.addFloor(0, 20);
  field.world.commit();
  const Body near = addBody({9.6F, 0.36F}, Form::box, 0.5F), far = addBody({9.6F, 3}, Form::box, 0.5F);
  for (const Body body : {near, far}) letSleep(body);
  const Terrain terrain(physics, field.world);
  EXPECT_TRUE(isAwake(near));
  EXPECT_FALSE(isAwake(far));
}

// Each body is held against each of the edges of its place.
TEST_F(Box2dTerrainSync, WhoSleepsBelowOneOfManyNewEdgesWakes) {
  field.addFloor(0, 20);
  field.world.commit();
  Terrain terrain(physics, field.world);
  const Body below = addBody({9.6F, 0.36F}, Form::box, 0.5F), far = addBody({4.5F, 0.36F}, Form::box, 0.5F);
  step(120);
  ASSERT_FALSE(isAwake(below) || isAwake(far));
  field.add({10, 2}, kSquare);
  field.add({8, 2}, kSquare);
  ASSERT_TRUE(terrain.commit(field.world));
  EXPECT_FALSE(isAwake(below));
  for (const Cell cell : {Cell{10, 3}, Cell{8, 3}}) field.add(cell, kSquare);
  constexpr std::int32_t kAbove = U * 25 / 32;
  field.add({9, 0}, {{0, kAbove}, {U, kAbove}, {U, U}, {0, U}});  // a slab that hangs closely above the first one
  ASSERT_TRUE(terrain.commit(field.world));
  EXPECT_TRUE(isAwake(below));
  EXPECT_FALSE(isAwake(far));
}

}  // namespace
}  // namespace lgs::box2d_test
