// What a terrain answers about contacts and cells in Box2D 2.4, against the slow way.
#include "oracle/check/isolated.h"

#include "distances.h"
#include "either.h"
#include "played.h"
#include "proptests/support/scale.h"

#include <lgs/box2d/terrain.h>
#include <set>

namespace lgs::box2d_test {
namespace {

using box2d::Terrain;
using box2d::TerrainOptions;
using box2d::Touch;

b2Body& addMoving(b2World& physics, b2Vec2 at, float angle = 0) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = at;
  definition.angle = angle;
  return *physics.CreateBody(&definition);
}

b2Fixture& addCircle(b2Body& body, float radius, b2Vec2 at = {0, 0}) {
  b2CircleShape circle;
  circle.m_radius = radius;
  circle.m_p = at;
  return *body.CreateFixture(&circle, 1);
}

b2Fixture& addBox(b2Body& body, b2Vec2 half, b2Vec2 at = {0, 0}, float angle = 0) {
  b2PolygonShape box;
  box.SetAsBox(half.x, half.y, at, angle);
  return *body.CreateFixture(&box, 1);
}

using Box2dQuestions = EitherBox2d;

// --- hit(contact) ----------------------------------------------------------------------------------------------------

// The middle of a contact's points, from its manifold by hand.
b2Vec2 middleOf(b2Contact& contact) {
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  b2Vec2 sum{0, 0};
  const int count = contact.GetManifold()->pointCount;
  for (int k = 0; k < count; ++k) sum += manifold.points[k];
  if (count > 0) return {sum.x / static_cast<float>(count), sum.y / static_cast<float>(count)};
  return contact.GetFixtureB()->GetAABB(contact.GetChildIndexB()).GetCenter();
}

void expectTouch(const World& world, const Terrain& terrain, b2Contact& contact) {
  std::set<const b2Fixture*> own;
  std::map<const b2Fixture*, std::vector<Segment>> behind;
  for (const SegmentId id : world.segments())
    if (const b2Fixture* fixture = terrain.fixture(id)) behind[fixture].push_back(*world.segment(id));
  const bool first = behind.contains(contact.GetFixtureA());
  const std::optional<Touch> touch = terrain.hit(contact);
  ASSERT_EQ(touch.has_value(), contact.IsTouching() && (first || behind.contains(contact.GetFixtureB())));
  if (!touch) return;
  EXPECT_EQ(touch->other, first ? contact.GetFixtureB() : contact.GetFixtureA());
  const std::vector<Segment>& segments = behind[first ? contact.GetFixtureA() : contact.GetFixtureB()];
  const b2Vec2 middle = middleOf(contact);
  double least = std::numeric_limits<double>::infinity(), found = least;
  for (const Segment& s : segments) {
    const double distance = distanceTo(terrain, s, placeOf(middle));
    least = std::min(least, distance);
    if (s.id == touch->hit.segment) found = distance;
    if (s.id != touch->hit.segment) continue;
    EXPECT_EQ(std::tie(touch->hit.polygon, touch->hit.block, touch->hit.cell), std::tie(s.polygon, s.block, s.cell));
    if (segments.size() > 1 && !terrain.edges().options().merge) continue;  // welded: the edge is not parallel to it
    EXPECT_NEAR(touch->normal.x, s.normal().x, 1e-6);
    EXPECT_NEAR(touch->normal.y, s.normal().y, 1e-6);
  }
  EXPECT_NEAR(found, least, 1e-5);
}

TEST_F(Box2dQuestions, AContactLeadsToWhatItTouches) {
  const oracle::Shared<std::size_t> touched;
  forAllEdits(60, [&](const Trace& trace, Chance random) {
    // No segment is short, so that none is welded.
    TerrainOptions options{.cellSize = 1'000, .chunkCells = 1 + random.below(6), .merge = random.chance(70)};
    if (!trace.calls.empty()) options.origin = test::boundsOf(trace).min;
    oracle::Player player(trace.preserve);
    b2World still({0, -1'000});
    Terrain terrain(still, player.world(), options);
    for (int k = 0; k < 12; ++k) {
      b2Body& body = addMoving(still, {between(random, 0, 5'000), between(random, 0, 6'000)}, between(random, 0, 3));
      b2Fixture& fixture = random.chance(50) ? addCircle(body, between(random, 100, 600))
                                             : addBox(body, {300, between(random, 100, 600)});
      fixture.SetSensor(random.chance(30));
    }
    playAll(trace, player, [&] {
      terrain.commit(player.world());
      still.Step(1.0F / 60, 8, 3);
      for (b2Contact* contact = still.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        expectTouch(player.world(), terrain, *contact);
        if (terrain.hit(*contact)) ++*touched;
      }
    });
  });
  if (HasFailure() || test::testScale() < 1) return;
  EXPECT_GT(*touched, 1'000U);
}

TEST_F(Box2dQuestions, ABoxOnAMergedFloorTouchesTheCellBelowItsMiddle) {
  field.addFloor(0, 9);
  Terrain terrain(physics, field.world, {.merge = true});
  terrain.commit(field.world);
  b2Body& box = addMoving(physics, {5.5F, 1});
  addBox(box, {2, 0.5F});
  step(60);
  int touches = 0;
  for (b2ContactEdge* c = box.GetContactList(); c != nullptr; c = c->next) {
    const std::optional<Touch> touch = terrain.hit(*c->contact);
    ASSERT_EQ(touch.has_value(), c->contact->IsTouching());
    if (!touch) continue;
    ++touches;
    EXPECT_EQ(touch->hit.cell, (Cell{5, -1}));
    EXPECT_EQ(touch->normal, b2Vec2(0, 1));
    EXPECT_EQ(touch->other->GetBody(), &box);
  }
  EXPECT_EQ(touches, 1);
}

// --- bodiesIn() ------------------------------------------------------------------------------------------------------

// From a body of circles and polygons with their skin, sensors apart: less than 0 if one reaches into the cell.
double distanceFrom(const b2Body& body, const Convex& cell) {
  double least = std::numeric_limits<double>::infinity();
  for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) {
    if (f->IsSensor()) continue;
    if (f->GetType() == b2Shape::e_circle) {
      const auto& circle = static_cast<const b2CircleShape&>(*f->GetShape());
      least = std::min(least, distanceBetween(placeOf(body.GetWorldPoint(circle.m_p)), cell) - circle.m_radius);
      continue;
    }
    const auto& polygon = static_cast<const b2PolygonShape&>(*f->GetShape());
    Convex corners;
    for (int k = 0; k < polygon.m_count; ++k) corners.push_back(placeOf(body.GetWorldPoint(polygon.m_vertices[k])));
    least = std::min(least, distanceBetween(corners, cell) - b2_polygonRadius);
  }
  return least;
}

TEST_F(Box2dQuestions, BodiesInCellsAreThoseThatReachIntoThem) {
  const oracle::Shared<std::size_t> found;
  test::forAll(300, [&](Chance random) {
    const double size = random.pick(std::vector<double>{0.5, 1, 2});
    Field ground;
    ground.addFloor(0, 5);
    ground.world.commit();
    b2World still({0, 0});
    const Terrain terrain(still, ground.world, {.cellSize = size});
    std::vector<b2Body*> bodies;
    for (int k = 0; k < 8; ++k) {
      b2Body& body = addMoving(still, {between(random, -1, 5), between(random, -1, 5)}, between(random, 0, 3));
      for (int fixtures = 1 + random.below(2); fixtures > 0; --fixtures) {
        const b2Vec2 at{between(random, -1, 1), between(random, -1, 1)};
        const float width = between(random, 0.05F, 0.8F);
        b2Fixture& fixture = random.chance(50) ? addCircle(body, width, at)
                                               : addBox(body, {width, between(random, 0.05F, 0.5F)}, at, at.x);
        fixture.SetSensor(random.chance(20));
      }
      bodies.push_back(&body);
    }
    const Cell cell{random.below(5), -1 + random.below(5)};
    const CellRect cells{cell, {cell.i + random.below(3), cell.j + random.below(3)}};
    const std::vector<b2Body*> in = terrain.bodiesIn(cells);
    EXPECT_EQ(std::set(in.begin(), in.end()).size(), in.size()) << "a body is there twice";
    std::size_t expected = 0;
    for (b2Body* body : bodies) {
      const double distance = distanceFrom(*body, convexOf(terrain, cells));
      if (std::abs(distance) < 1e-4) return;  // too near to tell
      expected += distance < 0 ? 1 : 0;
      EXPECT_EQ(std::count(in.begin(), in.end(), body), distance < 0 ? 1 : 0) << distance;
    }
    EXPECT_EQ(in.size(), expected) << "a body of the terrain's";
    *found += expected;
  });
  if (HasFailure() || test::testScale() < 1) return;
  EXPECT_GT(*found, 100U);
}

TEST_F(Box2dQuestions, BodiesThatRestBesideACellAreNotInIt) {
  field.addFloor(0, 5);
  field.add({4, 0}, kSquare);  // a wall
  field.world.commit();
  Terrain terrain(physics, field.world);
  b2Body& box = addMoving(physics, {3.48F, 0.52F});
  addBox(box, {0.5F, 0.5F});
  b2Body& ball = addMoving(physics, {1.5F, 0.4F});
  addCircle(ball, 0.35F);
  step(120);
  EXPECT_EQ(terrain.bodiesIn(Cell{3, 0}), std::vector<b2Body*>{&box});
  EXPECT_EQ(terrain.bodiesIn(Cell{1, 0}), std::vector<b2Body*>{&ball});
  EXPECT_EQ(terrain.bodiesIn({{0, -1}, {5, 1}}).size(), 2U);
  EXPECT_TRUE(terrain.bodiesIn({{3, 0}, {2, 0}}).empty()) << "of no cells";
  for (const Cell cell : {Cell{1, -1}, {3, -1}, {4, 0}, {0, 0}, {1, 1}})
    EXPECT_TRUE(terrain.bodiesIn(cell).empty()) << cell.i << ", " << cell.j;
}

// A chain has several children; the second one reaches into the cell.
TEST_F(Box2dQuestions, EachPartOfAChainIsLookedAt) {
  const Terrain terrain(physics, field.world);
  b2Body& body = addMoving(physics, {0, 0});
  const b2Vec2 vertices[] = {{-5, 0}, {-2, 0.5F}, {0.5F, 0.5F}};
  b2ChainShape chain;
  chain.CreateChain(vertices, 3, {-6, 0}, {1, 0.5F});
  body.CreateFixture(&chain, 1);
  EXPECT_EQ(terrain.bodiesIn(Cell{0, 0}), std::vector<b2Body*>{&body});
}

}  // namespace
}  // namespace lgs::box2d_test
