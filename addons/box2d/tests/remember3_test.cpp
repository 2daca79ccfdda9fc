// Box2D 3.2's snapshots: the terrain rolls back with them, and all goes on to the last bit.
#include "physics3.h"
#include "shapes3.h"

#include <gtest/gtest.h>
#include <lgs/box2d/terrain.h>
#include <cstdint>
#include <tuple>
#include <vector>

namespace lgs::box2d_test {
namespace {

using box2d::Terrain;
using box2d::TerrainOptions;
using Image = std::vector<std::uint8_t>;

// Older ones have no snapshots.
template <class World>
constexpr bool kHasSnapshots = requires(World physics) {
  b2World_Snapshot(physics, nullptr, 0);
};

template <class WorldId>
Image imageOf(WorldId physics) {
  Image image(static_cast<std::size_t>(b2World_Snapshot(physics, nullptr, 0)));
  EXPECT_EQ(b2World_Snapshot(physics, image.data(), static_cast<int>(image.size())), static_cast<int>(image.size()));
  return image;
}

template <class WorldId>
bool restore(WorldId physics, const Image& image) {
  return b2World_Restore(physics, image.data(), static_cast<int>(image.size()));
}

class Box2dRemember : public Physics3 {
 public:
  Box2dRemember() {
    for (std::int32_t j = 0; j < 6; ++j) EXPECT_TRUE(field.world.fill({{-20, -1 - j}, {20, -1 - j}}, square(), 1));
    for (std::int32_t i = -18; i < 18; i += 5) EXPECT_TRUE(field.world.add({i, 0}, {{0, 0}, {U, 0}, {U, U / 2}}, 2));
    field.world.commit();
    for (int k = 0; k < 30; ++k)
      balls.push_back(addBall({-15 + static_cast<float>(k), 2 + 0.3F * static_cast<float>(k % 5)}, 0.4F));
  }
  ShapeId square() { return *field.world.shape(kUnitSquare); }

  using Places = std::vector<std::tuple<double, double, float, float, float, float, std::uint32_t>>;
  /// Steps and digs, and all that there is to see.
  template <class WorldId>
  Places play(WorldId of, Terrain& terrain, int steps) {
    Places places;
    for (int k = 0; k < steps; ++k) {
      if (k % 7 == 3) {
        const auto at = terrain.cellAt(b2Body_GetPosition(balls[static_cast<std::size_t>(k) % balls.size()]));
        field.world.clear({{at.i - 1, at.j - 2}, {at.i, at.j - 1}});
        EXPECT_TRUE(terrain.commit(field.world));
      }
      b2World_Step(of, 1.0F / 60, 4);
      terrain.afterStep();
      for (const b2BodyId ball : balls) {
        const auto at = b2Body_GetPosition(ball);
        const b2Rot turned = b2Body_GetRotation(ball);
        const b2Vec2 speed = b2Body_GetLinearVelocity(ball);
        std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(ball)));
        contacts.resize(
            static_cast<std::size_t>(b2Body_GetContactData(ball, contacts.data(), static_cast<int>(contacts.size()))));
        std::uint32_t touched = 0;
        for (const b2ContactData& contact : contacts)
          if (const auto touch = terrain.hit(contact)) touched += touch->hit.segment.value;
        places.emplace_back(at.x, at.y, turned.c, turned.s, speed.x, speed.y, touched);
      }
    }
    return places;
  }

  std::vector<b2BodyId> balls;
};

template <class Test, class WorldId>
void replay(Test& test, World& world, WorldId physics, const TerrainOptions& options) {
  Terrain terrain(physics, world, options);
  test.play(physics, terrain, 60);
  const Mark mark = world.mark();
  const Terrain::MemoryPtr memory = terrain.remember();
  const Image image = imageOf(physics);
  const auto first = test.play(physics, terrain, 200);
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(restore(physics, image));
    ASSERT_TRUE(world.rollBack(mark));
    terrain.recall(memory);
    EXPECT_TRUE(terrain.isCurrent());
    expectShapes(physics, terrain, options);
    EXPECT_EQ(test.play(physics, terrain, 200), first);
  }
}

TEST_F(Box2dRemember, AReplayOfDigsIsEqualToTheLastBit) {
  if constexpr (kHasSnapshots<b2WorldId>) {
    replay(*this, field.world, physics, TerrainOptions{.chunkCells = 8});
  } else {
    GTEST_SKIP() << "this Box2D has no snapshots";
  }
}

template <class WorldId>
void digRollBackAndRestore(WorldId physics, World& world) {
  TerrainOptions options{.cellSize = 0.5};
  Terrain terrain(physics, world, options);
  const Image image = imageOf(physics);
  const Mark mark = world.mark();
  const auto memory = terrain.remember();
  terrain.moveOrigin({3, 3});
  world.clear({{-3, -2}, {3, -1}});
  ASSERT_TRUE(terrain.commit(world));
  ASSERT_TRUE(world.rollBack(mark));
  ASSERT_TRUE(terrain.sync(world.changesOfRollBack()));
  ASSERT_TRUE(restore(physics, image));
  terrain.recall(memory);
  expectShapes(physics, terrain, options);
  for (const SegmentId id : world.segments()) EXPECT_TRUE(terrain.hit(terrain.shape(id)));
  for (const b2BodyId body : terrain.bodiesIn({{-40, -1}, {40, 20}})) EXPECT_EQ(b2Body_GetType(body), b2_dynamicBody);
  world.clear({{-3, -2}, {3, -1}});
  ASSERT_TRUE(terrain.commit(world));
  expectShapes(physics, terrain, options);
  // A commit and its opposite have other versions than the mark.
  ASSERT_TRUE(world.rollBack(mark));
  ASSERT_TRUE(terrain.sync(world.changesOfRollBack()));
  const auto again = terrain.remember();
  const Image now = imageOf(physics);
  const PolygonHandle more = *world.add({0, 9}, kUnitSquare, 1);
  world.commit();
  ASSERT_TRUE(world.remove(more));
  world.commit();
  ASSERT_TRUE(restore(physics, now));
  terrain.recall(again);
  EXPECT_TRUE(terrain.isCurrent());
  expectShapes(physics, terrain, options);
}

TEST_F(Box2dRemember, DigRollBackSyncRestoreAndDigAgain) {
  if constexpr (kHasSnapshots<b2WorldId>) {
    digRollBackAndRestore(physics, field.world);
  } else {
    GTEST_SKIP() << "this Box2D has no snapshots";
  }
}

/// Contacts have ids since a state after 3.1.
template <class Data>
void expectHitsById(Terrain& terrain, b2BodyId ball) {
  if constexpr (requires(Data data) { terrain.hit(data.contactId); }) {
    std::vector<Data> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(ball)));
    const int count = b2Body_GetContactData(ball, contacts.data(), static_cast<int>(contacts.size()));
    ASSERT_GT(count, 0);
    const auto byData = terrain.hit(contacts[0]), byId = terrain.hit(contacts[0].contactId);
    ASSERT_TRUE(byData && byId);
    EXPECT_EQ(byData->hit.segment, byId->hit.segment);
    b2DestroyBody(ball);
    EXPECT_FALSE(terrain.hit(contacts[0].contactId)) << "it is no more";
  }
}

TEST_F(Box2dRemember, AContactIsHitByItsId) {
  Terrain terrain(physics, field.world, {.chunkCells = 8});
  step(120);
  expectHitsById<b2ContactData>(terrain, balls[3]);
}

}  // namespace
}  // namespace lgs::box2d_test
