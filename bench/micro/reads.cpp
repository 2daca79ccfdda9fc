// Reading what a commit changed, all segments, and all loops; and linking all segments anew without the world
// (lgs/radial_match.h). Times are for each segment.
#include "bench/edit_times.h"
#include "bench/micro/benches.h"

#include <lgs/radial_match.h>

#include <fmt/format.h>
#include <map>
#include <vector>

namespace lgs::bench {
namespace {

// Reads what a game hands on to its physics engine.
std::int64_t sumOf(const World& world, SegmentId id) {
  const Segment s = *world.segment(id);
  return s.start.x + s.end.y + s.ghost1.x + s.ghost2.y + s.block;
}

void readChanges(benchmark::State& state, const std::string& world, std::int64_t cells) {
  Built& b = built(world, cells);
  const auto dug = distinctCells(b.tiles, std::min<std::size_t>(1'000, b.tiles.occupied() / 10), 1);
  for (const std::uint32_t cell : dug) {
    b.engine.find(cell);
    b.engine.removeOnly(cell);
  }
  b.engine.commit();
  const Changes& changes = b.engine.changes();
  std::int64_t sum = 0;
  while (state.KeepRunning()) {
    for (const SegmentId id : changes.added) sum += sumOf(b.engine.world(), id);
    for (const SegmentId id : changes.relinked) sum += sumOf(b.engine.world(), id);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(changes.added.size() + changes.relinked.size()));
  for (const std::uint32_t cell : dug) b.engine.addOnly(cell, b.tiles.at[cell]);
  b.engine.commit();
}

void readSegments(benchmark::State& state, const std::string& world, std::int64_t cells) {
  Built& b = built(world, cells);
  std::int64_t sum = 0;
  std::int64_t count = 0;
  while (state.KeepRunning()) {
    for (const SegmentId id : b.engine.world().segments()) {
      sum += sumOf(b.engine.world(), id);
      ++count;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(count);
}

void readLoops(benchmark::State& state, const std::string& world, std::int64_t cells, Collinear collinear) {
  Built& b = built(world, cells);
  std::size_t loops = 0;
  while (state.KeepRunning()) loops = b.engine.world().loops(collinear).size();
  benchmark::DoNotOptimize(loops);
  state.counters["loops"] = static_cast<double>(loops);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(b.engine.world().stats().segments));
}

void match(benchmark::State& state, const std::string& world, std::int64_t cells) {
  const World& all = built(world, cells).engine.world();
  std::vector<Point> points;
  std::map<Point, std::uint32_t> numbers;
  const auto numberOf = [&](Point p) {
    const auto [at, isNew] = numbers.try_emplace(p, static_cast<std::uint32_t>(points.size()));
    if (isNew) points.push_back(p);
    return at->second;
  };
  std::vector<DirectedEdge> edges;
  for (const SegmentId id : all.segments()) {
    const Segment s = *all.segment(id);
    edges.push_back({numberOf(s.start), numberOf(s.end)});
  }
  while (state.KeepRunning()) benchmark::DoNotOptimize(radialMatch(points, edges).value().data());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(edges.size()));
}

}  // namespace

void registerReads(const Scale& scale) {
  const std::int64_t cells = std::min<std::int64_t>(scale.maxCells, 10'000);
  for (const std::string world : kWorlds) {
    const auto add = [&](const std::string& what, auto read) {
      benchmark::RegisterBenchmark(fmt::format("read/{}/{}", what, world).c_str(),
                                   [=](benchmark::State& state) { read(state, world, cells); });
    };
    add("changes", readChanges);
    add("segments", readSegments);
    add("loops", [](auto& state, auto& name, auto n) { readLoops(state, name, n, Collinear::keep); });
    add("loops-merged", [](auto& state, auto& name, auto n) { readLoops(state, name, n, Collinear::merge); });
    add("match", match);
  }
}

}  // namespace lgs::bench
