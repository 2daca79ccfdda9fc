// The part of law 13 that knows no Box2D: which middles were free, how deep a line is in a form, the way out.
#include "addons/box2d/src/new_ground.h"
#include "addons/box2d/src/way_out.h"
#include "distances.h"
#include "field.h"
#include "oracle/calls/random.h"
#include "played.h"
#include "proptests/support/must.h"

namespace lgs::box2d_test {
namespace {

using box2d::Catch;
using box2d::catchOf;
using box2d::EdgeSet;
using box2d::NewGround;
using box2d::WayOut;

bool holdsAll(Block /*block*/) { return true; }

box2d::Form ballAt(double x, double y, double radius) {
  return {{{x * U, y * U}}, radius * U, {x * U, y * U}, holdsAll};
}

box2d::Form boxAt(double x, double y, double half) {
  const double l = (x - half) * U, r = (x + half) * U, b = (y - half) * U, t = (y + half) * U;
  return {{{l, b}, {r, b}, {r, t}, {l, t}}, 0, {x * U, y * U}, holdsAll};
}

// After commits, roll-backs and loads: the segments that came and went say what a copy of the old world says.
LGS_LAW(Box2dNewGround, WasFreeIsWhatTheOldWorldSays, 150, (const Edits& trace, Chance random)) {
  oracle::Player player(trace.preserve);
  EdgeSet set(box2d::EdgeOptions{.merge = random.chance(50)});
  set.load(player.world());
  World before = player.world();
  const auto expectAgreement = [&](const NewGround& ground) {
    const CellRect all = player.world().bounds().value_or(CellRect{});
    for (int k = 0; k < 40; ++k) {
      const auto along = [&](std::int32_t from, std::int32_t to) {
        return (from - 1 + double{between(random, 0, 1)} * (to - from + 3)) * U + 0.25;
      };
      box2d::Form form;
      form.middle = {along(all.min.i, all.max.i), along(all.min.j, all.max.j)};
      form.holds = holdsAll;
      const Point p = latticePoint({form.middle.x / U, form.middle.y / U});
      const Spot::Where was = before.at(p).where, is = player.world().at(p).where;
      EXPECT_EQ(ground.isFree(form), is == Spot::Where::outside);
      if (was == Spot::Where::edge || is == Spot::Where::edge) continue;
      EXPECT_EQ(ground.wasFree(form), was == Spot::Where::outside) << p.x << ' ' << p.y;
    }
  };
  playAll(trace, player, [&] {
    const Changes changes = player.commit();
    if (random.chance(20)) {
      expectAgreement(NewGround(player.world(), set));
      set.load(player.world());
    } else {
      expectAgreement(NewGround(player.world(), set, changes));
      set.update(player.world(), changes);
    }
    before = player.world();
  });
}

/// At the edge of memory the outline is open, and edges beyond it come and go untold.
LGS_LAW(Box2dNewGround, WhoWasFreeBesideUnloadedGroundIsKnown, 100, (std::uint64_t seed)) {
  oracle::Random random(seed);
  constexpr std::int32_t kSide = 96;  // 3 chunks
  World world;
  EdgeSet set(box2d::EdgeOptions{.merge = random.chance(50)});
  set.load(world);
  const auto edit = [&] {
    const Cell a{random.below(kSide), random.below(kSide)};
    const CellRect cells{a, {std::min(a.i + random.below(40), kSide - 1), std::min(a.j + random.below(40), kSide - 1)}};
    if (world.clear(cells) && random.chance(60))
      static_cast<void>(world.fill(cells, world.shape(kUnitSquare).value(), 1));
  };
  const auto commit = [&](const World& before) {
    const Changes& changes = world.commit();
    const NewGround ground(world, set, changes);
    for (int k = 0; k < 60; ++k) {
      const box2d::Form form = ballAt(random.below(kSide) + 0.5, random.below(kSide) + 0.5, 0.3);
      const Point p = latticePoint({form.middle.x / U, form.middle.y / U});
      const bool isBuried = before.at(p).where == Spot::Where::outside && world.at(p).where == Spot::Where::inside;
      EXPECT_TRUE(!isBuried || ground.wasFree(form)) << p.x / U << ' ' << p.y / U;
    }
    set.update(world, changes);
  };
  for (int k = 0; k < 12; ++k) edit();
  commit(World());
  for (std::int32_t j = 0; j < kSide; j += 32)
    for (std::int32_t i = 0; i < kSide; i += 32)
      if (random.chance(50)) static_cast<void>(world.unload({{i, j}, {i + 31, j + 31}}, {}));
  set.update(world, world.commit());
  for (int k = 0; k < 6; ++k) {
    const World before = world;
    for (int n = random.below(3); n >= 0; --n) edit();
    commit(before);
  }
}

double depthOf(const box2d::Form& form, DoublePoint p) {
  if (form.hull.size() == 1) return form.radius - std::hypot(p.x - form.hull[0].x, p.y - form.hull[0].y);
  double inside = std::numeric_limits<double>::infinity(), outside = inside;
  for (std::size_t k = 0; k < form.hull.size(); ++k) {
    const DoublePoint a = form.hull[k], b = form.hull[(k + 1) % form.hull.size()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    inside = std::min(inside, ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length);
    outside = std::min(outside, distanceToEdge({p.x, p.y}, {a.x, a.y}, {b.x, b.y}));
  }
  return form.radius + (form.hull.size() > 2 && inside > 0 ? inside : -outside);
}

// The deepest of many points of the line.
LGS_LAW(Box2dNewGround, ALineReachesAsDeepAsItsDeepestPoint, 300, (Chance random)) {
  box2d::Form form;
  const int corners = 1 + random.below(6);
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.28 * k / corners;
    form.hull.push_back({100 * std::cos(angle), 60 * std::sin(angle)});
  }
  form.radius = corners < 3 || random.chance(50) ? between(random, 5, 40) : 0;
  const DoublePoint a{between(random, -150, 150), between(random, -150, 150)};
  const DoublePoint b{between(random, -150, 150), between(random, -150, 150)};
  double deepest = -1e9;
  for (int k = 0; k <= 2'000; ++k) {
    const double t = k / 2'000.0;
    deepest = std::max(deepest, depthOf(form, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
  }
  const double depth = between(random, 0, 80);
  if (std::abs(depth - deepest) < 0.3) return;
  if (reaches(form, a, b, depth) != (deepest > depth)) FAIL() << "asked for " << depth << ", is " << deepest;
}

class Box2dWayOut : public testing::Test {
 protected:
  /// A floor of stone, and above it blocks that are placed now.
  NewGround place(const std::vector<Cell>& cells) {
    field.addFloor(-8, 8);
    field.world.commit();
    set.load(field.world);
    for (const Cell cell : cells) field.add(cell, kSquare);
    const Changes& changes = field.world.commit();
    return NewGround(field.world, set, changes);
  }
  static std::optional<Catch> caught(const NewGround& ground, const box2d::Form& form) {
    return catchOf(ground, {form}, box2d::Whose::free, 0.01 * U);
  }
  Field field;
  EdgeSet set{box2d::EdgeOptions{}};
};

TEST_F(Box2dWayOut, IsTheShortest) {
  const NewGround ground = place({{0, 0}});
  const auto found = caught(ground, ballAt(0.8, 0.5, 0.3));
  ASSERT_TRUE(found && found->way);
  EXPECT_NEAR(found->depth, 0.3 * U, 1);
  EXPECT_NEAR(found->way->x, 0.5 * U, 0.05 * U);
  EXPECT_NEAR(found->way->y, 0, 0.1 * U);
}

TEST_F(Box2dWayOut, WhoIsNotDeepIsNotCaught) {
  const NewGround ground = place({{0, 0}});
  EXPECT_FALSE(caught(ground, ballAt(1.2, 0.4, 0.35)));  // 0.15 deep, and 0.175 is half
  EXPECT_TRUE(caught(ground, ballAt(1.15, 0.4, 0.35)));
  EXPECT_FALSE(caught(ground, boxAt(1.2, 0.4, 0.35)));
  EXPECT_TRUE(caught(ground, boxAt(1.15, 0.4, 0.35)));  // its middle is outside
}

// No ray from there says on which side it is.
TEST_F(Box2dWayOut, AMiddleOnTheRimOfANewBlockIsCaught) {
  const NewGround ground = place({{0, 0}});
  for (const double x : {0.0, 0.5, 1.0})
    for (const double y : {0.25, 1.0}) EXPECT_TRUE(caught(ground, ballAt(x, y, 0.2))) << x << ' ' << y;
}

TEST_F(Box2dWayOut, WhoWasInTheSolidBeforeIsNotCaught) {
  const NewGround ground = place({{0, 0}});
  EXPECT_FALSE(caught(ground, ballAt(0.5, -0.5, 0.3)));
  EXPECT_FALSE(caught(ground, boxAt(0.5, -0.1, 0.3)));  // and a new edge is deep in it
}

// The nearest free place is under the floor; the way there crosses an edge that was there before.
TEST_F(Box2dWayOut, CrossesNoEdgeThatWasThere) {
  std::vector<Cell> cells;
  for (std::int32_t j = 0; j < 4; ++j)
    for (std::int32_t i = -8; i <= 8; ++i) cells.push_back({i, j});
  const NewGround ground = place(cells);
  const auto found = caught(ground, ballAt(0.5, 0.4, 0.2));
  ASSERT_TRUE(found && found->way);
  EXPECT_GT(found->way->y, 3.7 * U);
}

// A cave that is filled: all ways cross what was its wall.
TEST_F(Box2dWayOut, WhoIsWalledInHasNone) {
  for (std::int32_t j = 0; j < 3; ++j)
    for (std::int32_t i = -1; i <= 1; ++i)
      if (i != 0 || j != 1) field.add({i, j}, kSquare);
  const NewGround ground = place({{0, 1}});
  const auto found = test::must(caught(ground, ballAt(0.5, 1.5, 0.3)));
  EXPECT_FALSE(found.way);
}

TEST_F(Box2dWayOut, OfSeveralFormsEachMustBeFree) {
  const NewGround ground = place({{0, 0}, {3, 0}});
  const box2d::Form left = ballAt(0.9, 0.5, 0.2), right = ballAt(2.5, 0.5, 0.2);  // there is a gap of two cells
  const auto found = catchOf(ground, {left, right}, box2d::Whose::free, 0.01 * U);
  ASSERT_TRUE(found && found->way);
  for (box2d::Form form : {left, right}) {
    form.middle = box2d::moved(form.middle, *found->way);
    EXPECT_TRUE(ground.isFree(form));
  }
}

TEST_F(Box2dWayOut, WhatIsLetThroughIsNotCaught) {
  const NewGround ground = place({{0, 0}});
  box2d::Form form = ballAt(0.5, 0.5, 0.3);
  form.holds = [](Block /*block*/) { return false; };
  EXPECT_FALSE(caught(ground, form));
}

}  // namespace
}  // namespace lgs::box2d_test
