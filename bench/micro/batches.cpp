// Many edits with one commit: what each edit costs then. One batch digs cells anywhere, and the next one refills them.
// All batch sizes edit the same cells.
#include "bench/edit_times.h"
#include "bench/micro/benches.h"

#include <algorithm>
#include <span>

namespace lgs::bench {
namespace {

constexpr std::size_t kCells = 10'000;

void batch(benchmark::State& state, const std::string& world, std::int64_t cells, std::size_t size) {
  Built& b = built(world, cells);
  const std::vector<std::uint32_t> all = distinctCells(b.tiles, std::min(kCells, b.tiles.occupied() / 10), 1);
  std::uint64_t changes = 0;
  const auto commit = [&] {
    b.engine.commit();
    const Changes& c = b.engine.changes();
    changes += c.removed.size() + c.added.size() + c.relinked.size();
  };
  std::size_t edits = 0;
  std::size_t from = 0;
  while (state.KeepRunning()) {
    const auto batch = std::span(all).subspan(from, std::min(size, all.size() - from));
    from = (from + batch.size()) % all.size();
    for (const std::uint32_t cell : batch) {
      b.engine.find(cell);
      b.engine.removeOnly(cell);
    }
    commit();
    for (const std::uint32_t cell : batch) b.engine.addOnly(cell, b.tiles.at[cell]);
    commit();
    edits += 2 * batch.size();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(edits));
  state.counters["changes"] = static_cast<double>(changes) / static_cast<double>(edits);
}

}  // namespace

void registerBatches(const Scale& scale) {
  const std::int64_t cells = std::min<std::int64_t>(scale.maxCells, 1'000'000);
  for (const std::string world : kWorlds) {
    for (const std::size_t size : {1U, 10U, 100U, 10'000U}) {
      const std::string name = "batch/" + world + "/" + std::to_string(size);
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { batch(state, world, cells, size); });
    }
  }
}

}  // namespace lgs::bench
