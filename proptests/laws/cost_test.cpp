// What memory a world takes: the statistics against what is really allocated, and what is given back.
#include "allocations.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <bit>

namespace lgs::test {
namespace {

using oracle::Random;

/// A world of this many cells each way; what it allocated, measured.
struct Measured {
  std::int64_t start = allocations().bytes;
  World world;
  double bytes() const { return static_cast<double>(allocations().bytes - start); }
};

void expectHonestStats(const Measured& m) {
  const double said = static_cast<double>(m.world.stats().bytes);
  EXPECT_NEAR(said / m.bytes(), 1.0, 0.03) << said << " bytes said, " << m.bytes() << " allocated";
}

TEST(Memory, ABuriedFullCellCostsAtMostEightBytes) {
  const std::int32_t side = 32 * 31;
  Measured m;
  fill(m.world, {{0, 0}, {side - 1, side - 1}});
  m.world.commit();
  EXPECT_EQ(m.world.stats().segments, 4U * static_cast<unsigned>(side));
  EXPECT_LT(m.bytes() / side / side, 8.0);
  RecordProperty("bytes_per_buried_cell", std::to_string(m.bytes() / side / side));
  expectHonestStats(m);
}

TEST(Memory, OfAnEmptyWorldIsSmall) {
  Measured m;
  EXPECT_LT(m.bytes(), 12'000) << "a server keeps a thousand of them";
  EXPECT_LT(World(m.world).stats().bytes, 12'000U) << "a copy, too";
}

TEST(Memory, GrowsWithWhatIsThere) {
  Measured m;
  const ShapeId square = shapeOf(m.world, {unitSquare()}), diamond = shapeOf(m.world, shapeNamed("diamond"));
  const std::uint64_t empty = m.world.stats().bytes;
  ASSERT_TRUE(m.world.fill({{0, 0}, {99, 99}}, square, 1));
  m.world.commit();
  const std::uint64_t full = m.world.stats().bytes;
  EXPECT_GT(full, empty);
  ASSERT_TRUE(m.world.clear({{0, 0}, {99, 99}}));
  ASSERT_TRUE(m.world.fill({{0, 0}, {99, 99}}, diamond, 1));
  m.world.commit();
  const Stats stats = m.world.stats();
  EXPECT_GT(stats.bytes, full + 40'000 * 28);
  EXPECT_EQ(stats.polygons, 10'000U);
  EXPECT_EQ(stats.cells, 10'000U);
  EXPECT_EQ(stats.segments, 40'000U);
  EXPECT_EQ(stats.shapes, 2U);
  EXPECT_EQ(stats.contents, 2U);
  EXPECT_EQ(stats.chunks, 16U);
  expectHonestStats(m);
}

TEST(Memory, OfCellsWhoseEditsAreUndoneIsGivenBack) {
  World world;
  fill(world, {{0, 0}, {159, 159}});
  world.commit();
  // A buried cell holds two halves for a while. Only then it needs a record of its own.
  const auto visit = [&](Cell cell) {
    const Mark before = world.mark();
    removeAll(world, cell);
    place(world, cell, {{0, 0}, {kUnitsPerCell, 0}, {0, kUnitsPerCell}});
    place(world, cell, {{kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}, {0, kUnitsPerCell}});
    world.commit();
    ASSERT_TRUE(world.rollBack(before));
    ASSERT_TRUE(world.forget(before));
  };
  for (const Cell& cell : cellsOf({{1, 1}, {158, 1}})) visit(cell);
  const std::uint64_t bytes = world.stats().bytes;
  for (const Cell& cell : cellsOf({{1, 2}, {158, 158}})) visit(cell);  // so many that their records would fill pages
  EXPECT_EQ(world.stats().bytes, bytes);
}

TEST(Memory, OfAHundredThousandEmptyChunksIsGivenBack) {
  const auto chunks = static_cast<std::int32_t>(scaled(100'000));
  Measured m;
  const ShapeId square = shapeOf(m.world, {unitSquare()});
  m.world.commit();
  for (std::int32_t k = 0; k < chunks; ++k) ASSERT_TRUE(m.world.add({32 * (k % 400), 32 * (k / 400)}, square, 1));
  m.world.commit();
  for (std::int32_t k = 0; k < chunks; ++k) m.world.clear(Cell{32 * (k % 400), 32 * (k / 400)});
  m.world.commit();
  const double before = m.bytes();
  EXPECT_GT(before, 9'000.0 * chunks);
  ASSERT_EQ(m.world.forgetChunks(CellRect{{0, 0}, {12'800, 12'800}}), static_cast<std::uint64_t>(chunks));
  EXPECT_EQ(m.world.stats().chunks, 0U);
  // What is left: ids of segments, which are used again, and working memory.
  EXPECT_LT(m.bytes(), 600'000 + 300.0 * std::bit_ceil(static_cast<unsigned>(chunks)));  // tables double
  RecordProperty("bytes_before", std::to_string(before));
  RecordProperty("bytes_after", std::to_string(m.bytes()));
  expectHonestStats(m);
}

/// A window over a world without end: 8 columns of chunks that hold some polygons each, one of which goes and one
/// comes.
class Window {
 public:
  Window() : square_(shapeOf(world, {unitSquare()})) {
    for (; next_ < 8; ++next_) edit(next_, true);
    world.commit();
  }
  void move() {
    edit(next_ - 8, false);
    edit(next_, true);
    world.commit();
    ASSERT_EQ(world.forgetChunks(CellRect{{32 * (next_ - 8), 0}, {32 * (next_ - 8) + 31, 127}}), 4U);
    ++next_;
  }
  std::size_t saved() const {
    std::size_t bytes = 0;
    EXPECT_TRUE(world.save([&](std::span<const std::byte> piece) { bytes += piece.size(); }));
    return bytes;
  }

  World world;

 private:
  void edit(std::int32_t column, bool comes) {
    for (std::int32_t j = 0; j < 128; j += 3) {
      const Cell cell{32 * column + j % 32, j};
      comes ? static_cast<void>(world.add(cell, square_, 1).value()) : static_cast<void>(world.clear(cell).value());
    }
  }
  ShapeId square_;
  std::int32_t next_ = 0;
};

TEST(Memory, OfAWindowThatMovesStaysTheSame) {
  Window window;
  const auto columns = scaled(2'000);
  for (int k = 0; k < 20; ++k) window.move();
  const Stats before = window.world.stats();
  const std::size_t saved = window.saved();
  const std::int64_t allocated = allocations().bytes;
  for (std::int64_t k = 0; k < columns; ++k) window.move();
  const Stats after = window.world.stats();
  EXPECT_EQ(after.chunks, before.chunks);
  EXPECT_EQ(after.bytes, before.bytes);
  EXPECT_EQ(allocations().bytes, allocated);
  EXPECT_LE(window.saved(), saved + 200) << "columns further away have longer numbers";
}

TEST(Memory, OfAThousandGoingsAndComingsStaysTheSame) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  constexpr CellRect kPlace{{-40, -40}, {80, 40}};
  const auto goAndCome = [&] {
    ASSERT_TRUE(world.clear(kPlace));
    world.commit();
    ASSERT_TRUE(world.forgetChunks(CellRect{{-128, -128}, {223, 127}}));
    EXPECT_EQ(world.stats().chunks, 0U);
    ASSERT_TRUE(world.fill(kPlace, square, 1));
    world.commit();
  };
  for (int k = 0; k < 5; ++k) goAndCome();  // lists reach their lengths
  const std::int64_t allocated = allocations().bytes;
  for (std::int64_t k = scaled(1'000); k != 0; --k) goAndCome();
  EXPECT_EQ(allocations().bytes, allocated);
}

TEST(Memory, OfCellsThatHeldManyPolygonsInTurnIsGivenBack) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  const auto goAndCome = [&](std::int32_t column) {
    const CellRect chunk{{32 * column, 0}, {32 * column + 31, 31}};
    for (int k = 0; k < 257; ++k) {  // from the 256th on a cell has a list, to know how many there were
      ASSERT_TRUE(world.fill(chunk, square, 1));
      ASSERT_TRUE(world.clear(chunk));
    }
    world.commit();
    ASSERT_EQ(world.forgetChunks(chunk), 1U);
  };
  for (std::int32_t column = 0; column < 5; ++column) goAndCome(column);
  const std::int64_t allocated = allocations().bytes;
  for (std::int32_t column = 5; column < 70; ++column) goAndCome(column);  // lists of these would fill two pages
  EXPECT_EQ(allocations().bytes, allocated);
}

TEST(Memory, StatsAreHonestWithManyShapesAndPolygons) {
  Measured m;
  Random random(5);
  for (int k = 0; k < 3000; ++k) {
    const oracle::NamedShape& shape = random.pick(oracle::degenerateShapes());
    std::vector<LocalPolygon> polygons;
    const int symmetry = random.below(8);
    for (const LocalPolygon& p : shape.polygons) polygons.push_back(oracle::turned(p, symmetry));
    const ShapeId id = shapeOf(m.world, polygons);
    EXPECT_TRUE(m.world.add({k % 60, k / 60}, id, random.below(3U)));
  }
  m.world.commit();
  expectHonestStats(m);
}

TEST(Memory, StatsAreHonestAboutWhatMarksKeep) {
  Measured m;
  const ShapeId diamond = shapeOf(m.world, shapeNamed("diamond"));
  constexpr CellRect kPlace{{0, 0}, {60, 60}};
  const Mark first = m.world.mark();
  for (int k = 0; k < 10; ++k) {
    ASSERT_TRUE(m.world.fill(kPlace, diamond, 1));
    m.world.commit();
    static_cast<void>(m.world.mark());
    ASSERT_TRUE(m.world.clear(kPlace));
    m.world.commit();
  }
  expectHonestStats(m);
  ASSERT_TRUE(m.world.rollBack(first, Undone::keep));
  expectHonestStats(m);
}

// Polygons that never come again must not stay for ever.
TEST(Memory, ForgetsThePolygonsThatNothingUses) {
  Measured m;
  const auto run = [&](std::int32_t from) {
    for (std::int32_t k = from; k < from + 5000; ++k) {
      EXPECT_TRUE(m.world.remove(place(m.world, {k % 7, 0}, {{0, 0}, {k + 2, 0}, {0, 5}})));
      if (k % 64 == 0) m.world.commit();
    }
    return m.bytes();
  };
  const double once = run(0);
  run(5000);
  EXPECT_LT(run(10'000), 1.5 * once);
  EXPECT_LT(m.world.stats().contents, 5000U);
}

TEST(Memory, ForgetsThePolygonsThatWereExchangedInOneCommit) {
  Measured m;
  PolygonHandle last = place(m.world, {0, 0}, {{0, 0}, {1, 0}, {0, 5}});
  for (std::int32_t k = 0; k < 20'000; ++k) {
    const std::vector<LocalPoint> triangle{{0, 0}, {k + 2, 0}, {0, 5}};
    const std::vector<NewPolygon> added{{triangle, 1}};
    EXPECT_TRUE(m.world.exchange({0, 0}, std::vector{last}, added, std::span(&last, 1)));
  }
  EXPECT_LT(m.world.stats().contents, 5'000U);
}

}  // namespace
}  // namespace lgs::test
