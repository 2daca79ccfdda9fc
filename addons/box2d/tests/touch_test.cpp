// A contact of what is only near leads nowhere: for whichever Box2D there is.
#include "either.h"

#include <map>
#include <string>

namespace lgs::box2d_test {
namespace {

using box2d::Terrain;

class Box2dTouch : public EitherBox2d {
 protected:
  Box2dTouch() {
    field.addFloor(0, 9);
    field.add({5, 0}, kSquare);  // a wall
    field.world.commit();
  }
};

// Who digs what the contacts say would dig the wall, although the ball is 3 cm away from it.
TEST_F(Box2dTouch, WhatIsOnlyNearIsNotHit) {
  const Terrain terrain(physics, field.world);
  for (const Form form : {Form::ball, Form::box}) {
    const Body body = addBody({4.62F, 0.36F}, form, 0.5F);
    step(30);
    ASSERT_NEAR(positionOf(body).x, 4.62F, 1e-3F);
    EXPECT_GT(contactCount(body), 1U) << "Box2D has no contact with the wall";
    EXPECT_EQ(touchedCells(terrain, body), (std::vector<Cell>{{4, -1}}));
    moveTo(body, {4.655F, positionOf(body).y});
    setVelocity(body, {1, 0});
    step(5);
    EXPECT_EQ(touchedCells(terrain, body).size(), 2U);  // the wall, too
    destroy(body);
  }
}

#ifndef B2_IS_NULL  // Box2D 2.4; in Box2D 3 there is no listener

// Counts what hit() answers in each function.
class Listener : public b2ContactListener {
 public:
  explicit Listener(const Terrain& terrain) : terrain_(terrain) {}
  void BeginContact(b2Contact* contact) override { count("begin", *contact); }
  void PreSolve(b2Contact* contact, const b2Manifold* /*before*/) override { count("pre", *contact); }
  void PostSolve(b2Contact* contact, const b2ContactImpulse* /*impulse*/) override { count("post", *contact); }
  void EndContact(b2Contact* contact) override {
    count("end", *contact);
    knowsFixture = terrain_.hit(*contact->GetFixtureA()).has_value();
  }
  std::map<std::string, std::pair<int, int>> counts;  // calls, and hits
  bool knowsFixture = false;

 private:
  void count(const std::string& function, b2Contact& contact) {
    ++counts[function].first;
    counts[function].second += terrain_.hit(contact) ? 1 : 0;
  }
  const Terrain& terrain_;
};

TEST_F(Box2dTouch, AListenerIsAnsweredUntilTheContactEnds) {
  const Terrain terrain(physics, field.world);
  Listener listener(terrain);
  physics.SetContactListener(&listener);
  const Body body = addBody({2.5F, 0.5F}, Form::ball, 0.5F);
  step(30);
  for (const char* function : {"begin", "pre", "post"}) {
    EXPECT_GT(listener.counts[function].first, 0) << function;
    EXPECT_EQ(listener.counts[function].first, listener.counts[function].second) << function;
  }
  setVelocity(body, {0, 5});
  step(10);
  EXPECT_EQ(listener.counts["end"], std::pair(1, 0));
  EXPECT_TRUE(listener.knowsFixture);
  physics.SetContactListener(nullptr);
}

#endif

}  // namespace
}  // namespace lgs::box2d_test
