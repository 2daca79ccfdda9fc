// Law 12, saved worlds: to load what was saved is never having left. Bytes that were not written are refused.
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"
#include "twins.h"

#include <gtest/gtest.h>

#include <vector>

namespace lgs::test {
namespace {

LGS_LAW(GoingBack, LoadingIsNeverHavingLeft, 1'000, (const Seeds& before, const Seeds& after, bool preserves)) {
  World stayed = grown(preserves, before);
  stayed.commit();
  const std::vector<std::byte> bytes = saved(stayed);
  auto loaded = World::load(bytes, relation(preserves));
  ASSERT_TRUE(loaded) << message(loaded.error());
  EXPECT_TRUE(saved(*loaded) == bytes) << "saved again, a loaded world gives other bytes";
  EXPECT_EQ(snapshotOf(*loaded, {}), snapshotOf(stayed, {}));
  expectNoDifference(stayed, *loaded, after);
}

/// Gives bytes the checksum that they should have.
void seal(std::vector<std::byte>& bytes) {
  std::uint32_t sum = 0xffff'ffff;
  for (std::size_t k = 0; k + 4 < bytes.size(); ++k) {
    sum ^= std::to_integer<std::uint32_t>(bytes[k]);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (0xedb8'8320u & (0u - (sum & 1u)));
  }
  for (std::size_t k = 0; k < 4; ++k) bytes[bytes.size() - 4 + k] = static_cast<std::byte>(~sum >> 8 * k & 0xffu);
}

LGS_LAW(GoingBack, BytesThatWereNotWrittenAreRefused, 500, (const Seeds& before, Chance chance)) {
  World world = grown(false, before);
  world.commit();
  std::vector<std::byte> wrong = saved(world);
  if (chance.chance(50)) {
    wrong.resize(chance.below(wrong.size()));
  } else {
    wrong[chance.below(wrong.size())] ^= std::byte{1} << chance.below(8);
  }
  const auto loaded = World::load(wrong);
  ASSERT_FALSE(loaded);
  EXPECT_LE(loaded.error().offset, wrong.size());
  EXPECT_FALSE(message(loaded.error()).empty());
}

/// Bytes of ill will have the right checksum. So they are read; what they say must be good, or be refused.
LGS_LAW(GoingBack, BytesOfIllWillAreRefusedOrAreAWorld, 2'000,
        (const Seeds& before, const Seeds& after, Chance chance)) {
  World world = grown(false, before);
  world.commit();
  std::vector<std::byte> bytes = saved(world);
  constexpr std::size_t kHead = 8, kTail = 4;
  for (int k = 1 + chance.below(3); k > 0; --k) {
    const std::size_t at = kHead + chance.below(bytes.size() - kHead - kTail);
    bytes[at] = std::byte{
        chance.pick<unsigned char>({0, 1, 2, 3, 0x7f, 0x80, 0xff, static_cast<unsigned char>(chance.below(256))})};
  }
  seal(bytes);
  auto loaded = World::load(bytes);
  if (!loaded) {
    EXPECT_LE(loaded.error().offset, bytes.size());
    return;
  }
  EXPECT_EQ(oracle::outlineOf(*loaded), outlineByLaws(*loaded, false));
  auto twin = World::load(saved(*loaded));
  ASSERT_TRUE(twin) << message(twin.error());
  expectNoDifference(*loaded, *twin, after);
}

// The bytes of a world with one square end with its serial, its block, no free id, no id just removed, the ids of its
// four segments and the checksum (docs/snapshot.md).
TEST(GoingBackByHand, MadeUpBytesAreRefusedForTheirReason) {
  using What = SnapshotError::What;
  World world;
  place(world, {}, unitSquare());
  world.commit();
  const std::vector<std::byte> good = saved(world);
  const std::size_t end = good.size() - 4, serial = end - 12;
  ASSERT_EQ(good[serial], std::byte{1});
  const auto expect = [&](std::size_t at, unsigned char value, What what, std::uint64_t offset) {
    std::vector<std::byte> bytes = good;
    bytes[at] = std::byte{value};
    seal(bytes);
    const auto loaded = World::load(bytes);
    ASSERT_FALSE(loaded) << "byte " << at;
    EXPECT_EQ(loaded.error(), (SnapshotError{what, offset})) << message(loaded.error());
  };
  expect(3, 'S', What::notASnapshot, 3);
  expect(7, 2, What::unknownVersion, 7);
  expect(8, 1, What::relation, 9);
  expect(serial, 0, What::badNumber, end - 8);
  expect(end - 1, 1, What::badSegments, end);  // the third id again
  expect(end - 1, 2, What::badSegments, end);  // the fifth id
  expect(end - 5, 1, What::cut, end - 3);      // three ids are left for four segments
  std::vector<std::byte> longer = good;
  longer.insert(longer.end() - 4, std::byte{});
  seal(longer);
  const auto loaded = World::load(longer);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().what, What::tooLong);
}

TEST(GoingBackByHand, AnotherRelationIsRefused) {
  World world(relation(true));
  place(world, {0, 0}, eighths({{0, 0}, {8, 0}, {8, 4}, {0, 4}}), 1);
  place(world, {0, 0}, eighths({{0, 4}, {8, 4}, {8, 8}, {0, 8}}), 2);
  world.commit();
  EXPECT_TRUE(World::load(saved(world), relation(true)));
  const auto other = World::load(saved(world), [](Block, Block) { return false; });
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().what, SnapshotError::What::relation);
}

TEST(GoingBackByHand, AWorldWithPendingEditsIsNotSaved) {
  World world;
  place(world, {}, unitSquare());
  const auto refused = world.save([](std::span<const std::byte>) { FAIL() << "nothing is written"; });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::uncommitted);
  EXPECT_EQ(message(refused.error()), "the world has edits that are not committed; call commit() before save()");
}

TEST(GoingBackByHand, FilesAreSmall) {
  World blocks, ramps;
  ASSERT_TRUE(blocks.fill({{0, 0}, {99, 99}}, shapeOf(blocks, {unitSquare()}), 1));
  oracle::Random random(1);
  for (const Cell cell : cellsOf({{0, 0}, {99, 99}})) place(ramps, cell, oracle::turned(ramp(), random.below(8)), 1);
  blocks.commit();
  ramps.commit();
  EXPECT_LT(saved(blocks).size(), 10'000U);
  EXPECT_LT(saved(ramps).size(), 40'000U);
}

}  // namespace
}  // namespace lgs::test
