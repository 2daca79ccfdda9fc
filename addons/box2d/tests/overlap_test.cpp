// What the terrain does with bodies in new ground: for whichever Box2D there is.
#include "either.h"
#include "proptests/support/must.h"

#include <lgs/box2d/cut_out.h>

namespace lgs::box2d_test {
namespace {

using box2d::OnOverlap, box2d::Overlap;
using box2d::Terrain;

class Box2dOverlap : public EitherBox2d {
 protected:
  Box2dOverlap() {
    field.addFloor(-8, 8);
    field.world.commit();
  }
#ifndef B2_IS_NULL
  static bool isEnabled(Body body) { return body->IsEnabled(); }
  static bool fits(Terrain& terrain, Body body) { return terrain.fits(*body); }
  static bool isSame(Body a, Body b) { return a == b; }
#else
  static bool isEnabled(Body body) { return b2Body_IsEnabled(body); }
  static bool fits(Terrain& terrain, Body body) { return terrain.fits(body); }
  static bool isSame(Body a, Body b) { return B2_ID_EQUALS(a, b); }
#endif
  /// Fills a hole around the cell (0, 0), where it puts a ball.
  Body bury(Terrain& terrain) {
    for (std::int32_t j = 0; j < 3; ++j)
      for (std::int32_t i = -1; i <= 1; ++i)
        if (i != 0 || j != 1) field.add({i, j}, kSquare);
    EXPECT_TRUE(terrain.commit(field.world));
    const Body body = addBody({0.5F, 1.4F}, Form::ball, 0);
    step(30);
    handle = field.add({0, 1}, kSquare);
    return body;
  }
  PolygonHandle handle;
};

TEST_F(Box2dOverlap, WhoIsInTheMiddleOfALargeHillIsFound) {
  Terrain terrain(physics, field.world);
  const Body here = addBody({4.5F, 5.5F}, Form::ball, 0), there = addBody({54.5F, 5.5F}, Form::box, 0);
  addBody({29.5F, 5.5F}, Form::ball, 0);  // between two hills
  for (const std::int32_t from : {0, 50})
    for (std::int32_t j = 1; j <= 9; ++j)
      for (std::int32_t i = 0; i < 9; ++i) field.add({from + i, j}, kSquare);
  const std::vector<Overlap> who = terrain.overlapsWith(field.world.commit());
  ASSERT_EQ(who.size(), 2U);
  const bool isInOrder = isSame(who[0].body, here);
  EXPECT_TRUE(isSame(who[isInOrder ? 0 : 1].body, here));
  EXPECT_TRUE(isSame(who[isInOrder ? 1 : 0].body, there));
}

TEST_F(Box2dOverlap, WhoIsInNewGroundIsPushedOut) {
  Terrain terrain(physics, field.world);
  for (const Form form : {Form::ball, Form::box}) {
    const Body body = addBody({0.6F, 0.36F}, form, 0);
    step(30);
    setVelocity(body, {-3, 1});
    const PolygonHandle block = field.add({0, 0}, kSquare);
    const Changes& changes = field.world.commit();
    const std::vector<Overlap> who = terrain.overlapsWith(changes);
    ASSERT_EQ(who.size(), 1U);
    EXPECT_TRUE(isSame(who[0].body, body));
    EXPECT_TRUE(who[0].isFree);
    EXPECT_NEAR(who[0].depth, 0.35F, 0.02F);
    EXPECT_FALSE(fits(terrain, body));
    const Position at = positionOf(body);
    ASSERT_TRUE(terrain.sync(changes));
    ASSERT_EQ(terrain.overlaps().size(), 1U);
    EXPECT_NEAR(positionOf(body).x, at.x + who[0].displacement.x, 1e-5F);
    EXPECT_NEAR(positionOf(body).y, at.y + who[0].displacement.y, 1e-5F);
    EXPECT_NEAR(velocityOf(body).x, 0, 0.8F) << "no velocity into the ground is left";
    EXPECT_TRUE(fits(terrain, body));
    EXPECT_TRUE(isAwake(body));
    EXPECT_TRUE(terrain.disabled().empty());
    step(60);
    EXPECT_GT(positionOf(body).y, 0.3F);
    ASSERT_TRUE(field.world.remove(block));
    ASSERT_TRUE(terrain.commit(field.world));
    EXPECT_TRUE(terrain.overlaps().empty());
    destroy(body);
  }
}

TEST_F(Box2dOverlap, APointThatIsInNewGroundIsPushedOutToo) {
  Terrain terrain(physics, field.world);
  const Body body = addBody({0.6F, 0.36F}, Form::point, 0);
  field.add({0, 0}, kSquare);
  ASSERT_TRUE(terrain.commit(field.world));
  ASSERT_EQ(terrain.overlaps().size(), 1U);
  EXPECT_EQ(terrain.overlaps()[0].depth, 0) << "it has none";
  EXPECT_TRUE(terrain.overlaps()[0].isFree);
  EXPECT_EQ(field.world.at(terrain.latticePoint(positionOf(body))).where, Spot::Where::outside);
}

TEST_F(Box2dOverlap, WhoHasNoWayOutIsHeldUntilItIsFree) {
  Terrain terrain(physics, field.world);
  const Body body = bury(terrain);
  const Position at = positionOf(body);
  setVelocity(body, {0, 5});
  ASSERT_TRUE(terrain.commit(field.world));
  ASSERT_EQ(terrain.overlaps().size(), 1U);
  EXPECT_FALSE(terrain.overlaps()[0].isFree);
  ASSERT_EQ(terrain.disabled().size(), 1U);
  EXPECT_FALSE(isEnabled(body));
  step(30);
  field.add({5, 5}, kSquare);  // elsewhere
  ASSERT_TRUE(terrain.commit(field.world));
  EXPECT_FALSE(isEnabled(body));
  EXPECT_EQ(std::pair(positionOf(body).x, positionOf(body).y), std::pair(at.x, at.y));
  ASSERT_TRUE(field.world.remove(handle));
  ASSERT_TRUE(terrain.commit(field.world));
  EXPECT_TRUE(isEnabled(body));
  EXPECT_TRUE(terrain.disabled().empty());
  EXPECT_EQ(std::pair(positionOf(body).x, positionOf(body).y), std::pair(at.x, at.y));
  EXPECT_EQ(velocityOf(body).y, 0);
  step(60);
  EXPECT_NEAR(positionOf(body).y, 1.35F, 0.02F);
}

TEST_F(Box2dOverlap, AnUndoThatBuriesIsNoUndoOfTheBody) {
  Terrain terrain(physics, field.world);
  const Mark mark = field.world.mark();
  ASSERT_TRUE(field.world.clear(CellRect{{-1, -1}, {1, -1}}));
  ASSERT_TRUE(terrain.commit(field.world));
  const Body body = addBody({0.5F, -0.5F}, Form::box, 0);
  ASSERT_TRUE(field.world.rollBack(mark));
  EXPECT_EQ(terrain.overlapsWith(field.world.changesOfRollBack()).size(), 1U);
  ASSERT_TRUE(terrain.sync(field.world.changesOfRollBack()));
  EXPECT_EQ(terrain.overlaps().size(), 1U);
  EXPECT_TRUE(fits(terrain, body));
}

TEST_F(Box2dOverlap, AWorldThatIsAssignedToPushesToo) {
  Terrain terrain(physics, field.world);
  World other = field.world;
  ASSERT_TRUE(other.add({0, 0}, *other.shape(kUnitSquare), 1));
  other.commit();
  const Body body = addBody({0.5F, 0.36F}, Form::box, 0);
  field.world = other;
  terrain.resync();
  EXPECT_EQ(terrain.overlaps().size(), 1U);
  EXPECT_TRUE(fits(terrain, body));
}

TEST_F(Box2dOverlap, AGameMayHoldOrLeaveThem) {
  for (const OnOverlap onOverlap : {OnOverlap::disable, OnOverlap::leave}) {
    Terrain terrain(physics, field.world, {.onOverlap = onOverlap});
    const Body body = addBody({0.6F, 0.36F}, Form::ball, 0);
    const Position at = positionOf(body);
    const PolygonHandle block = field.add({0, 0}, kSquare);
    ASSERT_TRUE(terrain.commit(field.world));
    EXPECT_EQ(isEnabled(body), onOverlap == OnOverlap::leave);
    EXPECT_EQ(terrain.disabled().size(), onOverlap == OnOverlap::disable ? 1U : 0U);
    EXPECT_EQ(positionOf(body).x, at.x);
    ASSERT_TRUE(field.world.remove(block));
    ASSERT_TRUE(terrain.commit(field.world));
    EXPECT_TRUE(isEnabled(body));
    destroy(body);
  }
}

// One that is asked for once: by who carves the bodies free afterwards.
TEST_F(Box2dOverlap, ASyncMayLeaveThemOnce) {
  Terrain terrain(physics, field.world);
  const Body body = addBody({0.6F, 0.36F}, Form::ball, 0);
  const Position at = positionOf(body);
  field.add({0, 0}, kSquare);
  ASSERT_TRUE(terrain.sync(field.world.commit(), OnOverlap::leave));
  EXPECT_EQ(positionOf(body).x, at.x);
  EXPECT_TRUE(isEnabled(body));
}

TEST_F(Box2dOverlap, WhoIsHeldMayBeDestroyed) {
  Terrain terrain(physics, field.world);
  destroy(bury(terrain));
  const Body other = addBody({0.5F, 1.4F}, Form::ball, 0);
  ASSERT_TRUE(terrain.commit(field.world));
  ASSERT_EQ(terrain.disabled().size(), 1U);
  destroy(other);
  EXPECT_TRUE(terrain.disabled().empty());
  const Body next = addBody({20.5F, 1.4F}, Form::ball, 0);  // maybe at the same address
  EXPECT_TRUE(terrain.disabled().empty());
  EXPECT_TRUE(isEnabled(next));
  ASSERT_TRUE(field.world.remove(handle));
  ASSERT_TRUE(terrain.commit(field.world));
  EXPECT_TRUE(terrain.disabled().empty());
}

TEST_F(Box2dOverlap, APlatformCatchesNobody) {
  box2d::TerrainOptions options;
  options.material = [](Block block) {
    box2d::Material material;
    material.isPassable = block == 9;
    return material;
  };
  Terrain terrain(physics, field.world, options);
  const Body body = addBody({0.5F, 0.5F}, Form::ball, 0);
  field.add({0, 0}, kSquare, 9);
  ASSERT_TRUE(terrain.commit(field.world));
  EXPECT_TRUE(terrain.overlaps().empty());
  EXPECT_TRUE(fits(terrain, body));
  step(1);
  EXPECT_TRUE(terrain.afterStep().empty());
}

// What is not in memory has no block, so the game is not asked about it.
TEST_F(Box2dOverlap, WhatIsNotInMemoryIsNoPlatform) {
  box2d::TerrainOptions options;
  options.material = [](Block block) {
    EXPECT_NE(block, 0U);
    box2d::Material material;
    material.isPassable = block == 0;
    return material;
  };
  Terrain terrain(physics, field.world, options);
  const Body body = addBody({0.5F, -3.5F}, Form::ball, 0);  // below the floor, in its chunk
  const Body other = addBody({4.5F, 2.5F}, Form::ball, 0);
  EXPECT_TRUE(terrain.afterStep().empty());
  ASSERT_EQ(test::must(field.world.unload({{0, -32}, {31, -1}}, [](Cell, std::span<const std::byte>) {})), 1U);
  ASSERT_TRUE(terrain.commit(field.world));
  EXPECT_FALSE(fits(terrain, body));
  step(1);
  moveTo(other, {4.5F, -3.5F});  // as if the step had pressed it there
  terrain.afterStep();
  EXPECT_GT(positionOf(other).y, 2);
}

// As when something heavy presses it through an edge.
TEST_F(Box2dOverlap, AfterAStepWhoIsInTheGroundIsPutBack) {
  Terrain terrain(physics, field.world);
  const Body body = addBody({0.5F, 0.36F}, Form::ball, 0);
  step(1);
  EXPECT_TRUE(terrain.afterStep().empty());
  const Position at = positionOf(body);
  moveTo(body, {0.5F, -0.5F});
  setVelocity(body, {0, -1});
  ASSERT_EQ(terrain.afterStep().size(), 1U);
  EXPECT_NEAR(positionOf(body).y, at.y, 1e-5F);
  EXPECT_EQ(velocityOf(body).y, 0);
}

// The floor is a cell thick, and below it there is nothing.
TEST_F(Box2dOverlap, AfterAStepWhoCameThroughTheGroundIsPutBack) {
  Terrain terrain(physics, field.world);
  const Body body = addBody({0.5F, 0.36F}, Form::box, 0);
  step(1);
  EXPECT_TRUE(terrain.afterStep().empty());
  moveTo(body, {0.5F, -1.5F});
  EXPECT_EQ(terrain.afterStep().size(), 1U);
  EXPECT_GT(positionOf(body).y, 0.3F);
  moveTo(body, {3.5F, 0.5F});  // fast, through the air
  EXPECT_TRUE(terrain.afterStep().empty());
}

// A portal to below the floor.
TEST_F(Box2dOverlap, WhoWasMovedByTheGameStaysThere) {
  Terrain terrain(physics, field.world);
  const Body body = addBody({0.5F, 0.36F}, Form::box, 0);
  step(1);
  EXPECT_TRUE(terrain.afterStep().empty());
  moveTo(body, {0.5F, -1.5F});
#ifndef B2_IS_NULL
  terrain.moved(*body);
#else
  terrain.moved(body);
#endif
  EXPECT_TRUE(terrain.afterStep().empty());
  EXPECT_EQ(positionOf(body).y, -1.5F);
}

TEST_F(Box2dOverlap, BeforeAStepItIsNotedWhoIsNewAndWhoIsElsewhere) {
  Terrain terrain(physics, field.world);
  const Body body = addBody({0.5F, 0.36F}, Form::box, 0);
  terrain.beforeStep();
  step(1);
  moveTo(body, {0.5F, -0.5F});  // by the solver, say
  ASSERT_EQ(terrain.afterStep().size(), 1U);
  EXPECT_EQ(positionOf(body).y, 0.36F);
  moveTo(body, {3.5F, -1.5F});  // through a portal
  terrain.beforeStep();
  EXPECT_TRUE(terrain.afterStep().empty());
  EXPECT_EQ(positionOf(body).y, -1.5F);
}

// In Box2D 2.4 the second body has the address of the first one.
TEST_F(Box2dOverlap, WhoIsMadeInTheGroundIsNotPutToWhereAnotherOneWas) {
  field.addFloor(10, 20);
  field.world.commit();
  Terrain terrain(physics, field.world);
  const Body gone = addBody({0.5F, 0.36F}, Form::box, 0);
  terrain.beforeStep();
  EXPECT_TRUE(terrain.afterStep().empty());
  destroy(gone);
  const Body body = addBody({12.5F, -0.5F}, Form::box, 0);
  terrain.beforeStep();
  EXPECT_TRUE(terrain.afterStep().empty());
  EXPECT_EQ(positionOf(body).x, 12.5F);
}

// Of two bodies one was held when the game was saved, and the other one is now.
TEST_F(Box2dOverlap, ALoadHoldsWhoWasHeldAndReleasesWhoIsFree) {
  Terrain terrain(physics, field.world);
  const Body held = bury(terrain), other = addBody({4.5F, 0.36F}, Form::ball, 0);
  ASSERT_TRUE(terrain.commit(field.world));
  ASSERT_EQ(terrain.disabled().size(), 1U);
  const World saved = field.world;
  const Position heldAt = positionOf(held), otherAt = positionOf(other);
  ASSERT_TRUE(field.world.remove(handle));
  ASSERT_TRUE(terrain.commit(field.world));
  ASSERT_TRUE(isEnabled(held));
  moveTo(other, {heldAt.x, heldAt.y});
  moveTo(held, {6.5F, 0.36F});
  ASSERT_TRUE(field.world.add({0, 1}, kSquare, 1));
  ASSERT_TRUE(terrain.commit(field.world));
  ASSERT_FALSE(isEnabled(other));
  field.world = saved;
  moveTo(held, heldAt);
  moveTo(other, otherAt);
  terrain.resync();
  EXPECT_FALSE(isEnabled(held));
  EXPECT_TRUE(isEnabled(other));
  step(2);
  EXPECT_TRUE(terrain.afterStep().empty()) << "it did not come through the ground: it was put there";
  EXPECT_NEAR(positionOf(other).x, otherAt.x, 0.01F);
  EXPECT_EQ(positionOf(held).x, heldAt.x);
}

// When the game was saved the body was below the floor.
TEST_F(Box2dOverlap, ALoadPutsBodiesWhereTheyWere) {
  Terrain terrain(physics, field.world);
  const World saved = field.world;
  const Body body = addBody({0.5F, 0.36F}, Form::box, 0);
  step(1);
  EXPECT_TRUE(terrain.afterStep().empty());
  field.world = saved;
  moveTo(body, {0.5F, -1.5F});
  terrain.resync();
  step(1);
  EXPECT_TRUE(terrain.afterStep().empty());
  EXPECT_NEAR(positionOf(body).y, -1.5F, 0.02F);
}

TEST_F(Box2dOverlap, BodiesAreCutOutOfWhatIsPainted) {
  Terrain terrain(physics, field.world);
  for (const Form form : {Form::ball, Form::box}) {
    const Body body = addBody({0.6F, 0.36F}, form, 0);
    step(60);
    const Position at = positionOf(body);
    ASSERT_TRUE(paint(field.world, circle({U / 2, U / 2}, 2 * U), 5, PaintMode::fill));
    ASSERT_TRUE(cutOut(terrain, field.world, field.world.commit()));
    EXPECT_TRUE(terrain.isCurrent());
    EXPECT_TRUE(terrain.disabled().empty());
    EXPECT_EQ(std::pair(positionOf(body).x, positionOf(body).y), std::pair(at.x, at.y));
    EXPECT_TRUE(fits(terrain, body));
    step(120);
    EXPECT_NEAR(positionOf(body).x, at.x, 0.05F);
    EXPECT_NEAR(positionOf(body).y, at.y, 0.05F);
    ASSERT_TRUE(carve(field.world, circle({U / 2, 2 * U}, 2 * U - 1)));
    ASSERT_TRUE(terrain.commit(field.world));
    destroy(body);
  }
}

TEST_F(Box2dOverlap, WhatIsPaintedGoesAroundBodies) {
  Terrain terrain(physics, field.world);
  const Body body = addBody({0.6F, 0.36F}, Form::box, 0);
  step(60);
  const Position at = positionOf(body);
  const auto room = test::must(withoutBodies(terrain, circle({U / 2, U / 2}, 2 * U)));
  ASSERT_TRUE(paint(field.world, room, 5, PaintMode::fill));
  const Changes& changes = field.world.commit();
  EXPECT_TRUE(terrain.overlapsWith(changes).empty());
  ASSERT_TRUE(terrain.sync(changes));
  EXPECT_TRUE(fits(terrain, body));
  EXPECT_EQ(field.world.at({U / 2, 5 * U / 4}).block, 5U);
  step(60);
  EXPECT_NEAR(positionOf(body).y, at.y, 0.05F);
  const Region away = circle({9 * U, 9 * U}, U);
  EXPECT_EQ(withoutBodies(terrain, away)->rings, away.rings) << "nobody is there";
}

}  // namespace
}  // namespace lgs::box2d_test
