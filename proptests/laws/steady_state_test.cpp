// A world that has reached its size allocates nothing.
#include "allocations.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace lgs::test {
namespace {

using oracle::Random;

/// Edits a grown world, as often as it takes to reach its size, and then counts allocations.
class SteadyState {
 public:
  explicit SteadyState(PreserveRelation preserve, std::vector<std::vector<LocalPolygon>> shapes, bool byVertices)
      : world_(std::move(preserve)), shapes_(std::move(shapes)), byVertices_(byVertices) {
    for (const auto& polygons : shapes_) ids_.push_back(shapeOf(world_, polygons));
    isTaken_.resize(std::size_t{kSide} * kSide);
  }

  /// Allocations of `edits` edits, and of the commits after them.
  std::pair<std::uint64_t, std::uint64_t> run(int edits, std::uint64_t seed) {
    Random random(seed);
    std::uint64_t ofEdits = 0, ofCommits = 0;
    for (int k = 0; k < edits; ++k) {
      const std::uint64_t before = allocations().count;
      edit(random);
      const std::uint64_t edited = allocations().count;
      if (random.chance(70)) world_.commit();
      ofEdits += edited - before;
      ofCommits += allocations().count - edited;
    }
    return {ofEdits, ofCommits};
  }

  /// The most there can be: every cell with the shape that has the most segments.
  void grow() {
    const auto cells = cellsOf({{0, 0}, {kSide - 1, kSide - 1}});
    for (std::size_t s = 0; s < shapes_.size(); ++s) {
      for (std::size_t k = 0; k < cells.size(); ++k) {
        EXPECT_TRUE(world_.clear({cells[k], cells[k]}));
        isTaken_[k] = false;
      }
      world_.commit();
      for (std::size_t k = 0; k < cells.size(); k += 1 + k % 2)
        isTaken_[k] = world_.add(cells[k], ids_[s], 1).has_value();
      world_.commit();
    }
  }

 private:
  static constexpr std::int32_t kSide = 40;  // beyond one chunk

  void edit(Random& random) {
    const std::int32_t i = random.below(kSide);
    const std::int32_t j = random.below(kSide);
    const Cell cell{i, j};
    const auto k = static_cast<std::size_t>(j) * kSide + static_cast<std::size_t>(i);
    isTaken_[k] = !isTaken_[k];
    if (!isTaken_[k]) {
      world_.polygons(cell, polygons_);
      for (const PlacedPolygon& p : polygons_) EXPECT_TRUE(world_.remove(p.handle));
      return;
    }
    const std::size_t s = random.below(shapes_.size());
    const Block block = random.below(3U);
    if (byVertices_) {
      for (const LocalPolygon& p : shapes_[s]) EXPECT_TRUE(world_.add(cell, std::span<const LocalPoint>(p), block));
    } else {
      EXPECT_TRUE(world_.add(cell, ids_[s], block));
    }
  }

  World world_;
  std::vector<std::vector<LocalPolygon>> shapes_;
  std::vector<ShapeId> ids_;
  std::vector<bool> isTaken_;
  std::vector<PlacedPolygon> polygons_;
  bool byVertices_;
};

std::vector<std::vector<LocalPolygon>> singleShapes() {
  return {{unitSquare()}, {ramp()}, shapeNamed("comb"), shapeNamed("diamond"), shapeNamed("gentle, low")};
}

TEST(Memory, TheSteadyStateAllocatesNothing) {
  const auto keeps = [](Block a, Block b) { return a != b; };
  for (const bool byVertices : {false, true}) {
    for (const bool preserve : {false, true}) {
      SteadyState state(preserve ? PreserveRelation(keeps) : PreserveRelation(), singleShapes(), byVertices);
      state.grow();
      state.run(20'000, 1);
      const auto [ofEdits, ofCommits] = state.run(10'000, 2);
      EXPECT_EQ(ofEdits, 0U) << "by vertices: " << byVertices << ", preserve: " << preserve;
      EXPECT_EQ(ofCommits, 0U) << "by vertices: " << byVertices << ", preserve: " << preserve;
    }
  }
}

// With several polygons in a cell what commit() promises still holds.
TEST(Memory, CommitsAllocateNothingWithSeveralPolygonsInACell) {
  for (const bool byVertices : {false, true}) {
    SteadyState state({}, {shapeNamed("two ramps"), shapeNamed("four around the middle"), {unitSquare()}}, byVertices);
    state.grow();
    state.run(20'000, 1);
    const auto [ofEdits, ofCommits] = state.run(10'000, 2);
    EXPECT_EQ(ofCommits, 0U) << "by vertices: " << byVertices;
    RecordProperty(byVertices ? "allocations_of_edits_by_vertices" : "allocations_of_edits_by_shape",
                   std::to_string(ofEdits));
  }
}

// Beyond the 255 placements that a compact cell can count.
TEST(Memory, AFewCellsEditedForLongAllocateNothing) {
  World world;
  const ShapeId shape = shapeOf(world, {ramp()});
  const auto run = [&](int edits) {
    const std::uint64_t before = allocations().count;
    for (int k = 0; k < edits; ++k) {
      const Cell cell{k % 3, 0};
      const auto handle = world.add(cell, shape, 1);
      world.commit();
      EXPECT_TRUE(world.remove(*handle));
      world.commit();
    }
    return allocations().count - before;
  };
  run(1000);
  EXPECT_EQ(run(1000), 0U);
}

}  // namespace
}  // namespace lgs::test
