// A digger in sixty lines, for Box2D 2.4: land without end that streams in and out, rocks that fall and are ground again,
// undo, redo, save and load. It plays by itself, and no body is lost. digger.cpp has a second world in step.
#include <box2d/box2d.h>
#include <lgs/box2d/ground.h>
#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

constexpr lgs::Block kEarth = 1, kBedrock = 2;

void land(lgs::World& world, const lgs::CellRect& chunk) {  // makes 32×32 cells, when one comes near
  const lgs::ShapeId square = world.shape(lgs::kUnitSquare).value();
  for (std::int32_t i = chunk.min.i; i <= chunk.max.i; ++i)
    for (std::int32_t j = std::max(chunk.min.j, 0); j <= std::min(chunk.max.j, 12 + (i & 15) / 4); ++j)
      static_cast<void>(world.add({i, j}, square, j == 0 ? kBedrock : kEarth));
}

int main() {
  b2World physics{{0, -10}};
  lgs::box2d::Ground ground({.isAnchor = [](lgs::Block block, lgs::Cell) { return block == kBedrock; },
                             .staying = [](lgs::Block block) { return block == kBedrock; },
                             .land = land},
                            physics, lgs::box2d::TerrainOptions{.cellSize = 0.5});
  std::vector<b2Body*> boxes;
  for (int k = 0; k < 20; ++k) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = {0.3F + 0.8F * static_cast<float>(k), 9};
    b2PolygonShape box;
    box.SetAsBox(0.15F, 0.15F);
    boxes.push_back(physics.CreateBody(&definition));
    boxes.back()->CreateFixture(&box, 1);
  }
  std::minstd_rand random(1);
  std::vector<std::byte> file;
  int lost = 0, refused = 0, drawn = 0;
  for (int frame = 0; frame < 3'000; ++frame) {
    const std::int32_t x = std::abs(frame / 20 % 100 - 50);          // the player walks to and fro
    refused += ground.window({{x - 40, -8}, {x + 40, 40}}) ? 0 : 1;  // the rest leaves memory, and comes back
    const auto what = random() % 48;
    const lgs::Point at = lgs::toWorld({x + static_cast<std::int32_t>(random() % 60) - 20, 3 + frame % 11}, {});
    if (what < 4) refused += ground.dig(lgs::circle(at, lgs::kUnitsPerCell * 3 / 2, 16)) ? 0 : 1;
    if (what == 4) refused += ground.paint(lgs::circle(at, lgs::kUnitsPerCell, 16), kEarth) ? 0 : 1;
    if (what == 5) ground.undo();
    if (what == 6) ground.redo();
    if (frame % 500 == 100) {
      file.clear();
      refused += ground.save([&](auto bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); }) ? 0 : 1;
    }
    if (frame % 500 == 400) refused += ground.load(file) ? 0 : 1;
    ground.step([&] { physics.Step(1.0F / 60, 8, 3); });
    for (const lgs::GroundDrawing& square : ground.draw()) drawn += square.fills.empty() ? 0 : 1;  // paint it anew
    for (const b2Body* box : boxes) {
      const lgs::Spot spot = ground.world().at(ground.host().terrain().latticePoint(box->GetPosition()));
      if (box->IsEnabled()) lost += spot.where != lgs::Spot::Where::outside;  // else it waits out of the window
    }
  }
  std::printf("%d lost, %d calls refused; %d squares drawn\n", lost, refused, drawn);
}
