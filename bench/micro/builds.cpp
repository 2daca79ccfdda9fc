// Worlds from nothing: the time of each cell, the memory of each cell and segment. The larger worlds are built only
// once, because they take seconds.
#include "bench/micro/benches.h"

#include <fmt/format.h>

#include <atomic>
#include <thread>

namespace lgs::bench {
namespace {

void onTwoThreads(std::size_t count, const std::function<void(std::size_t)>& job) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < count; k = next++) job(k);
  };
  const std::jthread other(work);
  work();
}

void build(benchmark::State& state, const std::string& world, std::int64_t cells, Engine::By by,
           const Executor& executor) {
  const Tiles tiles = makeTiles(world, sizeOf(cells));
  std::unique_ptr<Engine> engine;
  while (state.KeepRunning()) {
    state.PauseTiming();
    engine.reset();
    engine = std::make_unique<Engine>(by, executor);
    engine->prepare(tiles);
    state.ResumeTiming();
    engine->build();
  }
  const Stats stats = engine->world().stats();
  state.counters["cells"] = static_cast<double>(stats.cells);
  state.counters["segments"] = static_cast<double>(stats.segments);
  state.counters["bytes"] = static_cast<double>(stats.bytes);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tiles.size()));
}

}  // namespace

void registerBuilds(const Scale& scale) {
  for (const std::int64_t cells : {100L, 10'000L, 1'000'000L, 10'000'000L}) {
    if (cells > scale.maxCells) continue;
    const auto add = [&](const std::string& how, const std::string& world, Engine::By by,
                         const Executor& executor = {}) {
      const std::string name = fmt::format("build/{}/{}/{}", how, world, cells);
      auto* bench = benchmark::RegisterBenchmark(
          name.c_str(), [=](benchmark::State& state) { build(state, world, cells, by, executor); });
      bench->Unit(benchmark::kMillisecond)->UseRealTime();
      if (cells >= 1'000'000) bench->Iterations(1);
    };
    for (const std::string world : kWorlds) {
      add("shapes", world, Engine::By::shapes);
      add("shapes-2-threads", world, Engine::By::shapes, onTwoThreads);
    }
    add("fill", "full", Engine::By::fill);
  }
  const auto addHuge = [](const std::string& how, const std::string& world, std::int64_t cells, Engine::By by) {
    benchmark::RegisterBenchmark(fmt::format("build/{}/{}/{}", how, world, cells).c_str(),
                                 [=](benchmark::State& state) { build(state, world, cells, by, {}); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  };
  constexpr std::int64_t kHuge = 100'000'000;
  if (kHuge <= 10 * scale.maxCells) addHuge("fill", "full", kHuge, Engine::By::fill);
  // Ramps take a hundred bytes a cell: only for whoever asks for them (docs/timings.md, "How large one world may be").
  for (const std::int64_t cells : {30'000'000L, 100'000'000L})
    if (cells <= scale.maxCells) addHuge("shapes", "ramp", cells, Engine::By::shapes);
}

}  // namespace lgs::bench
