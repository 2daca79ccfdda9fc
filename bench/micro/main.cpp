// lgs_bench: the engine in detail. Google Benchmark's options, and two of its own (--help has all of them).
#include "bench/micro/benches.h"

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string_view>

namespace lgs::bench {
namespace {

constexpr const char* kHelp =
    "lgs_bench [--max_cells=<no world is larger; default 10000000>]\n"
    "          [--edits=<timed one by one in each row; default 20000>]\n"
    "\nTimes the engine: single edits, batches, builds, reads, worst cases. `lgs bench` compares it with others.\n\n";

// Takes the program's own options out of the list. False: one of them is no number.
bool readScale(int& argc, char** argv, Scale& scale) {
  int kept = 1;
  for (int k = 1; k < argc; ++k) {
    const std::string_view argument = argv[k];
    std::int64_t* value = nullptr;
    if (argument.starts_with("--max_cells=")) value = &scale.maxCells;
    if (argument.starts_with("--edits=")) value = &scale.edits;
    if (value == nullptr) {
      argv[kept++] = argv[k];
      continue;
    }
    const std::string_view text = argument.substr(argument.find('=') + 1);
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), *value);
    if (status != std::errc() || end != text.data() + text.size() || *value < 1) {
      std::fprintf(stderr, "lgs_bench: %s: not a number from 1\n", argv[k]);
      return false;
    }
  }
  argc = kept;
  return true;
}

int run(int argc, char** argv) {
  Scale scale;
  if (!readScale(argc, argv, scale)) return 2;
  if (argc > 1 && std::string_view(argv[1]) == "--help") std::fputs(kHelp, stdout);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("compiler", LGS_BENCH_COMPILER);
  registerBuilds(scale);
  registerEdits(scale);
  registerBatches(scale);
  registerReads(scale);
  registerWorst(scale);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace

Built& built(const std::string& world, std::int64_t cells) {
  static std::unique_ptr<Built> kept;
  static std::string name;
  static std::uint64_t checksum = 0;
  // Benches undo what they did. Where looking takes no time, see that they have.
  const auto look = [] {
    return kept && kept->tiles.size() <= 10'000 ? boundaryOf(kept->engine.edges()).checksum() : 0;
  };
  const std::string wanted = world + "/" + std::to_string(cells);
  if (look() != checksum) throw std::logic_error("a bench left the world " + name + " changed");
  if (name != wanted) {
    kept.reset();  // first, for two large worlds may not fit
    kept = std::make_unique<Built>();
    kept->tiles = makeTiles(world, sizeOf(cells));
    kept->engine.prepare(kept->tiles);
    kept->engine.build();
    name = wanted;
    checksum = look();
  }
  return *kept;
}

void report(benchmark::State& state, const Sample& sample) {
  state.counters["median_ns"] = static_cast<double>(sample.median());
  state.counters["p99_ns"] = static_cast<double>(sample.percentile(99));
  state.counters["max_ns"] = static_cast<double>(sample.max());
}

}  // namespace lgs::bench

int main(int argc, char** argv) { return lgs::bench::run(argc, argv); }
