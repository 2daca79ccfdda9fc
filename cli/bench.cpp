#include "bench/comparison.h"
#include "cli/command.h"
#include "cli/progress.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

using bench::Comparison;
using bench::Row;

constexpr std::int32_t kLargestSide = 1'000;  // of the worlds in which only edits are timed

struct BenchOptions {
  std::string json;
  int rounds = 5;
  std::int32_t side = 100;
  bool all = false;
};

void runScenarios(Comparison& comparison, const BenchOptions& options) {
  const auto namesOf = [](auto&& isWanted) {
    std::vector<std::string_view> names;
    for (const bench::SubjectInfo& info : bench::subjects()) {
      if (isWanted(info)) names.push_back(info.name);
    }
    return names;
  };
  const auto everyone = namesOf([](auto&) { return true; });
  const auto butFill = namesOf([](auto& info) { return info.name != "engine-fill"; });
  const auto editing = namesOf([](auto& info) { return info.isIncremental && info.name != "engine-fill"; });
  const auto far = namesOf([&](auto& info) {
    return info.name == "engine-polygons" || info.name == "engine-shapes" ||
           (options.all && info.name == "published-port");
  });

  const auto editBoth = [&](std::int32_t side, const std::vector<std::string_view>& names) {
    comparison.edit(fmt::format("{}", side), bench::fullTiles({side, side}), names);
    comparison.edit(fmt::format("ramp-{}", side), bench::rampTiles({side, side}), names);
  };
  const std::int32_t side = options.side;
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
  fmt::print("{:<18} {:<17} {:>10} {:>10} {:>9}  {:>13}\n", "scenario", "subject", "median", "p99", "segments",
             "÷ engine-shapes");
  std::string last;
  for (const Row& row : rows) {
    if (row.scenario.starts_with("polygons-")) continue;
    const auto own = std::find_if(rows.begin(), rows.end(), [&](const Row& other) {
      return other.scenario == row.scenario && other.subject == "engine-shapes";
    });
    const auto ratio = static_cast<double>(row.times.median()) / static_cast<double>(own->times.median());
    fmt::print("{:<18} {:<17} {:>10} {:>10} {:>9}  {:>13.{}f}\n", row.scenario == last ? "" : row.scenario, row.subject,
               readable(row.times.median()), readable(row.times.percentile(99)), row.segments, ratio,
               ratio < 100 ? 1 : 0);
    last = row.scenario;
  }
}

std::string toJson(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    text += text.empty() ? "[\n" : ",\n";
    text += fmt::format(
        R"(  {{"scenario": "{}", "subject": "{}", "median_ns": {}, "p99_ns": {}, "cells": {}, "segments": {}}})",
        row.scenario, row.subject, row.times.median(), row.times.percentile(99), row.cells, row.segments);
  }
  return text + "\n]\n";
}

void printReport(const Comparison& comparison, const BenchOptions& options) {
  fmt::print(
      "full-N, ramp-N: N×N cells from nothing. edit-N, edit-ramp-N: one polygon of such a world removed or added, and\n"
      "committed, anywhere; dig-…: near the last one. A library that recomputes takes as long for an edit as for "
      "all.\n\n");
  printTable(comparison.rows());
  fmt::print("\n");
  for (const std::string& note : comparison.notes()) fmt::print("{}\n", note);
  fmt::print("{} The checksum of their corners is {:016x}.\n",
             comparison.agree() ? "All subjects came to the same area and corners."
                                : "MISMATCH: not all subjects came to the same area and corners.",
             comparison.checksum());
  if (options.json.empty()) fmt::print("With --json FILE: the same as figures, and the time to make the polygons.\n");
}

Status run(const BenchOptions& options) {
  if (const Status bad = tryOutputs({options.json}); bad != Status::fine) return bad;
  Progress progress;
  Comparison comparison({options.rounds, options.all, [&](const std::string& what) {
                           if (progress.isDue()) progress.show(what);
                         }});
  runScenarios(comparison, options);
  progress.wipe();
  if (options.json != "-") printReport(comparison, options);
  const Status written = options.json.empty() ? Status::fine : write(options.json, toJson(comparison.rows()));
  return worst(written, comparison.agree() ? Status::fine : Status::mismatch);
}

}  // namespace

void addBench(CLI::App& app, Run& chosen) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command =
      *app.add_subcommand("bench", "Incremental against full recompute by five libraries, as a table of ratios");
  command
      .add_option("--json", options->json,
                  "Write the figures: an array of {scenario, subject, median_ns,\n"
                  "p99_ns, cells, segments}; - is stdout, without the table")
      ->option_text("FILE");
  addWholeNumber(
      command, "--rounds", [options](std::uint64_t n) { options->rounds = static_cast<int>(n); }, {1, 10'000},
      "How often the subjects run, one after the other; default 5.\nWhat takes longer than two seconds runs once")
      ->option_text("N");
  addWholeNumber(
      command, "--side", [options](std::uint64_t n) { options->side = static_cast<std::int32_t>(n); }, {4, 316},
      "Cells along one side of the worlds; default 100. Edits are also\ntimed in worlds of ten times that, up to 1000")
      ->option_text("N");
  command.add_flag("--all", options->all,
                   "Also what takes long: Boost.Geometry on ramps, the published\nalgorithm in the larger worlds");
  command.footer(
      "engine-polygons adds each polygon by its vertices, engine-shapes by the id of a shape, engine-fill all at\n"
      "once; published-port is the published algorithm, ported word for word; geos-coverage is CoverageUnion,\n"
      "geos UnaryUnion. Rows polygons-… in the JSON are the time to make the polygons, which is in no other row\n"
      "(but cgal's). Every subject of a scenario must come to the same area and corners, else its time does not\n"
      "count and the exit status is 1; what is missing here is skipped with a word. Times are of one core, and\n"
      "comparable only within one run.\n\n"
      "Example: lgs bench --json bench.json");
  command.callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace lgs::oracle
