#include "oracle/cgal/cgal_union.h"
#include "oracle/check/random.h"
#include "oracle/cli/command.h"
#include "oracle/cli/progress.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/dump.h"

#include <fmt/format.h>
#include <lgs/world.h>
#include <algorithm>
#include <chrono>
#include <map>

namespace lgs::oracle {
namespace {

using Clock = std::chrono::steady_clock;
using Nanoseconds = std::int64_t;

constexpr std::int32_t kSide = 100;  // cells
constexpr std::int32_t U = kUnitsPerCell;

template <class Work>
Nanoseconds timeOf(Work work) {
  const Clock::time_point begin = Clock::now();
  work();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - begin).count();
}

Scene fullScene() {
  Scene scene;
  for (std::int32_t j = 0; j < kSide; ++j) {
    for (std::int32_t i = 0; i < kSide; ++i) {
      scene.polygons.push_back({{i, j}, 1, {kUnitSquare.begin(), kUnitSquare.end()}});
    }
  }
  return scene;
}

Scene rampScene() {
  const std::vector<std::vector<LocalPoint>> ramps{
      {{0, 0}, {U, 0}, {U, U}}, {{0, 0}, {U, 0}, {0, U}}, {{0, 0}, {U, U}, {0, U}}, {{U, 0}, {U, U}, {0, U}}};
  Scene scene = fullScene();
  Random random(1);
  for (ScenePolygon& polygon : scene.polygons) polygon.vertices = random.pick(ramps);
  return scene;
}

// A game knows its tiles' shapes beforehand: finding their ids is no part of the work.
std::vector<ShapeId> shapesOf(World& world, const Scene& scene) {
  std::map<std::vector<LocalPoint>, ShapeId> known;
  std::vector<ShapeId> shapes;
  for (const ScenePolygon& p : scene.polygons) {
    const auto [entry, isNew] = known.try_emplace(p.vertices);
    if (isNew) entry->second = world.shape(std::span<const LocalPoint>(p.vertices)).value();
    shapes.push_back(entry->second);
  }
  return shapes;
}

// The ways to place a polygon.
using Add = PolygonHandle (*)(World&, const ScenePolygon&, ShapeId);

PolygonHandle addVertices(World& world, const ScenePolygon& p, ShapeId) {
  return world.add(p.cell, std::span<const LocalPoint>(p.vertices), p.block).value();
}

PolygonHandle addShape(World& world, const ScenePolygon& p, ShapeId shape) {
  return world.add(p.cell, shape, p.block).value();
}

constexpr std::pair<const char*, Add> kAdds[] = {{"engine-polygons", addVertices}, {"engine-shapes", addShape}};

struct Row {
  std::string scenario;
  std::string subject;
  std::vector<Nanoseconds> times;
  std::size_t cells = 0;
  std::size_t segments = 0;

  Nanoseconds percentile(std::size_t percent) {
    const auto at = times.begin() + static_cast<std::ptrdiff_t>((times.size() - 1) * percent / 100);
    std::nth_element(times.begin(), at, times.end());
    return *at;
  }
};

// Subjects run one after the other, round by round: a slow moment of the machine hits all alike. All subjects of a
// scenario must come to the same outline.
class Bench {
 public:
  explicit Bench(int rounds) : rounds_(rounds) {}

  /// A scene from nothing. `fill`: it is one full rectangle.
  void build(const std::string& scenario, const Scene& scene, bool fill) {
    Row cgal{scenario, "cgal", {}, scene.polygons.size(), 0};
    std::vector<Row> engine;
    for (const auto& add : kAdds) engine.push_back({scenario, add.first, {}, scene.polygons.size(), 0});
    if (fill) engine.push_back({scenario, "engine-fill", {}, scene.polygons.size(), 0});
    Outline expected;
    for (int round = 0; round < rounds_; ++round) {
      cgal.times.push_back(timeOf([&] { expected = cgalUnion(scene)->outline; }));
      constexpr int kRepeats = 10;  // so much faster that one run says little
      for (int repeat = 0; repeat < kRepeats; ++repeat) {
        for (std::size_t k = 0; k < engine.size(); ++k) {
          World world;
          const std::vector<ShapeId> shapes = shapesOf(world, scene);
          engine[k].times.push_back(timeOf([&] {
            if (k == std::size(kAdds)) {
              (void)world.fill({{0, 0}, {kSide - 1, kSide - 1}}, shapes[0], scene.polygons[0].block);
            } else {
              for (std::size_t at = 0; at < shapes.size(); ++at) kAdds[k].second(world, scene.polygons[at], shapes[at]);
            }
            world.commit();
          }));
          if (repeat == 0) agree_ = agree_ && outlineOf(world) == expected;
        }
      }
    }
    engine.push_back(std::move(cgal));
    take(std::move(engine), expected.size());
  }

  /// One polygon removed or added, and committed; against the whole world again.
  void edit(const std::string& scenario, const Scene& scene) {
    const std::size_t cells = scene.polygons.size();
    Row cgal{scenario, "cgal", {}, cells, 0};
    std::vector<Row> engine;
    std::vector<Digger> diggers;
    for (const auto& add : kAdds) {
      engine.push_back({scenario, add.first, {}, cells, 0});
      diggers.emplace_back(scene, add.second);
    }
    Outline expected;
    for (int round = 0; round < rounds_; ++round) {
      for (std::size_t k = 0; k < diggers.size(); ++k) diggers[k].dig(engine[k].times);
      cgal.times.push_back(timeOf([&] { expected = cgalUnion(scene)->outline; }));
      for (const Digger& digger : diggers) agree_ = agree_ && outlineOf(digger.world()) == expected;
    }
    engine.push_back(std::move(cgal));
    take(std::move(engine), expected.size());
  }

  std::vector<Row>& rows() { return rows_; }
  bool agree() const { return agree_; }

 private:
  /// Takes random polygons away and puts them back, the same ones for each way to add.
  class Digger {
   public:
    Digger(const Scene& scene, Add add) : scene_(scene), add_(add), shapes_(shapesOf(world_, scene)) {
      for (std::size_t k = 0; k < shapes_.size(); ++k) handles_.push_back(add_(world_, scene.polygons[k], shapes_[k]));
      world_.commit();
    }

    void dig(std::vector<Nanoseconds>& times) {
      constexpr int kTimes = 1'000;
      for (int k = 0; k < kTimes; ++k) {
        const std::size_t at = random_.below(handles_.size());
        times.push_back(timeOf([&] {
          (void)world_.remove(handles_[at]);
          world_.commit();
        }));
        times.push_back(timeOf([&] {
          handles_[at] = add_(world_, scene_.polygons[at], shapes_[at]);
          world_.commit();
        }));
      }
    }

    const World& world() const { return world_; }

   private:
    const Scene& scene_;
    Add add_;
    World world_;
    std::vector<ShapeId> shapes_;
    std::vector<PolygonHandle> handles_;
    Random random_{2};
  };

  void take(std::vector<Row> rows, std::size_t segments) {
    for (Row& row : rows) {
      row.segments = segments;
      rows_.push_back(std::move(row));
    }
  }

  int rounds_;
  std::vector<Row> rows_;
  bool agree_ = true;
};

std::string readable(double nanoseconds) {
  if (nanoseconds < 1e4) return fmt::format("{:.0f} ns", nanoseconds);
  return nanoseconds < 1e6 ? fmt::format("{:.1f} µs", nanoseconds / 1e3) : fmt::format("{:.2f} ms", nanoseconds / 1e6);
}

void printTable(std::vector<Row>& rows) {
  fmt::print("{:<15} {:<16} {:>12} {:>12} {:>9} {:>12}\n", "scenario", "subject", "median", "p99", "segments",
             "cgal/this");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Row& row = rows[k];
    const auto cgal = std::find_if(rows.begin(), rows.end(), [&](const Row& other) {
      return other.scenario == row.scenario && other.subject == "cgal";
    });
    const auto median = static_cast<double>(row.percentile(50));
    fmt::print("{:<15} {:<16} {:>12} {:>12} {:>9} {:>12.0f}\n", row.scenario, row.subject, readable(median),
               readable(static_cast<double>(row.percentile(99))), row.segments,
               static_cast<double>(cgal->percentile(50)) / median);
  }
}

std::string toJson(std::vector<Row>& rows) {
  std::string text;
  for (Row& row : rows) {
    text += text.empty() ? "[\n" : ",\n";
    text += fmt::format(
        R"(  {{"scenario": "{}", "subject": "{}", "median_ns": {}, "p99_ns": {}, "cells": {}, "segments": {}}})",
        row.scenario, row.subject, row.percentile(50), row.percentile(99), row.cells, row.segments);
  }
  return text + "\n]\n";
}

Status run(const std::string& json, int rounds) {
  if (const Status bad = tryOutputs({json}); bad != Status::fine) return bad;
  Bench bench(rounds);
  {
    Progress progress;
    const auto starts = [&](const char* scenario) {
      if (progress.isDue()) progress.show(scenario);
    };
    starts("full-100");
    bench.build("full-100", fullScene(), true);
    starts("ramp-100");
    bench.build("ramp-100", rampScene(), false);
    starts("edit-100");
    const Scene full = fullScene();
    bench.edit("edit-100", full);
    starts("edit-ramp-100");
    const Scene ramps = rampScene();
    bench.edit("edit-ramp-100", ramps);
  }
  if (json != "-") {
    fmt::print("{0}×{0} cells; full, ramp: from nothing; edit: one polygon removed or added, and committed.\n", kSide);
    fmt::print("cgal unites the whole world, and reads segments, links and owners from the union.\n\n");
    printTable(bench.rows());
    fmt::print("\n{}\n", bench.agree() ? "All subjects came to the same outlines." : "MISMATCH: the outlines differ.");
  }
  const Status written = json.empty() ? Status::fine : write(json, toJson(bench.rows()));
  return worst(written, bench.agree() ? Status::fine : Status::mismatch);
}

}  // namespace

void addBench(CLI::App& app, Run& chosen) {
  const auto json = std::make_shared<std::string>();
  const auto rounds = std::make_shared<int>(5);
  CLI::App& command = *app.add_subcommand("bench", "Incremental against full recompute by CGAL, as a table of ratios");
  command
      .add_option("--json", *json,
                  "Write the figures: an array of {scenario, subject, median_ns,\n"
                  "p99_ns, cells, segments}; - is stdout, without the table")
      ->option_text("FILE");
  addWholeNumber(
      command, "--rounds", [rounds](std::uint64_t n) { *rounds = static_cast<int>(n); }, {1, 10'000},
      "How often the subjects run, one after the other; default 5")
      ->option_text("N");
  command.footer(
      "engine-polygons adds each polygon by its vertices, engine-shapes by the id of a shape, engine-fill\n"
      "all at once; cgal unites the whole world again. Every subject of a scenario must come to the same\n"
      "outline, else the exit status is 1. Times are of one core, and comparable only within one run.\n\n"
      "Example: lgs bench --json bench.json");
  command.callback([json, rounds, &chosen] { chosen = [json, rounds] { return run(*json, *rounds); }; });
}

}  // namespace lgs::oracle
