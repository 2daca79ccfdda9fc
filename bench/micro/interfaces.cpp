// What the C interface costs: the same single edits, each with its commit, by C++ and by C, in turns. The C library is
// the shared one, as a program in another language has it.
#include "bench/edit_times.h"
#include "bench/micro/benches.h"

#include <fmt/format.h>
#include <lgs/lgs.h>
#include <lgs/world.h>

#include <stdexcept>

namespace lgs::bench {
namespace {

/// A world of tiles with one polygon each at most, by C++.
class ByCpp {
 public:
  explicit ByCpp(const Tiles& tiles) : tiles_(tiles), handles_(tiles.size()) {
    for (const Kind& kind : tiles.kinds) shapes_.push_back(world_.shape(kind.polygons).value());
    for (std::size_t k = 0; k < tiles.size(); ++k) handles_[k] = *world_.add(tiles.cell(k), shapes_[tiles.at[k]], 1);
    world_.commit();
  }
  std::size_t removeAndAdd(std::size_t k) {
    if (!world_.remove(handles_[k])) throw std::logic_error("a removal was refused");
    std::size_t changes = world_.commit().added.size();
    handles_[k] = *world_.add(tiles_.cell(k), shapes_[tiles_.at[k]], 1);
    changes += world_.commit().added.size();
    return changes;
  }

 private:
  const Tiles& tiles_;
  World world_;
  std::vector<ShapeId> shapes_;
  std::vector<PolygonHandle> handles_;
};

/// The same by C.
class ByC {
 public:
  explicit ByC(const Tiles& tiles) : tiles_(tiles), polygons_(tiles.size()) {
    lgs_new(nullptr, &world_);
    for (const Kind& kind : tiles.kinds) {
      std::vector<lgs_local_point> vertices;
      for (const LocalPoint p : kind.polygons.at(0)) vertices.push_back({p.x, p.y});
      check(lgs_shape(world_, vertices.data(), vertices.size(), &shapes_.emplace_back(), nullptr));
    }
    for (std::size_t k = 0; k < tiles.size(); ++k) add(k);
    check(lgs_commit(world_, nullptr));
  }
  ByC(const ByC&) = delete;
  ByC& operator=(const ByC&) = delete;
  ~ByC() { lgs_free(world_); }

  std::size_t removeAndAdd(std::size_t k) {
    lgs_changes changes;
    check(lgs_remove(world_, polygons_[k], nullptr));
    check(lgs_commit(world_, &changes));
    std::size_t added = changes.added_count;
    add(k);
    check(lgs_commit(world_, &changes));
    return added + changes.added_count;
  }

 private:
  static void check(lgs_status status) {
    if (status != LGS_OK) throw std::logic_error(lgs_status_name(status));
  }
  void add(std::size_t k) {
    const Cell cell = tiles_.cell(k);
    check(lgs_add(world_, {cell.i, cell.j}, shapes_[tiles_.at[k]], 1, &polygons_[k], nullptr));
  }

  const Tiles& tiles_;
  lgs_world* world_ = nullptr;
  std::vector<lgs_shape_id> shapes_;
  std::vector<lgs_polygon_id> polygons_;
};

void interfaces(benchmark::State& state, const Scale& scale, const std::string& world) {
  const Tiles tiles = makeTiles(world, sizeOf(std::min<std::int64_t>(scale.maxCells, 10'000)));
  const std::vector<std::uint32_t> cells =
      planEdits(tiles, static_cast<std::size_t>(scale.edits), Where::anywhere, 1).cells;
  constexpr std::size_t kAtOnce = 100;  // so that the clock costs nothing
  ByCpp cpp(tiles);
  ByC c(tiles);
  Times cppTimes, cTimes;
  while (state.KeepRunning()) {
    for (std::size_t from = 0; from < cells.size(); from += kAtOnce) {
      const auto some = std::span(cells).subspan(from, std::min(kAtOnce, cells.size() - from));
      std::size_t balance = 0;
      const auto timed = [&](auto& subject, Times& times, std::size_t sign) {
        const auto all = timeOf([&] {
          for (const std::uint32_t cell : some) balance += sign * subject.removeAndAdd(cell);
        });
        times.add(all / static_cast<Nanoseconds>(2 * some.size()));
      };
      timed(cpp, cppTimes, 1);
      timed(c, cTimes, static_cast<std::size_t>(-1));
      if (balance != 0) throw std::logic_error("C and C++ report different changes");
    }
  }
  putTimes(state, cppTimes, "cpp_");
  putTimes(state, cTimes, "c_");
}

}  // namespace

void registerInterfaces(const Scale& scale) {
  for (const std::string world : {"full", "ramp"}) {
    benchmark::RegisterBenchmark(fmt::format("interface/{}", world).c_str(), [=](benchmark::State& state) {
      interfaces(state, scale, world);
    })->Iterations(1);
  }
}

}  // namespace lgs::bench
