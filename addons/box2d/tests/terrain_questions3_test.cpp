// What a terrain answers about contacts and cells in Box2D 3, against the slow way.
#include "oracle/check/isolated.h"
#include "proptests/support/must.h"

#include "distances.h"
#include "physics3.h"
#include "played.h"
#include "proptests/support/scale.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

namespace lgs::box2d_test {
namespace {

using box2d::EdgeId;
using box2d::Terrain;
using box2d::TerrainOptions;
using box2d::Touch;

using Box2d3Questions = Physics3;

b2BodyId addMoving(b2WorldId physics, box2d::Position at, float angle) {
  b2BodyDef definition = b2DefaultBodyDef();
  definition.type = b2_dynamicBody;
  definition.position = at;
  definition.rotation = b2MakeRot(angle);
  return b2CreateBody(physics, &definition);
}

void addShape(b2BodyId body, bool isBall, b2Vec2 half, b2Vec2 at = {0, 0}, bool isSensor = false) {
  b2ShapeDef definition = b2DefaultShapeDef();
  definition.isSensor = isSensor;
  const b2Circle circle{at, half.x};
  const b2Polygon box = b2MakeOffsetBox(half.x, half.y, at, b2MakeRot(at.x));
  if (isBall) {
    b2CreateCircleShape(body, &definition, &circle);
  } else {
    b2CreatePolygonShape(body, &definition, &box);
  }
}

std::vector<b2ContactData> contactsOf(b2BodyId body) {
  std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(body)));
  contacts.resize(
      static_cast<std::size_t>(b2Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size()))));
  return contacts;
}

// --- hit(contact) ----------------------------------------------------------------------------------------------------

bool isSame(b2ShapeId a, b2ShapeId b) { return B2_ID_EQUALS(a, b); }

// The edge's shape by looking through all; the segment nearest to the middle of the contact's points likewise.
void expectTouch3(const World& world, const Terrain& terrain, const b2ContactData& contact, b2BodyId body) {
  EdgeId edge;
  for (const EdgeId id : terrain.edges().edges())
    if (isSame(terrain.shape(id), contact.shapeIdA)) edge = id;
  const std::optional<Touch> touch = terrain.hit(contact);
  ASSERT_EQ(touch.has_value(), static_cast<bool>(edge));
  if (!touch) return;
  EXPECT_TRUE(B2_ID_EQUALS(b2Shape_GetBody(touch->other), body));
  const auto corner = b2Body_GetPosition(b2Shape_GetBody(contact.shapeIdA));
  Place middle{corner.x, corner.y};
  const std::span points(contact.manifold.points, static_cast<std::size_t>(contact.manifold.pointCount));
  for (const b2ManifoldPoint& point : points) {
    middle.x += static_cast<double>(point.anchorA.x) / static_cast<double>(points.size());
    middle.y += static_cast<double>(point.anchorA.y) / static_cast<double>(points.size());
  }
  double least = std::numeric_limits<double>::infinity(), found = least;
  for (const SegmentId id : world.segments()) {
    if (terrain.edges().edgeOf(id) != edge) continue;
    const Segment s = *world.segment(id);
    const double distance = distanceTo(terrain, s, middle);
    least = std::min(least, distance);
    if (id != touch->hit.segment) continue;
    found = distance;
    EXPECT_EQ(std::tie(touch->hit.polygon, touch->hit.block, touch->hit.cell), std::tie(s.polygon, s.block, s.cell));
    EXPECT_NEAR(touch->normal.x, s.normal().x, 1e-6);
    EXPECT_NEAR(touch->normal.y, s.normal().y, 1e-6);
  }
  EXPECT_NEAR(found, least, 1e-4);
}

TEST_F(Box2d3Questions, AContactLeadsToWhatItTouches) {
  const oracle::Shared<std::size_t> touched;
  forAllEdits(60, [&](const Trace& trace, Chance random) {
    // No segment is short, so that none is welded.
    TerrainOptions options{.cellSize = 1'000, .chunkCells = 1 + random.below(6), .merge = random.chance(70)};
    options.origin = firstCell(trace);
    oracle::Player player(trace.preserve);
    Terrain terrain(physics, player.world(), options);
    std::vector<b2BodyId> bodies;
    for (int k = 0; k < 12; ++k) {
      bodies.push_back(
          addMoving(physics, {between(random, 0, 5'000), between(random, 0, 6'000)}, between(random, 0, 3)));
      addShape(bodies.back(), random.chance(50), {between(random, 100, 600), 300});
    }
    b2World_SetGravity(physics, {0, -1'000});
    playAll(trace, player, [&] {
      terrain.commit(player.world());
      step(1);
      for (const b2BodyId body : bodies) {
        for (const b2ContactData& contact : contactsOf(body)) {
          const bool isFirst = B2_ID_EQUALS(b2Shape_GetBody(contact.shapeIdA), body);
          expectTouch3(player.world(), terrain, contact, isFirst ? b2_nullBodyId : body);
          if (terrain.hit(contact)) ++*touched;
        }
      }
    });
    for (const b2BodyId body : bodies) b2DestroyBody(body);
  });
  if (HasFailure() || test::testScale() < 1) return;
  EXPECT_GT(*touched, 1'000U);
}

TEST_F(Box2d3Questions, ABoxOnAMergedFloorTouchesTheCellBelowItsMiddle) {
  field.addFloor(0, 9);
  Terrain terrain(physics, field.world, {.merge = true});
  terrain.commit(field.world);
  const b2BodyId box = addMoving(physics, {5.5F, 0.6F}, 0);
  addShape(box, false, {2, 0.5F});
  step(60);
  const std::vector<b2ContactData> contacts = contactsOf(box);
  ASSERT_EQ(contacts.size(), 1U);
  ASSERT_EQ(contacts[0].manifold.pointCount, 2);
  const Touch touch = test::must(terrain.hit(contacts[0]));
  EXPECT_EQ(touch.hit.cell, (Cell{5, -1}));
  EXPECT_EQ(std::pair(touch.normal.x, touch.normal.y), std::pair(0.0F, 1.0F));
  b2ContactData empty = contacts[0];
  empty.manifold.pointCount = 0;
  EXPECT_FALSE(terrain.hit(empty));
  std::swap(empty.shapeIdA, empty.shapeIdB);
  EXPECT_FALSE(terrain.hit(empty));
}

// --- bodiesIn() ------------------------------------------------------------------------------------------------------

struct Part {
  bool isBall = false, isSensor = false;
  b2Vec2 half{}, at{};
};

double distanceFrom3(b2BodyId body, const Part& part, const Convex& cell) {
  if (part.isBall) return distanceBetween(placeOf(b2Body_GetWorldPoint(body, part.at)), cell) - part.half.x;
  const b2Polygon box = b2MakeOffsetBox(part.half.x, part.half.y, part.at, b2MakeRot(part.at.x));
  Convex corners;
  for (int k = 0; k < box.count; ++k) corners.push_back(placeOf(b2Body_GetWorldPoint(body, box.vertices[k])));
  return distanceBetween(corners, cell) == 0 ? -1 : distanceBetween(corners, cell);
}

TEST_F(Box2d3Questions, BodiesInCellsAreThoseThatReachIntoThem) {
  const oracle::Shared<std::size_t> found;
  const auto law = [&](Chance random) {
    const double size = random.pick(std::vector<double>{0.5, 1, 2});
    Field ground;
    ground.addFloor(0, 5);
    ground.world.commit();
    const Terrain terrain(physics, ground.world, {.cellSize = size});
    const Cell cell{random.below(5), -1 + random.below(5)};
    const CellRect cells{cell, {cell.i + random.below(3), cell.j + random.below(3)}};
    const Convex smaller = convexOf(terrain, cells, 0.005);
    std::vector<b2BodyId> bodies;
    std::vector<double> distances;
    for (int k = 0; k < 8; ++k) {
      bodies.push_back(addMoving(physics, {between(random, -1, 5), between(random, -1, 5)}, between(random, 0, 3)));
      double least = std::numeric_limits<double>::infinity();
      for (int parts = 1 + random.below(2); parts > 0; --parts) {
        const Part part{random.chance(50),
                        random.chance(20),
                        {between(random, 0.05F, 0.8F), between(random, 0.05F, 0.5F)},
                        {between(random, -1, 1), between(random, -1, 1)}};
        addShape(bodies.back(), part.isBall, part.half, part.at, part.isSensor);
        if (!part.isSensor) least = std::min(least, distanceFrom3(bodies.back(), part, smaller));
      }
      distances.push_back(least);
    }
    const std::vector<b2BodyId> in = terrain.bodiesIn(cells);
    const bool isClear = std::none_of(distances.begin(), distances.end(), [](double d) { return std::abs(d) < 1e-3; });
    std::size_t expected = 0;
    for (std::size_t k = 0; k < bodies.size() && isClear; ++k) {
      expected += distances[k] < 0 ? 1 : 0;
      const auto isThis = [&](b2BodyId body) { return B2_ID_EQUALS(body, bodies[k]); };
      EXPECT_EQ(std::count_if(in.begin(), in.end(), isThis), distances[k] < 0 ? 1 : 0) << distances[k];
    }
    if (isClear) {
      EXPECT_EQ(in.size(), expected) << "a body of the terrain's";
    }
    *found += expected;
    for (const b2BodyId body : bodies) b2DestroyBody(body);
  };
  test::forAll(300, law);
  if (HasFailure() || test::testScale() < 1) return;
  EXPECT_GT(*found, 100U);
}

TEST_F(Box2d3Questions, BodiesThatRestBesideACellAreNotInIt) {
  field.addFloor(0, 5);
  field.add({4, 0}, kSquare);  // a wall
  field.world.commit();
  const Terrain terrain(physics, field.world);
  const b2BodyId box = addMoving(physics, {3.49F, 0.52F}, 0);
  addShape(box, false, {0.5F, 0.5F});
  const b2BodyId ball = addMoving(physics, {1.5F, 0.4F}, 0);
  addShape(ball, true, {0.35F, 0});
  step(120);
  ASSERT_EQ(terrain.bodiesIn(Cell{3, 0}).size(), 1U);
  EXPECT_TRUE(B2_ID_EQUALS(terrain.bodiesIn(Cell{3, 0})[0], box));
  ASSERT_EQ(terrain.bodiesIn(Cell{1, 0}).size(), 1U);
  EXPECT_TRUE(B2_ID_EQUALS(terrain.bodiesIn(Cell{1, 0})[0], ball));
  EXPECT_EQ(terrain.bodiesIn({{0, -1}, {5, 1}}).size(), 2U);
  EXPECT_TRUE(terrain.bodiesIn({{3, 0}, {2, 0}}).empty()) << "of no cells";
  for (const Cell cell : {Cell{1, -1}, {3, -1}, {4, 0}, {0, 0}, {1, 1}})
    EXPECT_TRUE(terrain.bodiesIn(cell).empty()) << cell.i << ", " << cell.j;
}

}  // namespace
}  // namespace lgs::box2d_test
