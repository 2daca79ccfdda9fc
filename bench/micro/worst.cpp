// The edits that cost most, by name. Each edit is timed by itself.
#include "bench/micro/benches.h"

#include <cmath>
#include <numbers>

namespace lgs::bench {
namespace {

constexpr std::int32_t U = kUnitsPerCell;
using Polygon = std::vector<LocalPoint>;

PolygonHandle place(World& world, Cell cell, const Polygon& polygon) {
  return world.add(cell, std::span<const LocalPoint>(polygon), 1).value();
}

// The first cell of a new chunk (32×32 cells). The chunk needs memory, and from time to time the table of chunks grows.
void newChunk(benchmark::State& state, std::int64_t edits) {
  World world;
  const ShapeId square = world.shape(kUnitSquare).value();
  Times times;
  while (state.KeepRunning()) {
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(edits); ++k) {
      times.add(timeOf([&] {
        (void)world.add({64 * k, 0}, square, 1);
        world.commit();
      }));
    }
  }
  state.counters["chunks"] = static_cast<double>(world.stats().chunks);
  putTimes(state, times);
}

// A polygon that the engine has never seen. It has to be validated and worked out.
void newPolygon(benchmark::State& state, std::int64_t edits, int vertices) {
  World world;
  Times times;
  while (state.KeepRunning()) {
    for (int k = 0; k < static_cast<int>(edits); ++k) {
      Polygon polygon;  // on a circle that is smaller each time, so that no polygon comes twice
      for (int v = 0; v < vertices; ++v) {
        const double angle = 2 * std::numbers::pi * v / vertices;
        const double radius = U / 2.0 - 1 - k;
        polygon.push_back({static_cast<std::int32_t>(std::lround(U / 2.0 + radius * std::cos(angle))),
                           static_cast<std::int32_t>(std::lround(U / 2.0 + radius * std::sin(angle)))});
      }
      PolygonHandle handle;
      times.add(timeOf([&] {
        handle = place(world, {0, 0}, polygon);
        world.commit();
      }));
      (void)world.remove(handle);
      world.commit();
    }
  }
  putTimes(state, times);
}

// Teeth that stand side by side on a wall, and cut it into many parts.
Polygon comb(std::int32_t teeth) {
  const std::int32_t step = U / (2 * teeth) * 2;
  Polygon polygon{{0, U}};
  for (std::int32_t k = 0; k < teeth; ++k) {
    polygon.push_back({k * step + step / 2, 0});
    polygon.push_back({(k + 1) * step, U / 2});
  }
  polygon.back() = {U, U};
  return polygon;
}

// The full cell under such a comb comes and goes. Its top is cut into as many segments as the comb has gaps.
void combWall(benchmark::State& state, std::int64_t edits, std::int32_t teeth) {
  World world;
  const ShapeId square = world.shape(kUnitSquare).value();
  place(world, {0, 1}, comb(teeth));
  world.commit();
  Times times;
  while (state.KeepRunning()) {
    for (std::int64_t k = 0; k < edits; ++k) {
      PolygonHandle handle;
      times.add(timeOf([&] {
        handle = world.add({0, 0}, square, 1).value();
        world.commit();
      }));
      times.add(timeOf([&] {
        (void)world.remove(handle);
        world.commit();
      }));
    }
  }
  putTimes(state, times);
}

// One of many polygons in a cell goes and comes back. Each time the cell has another content.
void crowdedCell(benchmark::State& state, std::int64_t edits, std::int32_t polygons) {
  World world;
  const std::int32_t rows = static_cast<std::int32_t>(std::sqrt(polygons));
  const std::int32_t step = U / rows;
  std::vector<Polygon> squares;
  std::vector<PolygonHandle> handles;
  for (std::int32_t k = 0; k < polygons && k < rows * rows; ++k) {
    const std::int32_t x = k % rows * step;
    const std::int32_t y = k / rows * step;
    squares.push_back({{x, y}, {x + step, y}, {x + step, y + step}, {x, y + step}});
    handles.push_back(place(world, {0, 0}, squares.back()));
  }
  world.commit();
  Times times;
  while (state.KeepRunning()) {
    for (std::int64_t k = 0; k < edits; ++k) {
      const auto at = static_cast<std::size_t>(k) % squares.size();
      times.add(timeOf([&] {
        (void)world.remove(handles[at]);
        world.commit();
      }));
      times.add(timeOf([&] {
        handles[at] = place(world, {0, 0}, squares[at]);
        world.commit();
      }));
    }
  }
  putTimes(state, times);
}

// A commit that has to look at the whole world.
void clearAll(benchmark::State& state, std::int64_t cells) {
  const Size size = sizeOf(cells);
  const CellRect all{{0, 0}, {size.width - 1, size.height - 1}};
  World world;
  const ShapeId square = world.shape(kUnitSquare).value();
  Times times;
  while (state.KeepRunning()) {
    (void)world.fill(all, square, 1);
    world.commit();
    times.add(timeOf([&] {
      (void)world.clear(all);
      world.commit();
    }));
  }
  putTimes(state, times);
}

}  // namespace

void registerWorst(const Scale& scale) {
  const auto add = [](const std::string& name, auto bench) {
    benchmark::RegisterBenchmark(("worst/" + name).c_str(), bench)->Iterations(1);
  };
  const std::int64_t some = std::min<std::int64_t>(scale.edits, 10'000);
  const std::int64_t few = std::min<std::int64_t>(scale.edits, 200);
  add("new-chunk", [=](auto& state) { newChunk(state, some); });
  for (const int vertices : {4, 64, 1'024}) {
    add("new-polygon/" + std::to_string(vertices), [=](auto& state) { newPolygon(state, few, vertices); });
  }
  for (const int teeth : {8, 1'000}) {
    add("comb-on-wall/" + std::to_string(teeth), [=](auto& state) { combWall(state, few, teeth); });
  }
  for (const int polygons : {4, 225}) {
    add("crowded-cell/" + std::to_string(polygons), [=](auto& state) { crowdedCell(state, few, polygons); });
  }
  add("clear-all", [=](auto& state) { clearAll(state, std::min<std::int64_t>(scale.maxCells, 1'000'000)); });
}

}  // namespace lgs::bench
