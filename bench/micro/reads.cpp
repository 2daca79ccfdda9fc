// Reading what a commit changed, all segments, and all loops. Times are for each segment that is read.
#include "bench/edit_times.h"
#include "bench/micro/benches.h"

#include <fmt/format.h>

namespace lgs::bench {
namespace {

// Reads what a game hands on to its physics engine.
std::int64_t sumOf(const World& world, SegmentId id) {
  const Segment s = *world.segment(id);
  return s.start.x + s.end.y + s.ghost1.x + s.ghost2.y + s.block;
}

void readChanges(benchmark::State& state, const std::string& world, std::int64_t cells) {
  Built& b = built(world, cells);
  const auto dug = distinctCells(b.tiles, std::min<std::size_t>(1'000, b.tiles.occupied() / 10), 1);
  for (const std::uint32_t cell : dug) {
    b.engine.find(cell);
    b.engine.removeOnly(cell);
  }
  b.engine.commit();
  const Changes& changes = b.engine.changes();
  std::int64_t sum = 0;
  while (state.KeepRunning()) {
    for (const SegmentId id : changes.added) sum += sumOf(b.engine.world(), id);
    for (const SegmentId id : changes.relinked) sum += sumOf(b.engine.world(), id);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(changes.added.size() + changes.relinked.size()));
  for (const std::uint32_t cell : dug) b.engine.addOnly(cell, b.tiles.at[cell]);
  b.engine.commit();
}

void readSegments(benchmark::State& state, const std::string& world, std::int64_t cells) {
  Built& b = built(world, cells);
  std::int64_t sum = 0;
  std::int64_t count = 0;
  while (state.KeepRunning()) {
    for (const SegmentId id : b.engine.world().segments()) {
      sum += sumOf(b.engine.world(), id);
      ++count;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(count);
}

void readLoops(benchmark::State& state, const std::string& world, std::int64_t cells, Collinear collinear) {
  Built& b = built(world, cells);
  std::size_t loops = 0;
  while (state.KeepRunning()) loops = b.engine.world().loops(collinear).size();
  benchmark::DoNotOptimize(loops);
  state.counters["loops"] = static_cast<double>(loops);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(b.engine.world().stats().segments));
}

}  // namespace

void registerReads(const Scale& scale) {
  const std::int64_t cells = std::min<std::int64_t>(scale.maxCells, 10'000);
  for (const std::string world : kWorlds) {
    const auto add = [&](const std::string& what, auto read) {
      benchmark::RegisterBenchmark(fmt::format("read/{}/{}", what, world).c_str(),
                                   [=](benchmark::State& state) { read(state, world, cells); });
    };
    add("changes", readChanges);
    add("segments", readSegments);
    add("loops", [](auto& state, auto& name, auto n) { readLoops(state, name, n, Collinear::keep); });
    add("loops-merged", [](auto& state, auto& name, auto n) { readLoops(state, name, n, Collinear::merge); });
  }
}

}  // namespace lgs::bench
