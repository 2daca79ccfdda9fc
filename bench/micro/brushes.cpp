// Brushes: a hole carved, with its commit, beside what Clipper takes for the same hole in the cells that it touches. The
// world is as before after each time.
#include "bench/micro/benches.h"

#include <lgs/brush.h>

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <random>
#include <stdexcept>

#ifdef LGS_BENCH_CLIPPER
#include <polyclipping/clipper.hpp>
#endif

namespace lgs::bench {
namespace {

constexpr std::int64_t kRadius = 3;  // cells

World worldOf(const Tiles& tiles) {
  World world;
  for (std::size_t k = 0; k < tiles.size(); ++k)
    for (const std::vector<LocalPoint>& polygon : tiles.kind(k).polygons)
      if (!world.add(tiles.cell(k), polygon, tiles.kind(k).block)) throw std::logic_error("a tile is refused");
  world.commit();
  return world;
}

/// Centers of holes that lie in the world as a whole, on any lattice point.
std::vector<Point> centersIn(const Tiles& tiles, std::size_t count) {
  std::mt19937_64 random(1);
  const auto coordinate = [&](std::int32_t cells) {
    const auto room = static_cast<std::uint64_t>((cells - 2 * kRadius) * kUnitsPerCell);
    return kRadius * kUnitsPerCell + static_cast<std::int64_t>(random() % room);
  };
  std::vector<Point> centers;
  while (centers.size() < count) {
    const std::int64_t x = coordinate(tiles.width);
    centers.push_back({x, coordinate(tiles.height)});
  }
  return centers;
}

/// Does the work, and undoes it.
template <class Work>
void timeIn(World& world, Times& times, Work&& work) {
  const Mark mark = world.mark();
  times.add(timeOf([&] {
    work();
    world.commit();
  }));
  if (!world.rollBack(mark) || !world.forget(mark)) throw std::logic_error("there is no way back");
}

#ifdef LGS_BENCH_CLIPPER
/// Clipper on the polygons of some cells of a world.
class Clipped {
 public:
  Clipped(const World& world, const CellRect& cells) {
    world.forEachPolygon(cells, [&](Cell cell, const PlacedPolygon& polygon) {
      ClipperLib::Path& path = solid_.emplace_back();
      for (const LocalPoint v : polygon.vertices) path.push_back(at(toWorld(cell, v)));
    });
  }

  Nanoseconds timeWithout(const Region& region) const {
    ClipperLib::Path hole;
    for (const Point p : region.rings[0]) hole.push_back(at(p));
    ClipperLib::Paths result;
    return timeOf([&] {
      ClipperLib::Clipper clipper;
      clipper.AddPaths(solid_, ClipperLib::ptSubject, true);
      clipper.AddPath(hole, ClipperLib::ptClip, true);
      clipper.Execute(ClipperLib::ctDifference, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    });
  }

 private:
  static ClipperLib::IntPoint at(Point p) { return {p.x, p.y}; }

  ClipperLib::Paths solid_;
};
#endif

void carveHoles(benchmark::State& state, const Tiles& tiles, std::size_t edits) {
  World world = worldOf(tiles);
  Times carved, ofCells;
  while (state.KeepRunning()) {
    for (const Point center : centersIn(tiles, edits)) {
      const Region hole = circle(center, kRadius * kUnitsPerCell, 32);
      timeIn(world, carved, [&] {
        if (!carve(world, hole)) throw std::logic_error("a hole is refused");
      });
#ifdef LGS_BENCH_CLIPPER
      constexpr std::int64_t kReach = kRadius * kUnitsPerCell;
      const CellRect touched{cellAt({center.x - kReach, center.y - kReach}),
                             cellAt({center.x + kReach, center.y + kReach})};
      ofCells.add(Clipped(world, touched).timeWithout(hole));
#endif
    }
  }
  putTimes(state, carved);
  if (!ofCells.empty()) putTimes(state, ofCells, "clipper_cells_");
}

}  // namespace

void registerBrushes(const Scale& scale) {
  const Size size = sizeOf(std::clamp<std::int64_t>(scale.maxCells, 100, 10'000));
  const auto edits = static_cast<std::size_t>(std::clamp<std::int64_t>(scale.edits / 50, 1, 400));
  for (const std::string world : {"full", "ramp", "mix"}) {
    benchmark::RegisterBenchmark(fmt::format("brush/carve/{}", world).c_str(), [=](benchmark::State& state) {
      carveHoles(state, makeTiles(world, size), edits);
    })->Iterations(1);
  }
}

}  // namespace lgs::bench
