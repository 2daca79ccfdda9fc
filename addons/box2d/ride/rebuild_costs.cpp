// What it costs to dig one cell: by the terrain, or as one would do without it, where the outline of a chunk of 16×16
// cells is made again, from its tiles, and with it the chains of its body. The outline is made by the engine, from
// nothing. Medians of 300 digs in 100×100 cells, in turns, and what a dig makes and destroys. Compare times of one run
// only.
#include "oracle/calls/random.h"

#include "physics.h"

#include <fmt/format.h>
#include <lgs/box2d/terrain.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lgs::bench {
namespace {

constexpr std::int32_t kSide = 100, kChunk = 16, U = kUnitsPerCell;
constexpr std::size_t kDigs = 300;

template <class Work>
double microseconds(Work work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  work();
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

double median(std::vector<double> times) {
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

/// Tiles, and chains around those of each chunk. The ghosts at the ends of a chunk are left out: they would need the
/// chunks beside it.
class Chains {
 public:
  Chains(Physics& physics, const World& shapes, std::vector<ShapeId> tiles) : blank_(shapes), tiles_(std::move(tiles)) {
    const std::int32_t chunks = (kSide + kChunk - 1) / kChunk;
    for (std::int32_t k = 0; k < chunks * chunks; ++k) {
      const b2BodyDef body;
      bodies_.push_back(physics.world().CreateBody(&body));
      rebuild({k % chunks, k / chunks});
    }
  }
  void set(Cell cell, ShapeId tile) {
    tiles_[static_cast<std::size_t>(cell.j) * kSide + static_cast<std::size_t>(cell.i)] = tile;
  }

  /// The outline of a chunk, from nothing.
  std::vector<Loop> outline(Cell chunk) const {
    World part(blank_);
    const Cell end{std::min(kSide, (chunk.i + 1) * kChunk), std::min(kSide, (chunk.j + 1) * kChunk)};
    for (std::int32_t j = chunk.j * kChunk; j < end.j; ++j)
      for (std::int32_t i = chunk.i * kChunk; i < end.i; ++i)
        if (const ShapeId tile = tiles_[static_cast<std::size_t>(j) * kSide + static_cast<std::size_t>(i)])
          (void)part.add({i, j}, tile, 1);
    part.commit();
    return part.loops();
  }
  void show(Cell chunk, const std::vector<Loop>& loops) {
    b2Body& body = *bodies_[static_cast<std::size_t>(chunk.j) * ((kSide + kChunk - 1) / kChunk) +
                            static_cast<std::size_t>(chunk.i)];
    while (b2Fixture* fixture = body.GetFixtureList()) body.DestroyFixture(fixture);
    for (const Loop& loop : loops) {
      points_.clear();
      for (const Point p : loop.vertices)
        points_.emplace_back(static_cast<float>(p.x) / U, static_cast<float>(p.y) / U);
      b2ChainShape chain;
      chain.CreateLoop(points_.data(), static_cast<int>(points_.size()));
      body.CreateFixture(&chain, 0);
    }
  }
  void rebuild(Cell chunk) { show(chunk, outline(chunk)); }

 private:
  World blank_;  // with the shapes of the tiles
  std::vector<ShapeId> tiles_;
  std::vector<b2Body*> bodies_;
  std::vector<b2Vec2> points_;
};

void print(const char* name, std::span<const std::vector<LocalPoint>> kinds) {
  World world;
  std::vector<ShapeId> shapes, tiles;
  for (const auto& kind : kinds) shapes.push_back(*world.shape(std::span<const LocalPoint>(kind)));
  const World blank(world);
  oracle::Random random{1};
  std::vector<PolygonHandle> handles;
  for (std::int32_t k = 0; k < kSide * kSide; ++k) {
    tiles.push_back(random.pick(shapes));
    handles.push_back(*world.add({k % kSide, k / kSide}, tiles.back(), 1));
  }
  world.commit();
  Physics ours, theirs;
  ours.addBody();
  theirs.addBody();
  box2d::Terrain terrain(ours.world(), world);
  Chains chains(theirs, blank, tiles);
  std::vector<double> edits, syncs, outlines, shown;
  for (std::size_t n = 0; n < kDigs; ++n) {
    const std::size_t at = random.below(handles.size());
    const Cell cell{static_cast<std::int32_t>(at) % kSide, static_cast<std::int32_t>(at) / kSide};
    const Cell chunk{cell.i / kChunk, cell.j / kChunk};
    const Changes* changes = nullptr;
    edits.push_back(microseconds([&] {
      (void)world.remove(handles[at]);
      changes = &world.commit();
    }));
    syncs.push_back(microseconds([&] { terrain.sync(*changes); }));
    chains.set(cell, {});
    std::vector<Loop> loops;
    outlines.push_back(microseconds([&] { loops = chains.outline(chunk); }));
    shown.push_back(microseconds([&] { chains.show(chunk, loops); }));
    handles[at] = *world.add(cell, tiles[at], 1);
    terrain.sync(world.commit());
    chains.set(cell, tiles[at]);
    chains.rebuild(chunk);
    ours.step();
    theirs.step();
  }
  fmt::print("| {} | {:.2f} | {:.1f} | {:.1f} | {:.1f} |\n", name, median(edits), median(syncs), median(outlines),
             median(shown));
}

}  // namespace
}  // namespace lgs::bench

int main() {
  using namespace lgs;
  constexpr std::int32_t U = kUnitsPerCell;
  const std::vector<std::vector<LocalPoint>> full{{{0, 0}, {U, 0}, {U, U}, {0, U}}};
  const std::vector<std::vector<LocalPoint>> ramps{
      {{0, 0}, {U, 0}, {U, U}}, {{0, 0}, {U, 0}, {0, U}}, {{0, 0}, {U, U}, {0, U}}, {{U, 0}, {U, U}, {0, U}}};
  fmt::print(
      "| a dig in | edit and commit, µs | sync of the terrain, µs | outline of the chunk, µs | its chains, µs |\n");
  fmt::print("|---|---:|---:|---:|---:|\n");
  bench::print("full blocks", full);
  bench::print("ramps", ramps);
}
