// The published algorithm, ported word for word (bench/published), in worlds with one polygon in each cell. Its
// vertices are floats, in cells. They are made beforehand, and they are exact, because all are corners of cells.
#include "bench/published/published_lattice.h"
#include "bench/subjects/libraries.h"
#include "oracle/reference/outline.h"

#include <algorithm>

namespace lgs::bench {
namespace {

class PublishedPort final : public Incremental {
 public:
  explicit PublishedPort(Published::Sets sets) : world_({}, sets) {}

  void prepare(const Tiles& tiles) override {
    tiles_ = &tiles;
    polygons_.resize(tiles.size());
    for (std::size_t k = 0; k < tiles.size(); ++k) place(k, tiles.at[k]);
  }

  bool build() override {
    const auto isOne = [](const Kind& kind) { return kind.polygons.size() == 1; };
    if (!std::all_of(tiles_->kinds.begin(), tiles_->kinds.end(), isOne)) return false;
    std::size_t k = 0;
    for (std::int32_t j = 0; j < tiles_->height; ++j) {
      for (std::int32_t i = 0; i < tiles_->width; ++i, ++k) world_.add({i, j}, polygons_[k].vertices, blockOf(k));
    }
    world_.compute();
    return true;
  }

  Edges edges() const override {
    Edges edges;
    for (const oracle::OutlineSegment& s : outlineOf(world_)) edges.push_back({s.start, s.end});
    return edges;
  }

  void find(std::size_t cell) override { at_ = tiles_->cell(cell); }
  void remove(std::size_t cell) override {
    world_.remove(at_, polygons_[cell].vertices, blockOf(cell));
    world_.compute();
  }
  void add(std::size_t cell, std::size_t kind) override {
    if (polygons_[cell].kind != kind) place(cell, kind);
    world_.add(at_, polygons_[cell].vertices, blockOf(cell));
    world_.compute();
  }
  void replace(std::size_t cell, std::size_t kind) override {
    world_.remove(at_, polygons_[cell].vertices, blockOf(cell));
    add(cell, kind);
  }

 private:
  struct Placed {
    std::vector<Vec2> vertices;
    std::size_t kind = 0;
  };

  void place(std::size_t cell, std::size_t kind) {
    const Kind& content = tiles_->kinds[kind];
    if (content.polygons.empty()) return;
    polygons_[cell] = {floatVertices({tiles_->cell(cell), content.block, content.polygons.front()}), kind};
  }
  Block blockOf(std::size_t cell) const { return tiles_->kinds[polygons_[cell].kind].block; }

  const Tiles* tiles_ = nullptr;
  std::vector<Placed> polygons_;  // by cell
  Cell at_;
  Published world_;
};

}  // namespace

Made makePublishedPort() { return std::make_unique<PublishedPort>(Published::Sets::cleared); }
Made makePublishedPortWithNewSets() { return std::make_unique<PublishedPort>(Published::Sets::renewed); }

}  // namespace lgs::bench
