// lgs_bench: the engine in detail. It takes two options of its own, and all of Google Benchmark's.
#include "bench/micro/benches.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <vector>

namespace lgs::bench {
namespace {

// Takes the program's own options, and returns what is left: Google Benchmark's options, --help among them.
std::vector<std::string> readScale(CLI::App& app, int argc, char** argv, Scale& scale) {
  const CLI::Range count(std::int64_t{1}, std::int64_t{1'000'000'000});
  app.set_help_flag();
  app.add_flag("--help")->description("Print these options, and Google Benchmark's");
  app.add_option("--max_cells", scale.maxCells, "No world has more cells; default 10000000")
      ->check(count)
      ->option_text("N");
  app.add_option("--edits", scale.edits, "Single edits that each row times; default 20000")
      ->check(count)
      ->option_text("N");
  app.allow_extras();
  app.parse(argc, argv);
  std::vector<std::string> others = app.remaining();
  if (app.count("--help") == 0) return others;
  std::puts(app.help().c_str());
  others.emplace_back("--help");
  return others;
}

int run(int argc, char** argv) {
  CLI::App app("Times the engine: single edits, builds, worst cases. `lgs bench` compares it with others.",
               "lgs_bench");
  Scale scale;
  std::vector<std::string> others;
  try {
    others = readScale(app, argc, argv, scale);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return 2;
  }
  std::vector<char*> arguments{argv[0]};
  for (std::string& other : others) arguments.push_back(other.data());
  auto count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::AddCustomContext("compiler", LGS_BENCH_COMPILER);
  registerBuilds(scale);
  registerEdits(scale);
  registerWorst(scale);
  registerBrushes(scale);
  registerPieces(scale);
  registerIslands(scale);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace
}  // namespace lgs::bench

int main(int argc, char** argv) {
  try {
    return lgs::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lgs_bench: %s\n", error.what());
    return 2;
  }
}
