// Islands: a bridge is cut, with what stands on its end said to be cut off; beside it a flood fill of all that hangs
// together, which is what one does without the view. The commit is in the time of both.
#include "bench/micro/benches.h"

#include <lgs/islands.h>

#include <algorithm>
#include <vector>

namespace lgs::bench {
namespace {

/// Two squares of rock, with a bridge of one cell between them; the left one is larger.
struct Bridge {
  explicit Bridge(std::int64_t cells) {
    while (2 * std::int64_t{side + 1} * (side + 1) <= cells) ++side;
    square = world.shape(kUnitSquare).value();
    (void)world.fill({{0, 0}, {side, side - 1}}, square, 1).value();
    (void)world.fill({{side + 2, 0}, {2 * side + 1, side - 1}}, square, 1).value();
    (void)world.add(cell(), square, 1).value();
    world.commit();
    (void)world.followCells(true);
  }
  Cell cell() const { return {side + 1, side / 2}; }

  std::int32_t side = 1;
  World world;
  ShapeId square;
};

void cutBridge(benchmark::State& state, std::int64_t cells, std::int64_t edits) {
  Bridge bridge(cells);
  Islands islands(bridge.world);
  Times cuts, joins;
  std::size_t told = 0;
  while (state.KeepRunning()) {
    for (std::int64_t k = 0; k < edits; ++k) {
      (void)bridge.world.clear(bridge.cell());
      cuts.add(timeOf([&] { (void)islands.update(bridge.world, bridge.world.commit()); }));
      told += islands.changes().cutOff.size();
      (void)bridge.world.add(bridge.cell(), bridge.square, 1);
      joins.add(timeOf([&] { (void)islands.update(bridge.world, bridge.world.commit()); }));
      told += islands.changes().joined.size();
    }
  }
  if (told != 2 * static_cast<std::size_t>(edits)) state.SkipWithError("not each cut was told");
  putTimes(state, cuts);
  putTimes(state, joins, "join_");
}

/// How many whole cells of a rectangle hang together with one, sides and corners alike.
std::size_t fill(const World& world, Cell from, const CellRect& cells) {
  const std::int32_t width = cells.max.i - cells.min.i + 1, height = cells.max.j - cells.min.j + 1;
  std::vector<bool> seen(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::vector<Cell> found;
  const auto visit = [&](Cell c) {
    if (c.i < cells.min.i || c.j < cells.min.j || c.i > cells.max.i || c.j > cells.max.j || world.isEmpty(c)) return;
    const auto at = static_cast<std::size_t>(c.j - cells.min.j) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(c.i - cells.min.i);
    if (seen[at]) return;
    seen[at] = true;
    found.push_back(c);
  };
  visit(from);
  for (std::size_t k = 0; k < found.size(); ++k)
    for (std::int32_t dj = -1; dj <= 1; ++dj)
      for (std::int32_t di = -1; di <= 1; ++di) visit({found[k].i + di, found[k].j + dj});
  return found.size();
}

void floodFill(benchmark::State& state, std::int64_t cells) {
  Bridge bridge(cells);
  const CellRect all{{0, 0}, {2 * bridge.side + 1, bridge.side - 1}};
  const Cell beside{bridge.cell().i - 1, bridge.cell().j};
  Times times;
  std::size_t found = 0;
  while (state.KeepRunning()) {
    (void)bridge.world.clear(bridge.cell());
    times.add(timeOf([&] {
      bridge.world.commit();
      found += fill(bridge.world, beside, all);
    }));
    (void)bridge.world.add(bridge.cell(), bridge.square, 1);
    bridge.world.commit();
  }
  benchmark::DoNotOptimize(found);
  putTimes(state, times);
}

}  // namespace

void registerIslands(const Scale& scale) {
  const auto edits = std::max<std::int64_t>(1, scale.edits / 20);
  for (std::int64_t cells = 10'000; cells <= scale.maxCells; cells *= 10) {
    const std::string size = std::to_string(cells);
    benchmark::RegisterBenchmark(("islands/cut/" + size).c_str(), [=](benchmark::State& s) {
      cutBridge(s, cells, edits);
    })->Iterations(1);
    benchmark::RegisterBenchmark(("islands/flood/" + size).c_str(), [=](benchmark::State& s) {
      floodFill(s, cells);
    })->Iterations(3);
  }
}

}  // namespace lgs::bench
