// What a stroke costs: memory, and work in cells with very much in them.
#include "cell_edit.h"
#include "cells.h"
#include "proptests/brush/strokes.h"
#include "proptests/laws/allocations.h"

#include <gtest/gtest.h>

namespace lgs::test::cost {
namespace {

constexpr std::int64_t kCell = kUnitsPerCell;

/// Allocations of the work on the cut cells of a stroke, without what it then does to the world.
std::uint64_t allocationsOf(const World& world, const Region& region, brush::Deed deed) {
  const brush::Coverage coverage = brush::coverage(region);
  std::uint64_t count = 0;
  for (const brush::CutCell& cell : coverage.cut) {
    const std::vector<PlacedPolygon> placed = world.polygons(cell.cell);
    const std::uint64_t before = allocations().count;
    const brush::Frame frame;
    (void)editOf(placed, cell.pieces, {deed, 2, region.rule});
    count += allocations().count - before;
  }
  return count;
}

TEST(BrushCost, ACutCellAllocatesNothing) {
  const brush::Frame frame;
  for (const Ground ground : {Ground::solid, Ground::slanted, Ground::halved}) {
    const World world = worldOf(ground);
    for (const brush::Deed deed : {brush::Deed::carve, brush::Deed::fill, brush::Deed::replace}) {
      const Region region = circle({3 * kCell / 2, 3 * kCell / 2 + 77}, kCell + 12'345, 32);
      (void)allocationsOf(world, region, deed);
      EXPECT_EQ(allocationsOf(world, region, deed), 0U);
    }
  }
}

// What a thread keeps is one block of 64 KiB. A longer list gets memory of its own, which goes with the frame.
TEST(BrushCost, AThreadKeepsOneBlock) {
  constexpr std::size_t kBlock = std::size_t{1} << 16;
  { const brush::Frame first; }  // makes the block that the thread keeps
  for (const std::size_t size : {kBlock + 1, kBlock + 1, 9 * kBlock}) {
    const Allocations before = allocations();
    std::uint64_t count = 0;
    {
      const brush::Frame frame;
      const brush::List<char> list(size);
      count = allocations().count - before.count;
    }
    EXPECT_GT(count, 0U);
    EXPECT_LT(allocations().bytes - before.bytes, 1'000) << "the list of blocks may have grown";
  }
}

/// A ring of spikes around the middle of a cell.
Ring spikes(std::size_t count) {
  Ring ring;
  for (std::size_t k = 0; k < count; ++k) {
    const auto x = static_cast<std::int64_t>(1'000 + 12 * (k / 2));
    ring.push_back({x + static_cast<std::int64_t>(k % 2) * 6, k % 2 == 0 ? 1'000 : 60'000});
  }
  ring.push_back({1'000, 65'000});
  return ring;
}

TEST(BrushCost, ARegionWithTooManyEdgesInACellIsRefused) {
  for (const std::size_t count : {kMaxRegionEdgesPerCell - 100, kMaxRegionEdgesPerCell + 2}) {
    World world;
    ASSERT_TRUE(world.add({0, 0}, {{0, 0}, {900, 0}, {900, 300}, {0, 300}}, 1).has_value());
    const Region region{{spikes(count)}};
    const auto carved = carve(world, region);
    const auto cells = cellsOf(region);
    EXPECT_EQ(carved.has_value(), count < kMaxRegionEdgesPerCell);
    EXPECT_EQ(cells.has_value(), carved.has_value());
    if (!carved && !cells) {
      for (const Error& error : {carved.error(), cells.error()}) {
        EXPECT_EQ(error.code, ErrorCode::capacity);
        EXPECT_EQ(error.cell, (Cell{0, 0}));
      }
    }
    EXPECT_EQ(world.stats().polygons, 1U);
  }
}

// Each half is not too much. No polygon is to blame for their union: nobody gave it.
TEST(BrushCost, AnAreaWithTooManyCornersIsRefused) {
  World world;
  Ring half = spikes(kMaxVerticesPerCell / 2 + 100);
  ASSERT_TRUE(paint(world, {{half}}, 1, PaintMode::fill).has_value());
  for (Point& p : half) p.x += static_cast<std::int64_t>(12 * (half.size() / 2 - 1));  // from its last spike on
  const auto painted = paint(world, {{half}}, 1, PaintMode::fill);
  ASSERT_FALSE(painted.has_value());
  EXPECT_EQ(painted.error().code, ErrorCode::capacity);
  EXPECT_EQ(painted.error().polygon, -1);
}

// 200 edges from left to right cross 200 from below.
TEST(BrushCost, ARegionThatCrossesItselfTooOftenIsRefused) {
  for (const std::int64_t lines : {80, 200}) {
    Region lattice;
    for (std::int64_t k = 0; k < lines; ++k) {
      const std::int64_t at = 1'000 + 300 * k;
      lattice.rings.push_back({{500, at}, {65'000, at + 3}, {65'000, at + 100}});
      lattice.rings.push_back({{at, 500}, {at + 100, 65'000}, {at + 3, 65'000}});
    }
    World world;
    const auto carved = carve(world, lattice);
    EXPECT_TRUE(carved.has_value()) << "an empty cell stays so";
    ASSERT_TRUE(world.add({0, 0}, {{0, 0}, {900, 0}, {900, 300}, {0, 300}}, 1).has_value());
    const auto again = carve(world, lattice);
    EXPECT_EQ(again.has_value(), lines == 80);
    if (!again) {
      EXPECT_EQ(again.error().code, ErrorCode::capacity);
    }
    EXPECT_EQ(world.stats().polygons, 1U);
  }
}

}  // namespace
}  // namespace lgs::test::cost
