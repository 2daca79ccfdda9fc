// The ground of a game with Box2D: what is cut off falls, rests and is ground again; roll-backs and unloading leave nobody
// in the ground and nothing twice.
#include "either.h"

#include <lgs/box2d/ground.h>

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

}  // namespace
}  // namespace lgs::box2d_test
