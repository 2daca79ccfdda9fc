// The benches of the engine alone, on Google Benchmark. Each file registers its own benches.
#pragma once

#include "bench/subjects/engine.h"
#include "bench/tiles.h"
#include "bench/times.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <string>

namespace lgs::bench {

struct Scale {
  std::int64_t maxCells = 10'000'000;  ///< no world has more cells
  std::int64_t edits = 20'000;         ///< how many single edits a bench times
};

/// The worlds' names, see tiles.h.
inline constexpr const char* kWorlds[] = {"full", "ramp", "map", "mix"};

/// A world in an engine, built by shapes. The last one is kept, so that benches in a row can share it. Each leaves it
/// as it was.
struct Built {
  Tiles tiles;
  Engine engine{Engine::By::shapes};
};
Built& built(const std::string& world, std::int64_t cells);

/// Puts median, p99 and maximum into the counters; their names begin with the prefix.
void putTimes(benchmark::State& state, const Times& times, const std::string& prefix = {});

void registerEdits(const Scale& scale);    ///< single edits: add and remove; dig and refill
void registerBuilds(const Scale& scale);   ///< time and memory of a world from nothing
void registerWorst(const Scale& scale);    ///< the edits that cost most
void registerIslands(const Scale& scale);  ///< a bridge is cut, beside a flood fill
void registerBrushes(const Scale& scale);  ///< holes of any shape, beside Clipper
void registerPieces(const Scale& scale);   ///< convex pieces, beside those of a chunk worked out anew

}  // namespace lgs::bench
