// Islands as bodies of whichever Box2D there is: where they were, at rest, without kicks, and back in the ground.
#include "either.h"
#include "oracle/calls/random.h"
#include "proptests/support/must.h"

#include <lgs/box2d/falling.h>
#include <lgs/brush.h>

namespace lgs::box2d_test {
namespace {

constexpr Block kIron = 7;

class Falling : public EitherBox2d {
 protected:
  static bool isAnchor(Block /*any*/, Cell cell) { return cell.j == -1; }
  static float density(Block block) { return block == kIron ? 8.0F : 2.0F; }

  void begin(box2d::TerrainOptions options = {}) {
    field.world.commit();
    ASSERT_TRUE(field.world.followCells(true));
    islands.emplace(field.world, isAnchor);
    terrain.emplace(physics, field.world, options);
    falling.emplace(physics, field.world, *terrain,
                    box2d::FallingOptions{.density = density, .material = [this](Block) { return material; }});
  }
  void commit() {
    const Changes& changes = field.world.commit();
    ASSERT_TRUE(terrain->sync(changes));
    ASSERT_TRUE(islands->update(field.world, changes));
  }
  /// What is loose falls.
  std::vector<box2d::Falling> letFall() {
    for (const IslandId id : islands->loose()) EXPECT_TRUE(falling->takeAsBody(*islands, id));
    commit();
    return falling->afterSync();
  }
  /// A pillar with an arm, of which the end is iron. Then the arm is cut off.
  box2d::Falling cutArm() {
    field.addFloor(-10, 20);
    for (std::int32_t j = 0; j < 4; ++j) field.add({0, j}, kSquare);
    for (std::int32_t i = 1; i < 5; ++i) field.add({i, 3}, kSquare, i == 4 ? kIron : 1);
    field.add({2, 4}, below(0, 8));
    begin();
    EXPECT_TRUE(field.world.clear(Cell{1, 3}));
    commit();
    const auto fallen = letFall();
    EXPECT_EQ(fallen.size(), 1U);
    return fallen.at(0);
  }

  box2d::Material material = withFriction(0.6F);
  std::optional<Islands> islands;
  std::optional<box2d::Terrain> terrain;
  std::optional<box2d::FallingGround> falling;
};

TEST_F(Falling, ABodyIsWhereItsGroundWasAndAtRest) {
  const box2d::Falling arm = cutArm();
  const auto at = positionOf(arm.body);
  EXPECT_EQ(at.x, 2);
  EXPECT_EQ(at.y, 3);
  EXPECT_EQ(velocityOf(arm.body).x, 0);
  EXPECT_EQ(velocityOf(arm.body).y, 0);
  EXPECT_EQ(falling->bodies().size(), 1U);
  EXPECT_EQ(islands->all().size(), 1U) << "the arm is no ground any more";
  step(1);
  EXPECT_EQ(velocityOf(arm.body).x, 0) << "it touched what it was part of";
  EXPECT_NEAR(velocityOf(arm.body).y, -10 / 60.0, 1e-6);
  EXPECT_TRUE(falling->afterSync().empty()) << "each is made once";
}

TEST_F(Falling, MassIsThatOfItsBlocks) {
  const box2d::Falling arm = cutArm();
  // Two squares and a half of weight 2, one square of weight 8; counted from (2, 3).
  const double mass = 2 * 2.5 + 8, x = (2 * (0.5 + 1.5 + 0.5 * 2 / 3) + 8 * 2.5) / mass;
  const double y = (2 * (0.5 + 0.5 + 0.5 * 4 / 3) + 8 * 0.5) / mass;
#ifndef B2_IS_NULL
  EXPECT_NEAR(arm.body->GetMass(), mass, 1e-5);
  EXPECT_NEAR(arm.body->GetLocalCenter().x, x, 1e-6);
  EXPECT_NEAR(arm.body->GetLocalCenter().y, y, 1e-6);
  const double inertia = arm.body->GetInertia() - mass * (x * x + y * y);
#else
  const b2MassData data = b2Body_GetMassData(arm.body);
  EXPECT_NEAR(data.mass, mass, 1e-5);
  EXPECT_NEAR(data.center.x, x, 1e-6);
  EXPECT_NEAR(data.center.y, y, 1e-6);
  const double inertia = data.rotationalInertia;
#endif
  const auto square = [&](double weight, double cx) {
    return weight / 6 + weight * ((cx - x) * (cx - x) + (0.5 - y) * (0.5 - y));
  };
  // Of a right triangle with legs of 1: 1/18 for each unit of area, about its centroid (2/3, 4/3).
  const double ramp = 2 * (0.5 / 9 + 0.5 * ((2.0 / 3 - x) * (2.0 / 3 - x) + (4.0 / 3 - y) * (4.0 / 3 - y)));
  EXPECT_NEAR(inertia, square(2, 0.5) + square(2, 1.5) + square(8, 2.5) + ramp, 1e-4);
}

TEST_F(Falling, WhatCameToRestIsGroundAgain) {
  const box2d::Falling arm = cutArm();
  int steps = 0;
  for (; steps < 1'200 && isAwake(arm.body); ++steps) {
    step(1);
    EXPECT_TRUE(terrain->afterStep().empty());
  }
  EXPECT_LT(steps, 1'200);
  ASSERT_TRUE(falling->settle(arm.body));
  commit();
  EXPECT_TRUE(falling->bodies().empty());
  EXPECT_EQ(islands->all().size(), 1U) << "it hangs together with what it rests on";
  EXPECT_GT(field.world.at({2 * U + U / 2, U / 2}).where, Spot::Where::outside);
  EXPECT_TRUE(terrain->isCurrent());
  EXPECT_FALSE(falling->settle(arm.body)) << "it is no more";
}

TEST_F(Falling, NobodySettlesInTheGround) {
  const box2d::Falling arm = cutArm();
  const std::uint64_t version = field.world.version();
  for (const float height : {-0.5F, -0.05F}) {
    moveTo(arm.body, {4, height});
    const auto done = test::refusal(falling->settle(arm.body));
    EXPECT_EQ(done.code, ErrorCode::overlap);
  }
  EXPECT_EQ(falling->bodies().size(), 1U);
  field.world.commit();
  EXPECT_EQ(field.world.version(), version) << "nothing has changed";
  ASSERT_TRUE(terrain->isCurrent());
  moveTo(arm.body, {4, 0.001F});
  EXPECT_TRUE(falling->settle(arm.body));
}

TEST_F(Falling, WhatCollidesWithNothingFallsThrough) {
  material.filter.maskBits = 0;
  const box2d::Falling arm = cutArm();
  step(120);
  EXPECT_LT(positionOf(arm.body).y, -1);
}

#ifdef B2_IS_NULL
TEST_F(Falling, TheCustomFilterIsAskedAboutTheBlockWithTheFlag) {
  material.enableCustomFiltering = true;
  const box2d::Falling arm = cutArm();
  b2World_SetCustomFilterCallback(
      physics, [](b2ShapeId, b2ShapeId, void*) { return false; }, nullptr);
  step(120);
  EXPECT_LT(positionOf(arm.body).y, -1);
}
#endif

TEST_F(Falling, DustHasNoBody) {
  field.addFloor(0, 3);
  field.add({1, 0}, {{0, 100}, {200, 100}, {100, 300}});  // three millimetres
  field.add({1, 1}, {{0, 100}, {U, 100}, {U, 300}});      // a metre long, and as thin
  begin();
  for (const auto& id : islands->all()) {
    if (islands->island(id)->anchors > 0) continue;
    EXPECT_TRUE(falling->takeAsBody(*islands, id));
  }
  commit();
  const auto fallen = falling->afterSync();
  EXPECT_EQ(fallen.size(), 2U);
  EXPECT_TRUE(falling->bodies().empty());
}

TEST_F(Falling, WhoIsForgottenIsTheGames) {
  const box2d::Falling arm = cutArm();
  falling->forget(arm.body);
  EXPECT_TRUE(falling->bodies().empty());
  EXPECT_EQ(falling->settle(arm.body).error().code, ErrorCode::staleHandle);
  step(1);
  EXPECT_LT(velocityOf(arm.body).y, 0) << "it is still there";
}

TEST_F(Falling, WhatSomethingHoldsIsNotTaken) {
  cutArm();
  ASSERT_EQ(islands->all().size(), 1U);
  EXPECT_EQ(test::refusal(falling->takeAsBody(*islands, islands->all().at(0))).code, ErrorCode::anchored);
  commit();
  EXPECT_EQ(islands->all().size(), 1U);
  EXPECT_TRUE(falling->afterSync().empty());
}

// For a game that calls no beforeStep().
TEST_F(Falling, ANewBodyIsGuardedFromItsFirstStepOn) {
  const box2d::Falling arm = cutArm();
  step(1);
  moveTo(arm.body, {2, -0.8F});
  EXPECT_EQ(terrain->afterStep().size(), 1U);
  EXPECT_EQ(positionOf(arm.body).y, 3);
}

TEST_F(Falling, WhoIsForgottenCanComeBack) {
  const box2d::Falling arm = cutArm();
  falling->forget(arm.body);
  falling->add(arm.body, arm.ground);
  for (int k = 0; k < 1'200 && isAwake(arm.body); ++k) step(1);
  EXPECT_TRUE(falling->settle(arm.body));
  const box2d::Falling other = falling->add(arm.ground);
  EXPECT_EQ(positionOf(other.body).y, 3);
  EXPECT_EQ(falling->bodies().size(), 1U);
}

/// Random digging, falling, undo and redo: the ground and its bodies together weigh what they weighed at the mark.
class FallingMatter : public Falling {
 protected:
  double matter() const {
    std::vector<BodyPolygon> ground;
    field.world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
      ground.push_back({cell, p.block, {p.vertices.begin(), p.vertices.end()}});
    });
    double sum = massOf(ground).area;
    for (const box2d::Falling& body : falling->bodies()) sum += body.ground.mass.area;
    return sum;
  }
  void note() {
    marks.resize(now + 1);
    marks.emplace_back(field.world.mark(), matter());
    ++now;
  }
  void dig(oracle::Random& random) {
    field.world.clear(Cell{random.below(12), random.below(8)});
    commit();
    if (!islands->loose().empty()) letFall();
    falling->afterSync();
    note();
  }
  void go(std::size_t to) {
    const bool isBack = to <= now;
    ASSERT_TRUE(isBack ? field.world.rollBack(marks[to].first, Undone::keep) : field.world.redo(marks[to].first));
    now = to;
    const Changes& changes = field.world.changesOfRollBack();
    ASSERT_TRUE(terrain->sync(changes));
    ASSERT_TRUE(islands->update(field.world, changes));
    falling->afterRollBack();
  }

  std::vector<std::pair<Mark, double>> marks;
  std::size_t now = 0;
};

TEST_F(FallingMatter, IsNeitherDoubledNorLostByUndoAndRedo) {
  oracle::Random random(7);
  field.addFloor(-10, 20);
  for (std::int32_t i = 0; i < 12; i += 3) {  // pillars with an arm
    for (std::int32_t j = 0; j < 8; ++j) field.add({i, j}, kSquare);
    field.add({i + 1, 7}, kSquare);
  }
  begin();
  marks = {{field.world.mark(), matter()}};
  std::size_t bodies = 0;
  for (int k = 0; k < 300; ++k) {
    if (random.chance(60))
      dig(random);
    else
      go(static_cast<std::size_t>(random.below(marks.size())));
    ASSERT_NEAR(matter(), marks[now].second, 1e-6) << "move " << k;
    bodies = std::max(bodies, falling->bodies().size());
    step(1);
    terrain->afterStep();
  }
  EXPECT_GT(bodies, 1U) << "nothing fell";
}

/// A round rock that rolls over a floor: how much it goes up at most, and how far it comes.
struct Roll {
  float upwards = 0, way = 0;
};

class Rolling : public Falling {
 protected:
  Roll roll(const box2d::TerrainOptions& options) {
    World world = field.world;
    EXPECT_TRUE(world.followCells(true));
    Islands rocks(world, isAnchor);
    box2d::Terrain ground(physics, world, options);
    box2d::FallingGround rolling(physics, world, ground, {.density = density, .material = {}});
    for (const IslandId id : rocks.all()) {
      if (rocks.island(id)->anchors > 0) continue;
      EXPECT_TRUE(rolling.takeAsBody(rocks, id));
    }
    EXPECT_TRUE(ground.commit(world));
    const Body body = rolling.afterSync().at(0).body;
    setVelocity(body, {4, 0});
    Roll out;
    for (int k = 0; k < 480; ++k) {
      step(1);
      if (k >= 90) out.upwards = std::max(out.upwards, velocityOf(body).y);  // after it fell onto the floor
    }
    out.way = static_cast<float>(positionOf(body).x);
    destroy(body);
    return out;
  }
};

TEST_F(Rolling, ARockRollsOverCellsAsOverOneEdge) {
  field.addFloor(-10, 90);
  paint(field.world, circle({2 * U, 3 * U / 2}, U, 48), 1, PaintMode::fill).value();
  field.world.commit();
  const Roll edge = roll({.chunkCells = 512, .merge = true});
  EXPECT_GT(edge.way, 10) << "it did not roll";
  for (const std::int32_t chunk : {1, 16}) {
    const Roll cells = roll({.chunkCells = chunk});
    EXPECT_LE(cells.upwards, edge.upwards * 1.25F + 0.02F) << "it was kicked";
    EXPECT_NEAR(cells.way, edge.way, 2);
  }
}

}  // namespace
}  // namespace lgs::box2d_test
