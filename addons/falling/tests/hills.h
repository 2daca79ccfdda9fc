// The land of the games that tests play on a Ground.
#pragma once

#include <lgs/ground.h>

#include <gtest/gtest.h>

#include <vector>

namespace lgs::test {

inline constexpr Block kStone = 1, kBedrock = 2, kWood = 3;
inline constexpr CellRect kEverywhere{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// Ground up to row 20, with caves, on bedrock in row 0. Here and there a slab hangs above it, and a beam, which is
/// held in the next chunk. Nothing else is above row 26 and below row 0.
inline void hills(World& land, const CellRect& chunk) {
  if (chunk.min.j != 0) return;
  const ShapeId square = land.shape(kUnitSquare).value();
  EXPECT_TRUE(land.fill({{chunk.min.i, 0}, {chunk.max.i, 0}}, square, kBedrock));
  for (std::int32_t i = chunk.min.i; i <= chunk.max.i; ++i)
    for (std::int32_t j = 1; j <= 20; ++j)
      if ((i * 7 + j * 5) % 11 > 1) static_cast<void>(land.add({i, j}, square, kStone));
  const std::int32_t which = chunk.min.i & 96;
  const auto fill = [&](Cell from, Cell to) {
    EXPECT_TRUE(land.fill({{chunk.min.i + from.i, from.j}, {chunk.min.i + to.i, to.j}}, square, kStone));
  };
  if (which == 32) fill({8, 23}, {10, 23});
  if (which == 64) fill({4, 26}, {31, 26});
  if (which == 96) fill({0, 26}, {3, 26}), fill({3, 21}, {3, 25});
}

inline GroundOptions options(std::size_t chunksAtOnce = 100, AtEdge atEdge = AtEdge::holds) {
  return {.isAnchor = [](Block block, Cell) { return block == kBedrock; },
          .atEdge = atEdge,
          .staying = [](Block block) { return block == kBedrock; },
          .land = hills,
          .chunksAtOnce = chunksAtOnce,
          .undoSteps = 6};
}

inline std::vector<std::byte> saved(Ground<>& ground) {
  std::vector<std::byte> bytes;
  EXPECT_TRUE(
      ground.save([&](std::span<const std::byte> more) { bytes.insert(bytes.end(), more.begin(), more.end()); }));
  return bytes;
}

}  // namespace lgs::test
