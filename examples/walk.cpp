// A long walk through a world without end: a window of 40×25 chunks goes to the right while holes are dug, and comes
// back.
//
//   walk [COLUMNS]    so many columns of chunks there and back; 40 if nothing is said
//
// A frame brings one chunk, lets one go, digs and commits. Around the window lies a ring of chunks that are unloaded:
// so no wall appears where the window ends. What is further away is forgotten. Chunks that were dug in go to the disk
// (here a map), all others are made anew. On the way back nothing is dug, and each chunk must leave with the bytes with
// which it came: so nothing was lost.
#include <lgs/world.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <set>
#include <vector>

namespace {

constexpr std::int32_t kWidth = 40, kHeight = 25, kSize = 32;

/// A number that depends on a place alone.
std::uint32_t hashOf(std::int32_t x, std::int32_t y) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u;
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return h ^ h >> 15;
}

/// Of the ground, in cells: hills of 64 cells' width.
std::int32_t heightAt(std::int32_t i) {
  const auto hill = [](std::int32_t k) { return 360 + static_cast<std::int32_t>(hashOf(k, -1) % 80); };
  const std::int32_t k = i >> 6, part = i & 63;
  return hill(k) + (hill(k + 1) - hill(k)) * part / 64;
}

class Walk {
 public:
  Walk() {
    constexpr auto kUnit = lgs::kUnitsPerCell;
    square_ = *world_.shape(lgs::kUnitSquare);
    ramp_ = *world_.shape({{0, 0}, {kUnit, 0}, {kUnit, kUnit}});
    for (std::int32_t ci = -1; ci <= kWidth; ++ci) {
      for (std::int32_t cj = -1; cj <= kHeight; ++cj) make({ci, cj});
      if (ci == -1 || ci == kWidth) keep(ci, 0, kHeight - 1);
      keep(ci, -1, -1);
      keep(ci, kHeight, kHeight);
    }
    world_.commit();
  }

  /// The window goes by one column; `way` is 1 to the right and -1 to the left.
  void step(std::int32_t way, bool digs) {
    const std::int32_t comes = way > 0 ? left_ + kWidth : left_ - 1, leaves = way > 0 ? left_ : left_ + kWidth - 1;
    for (std::int32_t row = -1; row <= kHeight + 1; ++row) {
      const std::clock_t begin = std::clock();         // the processor's time: other programs do not count
      if (row <= kHeight) border({comes + way, row});  // of the column beyond, a row ahead
      if (const std::int32_t cj = row - 1; cj >= 0 && cj < kHeight) {
        bring({comes, cj});
        keep(leaves, cj, cj);
      }
      if (digs) dig();
      segments_ += world_.commit().added.size();
      if (row == kHeight + 1) forget(leaves - way);
      frames_.push_back(static_cast<double>(std::clock() - begin) * 1e6 / CLOCKS_PER_SEC);
    }
    left_ += way;
  }

  void report(const char* what) {
    std::ranges::sort(frames_);
    const auto at = [&](double part) {
      return frames_.empty() ? 0 : frames_[static_cast<std::size_t>(part * static_cast<double>(frames_.size() - 1))];
    };
    const lgs::Stats stats = world_.stats();
    std::printf("%s: column %d, %zu frames, p50 %.0f, p99 %.0f, most %.0f us; %.1f MB, %llu chunks, %llu segments\n",
                what, left_, frames_.size(), at(0.5), at(0.99), at(1), static_cast<double>(stats.bytes) / 1e6,
                static_cast<unsigned long long>(stats.chunks), static_cast<unsigned long long>(stats.segments));
    frames_.clear();
  }

  std::size_t lost() const { return lost_; }
  std::size_t onDisk() const { return disk_.size(); }

 private:
  static lgs::CellRect cellsOf(lgs::Cell c) {
    return {{kSize * c.i, kSize * c.j}, {kSize * c.i + kSize - 1, kSize * c.j + kSize - 1}};
  }

  /// The ground of a chunk, as it is before anybody digs. Where it is all sky no chunk comes to be.
  void make(lgs::Cell chunk) {
    const lgs::CellRect cells = cellsOf(chunk);
    placed_.clear();
    for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i) {
      const std::int32_t height = heightAt(i), next = heightAt(i + 1);
      for (std::int32_t j = cells.min.j; j <= std::min(cells.max.j, height); ++j) {
        const bool isCave = hashOf(i >> 2, j >> 2) % 8 == 0 && j < height - 2;
        if (isCave) continue;
        if (j == height && next <= height) continue;
        placed_.push_back({{i, j}, j == height ? ramp_ : square_, static_cast<lgs::Block>(j < height - 20)});
      }
    }
    if (!world_.addMany(placed_)) std::abort();
  }

  /// A chunk comes from the disk, or is made.
  void fetch(lgs::Cell chunk) {
    const auto found = disk_.find(chunk);
    if (found == disk_.end()) return make(chunk);
    if (!world_.reload(found->second)) std::abort();
  }

  /// A chunk beyond the window: what it shows to those beside it must be known.
  void border(lgs::Cell chunk) {
    fetch(chunk);
    keep(chunk.i, chunk.j, chunk.j);
  }

  void bring(lgs::Cell chunk) {
    const auto found = shelf_.find(chunk);
    if (found == shelf_.end()) return;  // it is all sky
    if (!world_.reload(found->second)) std::abort();
    shelf_.erase(found);
  }

  /// Chunks leave the window, or are in the ring around it.
  void keep(std::int32_t ci, std::int32_t first, std::int32_t last) {
    const lgs::CellRect cells{cellsOf({ci, first}).min, cellsOf({ci, last}).max};
    const auto take = [&](lgs::Cell corner, std::span<const std::byte> bytes) {
      const lgs::Cell chunk{corner.i / kSize - (corner.i % kSize < 0), corner.j / kSize - (corner.j % kSize < 0)};
      std::vector<std::byte> copy(bytes.begin(), bytes.end());
      if (const auto was = disk_.find(chunk); was != disk_.end() && !dug_.contains(chunk)) lost_ += was->second != copy;
      if (dug_.erase(chunk) != 0) disk_[chunk] = copy;
      shelf_[chunk] = std::move(copy);
    };
    if (!world_.unload(cells, take)) std::abort();
  }

  void forget(std::int32_t ci) {
    if (!world_.forgetChunks(lgs::CellRect{cellsOf({ci, -1}).min, cellsOf({ci, kHeight}).max})) std::abort();
    for (std::int32_t cj = -1; cj <= kHeight; ++cj) shelf_.erase({ci, cj});
  }

  void dig() {
    const std::uint32_t a = hashOf(++digs_, 5), b = hashOf(digs_, 6);
    const std::int32_t i = kSize * (left_ + 2) + static_cast<std::int32_t>(a % (kSize * (kWidth - 4)));
    const std::int32_t j = 40 + static_cast<std::int32_t>(b % 360);
    const lgs::CellRect hole{{i, j}, {i + 2, j + 2}};
    if (world_.firstUnloaded(hole)) return;
    if (!world_.clear(hole)) std::abort();
    for (const lgs::Cell corner : {hole.min, hole.max, lgs::Cell{i, j + 2}, lgs::Cell{i + 2, j}})
      dug_.insert({corner.i >> 5, corner.j >> 5});
  }

  lgs::World world_;
  lgs::ShapeId square_, ramp_;
  std::int32_t left_ = 0, digs_ = 0;
  std::map<lgs::Cell, std::vector<std::byte>> shelf_, disk_;  ///< of the ring; of what was dug
  std::set<lgs::Cell> dug_;                                   ///< chunks that differ from what is on the disk
  std::vector<lgs::Placement> placed_;
  std::vector<double> frames_;
  std::size_t lost_ = 0, segments_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const int columns = argc > 1 ? std::atoi(argv[1]) : 40;
  Walk walk;
  walk.report("at the start");
  for (int way : {1, -1}) {
    for (int k = 1; k <= columns; ++k) {
      walk.step(way, way > 0);
      if (k % std::max(columns / 4, 1) == 0) walk.report(way > 0 ? "to the right" : "back");
    }
  }
  std::printf("%zu chunks were dug in, %zu came back wrong\n", walk.onDisk(), walk.lost());
  return walk.lost() == 0 ? 0 : 1;
}
