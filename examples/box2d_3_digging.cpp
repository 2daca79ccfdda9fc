// Digging at the mouse in Box2D 3: a ball lies on the ground until a click digs a round hole under it.
#include <box2d/box2d.h>
#include <lgs/box2d/terrain.h>
#include <lgs/brush.h>
#include <lgs/world.h>
#include <cstdio>

int main() {
  // The ground: 40 × 10 cells of block 1, each half a metre wide.
  lgs::World ground;
  const lgs::ShapeId square = *ground.shape(lgs::kUnitSquare);
  if (!ground.fill({.min = {0, 0}, .max = {39, 9}}, square, 1)) return 1;
  ground.commit();

  b2WorldDef worldDefinition = b2DefaultWorldDef();
  worldDefinition.gravity = {0, -10};
  const b2WorldId physics = b2CreateWorld(&worldDefinition);
  float before = 0, after = 0;
  {
    lgs::box2d::TerrainOptions options;
    options.cellSize = 0.5;
    options.material = [](lgs::Block block) {
      lgs::box2d::Material material;
      material.surface.friction = block == 1 ? 0.6F : 0.1F;
      return material;
    };
    lgs::box2d::Terrain terrain(physics, ground, options);

    b2BodyDef definition = b2DefaultBodyDef();
    definition.type = b2_dynamicBody;
    definition.position = {5, 6};
    const b2BodyId ball = b2CreateBody(physics, &definition);
    const b2ShapeDef shapeDefinition = b2DefaultShapeDef();
    const b2Circle circle{{0, 0}, 0.15F};
    b2CreateCircleShape(ball, &shapeDefinition, &circle);
    const auto height = [&] { return static_cast<float>(b2Body_GetPosition(ball).y); };

    for (int frame = 0; frame < 240; ++frame) {
      if (frame == 120) {
        before = height();
        const lgs::box2d::Position mouse{5, 5};  // a click, in metres
        if (!carve(ground, lgs::circle(terrain.latticePoint(mouse), lgs::kUnitsPerCell))) return 1;
        terrain.commit(ground);  // exactly the shapes that changed
      }
      terrain.beforeStep();  // these two keep bodies from falling through
      b2World_Step(physics, 1.0F / 60, 4);
      terrain.afterStep();
    }
    after = height();

    b2ContactData contacts[8];
    const int count = b2Body_GetContactData(ball, contacts, 8);
    for (int k = 0; k < count; ++k)
      if (const auto touch = terrain.hit(contacts[k]))
        std::printf("it touches cell (%d, %d) of block %u\n", touch->hit.cell.i, touch->hit.cell.j, touch->hit.block);
    std::printf("the ball lay at %.2f m, and in the hole lies at %.2f m; %zu shapes on %zu bodies\n",
                static_cast<double>(before), static_cast<double>(after), terrain.edges().counts().edges,
                terrain.bodyCount());
  }
  b2DestroyWorld(physics);
  return before > 5 && after > 4.5F && after < 4.9F ? 0 : 1;
}
