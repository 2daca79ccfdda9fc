#include "bench/micro/benches.h"

#include <stdexcept>

namespace lgs::bench {

Built& built(const std::string& world, std::int64_t cells) {
  static std::unique_ptr<Built> kept;
  static std::string name;
  static std::uint64_t checksum = 0;
  // A bench must undo what it did. This looks only where looking takes no time.
  const auto look = [] {
    return kept && kept->tiles.size() <= 10'000 ? boundaryOf(kept->engine.edges()).checksum() : 0;
  };
  const std::string wanted = world + "/" + std::to_string(cells);
  if (look() != checksum) throw std::logic_error("a bench left the world " + name + " changed");
  if (name != wanted) {
    kept.reset();  // before the next one is built, because two large worlds may not fit
    kept = std::make_unique<Built>();
    kept->tiles = makeTiles(world, sizeOf(cells));
    kept->engine.prepare(kept->tiles);
    kept->engine.build();
    name = wanted;
    checksum = look();
  }
  return *kept;
}

void putTimes(benchmark::State& state, const Times& times, const std::string& prefix) {
  const auto put = [&](const char* figure, Nanoseconds time) {
    state.counters[prefix + figure] = static_cast<double>(time);
  };
  put("median_ns", times.median());
  put("p99_ns", times.percentile(99));
  put("max_ns", times.max());
}

}  // namespace lgs::bench
