#include "bench/comparison.h"
#include "bench/subjects/other_engine.h"
#include "cli/command.h"
#include "cli/engine.h"
#include "cli/progress.h"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace lgs::cli {
namespace {

using bench::Comparison;
using bench::Row;

constexpr std::int32_t kLargestSide = 1'000;  // of worlds in which only edits are timed

struct BenchArguments {
  std::string json;
  int rounds = 5;
  std::int32_t side = 100;
  bool all = false;
  EngineArguments engine;
};

// What one edit costs an engine of others, beside this library's and full recompute.
void runBesideOther(Comparison& comparison, const BenchArguments& arguments, const oracle::Capabilities& can) {
  std::vector<std::string_view> everyone, editing;
  for (const bench::SubjectInfo& info : bench::subjects()) {
    const bool isOurs = info.name == "engine-polygons" || info.name == "engine-shapes";
    if (info.isOther || isOurs || !info.isIncremental) everyone.push_back(info.name);
    if (info.isOther || isOurs) editing.push_back(info.name);
  }
  const auto run = [&](const char* name, const std::string& size, const bench::Tiles& tiles) {
    const std::string build = fmt::format("{}-{}", name, arguments.side);
    comparison.build(build, tiles, everyone);
    comparison.edit(size, tiles, editing);
    comparison.recomputeInstead(build, "edit-" + size);
  };
  const std::int32_t side = arguments.side;
  run("full", fmt::format("{}", side), bench::fullTiles({side, side}));
  if (can.slants && !can.squares) run("ramp", fmt::format("ramp-{}", side), bench::rampTiles({side, side}));
}

void runScenarios(Comparison& comparison, const BenchArguments& arguments) {
  const auto namesOf = [](auto&& isWanted) {
    std::vector<std::string_view> names;
    for (const bench::SubjectInfo& info : bench::subjects()) {
      if (isWanted(info)) names.push_back(info.name);
    }
    return names;
  };
  const auto everyone = namesOf([](auto&) { return true; });
  const auto butFill = namesOf([](auto& info) { return info.name != "engine-fill"; });
  const auto editing = namesOf(
      [](auto& info) { return info.isIncremental && info.name != "engine-fill" && info.name != "engine-bulk"; });
  const auto far = namesOf([&](auto& info) {
    return info.name == "engine-polygons" || info.name == "engine-shapes" || info.name == "published-port-new-sets" ||
           (arguments.all && info.name == "published-port");
  });

  const auto editBoth = [&](std::int32_t side, const std::vector<std::string_view>& names) {
    comparison.edit(fmt::format("{}", side), bench::fullTiles({side, side}), names);
    comparison.edit(fmt::format("ramp-{}", side), bench::rampTiles({side, side}), names);
  };
  const std::int32_t side = arguments.side;
  const std::string full = fmt::format("full-{}", side);
  const std::string ramp = fmt::format("ramp-{}", side);
  comparison.build(full, bench::fullTiles({side, side}), everyone);
  comparison.build(ramp, bench::rampTiles({side, side}), butFill);
  editBoth(side, editing);
  comparison.recomputeInstead(full, fmt::format("edit-{}", side));
  comparison.recomputeInstead(ramp, fmt::format("edit-ramp-{}", side));
  if (side <= kLargestSide / 10) editBoth(10 * side, far);
}

std::string readable(bench::Nanoseconds time) {
  const auto ns = static_cast<double>(time);
  if (ns < 1e4) return fmt::format("{:.0f} ns", ns);
  if (ns < 1e6) return fmt::format("{:.1f} µs", ns / 1e3);
  return ns < 1e9 ? fmt::format("{:.2f} ms", ns / 1e6) : fmt::format("{:.2f} s", ns / 1e9);
}

void printTable(const std::vector<Row>& rows) {
  fmt::print("{:<18} {:<24} {:>10} {:>10} {:>9}  {:>13}\n", "scenario", "subject", "median", "p99", "segments",
             "÷ engine-shapes");
  std::string last;
  for (const Row& row : rows) {
    if (row.scenario.starts_with("polygons-")) continue;
    const auto own = std::find_if(rows.begin(), rows.end(), [&](const Row& other) {
      return other.scenario == row.scenario && other.subject == "engine-shapes";
    });
    const auto ratio = static_cast<double>(row.times.median()) / static_cast<double>(own->times.median());
    fmt::print("{:<18} {:<24} {:>10} {:>10} {:>9}  {:>13.{}f}\n", row.scenario == last ? "" : row.scenario, row.subject,
               readable(row.times.median()), readable(row.times.percentile(99)), row.segments, ratio,
               ratio < 100 ? 1 : 0);
    last = row.scenario;
  }
}

std::string toJson(const std::vector<Row>& rows) {
  auto figures = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    figures.push_back({{"scenario", row.scenario},
                       {"subject", row.subject},
                       {"median_ns", row.times.median()},
                       {"p99_ns", row.times.percentile(99)},
                       {"cells", row.cells},
                       {"segments", row.segments}});
  }
  return figures.dump(1) + "\n";
}

void printReport(const Comparison& comparison, const BenchArguments& arguments) {
  fmt::print(
      "full-N and ramp-N build N×N cells from nothing: full blocks, random ramps. edit-N and edit-ramp-N remove or "
      "add\n"
      "one polygon of such a world, anywhere, and commit; dig-… does it near the last place. A library that "
      "recomputes\n"
      "needs as long for an edit as for all.\n\n");
  printTable(comparison.rows());
  fmt::print("\n");
  for (const std::string& note : comparison.notes()) fmt::print("{}\n", note);
  fmt::print("{} The checksum of their corners is {:016x}.\n",
             comparison.agree() ? "All subjects came to the same area and corners."
                                : "MISMATCH: not all subjects came to the same area and corners.",
             comparison.checksum());
  if (arguments.json.empty()) fmt::print("With --json FILE: the same as figures, and the time to make the polygons.\n");
}

Status run(const BenchArguments& arguments) {
  if (const Status bad = tryOutputs({arguments.json}); bad != Status::fine) return bad;
  std::unique_ptr<oracle::Engine> started;
  oracle::Engine* other = arguments.engine.loaded.get();
  if (other == nullptr && arguments.engine.isGiven()) {
    started = startEngine(arguments.engine);
    if (!started) return Status::badInput;
    other = started.get();
  }
  if (other != nullptr) {
    if (other->can().cells < arguments.side)
      return complain(fmt::format("lgs bench: the engine has cells within {} only; give a --side", other->can().cells));
    bench::addSubject(other->name(), [other] { return std::make_unique<bench::OtherEngine>(*other); });
  }
  Progress progress;
  Comparison comparison({arguments.rounds, arguments.all, [&](const std::string& what) {
                           if (progress.isDue()) progress.show(what);
                         }});
  other != nullptr ? runBesideOther(comparison, arguments, other->can()) : runScenarios(comparison, arguments);
  progress.wipe();
  if (arguments.json != "-") printReport(comparison, arguments);
  if (other != nullptr && !other->can().time && arguments.json != "-")
    fmt::print("{} does not tell its time: in its times are {}what it puts out, and reading that.\n", other->name(),
               arguments.engine.loaded ? "" : "the pipe, ");
  const Status written = arguments.json.empty() ? Status::fine : write(arguments.json, toJson(comparison.rows()));
  if (started) static_cast<void>(started->finish());
  return worst(written, comparison.agree() ? Status::fine : Status::mismatch);
}

constexpr const char* kBenchHelp =
    "THE SUBJECTS. The engine runs in four ways: engine-polygons adds each polygon by its vertices, engine-shapes\n"
    "by the id of a shape, engine-bulk all shapes in one call, engine-fill fills the world at once. published-port\n"
    "is the published algorithm, ported word for word; it pays at each edit for clearing sets that were large once,\n"
    "and published-port-new-sets does not. published-arrays is the article's optimised C++; it takes worlds whose\n"
    "vertices are corners of cells. The libraries are Clipper, Boost.Geometry, CGAL, polygon-clipping (under Node)\n"
    "and GEOS: geos-coverage is its CoverageUnion, geos its UnaryUnion. What is missing here is skipped with a "
    "word.\n\n"
    "A time counts only if the subject comes to the same area and corners as the others; if one does not, the\n"
    "exit status is 1. Making the polygons is timed apart, in rows polygons-… of the JSON; only cgal's other rows\n"
    "include it. All times are of one core. Compare times of one run only.\n\n"
    "AN ENGINE OF YOUR OWN (--engine) builds and edits the same worlds, beside this library and full recompute. With\n"
    "the capability 'time' it prints a line 'time NANOSECONDS' before 'end': what the edits since the last commit\n"
    "and this one took by its own clock, without reading and printing. If it is slow, all make fewer edits.\n\n"
    "Examples: lgs bench --json bench.json\n"
    "          lgs bench --engine 'python3 my_engine.py' --side 30";

}  // namespace

void addBench(CLI::App& app, Action& chosen) {
  const auto arguments = std::make_shared<BenchArguments>();
  CLI::App& command =
      *app.add_subcommand("bench", "Time the engine, the published algorithm and five polygon libraries, side by side");
  command
      .add_option("--json", arguments->json,
                  "Write the figures: an array of {scenario, subject, median_ns,\n"
                  "p99_ns, cells, segments}; - is stdout, without the table")
      ->option_text("FILE");
  addWholeNumber(
      command, "--rounds", [arguments](std::uint64_t n) { arguments->rounds = static_cast<int>(n); }, {1, 10'000},
      "How often each subject runs; default 5. A subject that takes\nlonger than two seconds runs once")
      ->option_text("N");
  addWholeNumber(
      command, "--side", [arguments](std::uint64_t n) { arguments->side = static_cast<std::int32_t>(n); }, {4, 316},
      "The worlds have NxN cells; default 100. If N is at most 100,\nedits are timed in worlds of ten times that side, "
      "too")
      ->option_text("N");
  command.add_flag(
      "--all", arguments->all,
      "Run also what takes long: Boost.Geometry on ramps, and the\npublished algorithm in the larger worlds");
  addEngineOptions(command, arguments->engine);
  command.footer(kBenchHelp);
  command.callback([arguments, &chosen] {
    arguments->engine.prepare();
    chosen = [arguments] { return run(*arguments); };
  });
}

}  // namespace lgs::cli
