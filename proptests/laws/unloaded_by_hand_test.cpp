// Chunks that are unloaded, by hand: what bytes are taken.
#include "twins.h"
#include "unloaded.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

/// The bytes of a chunk with one of them changed, and with the checksum that fits.
std::vector<std::byte> spoilt(std::vector<std::byte> bytes, std::size_t at, std::byte by) {
  bytes[at] ^= by;
  seal(bytes);
  return bytes;
}

TEST(UnloadedByHand, BytesAreThoseOfTheChunkOrRefused) {
  World world = rowOfChunks(2);
  Shelf shelf;
  const auto refusal = [&](std::span<const std::byte> bytes) { return world.reload(bytes).error().what; };
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  const std::vector<std::byte> first = shelf.newest({0, 0});
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  EXPECT_EQ(refusal(first), SnapshotError::What::loaded);
  removeAll(world, {0, 0});
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  world.commit();
  EXPECT_EQ(refusal(first), SnapshotError::What::otherBytes);
  EXPECT_EQ(refusal({}), SnapshotError::What::cut);
  const std::vector<std::byte> bytes = shelf.newest({0, 0});
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(world.reload(std::span(bytes).first(size)));
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    std::vector<std::byte> damaged = bytes;
    damaged[k] ^= std::byte{0x10};
    EXPECT_FALSE(world.reload(damaged));
  }
  EXPECT_EQ(world.firstUnloaded(kEverywhere), (Cell{0, 0}));
  EXPECT_EQ(refusal(saved(rowOfChunks(1))), SnapshotError::What::notASnapshot);
  EXPECT_TRUE(world.reload(bytes));
  World other([](Block, Block) { return true; });
  EXPECT_EQ(other.reload(bytes).error().what, SnapshotError::What::relation);
  World empty;
  EXPECT_EQ(empty.reload(bytes), (Cell{0, 0})) << "where there is no chunk any bytes will do";
  EXPECT_EQ(empty.stats().polygons, 1023U);
  // Nor may bytes that somebody made up do harm.
  for (std::size_t k = 8; k + 4 < bytes.size(); ++k) {
    for (const int bit : {0, 1, 3, 7}) {
      World victim = rowOfChunks(1);
      EXPECT_EQ(victim.unload(kEverywhere, {}), 1U);
      victim.commit();
      EXPECT_EQ(victim.forgetChunks(kEverywhere), 1U);
      static_cast<void>(victim.reload(spoilt(bytes, k, std::byte{1} << bit)));
      victim.commit();
      EXPECT_EQ(victim.unload(kEverywhere, {}).has_value(), true);
      victim.commit();
    }
  }
}

TEST(UnloadedByHand, AChunkThatComesBackEmptyIsEmptyAtAllMarks) {
  World world = rowOfChunks(2);
  const Mark start = world.mark();
  removeAll(world, {31, 7});
  world.commit();
  EXPECT_EQ(world.unload(chunkAt(0, 0), {}), 1U);
  EXPECT_EQ(world.reloadEmpty(chunkAt(0, 0)), 1U);
  const PolygonHandle made = place(world, {3, 3}, unitSquare());
  EXPECT_GT(made.serial, 1U);
  world.commit();
  EXPECT_TRUE(world.rollBack(start));
  EXPECT_EQ(world.stats().polygons, 1024U);
  EXPECT_EQ(world.segments().size(), 4U * 32) << "the outline is that of then, and the chunk is empty";
}

}  // namespace
}  // namespace lgs::test
