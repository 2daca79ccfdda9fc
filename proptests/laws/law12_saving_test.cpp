// Law 12, saved worlds: to load what was saved is never having left. Bytes that were not written are refused.
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/traces.h"
#include "twins.h"

#include <gtest/gtest.h>

#include <set>

namespace lgs::test {
namespace {

// Of a snapshot, in bytes: letters and version; checksum.
constexpr std::size_t kHead = 8, kTail = 4;

LGS_LAW(RollBack, BytesThatWereNotWrittenAreRefused, 500,
        (const Calls& before, const Setting& setting, Chance chance)) {
  World world = grown({setting.corner, {}}, before).world;
  world.commit();
  std::vector<std::byte> wrong = saved(world);
  if (chance.chance(50)) {
    wrong.resize(chance.below(wrong.size()));
  } else {
    wrong[chance.below(wrong.size())] ^= std::byte{1} << chance.below(8);
  }
  const auto loaded = refusal(World::load(wrong));
  EXPECT_LE(loaded.offset, wrong.size());
  EXPECT_FALSE(message(loaded).empty());
}

/// Bytes of ill will have the right checksum. So they are read; what they say must be good, or be refused.
LGS_LAW(RollBack, BytesOfIllWillAreRefusedOrAreAWorld, 2'000,
        (const Calls& before, const Calls& after, const Setting& setting, Chance chance)) {
  World world = grown({setting.corner, {}}, before).world;
  world.commit();
  std::vector<std::byte> bytes = saved(world);
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
  EXPECT_EQ(oracle::outlineOf(*loaded), outlineByLaws(*loaded, {}));
  auto twin = must(World::load(saved(*loaded)));
  Caller one(std::move(*loaded), setting.corner), other(std::move(twin), setting.corner);
  expectNoDifference(one, other, after);
}

// The bytes of a world with one square end with its serial, its block, no free id, no id just removed, the ids of its
// four segments and the checksum (docs/internals/snapshot.md).
TEST(RollBackByHand, MadeUpBytesAreRefusedForTheirReason) {
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
    EXPECT_EQ(loaded.error().what, what) << message(loaded.error());
    EXPECT_EQ(loaded.error().offset, offset) << message(loaded.error());
    if (what == What::unknownVersion) {
      EXPECT_EQ(message(loaded.error()), "byte 7: the snapshot has version " + std::to_string(value) +
                                             " of its format, and this library reads versions from 1 to 2");
    }
  };
  expect(3, 'S', What::notASnapshot, 3);
  expect(7, 0, What::unknownVersion, 7);
  expect(7, 3, What::unknownVersion, 7);
  expect(8, 1, What::relation, 9);
  expect(serial, 0, What::badNumber, end - 8);
  expect(end - 1, 1, What::badSegments, end);  // the third id again
  expect(end - 1, 2, What::badSegments, end);  // the fifth id
  expect(end - 5, 1, What::cut, end - 3);      // three ids are left for four segments
  std::vector<std::byte> longer = good;
  longer.insert(longer.end() - 4, std::byte{});
  seal(longer);
  const auto loaded = refusal(World::load(longer));
  EXPECT_EQ(loaded.what, What::tooLong);
}

// --- Numbers beyond their range --------------------------------------------------------------------------------------

using Numbers = std::vector<std::uint64_t>;

/// The numbers of a snapshot, from its version on.
Numbers numbersOf(const std::vector<std::byte>& bytes) {
  Numbers numbers;
  unsigned shift = 0;
  for (std::size_t k = kHead - 1; k < bytes.size() - kTail; ++k) {
    const auto byte = std::to_integer<std::uint64_t>(bytes[k]);
    if (shift == 0) numbers.push_back(0);
    numbers.back() |= (byte & 0x7fu) << shift;
    shift = byte < 0x80 ? 0 : shift + 7;
  }
  return numbers;
}

std::vector<std::byte> bytesOf(const Numbers& numbers) {
  std::vector<std::byte> bytes;
  for (const char c : std::string("lgssnap")) bytes.push_back(static_cast<std::byte>(c));
  for (std::uint64_t number : numbers) {
    for (; number >= 0x80; number >>= 7) bytes.push_back(static_cast<std::byte>(number | 0x80u));
    bytes.push_back(static_cast<std::byte>(number));
  }
  bytes.resize(bytes.size() + kTail);
  seal(bytes);
  return bytes;
}

/// A square, two triangles that are one shape, and two squares that are gone.
World smallWorld() {
  constexpr auto kUnit = kUnitsPerCell;
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  const ShapeId halves = shapeOf(world, {{{0, 0}, {kUnit, 0}, {0, kUnit}}, {{kUnit, 0}, {kUnit, kUnit}, {0, kUnit}}});
  for (const Cell cell : {Cell{0, 0}, Cell{2, 0}}) EXPECT_TRUE(world.add(cell, square, 5));
  EXPECT_TRUE(world.add({32, 0}, halves, 7));
  EXPECT_TRUE(world.add({0, 40}, square, 5));
  world.commit();
  removeAll(world, {2, 0});
  world.commit();
  removeAll(world, {0, 40});
  world.commit();
  return world;
}

// Each group of numbers as docs/internals/snapshot.md has it; the indices below count from the first one.
const Numbers kSmallWorld{
    1, 0,  // 0: version, relation
    3, 3,     0,    0,     65536, 0,    0,     65536, 4,    0, 0,  65536, 0, 65536, 65536,
    0, 65536,                                                                           // 2: polygons 0 and 1
    3, 65536, 0,    65536, 65536, 0,    65536,                                          // 19: polygon 2
    2, 1,     1,    0,     2,     0,    2,     0,                                       // 26: contents
    2, 1,     1,    2,     0,     2,                                                    // 34: shapes
    3, 0,     0,    2,     2,     2047, 0,     6,     1,    0, 1,  2043,  0, 2,     5,  // 40: chunks, the first
    2, 0,     2,    5,     2047,  0,    2047,  0,     2,    1, 7,  2,     7,            // 55: the second
    1, 2,     2049, 0,     513,   0,    2,     1,     1535, 0,                          // 68: the third
    8, 8,     0,    0,     0,     8,    0,     0,     0,    0, 31, 0,     0, 0,     8,
    0, 0,     0};  // 78: ids: free, none apart, used

TEST(RollBackByHand, SnapshotsAreAsDocumented) {
  EXPECT_EQ(numbersOf(saved(smallWorld())), kSmallWorld);
  EXPECT_TRUE(bytesOf(kSmallWorld) == saved(smallWorld()));
}

// They kept the ids apart that the last commit had removed.
TEST(RollBackByHand, SnapshotsOfOlderLibrariesAreRead) {
  Numbers older = kSmallWorld;
  const Numbers ids{4, 8, 0, 0, 0, 4, 8, 0, 0, 0};
  std::ranges::copy(ids, older.begin() + 78);
  const auto loaded = World::load(bytesOf(older));
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(saved(*loaded) == saved(smallWorld()));
}

/// What becomes of the snapshot with other numbers in place of some.
std::optional<SnapshotError::What> reasonWith(std::size_t at, std::size_t count, const Numbers& instead) {
  Numbers numbers = kSmallWorld;
  const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(at);
  numbers.insert(numbers.erase(begin, begin + static_cast<std::ptrdiff_t>(count)), instead.begin(), instead.end());
  const auto loaded = World::load(bytesOf(numbers));
  return loaded ? std::nullopt : std::optional(loaded.error().what);
}

TEST(RollBackByHand, EveryNumberBeyondItsRangeIsRefused) {
  using What = SnapshotError::What;
  constexpr std::uint64_t kFarChunk = 2 * (kMaxCell / 32), kMuch = 1'000'000'000;
  const auto one = [](std::size_t at, std::uint64_t number) { return reasonWith(at, 1, {number}); };
  EXPECT_EQ(one(2, kMuch), What::badNumber) << "more polygons than bytes";
  EXPECT_EQ(one(4, 65'537), What::badNumber) << "a coordinate";
  EXPECT_EQ(reasonWith(19, 7, {3, 0, 0, 65'536, 0, 0, 65'536}), What::badPolygon) << "polygon 0 again";
  EXPECT_EQ(reasonWith(10, 9, {3, 0, 0, 65'536, 0, 0, 65'536}), What::badPolygon) << "again, in a content of its own";

  EXPECT_EQ(one(26, kMuch), What::badNumber) << "more contents than bytes";
  EXPECT_EQ(one(28, 3), What::badNumber) << "a polygon that is not there";
  EXPECT_EQ(one(32, 0), What::badNumber) << "a polygon twice in a content";
  EXPECT_EQ(reasonWith(31, 2, {2, 0}), What::badNumber) << "polygons that do not increase";
  EXPECT_EQ(one(32, 1), What::badPolygon) << "polygons that overlap";
  EXPECT_EQ(reasonWith(30, 3, {0}), What::badNumber) << "an empty content";
  EXPECT_EQ(reasonWith(33, 1, {1, 0, 1}), What::badNumber) << "a preserved overlap without a relation";

  EXPECT_EQ(one(36, 3), What::badNumber) << "a polygon that is not there, in a shape";
  EXPECT_EQ(reasonWith(37, 3, {1, 1}), What::badPolygon) << "a shape again";
  EXPECT_EQ(one(39, 1), What::badPolygon) << "a shape whose polygons overlap";

  EXPECT_EQ(one(55, 0), What::badNumber) << "a chunk again";
  EXPECT_EQ(one(55, kFarChunk), std::nullopt) << "the farthest chunk";
  EXPECT_EQ(reasonWith(55, 6, {kFarChunk, 0, 4, 0, 5, 2'045, 0}), What::badNumber) << "a cell beyond the farthest";
  EXPECT_EQ(one(55, kFarChunk + 2), What::badNumber) << "a chunk beyond the farthest";
  EXPECT_EQ(one(44, 6), What::badNumber) << "a content that is not there";
  EXPECT_EQ(one(44, 4), What::badNumber) << "two polygons in a cell that does not list them";
  EXPECT_EQ(one(45, 2'049), What::badNumber) << "more contents than cells";
  EXPECT_EQ(one(48, 0), What::badNumber) << "a polygon without a serial";
  EXPECT_EQ(one(48, 255), std::nullopt) << "the last serial";
  EXPECT_EQ(one(48, 256), What::badNumber) << "a serial that needs a list";
  EXPECT_EQ(one(63, 1), What::badNumber) << "a serial that was not given out yet";
  EXPECT_EQ(one(64, 0), What::badNumber) << "no serial";
  EXPECT_EQ(one(66, 1), What::badNumber) << "a serial twice";
  EXPECT_EQ(one(63, std::uint64_t{1} << 32), What::badNumber) << "a serial of too many bits";

  EXPECT_EQ(one(78, kMuch), What::badNumber) << "more free ids than bytes";
  EXPECT_EQ(one(79, 1), What::badSegments) << "id 0, free";
  EXPECT_EQ(one(79, 3), What::badSegments) << "id -1, free";
  EXPECT_EQ(one(79, kMuch), What::badSegments) << "a free id beyond all";
  EXPECT_EQ(reasonWith(79, 5, {14, (std::uint64_t{1} << 33) - 8, 0, 0, 10}), What::badNumber)
      << "ids of too many bits, all right in their lower 32";
  EXPECT_EQ(one(83, 7), What::badSegments) << "free ids twice";
  EXPECT_EQ(one(84, 1), What::badSegments) << "a free id twice in a row";
  EXPECT_EQ(one(88, 33), What::badSegments) << "id 0 of a segment";
  EXPECT_EQ(one(95, 2), What::badSegments) << "an id beyond those that there are";
}

TEST(RollBackByHand, EveryReasonOfARefusalHasItsSentence) {
  constexpr auto kLastReason = SnapshotError::What::otherBytes;
  std::set<std::string> sentences;
  for (std::uint64_t what = 0; what <= static_cast<std::uint64_t>(kLastReason); ++what)
    sentences.insert(message(SnapshotError{.what = static_cast<SnapshotError::What>(what), .offset = 17}));
  EXPECT_EQ(sentences.size(), static_cast<std::size_t>(kLastReason) + 1);
  for (const std::string& sentence : sentences) EXPECT_TRUE(sentence.starts_with("byte 17: ")) << sentence;
  const auto beyond = static_cast<SnapshotError::What>(static_cast<std::uint64_t>(kLastReason) + 1);
  EXPECT_EQ(message(SnapshotError{.what = beyond}), "byte 0: unknown error") << "so that was not the last";
}

TEST(RollBackByHand, AnotherRelationIsRefused) {
  const PreserveRelation relation = [](Block a, Block b) { return a != b; };
  World world(relation);
  place(world, {0, 0}, eighths({{0, 0}, {8, 0}, {8, 4}, {0, 4}}), 1);
  place(world, {0, 0}, eighths({{0, 4}, {8, 4}, {8, 8}, {0, 8}}), 2);
  world.commit();
  EXPECT_TRUE(World::load(saved(world), relation));
  const auto other = refusal(World::load(saved(world), [](Block, Block) { return false; }));
  EXPECT_EQ(other.what, SnapshotError::What::relation);
}

TEST(RollBackByHand, AWorldWithPendingEditsIsNotSaved) {
  World world;
  place(world, {}, unitSquare());
  const auto refused = refusal(world.save([](std::span<const std::byte>) { FAIL() << "nothing is written"; }));
  EXPECT_EQ(refused.code, ErrorCode::uncommitted);
  EXPECT_EQ(message(refused),
            "the world has edits that are not committed; commit them first (to follow or to forget cells, let go of "
            "marks, too)");
}

TEST(RollBackByHand, ASnapshotComesInSmallPieces) {
  World world;
  for (const Cell cell : cellsOf({{0, 0}, {39, 39}})) place(world, cell, ramp(), static_cast<Block>(cell.i * cell.j));
  world.commit();
  std::size_t largest = 0, pieces = 0;
  ASSERT_TRUE(world.save([&](std::span<const std::byte> piece) {
    largest = std::max(largest, piece.size());
    ++pieces;
  }));
  EXPECT_LE(largest, 4'096U);
  EXPECT_GT(pieces, 1U);
}

TEST(RollBackByHand, FilesAreSmall) {
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
