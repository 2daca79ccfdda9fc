// Loops whose instructions are counted: gate.py runs this program under Valgrind. It links the engine, the brushes and
// the rules of the terrain's edges, without Box2D, and does the same on every machine.
//
//   lgs_loops LOOP TIMES          runs a loop
//   lgs_loops --steps LOOP TIMES  says how many steps that is
#include "strokes.h"

#include <lgs/box2d/edges.h>
#include <lgs/world.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <span>
#include <string_view>
#include <vector>

namespace lgs::bench {
namespace {

constexpr std::int32_t U = kUnitsPerCell;
constexpr std::int32_t kSide = 100;
constexpr std::size_t kCells = std::size_t{kSide} * kSide;
constexpr std::size_t kEdits = 1'000;  // how often the loops of edits dig in one go
constexpr std::array<std::array<LocalPoint, 3>, 4> kRamps{
    {{{{0, 0}, {U, 0}, {0, U}}}, {{{U, 0}, {U, U}, {0, 0}}}, {{{U, U}, {0, U}, {U, 0}}}, {{{0, U}, {0, 0}, {U, U}}}}};

enum class Ground : std::uint8_t { full, ramps };

std::vector<ShapeId> shapesOf(World& world, Ground ground) {
  if (ground == Ground::full) return {world.shape(kUnitSquare).value()};
  std::vector<ShapeId> shapes;
  for (const auto& ramp : kRamps) shapes.push_back(world.shape(ramp).value());
  return shapes;
}

/// One polygon in each cell. The shapes have the same ids in every world. The generator gives the same numbers
/// everywhere, as the standard's distributions do not.
std::vector<Placement> placements(Ground ground) {
  World world;
  const std::vector<ShapeId> shapes = shapesOf(world, ground);
  std::mt19937 random(1);
  std::vector<Placement> out;
  for (std::int32_t j = 0; j < kSide; ++j)
    for (std::int32_t i = 0; i < kSide; ++i) out.push_back({{i, j}, shapes[random() % shapes.size()], 1});
  return out;
}

void must(const Expected<void>& done) {
  if (!done) std::abort();
}

void addOneByOne(World& world, std::span<const Placement> all, std::span<PolygonHandle> handles) {
  for (std::size_t k = 0; k < all.size(); ++k) handles[k] = world.add(all[k].cell, all[k].shape, all[k].block).value();
}

void addAtOnce(World& world, std::span<const Placement> all, std::span<PolygonHandle> handles) {
  must(world.addMany(all, handles));
}

/// A world from nothing, and its commit.
template <Ground ground, auto add>
void build(std::size_t times) {
  const std::vector<Placement> all = placements(ground);
  std::vector<PolygonHandle> handles(kCells);
  for (; times != 0; --times) {
    World world;
    shapesOf(world, ground);
    add(world, all, handles);
    world.commit();
  }
}

/// The same by the vertices of each polygon, of which there is no shape.
template <Ground ground>
void buildByPolygons(std::size_t times) {
  const std::vector<Placement> all = placements(ground);
  for (; times != 0; --times) {
    World world;
    for (const Placement& p : all) {
      const std::span<const LocalPoint> ramp = kRamps[p.shape.value - 1];
      must(world.add(p.cell, ground == Ground::full ? kUnitSquare : ramp, p.block).map([](PolygonHandle) {}));
    }
    world.commit();
  }
}

/// A polygon goes, and comes back. A commit follows each of the two, and what `view` does with its changes.
template <Ground ground, class View>
void edit(std::size_t times) {
  const std::vector<Placement> all = placements(ground);
  std::vector<PolygonHandle> handles(kCells);
  World world;
  shapesOf(world, ground);
  addAtOnce(world, all, handles);
  world.commit();
  View view(world);
  std::mt19937 random(2);
  for (std::size_t n = times * kEdits; n != 0; --n) {
    const std::size_t k = random() % kCells;
    must(world.remove(handles[k]));
    view.update(world, world.commit());
    handles[k] = world.add(all[k].cell, all[k].shape, all[k].block).value();
    view.update(world, world.commit());
  }
}

struct NoView {
  explicit NoView(const World&) {}
  void update(const World&, const Changes&) {}
};

/// The edges of a terrain.
struct Edges : box2d::EdgeSet {
  explicit Edges(const World& world) : EdgeSet({}) { load(world); }
};

/// A polygon of 64 vertices that the world has never seen comes with a commit, and goes with another one.
void neverSeen(std::size_t times) {
  constexpr std::int32_t kTeeth = 32, kStep = U / kTeeth;
  World world;
  for (std::size_t n = 0; n < times; ++n) {
    std::vector<LocalPoint> comb;  // teeth that hang from a slanted back, each time shorter
    for (std::int32_t k = 0; k < kTeeth; ++k)
      comb.push_back({k * kStep, k % 2 == 0 ? 1 + static_cast<std::int32_t>(n) : U / 2});
    for (std::int32_t k = kTeeth; k-- > 0;) comb.push_back({k * kStep, U - k});
    const PolygonHandle handle = world.add({0, 0}, comb, 1).value();
    world.commit();
    must(world.remove(handle));
    world.commit();
  }
}

template <StrokeGround ground, bool isUndone>
void strokes(std::size_t times) {
  carveHoles(ground, times, isUndone);
}

template <std::size_t count>
std::size_t each(std::size_t times) {
  return count * times;
}

struct Loop {
  std::string_view name;
  void (*run)(std::size_t times);
  std::size_t (*steps)(std::size_t times);
};
constexpr std::array<Loop, 14> kLoops{{{"edit-full", edit<Ground::full, NoView>, each<2 * kEdits>},
                                       {"edit-ramps", edit<Ground::ramps, NoView>, each<2 * kEdits>},
                                       {"edges-full", edit<Ground::full, Edges>, each<2 * kEdits>},
                                       {"edges-ramps", edit<Ground::ramps, Edges>, each<2 * kEdits>},
                                       {"add-full", build<Ground::full, addOneByOne>, each<kCells>},
                                       {"polygons-full", buildByPolygons<Ground::full>, each<kCells>},
                                       {"polygons-ramps", buildByPolygons<Ground::ramps>, each<kCells>},
                                       {"bulk-full", build<Ground::full, addAtOnce>, each<kCells>},
                                       {"bulk-ramps", build<Ground::ramps, addAtOnce>, each<kCells>},
                                       {"never-seen", neverSeen, each<1>},
                                       {"stroke-full", strokes<StrokeGround::full, false>, cellsCut},
                                       {"stroke-mixed", strokes<StrokeGround::mixed, false>, cellsCut},
                                       {"undo-full", strokes<StrokeGround::full, true>, each<1>},
                                       {"undo-mixed", strokes<StrokeGround::mixed, true>, each<1>}}};

}  // namespace
}  // namespace lgs::bench

int main(int count, char** values) {
  std::span arguments(values + 1, static_cast<std::size_t>(count) - 1);
  const bool asks = !arguments.empty() && std::string_view(arguments[0]) == "--steps";
  if (asks) arguments = arguments.subspan(1);
  std::size_t times = 0;
  if (arguments.size() == 2) std::from_chars(arguments[1], arguments[1] + std::strlen(arguments[1]), times);
  for (const lgs::bench::Loop& loop : lgs::bench::kLoops) {
    if (times == 0 || loop.name != arguments[0]) continue;
    if (asks) {
      std::printf("%zu\n", loop.steps(times));
    } else {
      loop.run(times);
    }
    return 0;
  }
  std::fputs("usage: lgs_loops [--steps] LOOP TIMES\n", stderr);
  return 2;
}
