// Materials in Box2D 3: each flag reaches the shapes of its block, and no others.
#include "physics3.h"

#include <set>
#include <span>

namespace lgs::box2d_test {
namespace {

using box2d::Material;
using box2d::Terrain;
using box2d::TerrainOptions;
using Flag = bool Material::*;

constexpr Flag kFlags[] = {&Material::enableSensorEvents, &Material::enableContactEvents, &Material::enableHitEvents,
                           &Material::enablePreSolveEvents, &Material::enableCustomFiltering};

TEST(Box2d3Material, EveryMemberCounts) {
  std::vector<Material> materials(15);
  materials[1].surface.friction = 0.25F;
  materials[2].surface.restitution = 0.25F;
  materials[3].surface.rollingResistance = 0.25F;
  materials[4].surface.tangentSpeed = 0.25F;
  materials[5].surface.userMaterialId = 7;
  materials[6].surface.customColor = 7;
  materials[7].filter.categoryBits = 8;
  materials[8].filter.maskBits = 8;
  materials[9].filter.groupIndex = 8;
  for (std::size_t k = 0; k < std::size(kFlags); ++k) materials[10 + k].*kFlags[k] = true;
  for (const Material& other : materials) EXPECT_EQ(other == materials[0], &other == &materials[0]);
}

// A floor: block 1 on the left, block 2 on the right. Block 2 has a flag. A ball falls on each.
class Box2d3Flags : public Physics3 {
 protected:
  Box2d3Flags() {
    for (std::int32_t i = 0; i < 4; ++i) field.add({i, -1}, kSquare, 1);
    for (std::int32_t i = 4; i < 8; ++i) field.add({i, -1}, kSquare, 2);
    field.world.commit();
  }

  TerrainOptions withFlag(Flag flag) const {
    TerrainOptions options;
    options.merge = true;
    options.material = [flag](Block block) {
      Material material;
      material.*flag = block == 2;
      return material;
    };
    return options;
  }

  // The blocks in events of 60 steps. Events whose shapes are not the terrain's do not count.
  template <class Events>
  std::set<Block> blocksIn(const Terrain& terrain, Events events) const {
    std::set<Block> blocks;
    for (int k = 0; k < 60; ++k) {
      step(1);
      for (const b2ShapeId shape : events()) {
        if (const auto hit = terrain.hit(shape)) blocks.insert(hit->block);
      }
    }
    return blocks;
  }

  b2BodyId left = addBall({1.5F, 1}, 0.5F);
  b2BodyId right = addBall({6.5F, 1}, 0.5F);
};

template <class Event>
std::vector<b2ShapeId> shapesOf(const Event* events, int count) {
  std::vector<b2ShapeId> shapes;
  for (const Event& event : std::span(events, static_cast<std::size_t>(count))) {
    shapes.push_back(event.shapeIdA);
    shapes.push_back(event.shapeIdB);
  }
  return shapes;
}

TEST_F(Box2d3Flags, AContactEventComesFromTheBlockWithTheFlag) {
  const Terrain terrain(physics, field.world, withFlag(&Material::enableContactEvents));
  EXPECT_EQ(blocksIn(terrain,
                     [&] {
                       const b2ContactEvents events = b2World_GetContactEvents(physics);
                       return shapesOf(events.beginEvents, events.beginCount);
                     }),
            std::set<Block>{2});
}

TEST_F(Box2d3Flags, AHitEventComesFromTheBlockWithTheFlagAndItsPointFindsTheCell) {
  const Terrain terrain(physics, field.world, withFlag(&Material::enableHitEvents));
  std::set<std::int32_t> columns;
  EXPECT_EQ(blocksIn(terrain,
                     [&] {
                       const b2ContactEvents events = b2World_GetContactEvents(physics);
                       for (int k = 0; k < events.hitCount; ++k) {
                         const b2ContactHitEvent& event = events.hitEvents[k];
                         for (const b2ShapeId shape : {event.shapeIdA, event.shapeIdB}) {
                           if (const auto hit = terrain.hit(shape, event.point)) columns.insert(hit->cell.i);
                         }
                       }
                       return shapesOf(events.hitEvents, events.hitCount);
                     }),
            std::set<Block>{2});
  EXPECT_EQ(columns, std::set<std::int32_t>{6});  // the edge is one, merged of four cells
}

TEST_F(Box2d3Flags, ASensorSeesTheBlockWithTheFlag) {
  const Terrain terrain(physics, field.world, withFlag(&Material::enableSensorEvents));
  addBall({2.5F, 1}, 0, true);
  addBall({5.5F, 1}, 0, true);
  EXPECT_EQ(blocksIn(terrain,
                     [&] {
                       const b2SensorEvents events = b2World_GetSensorEvents(physics);
                       std::vector<b2ShapeId> shapes;
                       for (int k = 0; k < events.beginCount; ++k)
                         shapes.push_back(events.beginEvents[k].visitorShapeId);
                       return shapes;
                     }),
            std::set<Block>{2});
}

// Notes the shapes that it is asked about. Some versions return whether there is contact, later ones nothing.
template <class Result>
Result notePreSolve(b2ShapeId a, b2ShapeId b, b2Manifold* /*manifold*/, void* context) {
  auto& shapes = *static_cast<std::vector<b2ShapeId>*>(context);
  shapes.insert(shapes.end(), {a, b});
  return static_cast<Result>(true);
}

template <class WorldId>
void notePreSolves(WorldId physics, std::vector<b2ShapeId>& shapes) {
  if constexpr (requires { b2World_SetPreSolveCallback(physics, notePreSolve<bool>, &shapes); }) {
    b2World_SetPreSolveCallback(physics, notePreSolve<bool>, &shapes);
  } else {
    b2World_SetPreSolveCallback(physics, notePreSolve<void>, nullptr, &shapes);
  }
}

TEST_F(Box2d3Flags, PreSolveIsCalledForTheBlockWithTheFlag) {
  const Terrain terrain(physics, field.world, withFlag(&Material::enablePreSolveEvents));
  std::vector<b2ShapeId> shapes;
  notePreSolves(physics, shapes);
  EXPECT_EQ(blocksIn(terrain, [&] { return shapes; }), std::set<Block>{2});
}

template <class ShapeDef>
constexpr bool kAsksAboutAll = !requires(ShapeDef definition) {
  definition.enableCustomFiltering;
};

TEST_F(Box2d3Flags, TheCustomFilterIsAskedAboutTheBlockWithTheFlag) {
  const Terrain terrain(physics, field.world, withFlag(&Material::enableCustomFiltering));
  b2World_SetCustomFilterCallback(
      physics, [](b2ShapeId, b2ShapeId, void*) { return false; }, nullptr);
  step(60);
  EXPECT_LT(heightOf(right), -1);
  EXPECT_EQ(heightOf(left) < -1, kAsksAboutAll<b2ShapeDef>);
}

TEST_F(Box2d3Flags, AShapeThatGetsAnotherGhostKeepsItsFlags) {
  for (const Flag flag : kFlags) {
    Terrain terrain(physics, field.world, withFlag(flag));
    const PolygonHandle wall = field.add({5, 0}, kSquare, 1);
    terrain.sync(field.world.commit());
    for (const SegmentId id : field.world.segments()) {
      const b2ShapeId shape = terrain.shape(id);
      const bool flagged = field.world.segment(id)->block == 2;
      EXPECT_EQ(b2Shape_AreSensorEventsEnabled(shape), flagged && flag == &Material::enableSensorEvents);
      EXPECT_EQ(b2Shape_AreContactEventsEnabled(shape), flagged && flag == &Material::enableContactEvents);
      EXPECT_EQ(b2Shape_AreHitEventsEnabled(shape), flagged && flag == &Material::enableHitEvents);
      EXPECT_EQ(b2Shape_ArePreSolveEventsEnabled(shape), flagged && flag == &Material::enablePreSolveEvents);
    }
    ASSERT_TRUE(field.world.remove(wall));
    field.world.commit();
  }
}

}  // namespace
}  // namespace lgs::box2d_test
