// What the terrain costs: fixtures and bodies against the size of a chunk, the initial load of 100×100 cells, a sync after
// one edit and after 1,000. Times are of one core, the least of some rounds, and comparable only within one run.
#include "oracle/check/random.h"

#include <fmt/format.h>
#include <lgs/box2d/terrain.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <vector>

namespace lgs::oracle {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::int32_t kSide = 100;
constexpr std::int32_t U = kUnitsPerCell;
constexpr int kRounds = 3;

template <class Work>
double microseconds(Work work) {
  const Clock::time_point begin = Clock::now();
  work();
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

struct Field {
  World world;
  std::vector<ShapeId> shapes;
  std::vector<PolygonHandle> handles;
  Random random{1};

  explicit Field(bool ramps) {
    constexpr std::array<LocalPoint, 3> kRamps[] = {
        {{{0, 0}, {U, 0}, {U, U}}}, {{{0, 0}, {U, 0}, {0, U}}}, {{{0, 0}, {U, U}, {0, U}}}, {{{U, 0}, {U, U}, {0, U}}}};
    for (const auto& ramp : kRamps) shapes.push_back(*world.shape(std::span<const LocalPoint>(ramp)));
    if (!ramps) shapes = {*world.shape(kUnitSquare)};
    for (std::int32_t k = 0; k < kSide * kSide; ++k) handles.push_back(add({k % kSide, k / kSide}));
    world.commit();
  }
  PolygonHandle add(Cell cell) { return *world.add(cell, random.pick(shapes), 1); }

  void dig(std::size_t at) { (void)world.remove(handles[at]); }
  void refill(std::size_t at) {
    const auto index = static_cast<std::int32_t>(at);
    handles[at] = add({index % kSide, index / kSide});
  }
};

// Box2D looks through everything made since the last step whenever a fixture goes, so a game without steps is none.
void step(b2World& physics) { physics.Step(1.0F / 60, 8, 3); }

// A world with a body in it: then the terrain looks for bodies to wake.
struct Populated {
  b2World physics{{0, -10}};
  Populated() {
    b2BodyDef body;
    body.type = b2_dynamicBody;
    physics.CreateBody(&body);
  }
};

double bestLoad(const Field& field, const box2d::TerrainOptions& options) {
  double best = std::numeric_limits<double>::max();
  for (int round = 0; round < kRounds; ++round) {
    b2World physics({0, -10});
    std::optional<box2d::Terrain> terrain;
    best = std::min(best, microseconds([&] { terrain.emplace(physics, field.world, options); }));
  }
  return best;
}

// The mean of digs and refills of random cells; in a game bodies are about, so that wakening is part of it.
double oneEdit(Field& field, const box2d::TerrainOptions& options) {
  constexpr int kTimes = 300;
  Populated populated;
  b2World& physics = populated.physics;
  box2d::Terrain terrain(physics, field.world, options);
  step(physics);
  double best = std::numeric_limits<double>::max();
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0;
    for (int k = 0; k < kTimes; ++k) {
      const std::size_t at = field.random.below(field.handles.size());
      field.dig(at);
      const Changes& dug = field.world.commit();
      sum += microseconds([&] { terrain.sync(dug); });
      step(physics);
      field.refill(at);
      const Changes& refilled = field.world.commit();
      sum += microseconds([&] { terrain.sync(refilled); });
      step(physics);
    }
    best = std::min(best, sum / (2 * kTimes));
  }
  return best;
}

double manyEdits(Field& field, const box2d::TerrainOptions& options) {
  constexpr int kTimes = 1'000;
  Populated populated;
  b2World& physics = populated.physics;
  box2d::Terrain terrain(physics, field.world, options);
  step(physics);
  double best = std::numeric_limits<double>::max();
  for (int round = 0; round < kRounds; ++round) {
    for (int k = 0; k < kTimes; ++k) field.dig(static_cast<std::size_t>(k) * 9);
    const Changes& dug = field.world.commit();
    best = std::min(best, microseconds([&] { terrain.sync(dug); }));
    step(physics);
    for (int k = 0; k < kTimes; ++k) field.refill(static_cast<std::size_t>(k) * 9);
    terrain.sync(field.world.commit());
    step(physics);
  }
  return best;
}

void run() {
  fmt::print("{0}×{0} cells. A sync after an edit: the mean of digging random cells away and refilling them.\n\n",
             kSide);
  fmt::print(
      "| world | chunk | merged | bodies | fixtures | most on a body | load, ms | sync after 1 edit, µs | after 1,000 "
      "digs, ms |\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|\n");
  for (const bool ramps : {false, true}) {
    for (const std::int32_t chunk : {1, 4, 8, 16, 32, 100}) {
      for (const bool merge : {false, true}) {
        Field field(ramps);
        const box2d::TerrainOptions options{.chunkCells = chunk, .merge = merge};
        b2World physics({0, -10});
        const box2d::Terrain terrain(physics, field.world, options);
        std::size_t most = 0;
        for (const b2Body* body = physics.GetBodyList(); body != nullptr; body = body->GetNext()) {
          std::size_t count = 0;
          for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) ++count;
          most = std::max(most, count);
        }
        const double load = bestLoad(field, options);
        const double one = oneEdit(field, options);
        const double many = manyEdits(field, options);
        fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} |\n", ramps ? "ramps" : "full", chunk,
                   merge ? "yes" : "no", terrain.bodyCount(), terrain.edges().counts().edges, most, load / 1e3, one,
                   many / 1e3);
      }
    }
  }
}

}  // namespace
}  // namespace lgs::oracle

int main() { lgs::oracle::run(); }
