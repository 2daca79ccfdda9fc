// The ground of a game with Box2D: what is cut off falls, rests and is ground again; roll-backs and unloading leave nobody
// in the ground and nothing twice.
#include "crowd.h"
#include "either.h"

#include <lgs/box2d/ground.h>

#include <array>
#include <limits>

namespace lgs::box2d_test {
namespace {

constexpr Block kBedrock = 9;

class GroundOfBox2d : public EitherBox2d {
 protected:
  GroundOfBox2d() {
    EXPECT_TRUE(ground.edit([](World& world) -> Expected<void> {
      const ShapeId square = world.shape(kUnitSquare).value();
      if (const auto done = world.fill({{-40, -1}, {40, -1}}, square, kBedrock); !done)
        return tl::unexpected(done.error());
      if (const auto done = world.fill({{0, 0}, {0, 6}}, square, 1); !done) return tl::unexpected(done.error());
      if (const auto done = world.fill({{1, 6}, {4, 6}}, square, 1); !done) return tl::unexpected(done.error());
      return {};
    }));
    ground.forgetUndo();
  }
  void play(int steps) {
    for (int k = 0; k < steps; ++k) ground.step([&] { step(1); });
  }
  void expectFree(Body body) {
    const Spot::Where where = ground.world().at(ground.host().terrain().latticePoint(positionOf(body))).where;
    EXPECT_TRUE(where == Spot::Where::outside || !Crowd::isEnabled(body)) << "it is in the ground";
  }
  std::size_t rocks() const {
    std::size_t count = 0;
    ground.forEachRock([&](auto, const auto&) { ++count; });
    return count;
  }

  box2d::Ground ground{{.isAnchor = [](Block block, Cell) { return block == kBedrock; }}, physics};
};

TEST_F(GroundOfBox2d, WhatIsCutOffFallsRestsAndIsGroundUntilItIsUndone) {
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{1, 6}); }));
  EXPECT_EQ(rocks(), 1U);
  play(300);
  EXPECT_EQ(rocks(), 0U) << "it lies on the floor";
  EXPECT_FALSE(ground.world().isEmpty({3, 0}));
  ASSERT_TRUE(ground.undo());
  EXPECT_EQ(rocks(), 0U);
  EXPECT_TRUE(ground.world().isEmpty({3, 0}));
  EXPECT_FALSE(ground.world().isEmpty({3, 6}));
  ASSERT_TRUE(ground.redo());
  EXPECT_EQ(rocks(), 1U) << "it falls again";
  ASSERT_TRUE(ground.place({-5, 0}, kUnitSquare, 1));
  play(300);
  EXPECT_EQ(rocks(), 0U);
  ASSERT_TRUE(ground.undo());
  EXPECT_EQ(rocks(), 1U) << "what settled since lies there as a body";
}

TEST_F(GroundOfBox2d, WhileThereIsSomethingToRedoNothingSettles) {
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{1, 6}); }));
  ASSERT_TRUE(ground.place({-5, 0}, kUnitSquare, 1));
  ASSERT_TRUE(ground.undo());
  play(300);
  EXPECT_EQ(rocks(), 1U);
  ASSERT_TRUE(ground.redo());
  play(300);
  EXPECT_EQ(rocks(), 0U);
}

TEST_F(GroundOfBox2d, ARockThatTheGameDestroysIsNotTheNextBodyAtItsAddress) {
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{1, 6}); }));
  ASSERT_EQ(rocks(), 1U);
  ground.forEachRock([&](auto rock, const auto&) { destroy(rock); });  // without forget()
  const auto ball = addBody({3.5F, 2.5F}, Form::ball, 0.6F);
  play(200);
  EXPECT_EQ(rocks(), 0U);
  EXPECT_TRUE(ground.world().isEmpty({3, 0})) << "the ball is no ground";
  const std::size_t bodies = bodyCount();
  ASSERT_TRUE(ground.undo());
  EXPECT_EQ(bodyCount(), bodies);
  EXPECT_NEAR(positionOf(ball).y, 0.35F, 0.05F);
  EXPECT_FALSE(ground.world().isEmpty({3, 6}));
}

TEST_F(GroundOfBox2d, TwoTerrainsShareOnePhysicsWorld) {
  World below;
  ASSERT_TRUE(below.fill({{-40, -9}, {40, -9}}, below.shape(kUnitSquare).value(), 1));
  below.commit();
  box2d::Terrain cellar(physics, below);
  const auto ball = addBody({-20.5F, -6}, Form::ball, 0.6F);
  const auto rest = [&] {
    for (int k = 0; k < 120; ++k) {
      cellar.beforeStep();
      play(1);
      EXPECT_TRUE(cellar.afterStep().empty());
    }
  };
  rest();
  EXPECT_EQ(touchedCells(cellar, ball), std::vector<Cell>{(Cell{-21, -9})});
  EXPECT_TRUE(touchedCells(ground.host().terrain(), ball).empty());
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{-21, -1}); }));
  rest();
  EXPECT_NEAR(positionOf(ball).y, -7.65F, 0.05F) << "nothing was dug where it lies";
  ASSERT_TRUE(below.clear({{-22, -9}, {-20, -9}}));
  ASSERT_TRUE(cellar.commit(below));
  rest();
  EXPECT_LT(positionOf(ball).y, -10);
  EXPECT_TRUE(ground.undo());
  EXPECT_FALSE(cellar.sync(ground.world().changesOfRollBack())) << "those of the other world";
}

TEST_F(GroundOfBox2d, BodiesWaitWhereTheirGroundIsNotInMemory) {
  const auto ball = addBody({35.5F, 0.5F}, Form::ball, 0.6F);
  ASSERT_TRUE(ground.window({{-32, -32}, {31, 31}}));
  EXPECT_EQ(ground.host().away().size(), 1U);
  play(60);
  EXPECT_GT(positionOf(ball).y, 0.3F) << "it does not fall out of the world";
  ASSERT_TRUE(ground.window({{-64, -32}, {63, 31}}));
  EXPECT_TRUE(ground.host().away().empty());
  play(60);
  EXPECT_GT(positionOf(ball).y, 0.3F) << "it lies on the floor again";
}

/// The outline is open at the edge of memory: nothing there says that what lies to the left of it became solid.
TEST_F(GroundOfBox2d, WhoWaitedIsPutOutOfGroundThatCameThereMeanwhile) {
  const CellRect rock{{33, 5}, {80, 20}};
  ASSERT_TRUE(ground.edit([&](World& world) { return world.fill(rock, world.shape(kUnitSquare).value(), kBedrock); }));
  ASSERT_TRUE(ground.edit([&](World& world) { return world.clear(rock); }));
  const auto ball = addBody({40.5F, 12.5F}, Form::ball, 0.6F);
  ASSERT_TRUE(ground.window({{-64, -32}, {31, 31}}));
  ASSERT_TRUE(ground.undo());
  ASSERT_TRUE(ground.window({{-64, -32}, {63, 31}}));
  expectFree(ball);
}

TEST_F(GroundOfBox2d, GroundThatIsPaintedUpToTheEdgeOfMemoryBuriesNobody) {
  const auto fill = [&](const CellRect& cells) {
    return ground.edit([&](World& world) { return world.fill(cells, world.shape(kUnitSquare).value(), kBedrock); });
  };
  ASSERT_TRUE(fill({{32, 5}, {40, 20}}));
  const auto ball = addBody({20.5F, 12.5F}, Form::ball, 0.6F);
  ASSERT_TRUE(ground.window({{-64, -32}, {31, 31}}));
  ASSERT_TRUE(fill({{15, 5}, {31, 20}}));
  expectFree(ball);
  EXPECT_TRUE(Crowd::isEnabled(ball)) << "there is a way out";
}

TEST_F(GroundOfBox2d, ARockInTheAirIsSavedAndLoaded) {
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{1, 6}); }));
  play(20);
  std::vector<std::byte> saved;
  ASSERT_TRUE(
      ground.save([&](std::span<const std::byte> bytes) { saved.insert(saved.end(), bytes.begin(), bytes.end()); }));
  play(300);
  EXPECT_EQ(rocks(), 0U);
  ASSERT_TRUE(ground.load(saved));
  EXPECT_EQ(rocks(), 1U);
  EXPECT_TRUE(ground.world().isEmpty({3, 0}));
  play(300);
  EXPECT_EQ(rocks(), 0U);
  EXPECT_FALSE(ground.world().isEmpty({3, 0}));
}

TEST_F(GroundOfBox2d, ARockThatIsWalledInStaysThereAfterALoad) {
  const auto fill = [&](const CellRect& cells, Block block) {
    return ground.edit([&](World& world) { return world.fill(cells, world.shape(kUnitSquare).value(), block); });
  };
  ASSERT_TRUE(fill({{-10, 30}, {-9, 31}}, 1));
  ASSERT_EQ(rocks(), 1U);
  ASSERT_TRUE(fill({{-40, 10}, {40, 60}}, kBedrock));
  play(2);
  std::vector<std::byte> saved;
  ASSERT_TRUE(
      ground.save([&](std::span<const std::byte> bytes) { saved.insert(saved.end(), bytes.begin(), bytes.end()); }));
  ASSERT_TRUE(ground.load(saved));
  play(200);
  EXPECT_EQ(rocks(), 1U);
  ground.forEachRock(
      [&](auto rock, const auto&) { EXPECT_GT(positionOf(rock).y, 20) << "it fell through the ground"; });
}

TEST_F(GroundOfBox2d, ABodyThatTheGameKeepsOffIsNotTheOneThatWaitedAtItsAddress) {
  const auto waiting = addBody({-30.5F, 2.5F}, Form::ball, 0.6F);
  const auto leaving = addBody({30.5F, 2.5F}, Form::ball, 0.6F);
  ASSERT_TRUE(ground.window({{0, -32}, {31, 31}}));
  ASSERT_EQ(ground.host().away().size(), 1U);
  destroy(waiting);
  const auto off = addBody({10.5F, 2.5F}, Form::ball, 0.6F);
  Crowd::setEnabled(off, false);
  ASSERT_TRUE(ground.window({{0, -32}, {63, 31}}));
  Crowd::put(leaving, {70.5F, 2.5F});
  Crowd::kick(leaving, {1, 0});
  play(1);
  EXPECT_FALSE(Crowd::isEnabled(leaving)) << "it left the window";
  ASSERT_TRUE(ground.window({{-64, -32}, {95, 31}}));
  EXPECT_FALSE(Crowd::isEnabled(off));
}

TEST_F(GroundOfBox2d, RocksOutsideOfTheWindowWaitAsSoonAsTheyAreThere) {
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{1, 6}); }));
  const auto expectWaiting = [&] {
    EXPECT_EQ(rocks(), 1U);
    ground.forEachRock([&](auto rock, const auto&) { EXPECT_FALSE(Crowd::isEnabled(rock)); });
  };
  std::vector<std::byte> saved;
  ASSERT_TRUE(
      ground.save([&](std::span<const std::byte> bytes) { saved.insert(saved.end(), bytes.begin(), bytes.end()); }));
  ASSERT_TRUE(ground.window({{-64, -32}, {-33, 31}}));
  expectWaiting();
  ASSERT_TRUE(ground.load(saved));
  expectWaiting();
}

/// One that is too thin for Box2D has a null body: it is named by nothing.
TEST_F(GroundOfBox2d, NoRockIsNamedByANullBody) {
  constexpr std::array<LocalPoint, 4> kSliver{{{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, 100}, {0, 100}}};
  ASSERT_TRUE(ground.place({-8, 5}, kSliver, 1));
  ASSERT_EQ(rocks(), 1U);
  ground.forEachRock([&](auto rock, const auto&) { ASSERT_TRUE(box2d::GroundHost::isSame(rock, {})); });
  EXPECT_FALSE(ground.settle({}));
  ground.forget({});
  EXPECT_EQ(rocks(), 1U);
}

/// Damaged bytes are refused, or what they say is a game in which nothing breaks.
TEST_F(GroundOfBox2d, BytesThatAreDamagedAreRefusedOrHold) {
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{1, 6}); }));
  std::vector<std::byte> good;
  ASSERT_TRUE(
      ground.save([&](std::span<const std::byte> bytes) { good.insert(good.end(), bytes.begin(), bytes.end()); }));
  for (const int by : {0x01, 0x40, 0x80, 0xff}) {
    for (std::size_t k = 0; k < good.size(); ++k) {
      std::vector<std::byte> bad = good;
      bad[k] ^= static_cast<std::byte>(by);
      if (ground.load(bad)) play(2);
    }
  }
  EXPECT_TRUE(ground.load(good));
}

TEST_F(GroundOfBox2d, ABodyThatTheGameBrokeIsSavedWhereItsGroundWas) {
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{1, 6}); }));
  ground.forEachRock([&](auto rock, const auto&) { Crowd::kick(rock, {std::numeric_limits<float>::quiet_NaN(), 0}); });
  std::vector<std::byte> saved;
  ASSERT_TRUE(
      ground.save([&](std::span<const std::byte> bytes) { saved.insert(saved.end(), bytes.begin(), bytes.end()); }));
  ground.forEachRock([&](auto rock, const auto&) { Crowd::kick(rock, {0, 0}); });
  EXPECT_TRUE(ground.load(saved));
  play(300);
  EXPECT_FALSE(ground.world().isEmpty({3, 0}));
}

}  // namespace
}  // namespace lgs::box2d_test
