// A ball rolls over a floor of cells in Box2D 2.4. As soon as it touches a cell of column 12 or later, that cell is dug
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

  b2World physics({0, -10});
  lgs::box2d::TerrainOptions options;
  options.cellSize = 0.5;
  options.material = [](lgs::Block block) { return lgs::box2d::Material{.friction = block == 1 ? 0.6F : 0.1F}; };
  lgs::box2d::Terrain terrain(physics, ground, options);

  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = {1, 1.2F};
  definition.linearVelocity = {3, 0};
  b2Body* ball = physics.CreateBody(&definition);
  b2CircleShape circle;
  circle.m_radius = 0.15F;
  ball->CreateFixture(&circle, 1);

  bool dug = false;
  for (int step = 0; step < 300; ++step) {
    terrain.beforeStep();  // these two keep bodies from falling through
    physics.Step(1.0F / 60, 8, 3);
    terrain.afterStep();
    for (const b2ContactEdge* c = ball->GetContactList(); c != nullptr && !dug; c = c->next) {
      const auto touch = terrain.hit(*c->contact);
      if (!touch || touch->hit.cell.i < 12) continue;
      std::printf("at %.2f m it touches cell (%d, %d) of block %u: dig\n", static_cast<double>(ball->GetPosition().x),
                  touch->hit.cell.i, touch->hit.cell.j, touch->hit.block);
      if (!ground.remove(touch->hit.polygon)) return 1;
      terrain.commit(ground);  // exactly the fixtures that changed
      dug = true;
      break;
    }
  }
  const b2Vec2 end = ball->GetPosition();
  std::printf("after 5 s the ball is at (%.2f, %.2f); %zu fixtures on %zu bodies\n", static_cast<double>(end.x),
              static_cast<double>(end.y), terrain.edges().counts().edges, terrain.bodyCount());
  return dug && end.y > 0.6F ? 0 : 1;
}
