// What a stranger can choose costs no more than what anybody would: the indices of a world have seeds.
#include "storage/hash_index.h"
#include "visits.h"

#include <lgs/world.h>

#include <gtest/gtest.h>

#include <vector>

namespace lgs::cost_test {
namespace {

constexpr std::size_t kChunks = 2'000;
constexpr std::uint64_t kPlaces = 4'096;  // of an index with so many in it

/// Cells in chunks that would all have the same place, if there were no seed.
std::vector<Cell> chosen() {
  std::vector<Cell> cells;
  for (std::int32_t j = 0; cells.size() < kChunks; ++j)
    for (std::int32_t i = 0; i < 4'096; ++i)
      if (detail::mix(0, static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint32_t>(j)) % kPlaces == 0)
        cells.push_back({32 * i, 32 * j});
  cells.resize(kChunks);
  return cells;
}

std::uint64_t costOf(const std::vector<Cell>& cells) {
  World world;
  const ShapeId square = world.shape(kUnitSquare).value();
  return visitsOf([&] {
    for (const Cell cell : cells) EXPECT_TRUE(world.add(cell, square, 1));
  });
}

TEST(HashCost, OfChosenChunksIsThatOfAny) {
  std::vector<Cell> any;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(kChunks); ++k) any.push_back({64 * (k % 50), 64 * (k / 50)});
  const std::uint64_t usual = costOf(any);
  EXPECT_LT(costOf(chosen()), usual + usual / 4);
}

}  // namespace
}  // namespace lgs::cost_test
