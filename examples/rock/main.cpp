// A miner digs around a rock that sits in a cliff. As the last of the cliff goes that holds it, the rock falls, rolls
// down the slope and comes to rest. There it is ground again, and is dug through. With a file as argument it draws
// that.
#include "physics.h"
#include "picture.h"

#include <lgs/box2d/falling.h>
#include <lgs/brush.h>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace {

constexpr lgs::Block kSoil = 1, kRock = 2, kOre = 3;
constexpr lgs::CellRect kCells{{0, 0}, {47, 13}};

const char* lookOf(lgs::Block block) { return block == kSoil ? "soil" : block == kRock ? "rock" : "ore"; }
const char* lookOfDug(lgs::Block /*any*/) { return "dug"; }

lgs::Region polygon(const std::vector<lgs::DoublePoint>& corners) { return lgs::region({{corners}}); }

/// The game: ground, what follows it, and the physics.
struct Game {
  Game() {
    const lgs::Point middle = lgs::latticePoint({8, 10.9});
    const auto at = [](double cells) { return static_cast<std::int64_t>(cells * lgs::kUnitsPerCell); };
    const bool isPainted =
        paint(world, polygon({{0, 0}, {48, 0}, {48, 7}, {45, 7}, {44, 2}, {24, 2}, {10, 9}, {10, 13}, {0, 13}}), kSoil,
              lgs::PaintMode::fill) &&
        paint(world, lgs::circle(middle, at(1.8), 24), kRock, lgs::PaintMode::replace) &&
        paint(world, lgs::circle({middle.x + at(0.5), middle.y}, at(0.6), 16), kOre, lgs::PaintMode::replace);
    if (!isPainted) std::abort();
    world.commit();
    if (!world.followCells(true)) std::abort();
    islands = lgs::Islands(world, isAnchor);
    terrain.resync();
  }

  static bool isAnchor(lgs::Block /*any*/, lgs::Cell cell) { return cell.j == 0; }
  static float density(lgs::Block block) { return block == kOre ? 8.0F : 2.5F; }

  /// After each edit.
  void commit() {
    const lgs::Changes& changes = world.commit();
    if (!terrain.sync(changes) || !islands.update(world, changes)) std::abort();
  }

  lgs::World world;
  examples::Physics physics;
  lgs::box2d::Terrain terrain{physics.world(), world};
  lgs::Islands islands{world, isAnchor};
  lgs::box2d::FallingGround falling{physics.world(), world, terrain, {.density = density, .material = {}}};
};

/// Digs away what the slope's line has above it, from column to column. The rock stays, whatever is dug around it.
bool dig(Game& game, double from, double to) {
  const auto line = [](double x) { return std::max(2.0, 12.8 - 0.5 * x); };
  const auto isRock = [](lgs::Block block) { return block != kSoil; };
  const auto strip = polygon({{from, line(from)}, {to, line(to)}, {to, 13}, {from, 13}});
  if (!carve(game.world, strip, isRock)) return false;
  game.commit();
  std::printf("dug from %g to %g: %zu islands\n", from, to, game.islands.all().size());
  return true;
}

/// A body, where it is.
void drawBody(const lgs::box2d::Falling& fallen, std::vector<examples::Drawn>& out) {
  const std::size_t first = out.size();
  for (const lgs::BodyPolygon& p : fallen.ground.polygons) {
    std::vector<lgs::DoublePoint> corners;
    for (const lgs::LocalPoint v : p.vertices) {
      const auto metres = [](std::int32_t cell, std::int32_t units) {
        return static_cast<float>(cell) + static_cast<float>(units) / lgs::kUnitsPerCell;
      };
      const auto at = examples::Physics::placeOf(fallen.body, {metres(p.cell.i, v.x), metres(p.cell.j, v.y)});
      corners.push_back({at.x, at.y});
    }
    examples::draw(out, first, p.block == kOre ? "falling-ore" : "falling-rock", std::move(corners));
  }
}

}  // namespace

int main(int argc, char** argv) {
  Game game;
  std::vector<examples::Drawn> picture, way;
  drawGround(game.world, lookOfDug, picture);
  if (!dig(game, 9.5, 24) || !dig(game, 7, 9.5) || !dig(game, 5.4, 7)) return 1;

  for (const lgs::IslandId id : game.islands.loose())
    if (!game.falling.takeAsBody(game.islands, id)) return 1;
  game.commit();
  for (const lgs::box2d::Falling& fallen : game.falling.afterSync())
    std::printf("%.2f cells of rock fall, %.1f kg\n", fallen.ground.mass.area,
                double{examples::Physics::massOf(fallen.body)});
  if (game.falling.bodies().size() != 1) return 1;

  const lgs::box2d::Falling rock = game.falling.bodies().front();
  int steps = 0;
  for (; steps < 60 * 60 && examples::Physics::isAwake(rock.body); ++steps) {
    if (steps % 30 == 0 && steps < 480) drawBody(rock, way);
    game.terrain.beforeStep();
    game.physics.step();
    if (!game.terrain.afterStep().empty()) return 1;
  }
  const lgs::DoublePoint& centroid = rock.ground.mass.centroid;
  const auto middle =
      examples::Physics::placeOf(rock.body, {static_cast<float>(centroid.x), static_cast<float>(centroid.y)});
  std::printf("at rest after %.1f s, %.1f cells further\n", steps / 60.0, static_cast<double>(middle.x) - 8);

  if (const auto done = game.falling.settle(rock.body); !done)
    return std::printf("%s\n", message(done.error()).c_str());
  game.commit();
  std::printf("ground again: %zu island, %zu body\n", game.islands.all().size(), game.falling.bodies().size());
  const lgs::Point shaft[] = {lgs::latticePoint({middle.x, 8}), lgs::latticePoint({middle.x, 3})};
  if (!carve(game.world, lgs::thickLine(shaft, lgs::kUnitsPerCell / 4))) return 1;
  game.commit();
  std::printf("dug into it: %zu island\n", game.islands.all().size());

  if (argc < 2) return 0;
  picture.insert(picture.end(), way.begin(), way.end());
  drawGround(game.world, lookOf, picture);
  std::ofstream file(argv[1]);
  writePicture(file, kCells, picture);
  return file ? 0 : 1;
}
