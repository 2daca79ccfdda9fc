// A ball rolls over a floor of cells in Box2D 3. As soon as it touches a cell of column 12 or later, that cell is dug
// away under it.
#include <box2d/box2d.h>
#include <lgs/box2d/terrain.h>
#include <lgs/world.h>
#include <cstdio>

int main() {
  // The ground: 40 × 2 cells of block 1, each half a metre wide.
  lgs::World ground;
  const lgs::ShapeId square = *ground.shape(lgs::kUnitSquare);
  if (!ground.fill({.min = {0, 0}, .max = {39, 1}}, square, 1)) return 1;
  ground.commit();

  b2WorldDef worldDefinition = b2DefaultWorldDef();
  worldDefinition.gravity = {0, -10};
  const b2WorldId physics = b2CreateWorld(&worldDefinition);
  bool dug = false;
  b2Vec2 end{};
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
    definition.position = {1, 1.2F};
    definition.linearVelocity = {3, 0};
    const b2BodyId ball = b2CreateBody(physics, &definition);
    const b2ShapeDef shapeDefinition = b2DefaultShapeDef();
    const b2Circle circle{{0, 0}, 0.15F};
    b2CreateCircleShape(ball, &shapeDefinition, &circle);

    for (int step = 0; step < 300; ++step) {
      b2World_Step(physics, 1.0F / 60, 4);
      b2ContactData contacts[8];
      const int count = b2Body_GetContactData(ball, contacts, 8);
      for (int k = 0; k < count && !dug; ++k) {
        const auto touch = terrain.hit(contacts[k]);
        if (!touch || touch->hit.cell.i < 12) continue;
        std::printf("it touches cell (%d, %d) of block %u: dig\n", touch->hit.cell.i, touch->hit.cell.j,
                    touch->hit.block);
        if (!ground.remove(touch->hit.polygon)) return 1;
        terrain.commit(ground);  // exactly the shapes that changed
        dug = true;
      }
    }
    const auto position = b2Body_GetPosition(ball);
    end = {static_cast<float>(position.x), static_cast<float>(position.y)};
    std::printf("after 5 s the ball is at (%.2f, %.2f); %zu shapes on %zu bodies\n", static_cast<double>(end.x),
                static_cast<double>(end.y), terrain.edges().counts().edges, terrain.bodyCount());
  }
  b2DestroyWorld(physics);
  return dug && end.y > 0.6F ? 0 : 1;
}
