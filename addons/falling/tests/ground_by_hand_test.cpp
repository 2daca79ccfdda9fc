// The ground of a game, without physics: what has gone wrong, or is told in the manual.
#include "addons/falling/tests/hills.h"

#include <gtest/gtest.h>

#include <limits>

namespace lgs::test {
namespace {

/// A bridge from a wall on bedrock to nowhere.
void buildBridge(Ground<>& ground) {
  EXPECT_TRUE(ground.edit([](World& world) -> Expected<void> {
    const ShapeId square = world.shape(kUnitSquare).value();
    if (const auto done = world.fill({{0, 0}, {0, 5}}, square, kBedrock); !done) return tl::unexpected(done.error());
    if (const auto done = world.fill({{1, 0}, {8, 0}}, square, kBedrock); !done) return tl::unexpected(done.error());
    if (const auto done = world.fill({{1, 5}, {8, 5}}, square, kStone); !done) return tl::unexpected(done.error());
    return {};
  }));
  ground.forgetUndo();
}

TEST(GroundByHand, UndoOverATakeAndOverASettle) {
  Ground<> ground({.isAnchor = options().isAnchor});
  buildBridge(ground);
  const auto rocks = [&] {
    std::vector<NoPhysics::Handle> handles;
    ground.forEachRock([&](NoPhysics::Handle handle, const Body&) { handles.push_back(handle); });
    return handles;
  };
  const auto cut = [](World& world) { return world.clear(Cell{2, 5}); };
  ASSERT_TRUE(ground.edit(cut));
  ASSERT_EQ(rocks().size(), 1U);
  EXPECT_TRUE(ground.world().isEmpty({5, 5}));
  ground.host().rock(rocks()[0]).placing.origin.y -= 4;
  ASSERT_TRUE(ground.place({0, 8}, kUnitSquare, kBedrock));  // another stroke, while it falls
  ASSERT_TRUE(ground.settle(rocks()[0]));
  EXPECT_TRUE(rocks().empty());
  EXPECT_FALSE(ground.world().isEmpty({5, 1}));
  ASSERT_TRUE(ground.undo());
  ASSERT_EQ(rocks().size(), 1U) << "it lies there, and is no ground";
  EXPECT_TRUE(ground.world().isEmpty({5, 1}));
  EXPECT_EQ(ground.host().rock(rocks()[0]).placing.origin.y, 1);
  ASSERT_TRUE(ground.undo());
  EXPECT_TRUE(rocks().empty()) << "it hangs at the bridge again";
  EXPECT_FALSE(ground.world().isEmpty({5, 5}));
  ASSERT_TRUE(ground.redo());
  ASSERT_EQ(rocks().size(), 1U) << "it falls again, from where it was";
  EXPECT_EQ(ground.host().rock(rocks()[0]).placing.origin.y, 5);
  EXPECT_TRUE(ground.redo() && !ground.redo());
  ground.step([] {});
  ASSERT_EQ(rocks().size(), 1U) << "without physics nothing settles by itself";
  ground.forget(rocks()[0]);
  EXPECT_TRUE(rocks().empty());
}

TEST(GroundByHand, BytesThatAreDamagedAreRefusedOrHold) {
  Ground<> ground({.isAnchor = options().isAnchor});
  buildBridge(ground);
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{2, 5}); }));
  const std::vector<std::byte> good = saved(ground);
  for (std::size_t k = 0; k < good.size(); ++k) {
    std::vector<std::byte> bad = good;
    bad[k] ^= std::byte{0x15};
    const auto loaded = loadGround(bad, {}, kEverywhere, shelfInMemory());
    for (const Rock& rock : loaded ? loaded->rocks : std::vector<Rock>()) {
      EXPECT_TRUE(isSound(rock)) << "byte " << k;
      World alone;
      for (const BodyPolygon& p : rock.ground.polygons)
        EXPECT_TRUE(alone.add(p.cell, p.vertices, p.block)) << "byte " << k << ": no ground looks like that";
    }
    EXPECT_FALSE(loadGround(std::span(good).first(k), {}, kEverywhere, shelfInMemory())) << "the first " << k;
  }
  EXPECT_TRUE(ground.load(good));
}

Block blockIn(const Ground<>& ground, Cell cell) {
  Block block = 0;
  ground.world().forEachPolygon({cell, cell}, [&](Cell, const PlacedPolygon& p) { block = p.block; });
  return block;
}

/// The land's fill() comes over cells in which the game has built.
TEST(GroundByHand, LandIsMadeAroundWhatWasBuiltBefore) {
  Ground<> ground(options());
  const auto build = [](std::int32_t i) {
    return [i](World& world) { return world.fill({{i, 0}, {i, 1}}, *world.shape(kUnitSquare), kBedrock); };
  };
  ASSERT_TRUE(ground.edit(build(5)));
  ASSERT_TRUE(ground.edit(build(330)));
  ASSERT_TRUE(ground.window({{0, 0}, {31, 31}}));
  ASSERT_TRUE(ground.window({{320, 0}, {351, 31}}));
  EXPECT_EQ(blockIn(ground, {330, 1}), kBedrock) << "what was built is still there";
  EXPECT_EQ(blockIn(ground, {331, 0}), kBedrock) << "the land is there";
  ASSERT_TRUE(ground.window({{0, 0}, {31, 31}}));
  EXPECT_EQ(blockIn(ground, {5, 1}), kBedrock);
  EXPECT_EQ(blockIn(ground, {6, 0}), kBedrock);
}

TEST(GroundByHand, WhereNoLandIsMadeYetNothingIsDug) {
  Ground<> ground(options(100, AtEdge::holds));
  ASSERT_TRUE(ground.window({{0, 0}, {31, 31}}));
  const Region hole = circle(latticePoint({70, 5}), kUnitsPerCell);
  const auto done = ground.dig(hole);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::unloaded);
  EXPECT_EQ(done.error().cell, (Cell{64, 0}));
  ASSERT_TRUE(ground.window({{64, 0}, {95, 31}}));
  EXPECT_TRUE(ground.dig(hole));
}

TEST(GroundByHand, AnyNumberOfStepsOfUndo) {
  Ground<> ground({.isAnchor = {}, .undoSteps = std::numeric_limits<std::size_t>::max()});
  ASSERT_TRUE(ground.place({3, 4}, kUnitSquare, kStone));
  EXPECT_TRUE(ground.undo());
}

/// What came in and fell is in the air again after that was undone.
TEST(GroundByHand, WhatHangsAfterAnUndoFallsAsSoonAsNothingCanBeRedone) {
  Ground<> ground({.isAnchor = options().isAnchor, .land = hills});
  const auto hangs = [&] { return !ground.world().isEmpty({41, 23}); };
  ASSERT_TRUE(ground.window({{0, 0}, {31, 31}}));
  ASSERT_TRUE(ground.place({3, 28}, kUnitSquare, kBedrock));
  ASSERT_TRUE(ground.window({{0, 0}, {63, 31}}));
  EXPECT_FALSE(hangs());
  ASSERT_TRUE(ground.undo());
  EXPECT_FALSE(hangs() && !ground.canRedo());
  EXPECT_FALSE(ground.redo() && hangs());
  ASSERT_TRUE(ground.place({5, 28}, kUnitSquare, kBedrock));
  EXPECT_FALSE(hangs());
}

TEST(GroundByHand, ARockIsNeverSettledInPart) {
  Ground<> ground({.isAnchor = options().isAnchor});
  buildBridge(ground);
  ASSERT_TRUE(ground.edit([](World& world) { return world.clear(Cell{2, 5}); }));
  NoPhysics::Handle rock = 0;
  ground.forEachRock([&](NoPhysics::Handle handle, const Body&) { rock = handle; });
  ground.host().rock(rock).placing.origin.y = 0.5;
  const auto refused = ground.settle(rock);
  ASSERT_FALSE(refused) << "the bedrock is in its way";
  EXPECT_EQ(refused.error().code, ErrorCode::overlap);
  ground.host().rock(rock).placing.origin.y = 1 + 1e-3;
  EXPECT_TRUE(ground.settle(rock));
  EXPECT_FALSE(ground.settle(0)) << "no rock";
}

TEST(GroundByHand, ARockIsDrawnFromTheOriginOfItsBody) {
  Ground<> ground({.isAnchor = options().isAnchor});
  ASSERT_TRUE(ground.place({7, -3}, kUnitSquare, kStone));
  std::vector<GroundDrawing::Fill> fills;
  ground.forEachRock([&](NoPhysics::Handle, const Body& rock) { fills = fillsOf(rock); });
  ASSERT_EQ(fills.size(), 1U);
  EXPECT_EQ(fills[0].block, kStone);
  ASSERT_EQ(fills[0].corners.size(), 4U);
  EXPECT_EQ(fills[0].corners[2].x, 1);
  EXPECT_EQ(fills[0].corners[2].y, 1);
}

TEST(GroundByHand, DrawsWhatChanged) {
  Ground<> ground({});
  ASSERT_TRUE(ground.place({3, 4}, kUnitSquare, kStone));
  const auto first = ground.draw();
  std::size_t fills = 0, lines = 0;
  for (const GroundDrawing& d : first) fills += d.fills.size(), lines += d.lines.size();
  EXPECT_EQ(fills, 1U);
  EXPECT_EQ(lines, 4U);
  EXPECT_TRUE(ground.draw().empty());
  ASSERT_TRUE(ground.undo());
  const auto gone = ground.draw();
  EXPECT_EQ(gone.size(), first.size());
  for (const GroundDrawing& d : gone) EXPECT_TRUE(d.fills.empty() && d.lines.empty());
}

}  // namespace
}  // namespace lgs::test
