// The published algorithm, ported word for word, and its optimised form (bench/published), in worlds with one polygon
// in each cell. Its vertices are floats, in cells. They are made beforehand, and they are exact, because all are
// corners of cells.
#include "bench/published/published_arrays.h"
#include "bench/published/published_lattice.h"
#include "bench/subjects/libraries.h"
#include "oracle/reference/outline.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace lgs::bench {
namespace {

/// Their segments, as the bench compares them.
Edges edgesOf(const Published& world) {
  Edges edges;
  for (const oracle::OutlineSegment& s : outlineOf(world)) edges.push_back({s.start, s.end});
  return edges;
}
Edges edgesOf(const PublishedArrays& world) {
  Edges edges;
  world.forEachSegment([&](const PublishedArrays::Segment& s) {
    edges.push_back({toLattice(PublishedArrays::unpacked(s.start)), toLattice(PublishedArrays::unpacked(s.end))});
  });
  return edges;
}
bool takes(const Published&, std::span<const Vec2>) { return true; }
bool takes(const PublishedArrays&, std::span<const Vec2> polygon) { return PublishedArrays::takes(polygon); }

/// `Make` makes the world for tiles.
template <class World, class Make>
class PublishedPort final : public Incremental {
 public:
  explicit PublishedPort(Make make) : make_(std::move(make)) {}

  void prepare(const Tiles& tiles) override {
    tiles_ = &tiles;
    polygons_.resize(tiles.size());
    for (std::size_t k = 0; k < tiles.size(); ++k) {
      if (const Kind& kind = tiles.kind(k); !kind.polygons.empty())
        polygons_[k] = floatVertices({tiles.cell(k), kind.block, kind.polygons.front()});
    }
  }

  bool build() override {
    const auto isOne = [](const Kind& kind) { return kind.polygons.size() == 1; };
    if (!std::all_of(tiles_->kinds.begin(), tiles_->kinds.end(), isOne)) return false;
    world_.emplace(make_(*tiles_));  // what the algorithm's own memory costs counts
    const auto isTaken = [&](const std::vector<Vec2>& polygon) { return takes(*world_, polygon); };
    if (!std::all_of(polygons_.begin(), polygons_.end(), isTaken)) return false;
    std::size_t k = 0;
    for (std::int32_t j = 0; j < tiles_->height; ++j) {
      for (std::int32_t i = 0; i < tiles_->width; ++i, ++k) world_->add({i, j}, polygons_[k], blockOf(k));
    }
    world_->compute();
    return true;
  }

  Edges edges() const override { return edgesOf(*world_); }

  void find(std::size_t cell) override { at_ = tiles_->cell(cell); }
  void remove(std::size_t cell) override {
    world_->remove(at_, polygons_[cell], blockOf(cell));
    world_->compute();
  }
  void add(std::size_t cell, std::size_t) override {
    world_->add(at_, polygons_[cell], blockOf(cell));
    world_->compute();
  }

 private:
  Block blockOf(std::size_t cell) const { return tiles_->kind(cell).block; }

  const Tiles* tiles_ = nullptr;
  std::vector<std::vector<Vec2>> polygons_;  // by cell
  Cell at_;
  Make make_;
  std::optional<World> world_;
};

template <class World, class Make>
Made made(Make make) {
  return std::make_unique<PublishedPort<World, Make>>(std::move(make));
}

}  // namespace

Made makePublishedPort() {
  return made<Published>([](const Tiles&) { return Published({}, Published::Sets::cleared); });
}
Made makePublishedPortWithNewSets() {
  return made<Published>([](const Tiles&) { return Published({}, Published::Sets::renewed); });
}
Made makePublishedArrays() {
  return made<PublishedArrays>([](const Tiles& tiles) { return PublishedArrays(tiles.width, tiles.height); });
}

}  // namespace lgs::bench
