// Law 13 where places are rounded to floats: for whichever Box2D there is.
#include "crowd.h"
#include "field.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"

#include <algorithm>

namespace lgs::box2d_test {
namespace {

using box2d::Terrain;
using test::Chance;

#ifndef B2_IS_NULL
Crowd::Position worldPoint(b2Body* body, b2Vec2 local) { return body->GetWorldPoint(local); }
void turnTo(b2Body* body, float angle) { body->SetTransform(body->GetPosition(), angle); }
#else
Crowd::Position worldPoint(b2BodyId body, b2Vec2 local) { return b2Body_GetWorldPoint(body, local); }
void turnTo(b2BodyId body, float angle) { b2Body_SetTransform(body, b2Body_GetPosition(body), b2MakeRot(angle)); }
#endif

float again(float angle) { return std::atan2(std::sin(angle), std::cos(angle)); }

/// So far away that a float in metres is 32 lattice units.
constexpr Cell kFarUp{0, 4'096};

class Box2dRounding : public testing::Test {
 protected:
  Box2dRounding() {
    field.addFloor(-8, 8);
    field.world.commit();
  }
  bool isFree(const Terrain& terrain, Crowd::Body body) const {
    return field.world.at(terrain.latticePoint(Crowd::middlesOf(body)[0])).where == Spot::Where::outside;
  }
  /// A ball whose middle is 0.6 lattice units above the floor, so that it is free; and then the origin moves, and the
  /// game rounds its place to the line of the floor.
  Crowd::Body atTheFloor(Terrain& terrain) {
    const Crowd::Body body = crowd.add(Figure::circle, 0.7F, {0.5F, 0.6F / U});
    terrain.resync();  // notes where bodies are
    EXPECT_TRUE(isFree(terrain, body));
    crowd.moveOrigin(terrain, kFarUp);
    return body;
  }
  Field field;
  Crowd crowd;
};

TEST_F(Box2dRounding, WhoIsRoundedIntoTheGroundWhenTheOriginMovesIsFreeAtOnce) {
  Terrain terrain(crowd.physics, field.world);
  const Crowd::Body body = atTheFloor(terrain);
  EXPECT_TRUE(isFree(terrain, body));
  EXPECT_NEAR(Crowd::positionOf(body).y, -4'096, 0.001);
}

TEST_F(Box2dRounding, WhoIsPutBackAfterTheOriginMovedIsFree) {
  Terrain terrain(crowd.physics, field.world);
  const Crowd::Body body = atTheFloor(terrain);
  Crowd::put(body, {0.5F, -4'096.3F});
  Crowd::kick(body, {0, -1});
  crowd.step();
  ASSERT_EQ(terrain.afterStep().size(), 1U);
  EXPECT_TRUE(isFree(terrain, body));
  EXPECT_NEAR(Crowd::positionOf(body).y, -4'096, 0.001);
}

// Its middle is beside the origin of its body: where that is turned by the last bit, it may be in the ground.
LGS_LAW(Box2dRoundedPlaces, WhoIsPutBackIsTurnedAsItWas, 500, (Chance random)) {
  Field field;
  field.addFloor(-8, 8);
  field.world.commit();
  Crowd crowd;
  Terrain terrain(crowd.physics, field.world);
  const auto body = crowd.add(Figure::triangle, 2, {0.5F, 1});
  float angle = 0;  // one that changes when it is taken from its sine and cosine again and again
  for (int k = 0; k < 200 && again(angle) == again(again(angle)); ++k)
    angle = 1e-6F * static_cast<float>(random.below(3'000'000));
  turnTo(body, angle);
  const auto isFree = [&] {
    return field.world.at(terrain.latticePoint(Crowd::middlesOf(body)[0])).where == Spot::Where::outside;
  };
  float solid = -0.5F, free = 0.5F;  // as near to the floor as it is free
  for (int k = 0; k < 40; ++k) {
    const float y = (solid + free) / 2;
    Crowd::put(body, {0.5F, y});
    (isFree() ? free : solid) = y;
  }
  Crowd::put(body, {0.5F, free});
  terrain.resync();
  Crowd::put(body, {0.5F, free - 0.3F});
  Crowd::kick(body, {0, -1});
  crowd.step();
  ASSERT_EQ(terrain.afterStep().size(), 1U);
  EXPECT_TRUE(isFree());
}

// A stick is as thin as what Box2D lets overlap, so its way may end with the middle on the outline.
LGS_LAW(Box2dRoundedPlaces, WhoIsPushedOutIsFreeWhereTheWayIsRounded, 100, (Chance random)) {
  Field field;
  field.addFloor(-8, 8);
  field.world.commit();
  Crowd crowd;
  Terrain terrain(crowd.physics, field.world, {.origin = kFarUp});
  for (int k = 0; k < 20; ++k) {
    const float x = static_cast<float>(random.below(1'000)) / 1'000;
    const float y = static_cast<float>(1 + random.below(999)) / 1'000;
    turnTo(crowd.add(Figure::stick, 0.1F, {x, y - 4'096}), 0.01F * static_cast<float>(random.below(314)));
  }
  field.add({0, 0}, kSquare);
  ASSERT_TRUE(terrain.commit(field.world));
  for (const Crowd::Body body : crowd.bodies) {
    const Point middle = terrain.latticePoint(Crowd::middlesOf(body)[0]);
    EXPECT_TRUE(!Crowd::isEnabled(body) || field.world.at(middle).where == Spot::Where::outside) << middle.y;
  }
}

// What is free is told of the place that Box2D says, rounded as it rounds.
LGS_LAW(Box2dRoundedPlaces, OutlinesAreWhereBox2dSaysThatTheCornersAre, 100, (Chance random)) {
  Field field;
  Crowd crowd;
  const Cell origin{random.below(8'000) - 4'000, random.below(8'000) - 4'000};
  Terrain terrain(crowd.physics, field.world, {.cellSize = 0.5, .origin = origin});
  const auto metres = [&] { return static_cast<float>(random.below(1 << 24)) / (1 << 14) - 512; };
  const auto body = crowd.add(Figure::triangle, 0.7F, {metres(), metres()});
  turnTo(body, 0.001F * static_cast<float>(random.below(6'283)));
  const auto outlines = terrain.outlinesOf(body);
  ASSERT_EQ(outlines.size(), 1U);
  std::vector<Point> corners;
  for (const b2Vec2 corner : cornersOf(Figure::triangle, 0.7F))
    corners.push_back(terrain.latticePoint(worldPoint(body, corner)));
  for (const Point corner : outlines[0])
    EXPECT_NE(std::find(corners.begin(), corners.end(), corner), corners.end()) << corner.x << ' ' << corner.y;
}

}  // namespace
}  // namespace lgs::box2d_test
