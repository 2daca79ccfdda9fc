// What the terrain costs, by the size of a chunk: bodies and shapes, loading 100×100 cells, a sync after one edit and
// after 1,000; what it costs to undo 100 edits, and to do them again; what law 13 costs among bodies; and a sync beside
// the edit, and beside what Box2D itself takes to make and destroy as many shapes. Each time of the first two is the
// least of some rounds on one core; those of law 13 are of the processor; the last ones are medians of 200. Compare
// times of one run only.
#include "oracle/calls/random.h"

#include "physics.h"

#include <fmt/format.h>
#include <lgs/box2d/terrain.h>
#include <lgs/brush.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <limits>
#include <optional>
#include <vector>

namespace lgs::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::int32_t kSide = 100;
constexpr std::int32_t U = kUnitsPerCell;
constexpr int kRounds = 3;

template <class Work>
double microseconds(Work work) {
  const Clock::time_point begin = Clock::now();
  work();
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

// The same in time of the processor, for what takes longer than it takes to ask for that: others on the machine count
// less.
template <class Work>
double processorMicroseconds(Work work) {
  const auto now = [] {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

struct Field {
  World world;
  std::vector<ShapeId> shapes;
  std::vector<PolygonHandle> handles;
  oracle::Random random{1};

  explicit Field(bool ramps) {
    constexpr std::array<LocalPoint, 3> kRamps[] = {
        {{{0, 0}, {U, 0}, {U, U}}}, {{{0, 0}, {U, 0}, {0, U}}}, {{{0, 0}, {U, U}, {0, U}}}, {{{U, 0}, {U, U}, {0, U}}}};
    for (const auto& ramp : kRamps) shapes.push_back(*world.shape(std::span<const LocalPoint>(ramp)));
    if (!ramps) shapes = {*world.shape(kUnitSquare)};
    for (std::int32_t k = 0; k < kSide * kSide; ++k) handles.push_back(add({k % kSide, k / kSide}));
    world.commit();
  }
  PolygonHandle add(Cell cell) { return *world.add(cell, random.pick(shapes), 1); }

  void dig(std::size_t at) { (void)world.remove(handles[at]); }
  void refill(std::size_t at) {
    const auto index = static_cast<std::int32_t>(at);
    handles[at] = add({index % kSide, index / kSide});
  }

  /// Carves a circle that is 1.5 cells in radius.
  void stroke() {
    const Point middle{(2 + random.below(kSide - 4)) * U, (2 + random.below(kSide - 4)) * U};
    (void)carve(world, circle(middle, 3 * U / 2, 24));
  }
};

// Calls `round` a few times, and returns the least that it measured.
template <class Round>
double leastOf(Round round) {
  double least = std::numeric_limits<double>::max();
  for (int k = 0; k < kRounds; ++k) least = std::min(least, round());
  return least;
}

// A terrain in a world with a body in it, after a step. A game has bodies too, and the terrain looks for those that it
// must wake. Whenever a fixture goes, Box2D 2.4 looks through everything that was made since the last step. A game
// takes steps, so this must too.
class Populated {
 public:
  Populated(Field& field, const box2d::TerrainOptions& options) : field_(field) {
    physics_.addBody();
    terrain_.emplace(physics_.world(), field.world, options);
    physics_.step();
  }

  /// Commits and syncs; returns the time of the sync alone.
  double sync() {
    const Changes& changes = field_.world.commit();
    const double time = microseconds([&] { terrain_->sync(changes); });
    physics_.step();
    return time;
  }
  box2d::Terrain& terrain() { return *terrain_; }
  void step() { physics_.step(); }

 private:
  Field& field_;
  Physics physics_;
  std::optional<box2d::Terrain> terrain_;
};

double load(const Field& field, const box2d::TerrainOptions& options) {
  return leastOf([&] {
    Physics physics;
    std::optional<box2d::Terrain> terrain;
    return microseconds([&] { terrain.emplace(physics.world(), field.world, options); });
  });
}

// The mean time of digging and refilling random cells.
double oneEdit(Field& field, const box2d::TerrainOptions& options) {
  constexpr int kTimes = 300;
  Populated populated(field, options);
  return leastOf([&] {
    double sum = 0;
    for (int k = 0; k < kTimes; ++k) {
      const std::size_t at = field.random.below(field.handles.size());
      field.dig(at);
      sum += populated.sync();
      field.refill(at);
      sum += populated.sync();
    }
    return sum / (2 * kTimes);
  });
}

double thousandDigs(Field& field, const box2d::TerrainOptions& options) {
  constexpr std::size_t kTimes = 1'000;
  Populated populated(field, options);
  return leastOf([&] {
    for (std::size_t k = 0; k < kTimes; ++k) field.dig(k * 9);
    const double time = populated.sync();
    for (std::size_t k = 0; k < kTimes; ++k) field.refill(k * 9);
    populated.sync();
    return time;
  });
}

// Rolls back 100 edits, each with its commit, at once, and redoes them. Both times are with the sync.
struct BackAndForth {
  double undo, redo;
};
template <class Edit>
BackAndForth hundredEdits(Field& field, Edit edit) {
  Populated populated(field, {});
  const Mark begin = field.world.mark();
  for (std::size_t k = 0; k < 100; ++k) {
    edit(field, k);
    populated.sync();
  }
  const Mark end = field.world.mark();
  const auto both = [&](auto go) {
    const double time = processorMicroseconds([&] {
      (void)go();
      populated.terrain().sync(field.world.changesOfRollBack());
    });
    populated.step();
    return time;
  };
  double redo = std::numeric_limits<double>::max();
  const double undo = leastOf([&] {
    const double back = both([&] { return field.world.rollBack(begin, Undone::keep); });
    redo = std::min(redo, both([&] { return field.world.redo(end); }));
    return back;
  });
  return {undo, redo};
}

// Circles are painted and carved where 50 boxes are, in a closed world of 24×14 cells.
struct AmongBodies {
  std::vector<double> looks;  // overlapsWith()
  std::vector<double> syncs;  // with what it looks at
  std::size_t overlaps = 0;
};
AmongBodies amongBodies(int edits) {
  constexpr std::int32_t kWidth = 24, kHeight = 14;
  World world;
  const ShapeId square = *world.shape(kUnitSquare);
  (void)world.fill({{-1, -1}, {kWidth, kHeight}}, square, 1);
  (void)world.clear({{0, 2}, {kWidth - 1, kHeight - 1}});
  world.commit();
  Physics physics;
  box2d::Terrain terrain(physics.world(), world);
  for (int k = 0; k < 50; ++k) physics.addBox(terrain.position({(k % 22 + 1) * U, (4 * U + k / 22 * 2 * U)}), 0.3F);
  oracle::Random random(1);
  AmongBodies result;
  for (int k = 0; k < edits; ++k) {
    const Point at = terrain.latticePoint(physics.placeOf(static_cast<std::size_t>(random.below(50))));
    const auto within = [](std::int64_t v, std::int64_t cells) {
      return std::clamp<std::int64_t>(v, 2 * U, (cells - 2) * U);
    };
    const Region region = circle({within(at.x, kWidth), within(at.y, kHeight)}, (2 + random.below(6)) * U / 4, 24);
    (void)(random.chance(40) ? paint(world, region, 2, PaintMode::fill) : carve(world, region));
    const Changes& changes = world.commit();
    result.looks.push_back(processorMicroseconds([&] { result.overlaps += terrain.overlapsWith(changes).size(); }));
    result.syncs.push_back(processorMicroseconds([&] { (void)terrain.sync(changes); }));
    for (int step = 0; step < 4; ++step) {
      terrain.beforeStep();
      physics.step();
      terrain.afterStep();
    }
  }
  return result;
}

// A box of nearly 2 cells in a hole that is filled: how long it takes to find no way out.
double noWayOut(Field& field) {
  const auto around = [&](auto act) {
    for (std::int32_t j = 49; j < 52; ++j)
      for (std::int32_t i = 49; i < 52; ++i) act(static_cast<std::size_t>(j * kSide + i));
  };
  around([&](std::size_t at) { field.dig(at); });
  field.world.commit();
  Physics physics;
  box2d::Terrain terrain(physics.world(), field.world);
  physics.addBox(terrain.position({101 * U / 2, 101 * U / 2}), 0.9F);
  around([&](std::size_t at) { field.refill(at); });
  const Changes& changes = field.world.commit();
  return leastOf([&] { return processorMicroseconds([&] { (void)terrain.overlapsWith(changes); }); });
}

double mean(const std::vector<double>& times) {
  double sum = 0;
  for (const double time : times) sum += time;
  return sum / static_cast<double>(times.size());
}

std::size_t mostOnABody(const box2d::EdgeSet& edges) {
  std::vector<std::size_t> counts(edges.chunkCount());
  for (const box2d::EdgeId id : edges.edges()) ++counts[edges.edge(id).chunk];
  return *std::max_element(counts.begin(), counts.end());
}

void printLine(bool ramps, std::int32_t chunk, bool merge) {
  Field field(ramps);
  const box2d::TerrainOptions options{.chunkCells = chunk, .merge = merge};
  Physics physics;
  const box2d::Terrain terrain(physics.world(), field.world, options);
  fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} |\n", ramps ? "ramps" : "full", chunk,
             merge ? "yes" : "no", terrain.bodyCount(), terrain.edges().counts().edges, mostOnABody(terrain.edges()),
             load(field, options) / 1e3, oneEdit(field, options), thousandDigs(field, options) / 1e3);
}

// The edit is made anywhere in full blocks, and undone. Medians.
template <class Edit>
void printBeside(std::int32_t side, const char* name, Edit edit) {
  constexpr std::size_t kTimes = 200, kOnAChunk = 150;
  World world;
  (void)world.fill({{0, 0}, {side - 1, side - 1}}, *world.shape(kUnitSquare), 1);
  world.commit();
  Physics physics, bare;
  box2d::Terrain terrain(physics.world(), world);
  BareEdges edges(bare);
  oracle::Random random{1};
  std::vector<double> edited, synced, made;
  while (edited.size() < kTimes) {
    const auto coordinate = [&] { return 4 * U + random.below((side - 8) * U); };
    const Point at{coordinate(), coordinate()};
    while (edges.size() < kOnAChunk) edges.make();
    const Mark mark = world.mark();
    const Changes* changes = nullptr;
    edited.push_back(microseconds([&] {
      edit(world, at);
      changes = &world.commit();
    }));
    synced.push_back(microseconds([&] { terrain.sync(*changes); }));
    made.push_back(microseconds([&] {
      for (std::size_t k = 0; k < changes->added.size(); ++k) edges.make();
      for (std::size_t k = 0; k < changes->removed.size(); ++k) edges.destroy();
    }));
    while (edges.size() > kOnAChunk) edges.destroy();
    (void)world.rollBack(mark);
    terrain.sync(world.changesOfRollBack());
    (void)world.forget(mark);
    physics.step();
    bare.step();
  }
  const auto median = [](std::vector<double>& times) {
    std::nth_element(times.begin(), times.begin() + kTimes / 2, times.end());
    return times[kTimes / 2];
  };
  const double ofEdit = median(edited), ofSync = median(synced), itself = median(made);
  fmt::print("| {0}×{0} | {1} | {2:.2f} | {3:.2f} | {4:.2f} | {5:.2f} |\n", side, name, ofEdit, ofSync, itself,
             (ofSync - itself) / ofEdit);
}

void run() {
  fmt::print("| world | chunk | merged | bodies | shapes | most on a body | load, ms | sync after 1 edit, µs | ");
  fmt::print("after 1,000 digs, ms |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const bool ramps : {false, true}) {
    for (const std::int32_t chunk : {1, 4, 8, 16, 32, 100}) {
      for (const bool merge : {false, true}) printLine(ramps, chunk, merge);
    }
  }
  fmt::print("\n| world | edit | with its commit, µs | sync, µs | Box2D itself, µs | beyond it ÷ the edit |\n");
  fmt::print("|---|---|---|---|---|---|\n");
  for (const std::int32_t side : {16, 64, 256}) {
    printBeside(side, "a tile", [](World& world, Point at) { (void)world.clear(cellAt(at)); });
    printBeside(side, "a stroke of radius 3",
                [](World& world, Point at) { (void)carve(world, circle(at, 3 * U, 32)); });
  }
  fmt::print("\n| world | edits | undo 100, ms | and redo, ms |\n|---|---|---|---|\n");
  for (const bool ramps : {false, true}) {
    const auto print = [&](const char* edits, auto edit) {
      Field field(ramps);
      const auto [undo, redo] = hundredEdits(field, edit);
      fmt::print("| {} | {} | {:.2f} | {:.2f} |\n", ramps ? "ramps" : "full", edits, undo / 1e3, redo / 1e3);
    };
    print("cells", [](Field& field, std::size_t k) { field.dig(k * 97); });
    print("strokes", [](Field& field, std::size_t) { field.stroke(); });
  }
  constexpr int kEdits = 2'000;
  AmongBodies among = amongBodies(kEdits);
  const auto row = [](const char* what, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", what, mean(times), times[times.size() / 2],
               times[times.size() * 99 / 100], times.back());
  };
  fmt::print("\n| {} edits where 50 boxes are, {} overlaps | mean, µs | median | 99 % | worst |\n", kEdits,
             among.overlaps);
  fmt::print("|---|---|---|---|---|\n");
  row("the sync", among.syncs);
  row("of it the look for bodies", among.looks);
  for (const bool ramps : {false, true}) {
    Field field(ramps);
    fmt::print("\nno way out of 100×100 {}: {:.2f} ms\n", ramps ? "ramps" : "full cells", noWayOut(field) / 1e3);
  }
}

}  // namespace
}  // namespace lgs::bench

int main() { lgs::bench::run(); }
