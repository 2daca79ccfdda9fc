// Single edits, each with its commit, and each timed by itself.
#include "bench/edit_times.h"
#include "bench/micro/benches.h"

#include <fmt/format.h>

namespace lgs::bench {
namespace {

void edits(benchmark::State& state, const Scale& scale, const std::string& world, std::int64_t cells, Where where) {
  Built& b = built(world, cells);
  const EditPlan plan = planEdits(b.tiles, static_cast<std::size_t>(scale.edits), where, 1);
  EditTimes times;
  std::uint64_t removed = 0;
  std::uint64_t added = 0;
  std::uint64_t relinked = 0;
  while (state.KeepRunning()) {
    timeRemovesAndAdds(b.engine, b.tiles, plan, times, [&] {
      const Changes& c = b.engine.changes();
      removed += c.removed.size();
      added += c.added.size();
      relinked += c.relinked.size();
    });
  }
  putTimes(state, times.first, "first_");
  putTimes(state, times.back, "back_");
  const auto count = static_cast<double>(times.first.size() + times.back.size());
  state.counters["removed"] = static_cast<double>(removed) / count;
  state.counters["added"] = static_cast<double>(added) / count;
  state.counters["relinked"] = static_cast<double>(relinked) / count;
  state.SetItemsProcessed(static_cast<std::int64_t>(count));
}

}  // namespace

void registerEdits(const Scale& scale) {
  // The outer loops go by size and world, so that each world is built once.
  for (const std::int64_t cells : {100L, 10'000L, 1'000'000L, 10'000'000L}) {
    if (cells > scale.maxCells) continue;
    for (const std::string world : kWorlds) {
      const auto add = [&](const std::string& what, Where where) {
        const std::string name = fmt::format("edit/{}/{}/{}", what, world, cells);
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
          edits(state, scale, world, cells, where);
        })->Iterations(1);
      };
      add("remove-add", Where::anywhere);
      add("dig", Where::nearby);
    }
  }
}

}  // namespace lgs::bench
