// The documented limits that no test can reach by edits alone, reached by going in behind the edits; what the index and
// the catalogue must do when it gets tight.
#include "ground/places.h"
#include "oracle/trace/dump.h"
#include "proptests/support/scale.h"
#include "proptests/support/worlds.h"
#include "world/impl.h"

#include <gtest/gtest.h>

#include <iterator>
#include <set>

namespace lgs::test {
namespace {

using detail::kMaxSerial;
using oracle::Random;

/// A world with cells that have given out nearly all their serials, as after minutes of edits.
struct WornWorld {
  World::Impl impl{PreserveRelation()};
  ShapeId square = shapeOf({unitSquare()});
  ShapeId halves = shapeOf(shapeNamed("two halves"));

  ShapeId shapeOf(const std::vector<LocalPolygon>& polygons) {
    const std::vector<detail::PolygonView> views(polygons.begin(), polygons.end());
    return impl.edit.shape(views).value();
  }

  /// Leaves the cell empty, with so many serials to go.
  void wear(Cell cell, std::uint32_t left) {
    const PolygonHandle handle = add(cell, square).value();
    const detail::CellAt at = impl.ground.grid.find(cell);
    const detail::Placed last{kMaxSerial - left, 1};
    impl.ground.set(at, impl.ground.contentId(at), last.serial, {&last, 1});
    EXPECT_TRUE(impl.edit.remove({handle.cellRef, last.serial}));
    commit();
  }

  Expected<PolygonHandle> add(Cell cell, ShapeId shape) { return impl.edit.add(cell, shape, 1, {}); }

  const Changes& commit() {
    impl.outline.update(impl.ground, nullptr, {});
    impl.ground.endCommit();
    return impl.outline.changes();
  }

  std::size_t polygonsAt(Cell cell) const {
    std::vector<PlacedPolygon> polygons;
    detail::polygonsOf(impl.ground, cell, polygons);
    return polygons.size();
  }
};

template <class Result>
void expectCapacity(const Result& result, Cell cell) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::capacity);
  EXPECT_EQ(result.error().cell, cell);
}

TEST(Limits, ACellWhoseSerialsAreUsedUpRefuses) {
  constexpr Cell kCell{3, 4};
  WornWorld world;
  world.wear(kCell, 2);
  std::vector<PolygonHandle> old;
  for (const std::uint32_t serial : {kMaxSerial - 1, kMaxSerial}) {
    old.push_back(world.add(kCell, world.square).value());
    EXPECT_EQ(old.back().serial, serial);
    EXPECT_EQ(world.commit().added.size(), 4U);
    EXPECT_TRUE(world.impl.edit.remove(old.back()));
    EXPECT_EQ(world.commit().removed.size(), 4U);
  }
  expectCapacity(world.add(kCell, world.square), kCell);
  const LocalPolygon unknown{{1, 2}, {30, 4}, {5, 60}};
  expectCapacity(world.impl.edit.add(kCell, detail::PolygonView(unknown), 1), kCell);
  for (const PolygonHandle handle : old) EXPECT_FALSE(world.impl.edit.remove(handle)) << "stale for good";
  EXPECT_EQ(world.polygonsAt(kCell), 0U);
  EXPECT_TRUE(world.add({4, 4}, world.square)) << "its neighbour has serials of its own";
}

TEST(Limits, AShapeNeedsASerialForEachOfItsPolygons) {
  constexpr Cell kCell{-1, 0};
  WornWorld world;
  world.wear(kCell, 1);
  expectCapacity(world.add(kCell, world.halves), kCell);
  EXPECT_EQ(world.add(kCell, world.square).value().serial, kMaxSerial);
}

TEST(Limits, AFillThatMeetsAWornCellChangesNothing) {
  constexpr CellRect kRect{{-3, -3}, {40, 3}};
  WornWorld world;
  world.wear({34, 2}, 0);
  world.wear({-2, 3}, 0);
  world.wear({1, 1}, 254);  // enough
  expectCapacity(world.impl.edit.fill(kRect, world.square, 1, {}), {34, 2});
  for (const Cell& cell : cellsOf(kRect)) EXPECT_EQ(world.polygonsAt(cell), 0U);
  world.wear({5, 2}, 1);
  expectCapacity(world.impl.edit.fill({{5, 2}, {33, 2}}, world.halves, 1, {}), {5, 2});
  EXPECT_EQ(world.impl.edit.fill({{-3, -3}, {33, 2}}, world.square, 1, {}).value(), 37U * 6U);
  EXPECT_TRUE(world.commit().removed.empty());
}

/// So many contents are there already that only this many more can be made.
void leaveContents(WornWorld& world, std::size_t left) {
  detail::Catalogue& catalogue = world.impl.ground.catalogue;
  catalogue.passOver(detail::kMaxContent + 1 - left - catalogue.contentLimit());
}

TEST(Limits, TheLastContentCanBeMadeAndNoMore) {
  WornWorld world;
  const LocalPolygon last{{1, 2}, {30, 4}, {5, 60}}, tooMany{{1, 2}, {30, 4}, {5, 61}};
  leaveContents(world, 1);
  const PolygonHandle handle = world.impl.edit.add({0, 0}, detail::PolygonView(last), 7).value();
  EXPECT_EQ(world.impl.ground.contentId(world.impl.ground.grid.find(Cell{0, 0})), detail::kMaxContent);
  expectCapacity(world.impl.edit.add({1, 0}, detail::PolygonView(tooMany), 7), {1, 0});
  EXPECT_TRUE(world.impl.edit.add({1, 0}, detail::PolygonView(last), 8)) << "it is there already";
  EXPECT_EQ(world.commit().added.size(), 6U);
  EXPECT_TRUE(world.impl.edit.remove(handle));
  EXPECT_EQ(world.commit().removed.size(), 3U);
  EXPECT_EQ(world.polygonsAt({1, 0}), 1U);
}

TEST(Limits, WhatIsLeftOfACellNeedsAContentToo) {
  WornWorld world;
  const PolygonHandle first = world.add({0, 0}, world.halves).value();
  const LocalPolygon third{{U / 2, U / 2}, {U, U / 2}, {U, U}};
  world.commit();
  leaveContents(world, 0);
  expectCapacity(world.impl.edit.remove(first), {0, 0});
  expectCapacity(world.impl.edit.add({2, 0}, detail::PolygonView(third), 1), {2, 0});
  EXPECT_EQ(world.polygonsAt({0, 0}), 2U);
  EXPECT_TRUE(world.commit().removed.empty());
}

TEST(Limits, TheLastChunkCanBeMadeAndNoMore) {
  WornWorld world;
  detail::Grid& grid = world.impl.ground.grid;
  grid.passOver(kMaxChunks - 1 - grid.count());
  const PolygonHandle handle = world.add({-5, 7}, world.square).value();
  EXPECT_EQ(handle.cellRef / detail::kChunkCells, kMaxChunks);
  EXPECT_EQ(grid.cellOf(handle.cellRef), (Cell{-5, 7}));
  expectCapacity(world.add({32, 7}, world.square), {32, 7});
  EXPECT_TRUE(world.add({-6, 7}, world.square)) << "its chunk is there already";
  EXPECT_EQ(world.commit().added.size(), 6U);
}

TEST(LimitsDeathTest, TheLastIdOfASegmentIsNoLinkOfNone) {
  detail::SegmentPool pool;
  pool.passOver(detail::kMaxSegment / detail::kSegmentPage - 1);
  std::uint32_t id = 0;
  for (std::uint32_t k = 0; k < detail::kSegmentPage; ++k) id = pool.take();
  EXPECT_EQ(id, detail::kMaxSegment);
  EXPECT_LT(id, detail::kUnlinked);
  EXPECT_DEATH(static_cast<void>(pool.take()), "");
}

TEST(LimitsDeathTest, TheLastPageOfRecordsCanBeUsedAndNoMore) {
  detail::RecordArena arena;
  arena.passOver(detail::RecordArena::kMaxPages - 1);
  const auto ref = arena.allocate(3);
  EXPECT_LT(ref, std::uint32_t{1} << 31);
  arena.at(ref)[2] = 77;
  EXPECT_DEATH(static_cast<void>(arena.allocate(detail::RecordArena::kPageWords)), "");
}

// Chosen hashes, so few that most meet others: the real ones are so well spread that two never do.
TEST(HashIndex, KeepsApartWhatHasTheSameHash) {
  for (std::int64_t round = 0; round < scaled(200); ++round) {
    Random random(static_cast<std::uint64_t>(round));
    detail::HashIndex index;
    std::map<std::uint64_t, std::uint64_t> hashOf;  // of the numbers that are there
    const auto is = [](std::uint64_t number) { return [number](std::uint64_t n) { return n == number; }; };
    const std::uint64_t hashes = 1 + random.below(9U);
    for (std::uint64_t number = 1; number <= 60; ++number) {
      const std::uint64_t hash = std::uint64_t{random.below(static_cast<std::uint32_t>(hashes))} << random.below(5);
      ASSERT_EQ(index.set(hash, number, is(number)), 0U);
      hashOf.emplace(number, hash);
      while (!hashOf.empty() && random.chance(45)) {
        const auto gone = std::next(hashOf.begin(), random.below(static_cast<int>(hashOf.size())));
        index.erase(gone->second, is(gone->first));
        hashOf.erase(gone);
      }
      ASSERT_EQ(index.count(), hashOf.size());
      for (std::uint64_t n = 1; n <= number; ++n) {
        const auto there = hashOf.find(n);
        for (std::uint64_t h = 0; h < hashes; ++h) {
          const bool isThere = there != hashOf.end() && there->second == h;
          ASSERT_EQ(index.find(h, is(n)), isThere ? n : 0U);
        }
      }
    }
  }
}

TEST(ChunkRect, HoldsTheChunksThatItsCellsReach) {
  constexpr std::int32_t kAbout[] = {-65, -64, -33, -32, -1, 0, 31, 32, 63};
  for (const std::int32_t i0 : kAbout)
    for (const std::int32_t i1 : kAbout)
      for (const std::int32_t j0 : {-33, 0, 32})
        for (const std::int32_t j1 : {-32, 31, 33}) {
          if (i1 < i0 || j1 < j0) continue;
          const CellRect rect{{i0, j0}, {i1, j1}};
          std::set<Cell> reached;
          for (const Cell& c : cellsOf(rect)) reached.insert({c.i >> 5, c.j >> 5});
          const detail::ChunkRect chunks(rect);
          EXPECT_EQ(chunks.count(), reached.size());
          for (const Cell& c : cellsOf({{-4, -4}, {4, 4}})) {
            detail::Chunk chunk;
            chunk.ci = c.i;
            chunk.cj = c.j;
            EXPECT_EQ(chunks.contains(chunk), reached.contains(c));
          }
        }
}

/// A triangle for each number.
LocalPolygon numbered(std::int32_t k) { return {{0, 0}, {1 + k % 250, 0}, {0, 1 + k / 250}}; }

// The catalogue forgets what nothing uses, once that is much. What is used it must keep, and what it has forgotten it
// must not forget again: two contents would get the same place.
TEST(Catalogue, ForgetsOnceAndNeverWhatIsUsed) {
  World world;
  std::map<std::int32_t, PolygonHandle> standing;
  const auto put = [&](std::int32_t from, std::int32_t to) {
    for (std::int32_t k = from; k < to; ++k) standing[k] = place(world, {k % 100, k / 100}, numbered(k));
  };
  const auto take = [&](std::int32_t from, std::int32_t to) {
    for (std::int32_t k = from; k < to; ++k) {
      ASSERT_TRUE(world.remove(standing.at(k)));
      standing.erase(k);
    }
  };
  const auto expectRight = [&] {
    World fresh;
    for (const auto& [k, handle] : standing) {
      const auto vertices = world.polygon(handle).value().vertices;
      ASSERT_EQ(LocalPolygon(vertices.begin(), vertices.end()), numbered(k));
      place(fresh, {k % 100, k / 100}, numbered(k));
    }
    world.commit();
    fresh.commit();
    ASSERT_EQ(oracle::outlineOf(world), oracle::outlineOf(fresh));
  };
  put(0, 5000);
  take(0, 1200);  // more than a thousand unused, but not enough of all
  put(5000, 5001);
  EXPECT_GT(world.stats().contents, 5000U);
  take(1200, 4900);  // forgotten with the next edit
  put(5001, 5010);
  EXPECT_LT(world.stats().contents, 200U);
  expectRight();
  put(8000, 10'000);
  take(8000, 10'000);
  world.commit();  // a commit forgets, too
  EXPECT_LT(world.stats().contents, 200U);
  put(3010, 4700);
  take(3100, 4700);  // forgotten too, while there are free places left of the first time
  put(5010, 8000);
  expectRight();
}

}  // namespace
}  // namespace lgs::test
