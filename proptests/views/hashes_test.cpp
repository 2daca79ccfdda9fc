// The hashes of the ground follow from the polygons alone, at all levels; and where two worlds differ is where they do.
#include "oracle/views/ground_hashes.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"

#include <lgs/hashes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace lgs::test {
namespace {

constexpr CellRect kEverywhere{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

bool touch(const CellRect& a, const CellRect& b) {
  return a.min.i <= b.max.i && b.min.i <= a.max.i && a.min.j <= b.max.j && b.min.j <= a.max.j;
}

/// All that hashes say of a world without pending edits, by all of its polygons.
void expectRight(const World& world, const GroundHashes& hashes) {
  std::array<std::vector<HashedSquare>, GroundHashes::kTopLevel + 1> levels;
  HashedSquare least = GroundHashes::square({}, 0);
  for (int level = GroundHashes::kTopLevel; level >= 0; --level) {
    auto& squares = levels[static_cast<std::size_t>(level)];
    squares = oracle::groundHashes(world, level);
    EXPECT_EQ(hashes.hashes(kEverywhere, level), squares) << "level " << level;
    if (squares.size() == 1) least = squares.front();
  }
  failIf(oracle::faultOf(hashes, world));
  EXPECT_EQ(hashes.whole(), least);
  EXPECT_EQ(hashes.hash(), least.hash);
  EXPECT_EQ(groundHash(world, least.cells), least.hash);
  for (const HashedSquare& asked : levels[1])
    for (const CellRect& cells : {asked.cells, CellRect{asked.cells.min, {asked.cells.max.i, asked.cells.min.j}},
                                  CellRect{asked.cells.max, asked.cells.max}}) {
      std::vector<HashedSquare> there;
      for (const HashedSquare& s : levels[0])
        if (touch(s.cells, cells)) there.push_back(s);
      EXPECT_EQ(hashes.hashes(cells), there);
      EXPECT_EQ(hashes.hashes(asked.cells, 1), std::vector{asked});
      EXPECT_EQ(groundHash(world, asked.cells), asked.hash);
    }
}

/// The chunks that have other hashes, by all polygons of both worlds.
std::vector<CellRect> differencesOf(const World& a, const World& b) {
  const auto ofA = oracle::groundHashes(a, 0), ofB = oracle::groundHashes(b, 0);
  std::vector<CellRect> differ;
  for (const auto& [some, others] : {std::pair(&ofA, &ofB), std::pair(&ofB, &ofA)})
    for (const HashedSquare& square : *some)
      if (std::ranges::find(*others, square) == others->end() &&
          std::ranges::find(differ, square.cells) == differ.end())
        differ.push_back(square.cells);
  std::ranges::sort(differ, {}, [](const CellRect& r) { return r.min; });
  return differ;
}

void expectDifferences(const World& a, const GroundHashes& hashesOfA, const World& b, const GroundHashes& hashesOfB) {
  std::vector<CellRect> found = differences(hashesOfA, hashesOfB);
  EXPECT_EQ(differences(hashesOfB, hashesOfA), found);
  EXPECT_EQ(hashesOfA.hash() == hashesOfB.hash(), samePolygons(a, b));
  std::ranges::sort(found, {}, [](const CellRect& r) { return r.min; });
  EXPECT_EQ(found, differencesOf(a, b));
}

/// On, or beside, borders of squares of all levels.
Cell cellByABorder(Chance& chance) {
  const auto index = [&] {
    const std::int64_t side = std::int64_t{32} << 2 * chance.below(14);
    const std::int64_t border = side * (chance.below(5) - 2) - (side - 32) / 3;
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(border - chance.below(2), -kMaxCell, kMaxCell));
  };
  const std::int32_t i = index();
  return {i, index()};
}

LGS_LAW(Hashes, FollowFromThePolygonsAloneAndSayWhereTheyDiffer, 300, (Chance chance)) {
  std::vector<Cell> cells;
  for (int k = chance.below(20); k > 0; --k) cells.push_back(cellByABorder(chance));
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  World world, other;
  std::vector<LocalPoint> shape{{0, 0}, {kUnitsPerCell, 0}, {chance.below(kUnitsPerCell), kUnitsPerCell}};
  const auto place = [&](World& to, Cell cell, Block block) { return to.add(cell, shape, block).has_value(); };
  for (const Cell cell : cells) EXPECT_TRUE(place(world, cell, 1));
  world.commit();
  // The other one has more at first, in another order, and its polygons begin elsewhere.
  std::rotate(shape.begin(), shape.begin() + chance.below(3), shape.end());
  const Cell more = cellByABorder(chance);
  const bool hasMore = std::ranges::find(cells, more) == cells.end() && place(other, more, 2);
  std::ranges::reverse(cells);
  other.commit();
  EXPECT_TRUE(other.followCells(true));
  GroundHashes grown(other);
  for (const Cell cell : cells) {
    if (chance.chance(50)) {
      EXPECT_TRUE(grown.update(other, other.commit()));
    }
    EXPECT_TRUE(place(other, cell, 1));
  }
  EXPECT_TRUE(grown.update(other, other.commit()));
  const GroundHashes hashes(world);
  expectRight(other, grown);
  expectDifferences(world, hashes, other, grown);
  EXPECT_TRUE(!hasMore || other.clear(more));
  EXPECT_TRUE(grown.update(other, other.commit()));
  EXPECT_EQ(grown.hash(), hashes.hash());
  expectRight(other, grown);
  expectDifferences(world, hashes, other, grown);
}

TEST(HashesByHand, AreTheseForEver) {
  World world;
  EXPECT_EQ(GroundHashes(world).hash(), 0U);
  place(world, {-3, 7}, {{0, 0}, {kUnitsPerCell, 0}, {0, 1}}, 9);
  world.commit();
  EXPECT_EQ(GroundHashes(world).hash(), 2'597'067'710'786'626'438U) << "as docs/sync.md has it";
}

TEST(HashesByHand, OfWhatIsOutOfRangeThereAreNone) {
  World world;
  place(world, {kMaxCell, kMaxCell}, unitSquare());
  world.commit();
  const GroundHashes hashes(world);
  const std::int32_t beyond = kMaxCell + 1;
  EXPECT_EQ(hashes.hashes({{kMaxCell, kMaxCell}, {INT32_MAX, INT32_MAX}}).size(), 1U);
  EXPECT_TRUE(hashes.hashes({{beyond, kMaxCell}, {INT32_MAX, INT32_MAX}}).empty());
  EXPECT_TRUE(hashes.hashes({{INT32_MIN, INT32_MIN}, {-beyond, INT32_MAX}}).empty());
  EXPECT_TRUE(hashes.hashes({{1, 1}, {0, 0}}).empty());
  EXPECT_TRUE(hashes.hashes(kEverywhere, -1).empty());
  EXPECT_TRUE(hashes.hashes(kEverywhere, GroundHashes::kTopLevel + 1).empty());
  EXPECT_EQ(GroundHashes::square({beyond, INT32_MIN}, -1), GroundHashes::square({kMaxCell, -kMaxCell}, 0));
  EXPECT_EQ(GroundHashes::square({}, 99).cells, kEverywhere);
}

TEST(HashesByHand, MemoryIsThatOfWhereTheGroundIs) {
  World world;
  EXPECT_TRUE(world.followCells(true));
  GroundHashes hashes(world);
  CellRect last{{}, {-1, -1}};
  const auto moveTo = [&](std::int32_t i) {
    EXPECT_TRUE(world.clear(last));
    for (std::int32_t j = 0; j < 320; j += 32) place(world, {i, j}, unitSquare());
    last = {{i, 0}, {i, 319}};
    EXPECT_TRUE(hashes.update(world, world.commit()));
  };
  for (std::int32_t k = 0; k < 20; ++k) moveTo(50'000 * k);
  const std::uint64_t bytes = hashes.bytes();
  for (std::int32_t k = 20; k < 200; ++k) moveTo(50'000 * k);
  EXPECT_EQ(hashes.bytes(), bytes);
}

}  // namespace
}  // namespace lgs::test
