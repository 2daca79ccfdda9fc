// The benches of the engine by itself, on Google Benchmark. Each file registers its own; all take their sizes from here.
#pragma once

#include "bench/sample.h"
#include "bench/subjects/engine.h"
#include "bench/tiles.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <string>

namespace lgs::bench {

struct Scale {
  std::int64_t maxCells = 10'000'000;  ///< no world is larger
  std::int64_t edits = 20'000;         ///< timed one by one, in each row
};

/// The worlds' names, see tiles.h.
inline constexpr const char* kWorlds[] = {"full", "ramp", "map", "mix"};

/// A world with its engine, by shapes. One at a time is kept: benches in a row that ask for the same one share it, and
/// leave it as it was.
struct Built {
  Tiles tiles;
  Engine engine{Engine::By::shapes};
};
Built& built(const std::string& world, std::int64_t cells);

/// Puts median, p99 and maximum of single times into the counters.
void report(benchmark::State& state, const Sample& sample);

void registerEdits(const Scale& scale);    ///< single edits: add, remove, replace; dig and refill
void registerBatches(const Scale& scale);  ///< many edits with one commit
void registerBuilds(const Scale& scale);   ///< time and memory of a world from nothing
void registerReads(const Scale& scale);    ///< changes, segments, loops
void registerWorst(const Scale& scale);    ///< the edits that cost most

}  // namespace lgs::bench
