// Boxes live in ground that is dug and built where they are, with undo, redo, save and load, in Box2D 2.4: no body is
// lost, and no undo is refused. box2d_game.h is a larger game, for both generations.
#include <box2d/box2d.h>
#include <lgs/box2d/terrain.h>
#include <lgs/brush.h>
#include <cstddef>
#include <cstdio>
#include <random>
#include <utility>
#include <vector>

struct Game {
  lgs::World world;
  b2World physics{{0, -10}};
  lgs::box2d::Terrain terrain{physics, world, {.cellSize = 0.5}};  // after both worlds, so that it goes first
  std::vector<lgs::Mark> marks;                                    // at the start, and after each edit
  std::size_t now = 0;                                             // at which of them the world is
  std::vector<b2Body*> bodies;
  std::vector<std::byte> file;      // what was saved
  std::vector<b2Transform> places;  // where the bodies were then

  Game() {
    const lgs::ShapeId square = world.shape(lgs::kUnitSquare).value();
    if (!world.fill({.min = {-2, -2}, .max = {25, 13}}, square, 1)) return;  // rock, of block 1
    if (!world.clear({.min = {0, 3}, .max = {23, 11}})) return;              // a cave in it
    show(world.commit());
    marks = {world.checkpoint()};
    for (int k = 0; k < 20; ++k) {
      b2BodyDef definition;
      definition.type = b2_dynamicBody;
      definition.position = {1.5F + 0.45F * static_cast<float>(k), 4};
      b2PolygonShape box;
      box.SetAsBox(0.15F, 0.15F);
      bodies.push_back(physics.CreateBody(&definition));
      bodies.back()->CreateFixture(&box, 1);
    }
  }
  bool show(const lgs::Changes& changes) { return terrain.sync(changes).has_value(); }  // pushes out who is in the way

  void step() {
    terrain.beforeStep();
    physics.Step(1.0F / 60, 8, 3);
    terrain.afterStep();
  }
  void edit(const lgs::Region& region, bool dig) {
    const auto done = dig ? carve(world, region) : paint(world, region, 2, lgs::PaintMode::fill);
    if (!done) return;  // a refused brush changes nothing
    show(world.commit());
    marks.resize(++now);  // what was undone can not be done again after an edit
    marks.push_back(world.checkpoint());
  }
  bool undo() {
    if (now == 0) return true;
    if (!world.rollBack(marks[now - 1], lgs::Undone::keep)) return false;
    --now;
    return show(world.changesOfRollBack());
  }
  bool redo() {
    if (now + 1 == marks.size()) return true;
    if (!world.rollForward(marks[now + 1])) return false;
    ++now;
    return show(world.changesOfRollBack());
  }
  bool save() {
    file.clear();
    places.clear();
    for (const b2Body* body : bodies) places.push_back(body->GetTransform());
    return world.save([&](auto bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); }).has_value();
  }
  bool load() {
    auto loaded = lgs::World::load(file);
    if (!loaded) return false;
    world = std::move(*loaded);  // the terrain's world stays where it is, and gets another content
    for (std::size_t k = 0; k < bodies.size(); ++k) {  // all of them, also those that are held
      bodies[k]->SetTransform(places[k].p, places[k].q.GetAngle());
      bodies[k]->SetLinearVelocity({0, 0});
      bodies[k]->SetAwake(true);
    }
    terrain.resync();
    marks = {world.checkpoint()};  // those of before belong to another world
    now = 0;
    return true;
  }
  bool isLost(const b2Body* body) const {
    if (!body->IsEnabled()) return false;  // it is held
    const lgs::Cell cell = terrain.cellAt(body->GetPosition());
    if (cell.i < 0 || cell.j < 0 || cell.i > 23 || cell.j > 11) return true;
    return world.at(terrain.latticePoint(body->GetPosition())).where == lgs::Spot::Where::inside;
  }
};

int main() {
  constexpr auto kUnit = lgs::kUnitsPerCell;
  Game game;
  std::minstd_rand random(1);
  int lost = 0, refused = 0;
  for (int frame = 0; frame < 3'000; ++frame) {
    game.step();
    for (const b2Body* body : game.bodies) lost += game.isLost(body) ? 1 : 0;
    if (frame % 500 == 100) refused += game.save() ? 0 : 1;
    if (frame % 500 == 400) refused += game.load() ? 0 : 1;
    if (frame % 6 != 0) continue;
    const auto what = random() % 8;
    const lgs::Point at = game.terrain.latticePoint(game.bodies[random() % 20]->GetPosition());
    const bool isInside = at.x > kUnit && at.y > kUnit && at.x < 23 * kUnit && at.y < 11 * kUnit;  // the walls stay
    if (what == 6) refused += game.undo() ? 0 : 1;
    if (what == 7) refused += game.redo() ? 0 : 1;
    if (what < 6 && isInside) game.edit(lgs::circle(at, kUnit, 16), what % 2 == 0);
  }
  std::printf("%d lost, %d undos, redos and loads refused\n", lost, refused);
}
