// Chunks that are unloaded, by hand: what is refused, what bytes are taken, what memory it costs.
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "twins.h"
#include "unloaded.h"

#include <gtest/gtest.h>

#include <optional>

namespace lgs::test {
namespace {

/// So many chunks in a row, full of squares.
World rowOfChunks(std::int32_t chunks) {
  World world;
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_TRUE(world.fill({{0, 0}, {32 * chunks - 1, 31}}, square, 1));
  world.commit();
  return world;
}

std::size_t segmentsOf(const World& world) { return world.segments().size(); }

/// The bytes of a chunk with one of them changed, and with the checksum that fits.
std::vector<std::byte> spoilt(std::vector<std::byte> bytes, std::size_t at, std::byte by) {
  bytes[at] ^= by;
  seal(bytes);
  return bytes;
}

TEST(UnloadedByHand, NoWallAppearsWhereTheLoadedWorldEnds) {
  World world = rowOfChunks(3);
  EXPECT_EQ(segmentsOf(world), 2U * 96 + 2U * 32);
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(1, 0), shelf.sink()), 1U);
  EXPECT_EQ(segmentsOf(world), 2U * 96 + 2U * 32) << "as of the last commit";
  const Changes& gone = world.commit();
  EXPECT_EQ(gone.removed.size(), 64U);
  EXPECT_TRUE(gone.added.empty() && gone.relinked.empty());
  EXPECT_EQ(segmentsOf(world), 2U * 64 + 2U * 32);
  EXPECT_EQ(world.stats().polygons, 2U * 1024);
  EXPECT_EQ(world.firstUnloaded({{0, 0}, {95, 31}}), (Cell{32, 0}));
  EXPECT_EQ(world.firstUnloaded({{0, 0}, {31, 31}}), std::nullopt);
  // The last segment on top of the first chunk goes on into what is unloaded.
  for (const SegmentId id : world.segments({{31, 31}, {31, 31}})) {
    const Segment s = *world.segment(id);
    EXPECT_EQ(s.ghost1, (Point{33 * U, 32 * U}));
    EXPECT_EQ(world.segment(s.predecessor).error().code, ErrorCode::unloaded);
    EXPECT_EQ(world.segment(s.predecessor).error().cell, (Cell{32, 31}));
    Segment out;
    EXPECT_EQ(world.segments({&s.predecessor, 1}, {&out, 1}).error().code, ErrorCode::unloaded);
  }
  EXPECT_EQ(world.commit().removed.size(), 0U);
  EXPECT_TRUE(shelf.reload(world, {32, 0}));
  const Changes& back = world.commit();
  EXPECT_EQ(back.added.size(), 64U);
  EXPECT_TRUE(back.removed.empty() && back.relinked.empty());
}

TEST(UnloadedByHand, WithoutACommitBetweenNothingHasHappened) {
  World world = rowOfChunks(2);
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  const Changes& changes = world.commit();
  EXPECT_TRUE(changes.removed.empty() && changes.added.empty() && changes.relinked.empty());
}

TEST(UnloadedByHand, OnlyChunksWithinTheRectangleGo) {
  World world = rowOfChunks(2);
  EXPECT_EQ(world.unload({{0, 0}, {31, 30}}, {}), 0U);
  EXPECT_EQ(world.unload({{1, 0}, {63, 31}}, {}), 1U);
  EXPECT_EQ(world.unload({{0, 0}, {63, 31}}, {}), 1U) << "the other one is unloaded already";
  EXPECT_EQ(world.unload({{0, 0}, {-1, 31}}, {}), 0U);
  EXPECT_EQ(world.unload({{0, 0}, {kMaxCell + 1, 31}}, {}).error().code, ErrorCode::cellOutOfRange);
  EXPECT_EQ(world.reloadEmpty({{kMaxCell + 1, 0}, {kMaxCell + 1, 31}}).error().code, ErrorCode::cellOutOfRange);
  EXPECT_EQ(world.firstUnloaded({{0, 0}, {-1, 0}}), std::nullopt);
}

TEST(UnloadedByHand, TheFirstUnloadedCellIsTheFirstByRows) {
  World world;
  for (const Cell cell : {Cell{0, 0}, Cell{64, 0}, Cell{0, 32}, Cell{32, 32}}) place(world, cell, unitSquare());
  world.commit();
  EXPECT_EQ(world.unload({{32, 0}, {95, 31}}, {}), 1U);
  EXPECT_EQ(world.unload({{0, 32}, {95, 63}}, {}), 2U);
  EXPECT_EQ(world.firstUnloaded(kEverywhere), (Cell{64, 0}));
  EXPECT_EQ(world.firstUnloaded({{0, 0}, {63, 63}}), (Cell{0, 32}));
  EXPECT_EQ(world.firstUnloaded({{5, 40}, {95, 63}}), (Cell{5, 40}));
}

TEST(UnloadedByHand, HandlesAreRefusedAndValidAgain) {
  World world;
  const PolygonHandle gone = place(world, {3, 4}, unitSquare()), stale = place(world, {5, 5}, unitSquare());
  EXPECT_TRUE(world.remove(stale));
  world.commit();
  Shelf shelf;
  EXPECT_EQ(world.unload(kEverywhere, shelf.sink()), 1U);
  for (int commits = 0; commits < 2; ++commits) {
    EXPECT_EQ(world.polygon(gone).error().code, ErrorCode::unloaded);
    EXPECT_EQ(world.polygon(gone).error().cell, (Cell{3, 4}));
    EXPECT_EQ(world.cellOf(gone).error().code, ErrorCode::unloaded);
    EXPECT_EQ(world.remove(gone).error().code, ErrorCode::unloaded);
    world.commit();
  }
  EXPECT_EQ(world.save({}).error().code, ErrorCode::unloaded);
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  EXPECT_EQ(world.cellOf(gone), (Cell{3, 4}));
  EXPECT_EQ(world.polygon(stale).error().code, ErrorCode::staleHandle);
  EXPECT_EQ(place(world, {5, 5}, unitSquare()).serial, stale.serial + 1) << "none is given out twice";
}

TEST(UnloadedByHand, AChunkThatComesBackEmptyGivesNoHandleTwice) {
  for (const int edits : {1, 300}) {  // more than a word counts
    World world;
    PolygonHandle old;
    for (int k = 0; k < edits; ++k) {
      if (old) {
        EXPECT_TRUE(world.remove(old));
      }
      old = place(world, {3, 4}, unitSquare());
    }
    place(world, {40, 4}, unitSquare());
    world.commit();
    EXPECT_EQ(world.unload(chunkAt(0, 0), {}), 1U);
    world.commit();
    EXPECT_EQ(world.reloadEmpty(kEverywhere), 1U);
    EXPECT_EQ(world.reloadEmpty(kEverywhere), 0U);
    EXPECT_EQ(world.polygon(old).error().code, ErrorCode::staleHandle);
    for (const Cell cell : {Cell{3, 4}, Cell{9, 9}}) EXPECT_GT(place(world, cell, unitSquare()).serial, old.serial);
    EXPECT_EQ(world.commit().added.size(), 8U);
  }
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
      EXPECT_EQ(victim.forget(kEverywhere), 1U);
      static_cast<void>(victim.reload(spoilt(bytes, k, std::byte{1} << bit)));
      victim.commit();
      EXPECT_EQ(victim.unload(kEverywhere, {}).has_value(), true);
      victim.commit();
    }
  }
}

TEST(UnloadedByHand, ForgottenPlacesGiveTheirNumbersAndBordersBack) {
  World world = rowOfChunks(3);
  Shelf shelf;
  EXPECT_EQ(world.unload({{0, 0}, {63, 31}}, shelf.sink()), 2U);
  EXPECT_EQ(world.forget(kEverywhere).error().code, ErrorCode::uncommitted);
  world.commit();
  EXPECT_EQ(world.stats().chunks, 3U);
  EXPECT_EQ(world.forget(kEverywhere), 1U) << "the second one is beside one that is loaded";
  EXPECT_EQ(world.firstUnloaded(kEverywhere), (Cell{32, 0}));
  EXPECT_EQ(world.forget({{0, 0}, {63, 31}}), 0U);
  // It comes back where it was, under a number that is free.
  EXPECT_TRUE(shelf.reload(world, {0, 0}));
  EXPECT_TRUE(shelf.reload(world, {32, 0}));
  world.commit();
  EXPECT_EQ(segmentsOf(world), 2U * 96 + 2U * 32);
  // A loaded chunk that is forgotten is one that needs nothing any more.
  EXPECT_EQ(world.unload(chunkAt(0, 0), shelf.sink()), 1U);
  EXPECT_TRUE(world.clear(CellRect{{32, 0}, {95, 31}}));
  world.commit();
  EXPECT_EQ(world.forget(kEverywhere), 2U);
  EXPECT_EQ(world.forget(kEverywhere), 0U) << "what the empty ones needed goes with a commit";
  world.commit();
  EXPECT_EQ(world.forget(kEverywhere), 1U);
  EXPECT_EQ(world.stats().chunks, 0U);
  EXPECT_TRUE(world.save({}));
}

TEST(UnloadedByHand, WhatNobodyNeedsCanBeForgottenAfterGoingBackToo) {
  World world = rowOfChunks(2);
  EXPECT_EQ(world.unload(chunkAt(0, 0), {}), 1U);
  EXPECT_TRUE(world.clear(CellRect{{32, 0}, {63, 31}}));
  world.commit();
  EXPECT_EQ(world.forget(kEverywhere), 1U) << "the empty one";
  const Mark mark = world.checkpoint();
  world.commit();
  EXPECT_TRUE(world.rollBack(mark));
  EXPECT_TRUE(world.forget(mark));
  world.commit();
  EXPECT_EQ(world.forget(kEverywhere), 1U);
}

TEST(UnloadedByHand, AnUnknownPlaceCanCountAsSolid) {
  World world = rowOfChunks(1);
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_TRUE(world.fill(chunkAt(1, 0), square, 1));
  EXPECT_EQ(world.unload(chunkAt(1, 0), {}), 1U);
  world.commit();
  EXPECT_EQ(segmentsOf(world), 96U) << "no wall towards it";
  EXPECT_EQ(world.reloadEmpty(chunkAt(1, 0)), 1U);
  EXPECT_EQ(world.commit().added.size(), 32U) << "it is known now, and there is nothing";
}

TEST(UnloadedByHand, AChainThatLeadsIntoWhatIsUnloadedIsNoLoop) {
  World world = rowOfChunks(2);
  Loops loops(world);
  ASSERT_EQ(loops.all().size(), 1U);
  EXPECT_EQ(world.unload(chunkAt(1, 0), {}), 1U);
  ASSERT_TRUE(loops.update(world, world.commit()));
  EXPECT_TRUE(loops.all().empty());
  for (const SegmentId id : world.segments()) EXPECT_FALSE(loops.of(id));
}

TEST(UnloadedByHand, QuestionsSayWhereTheyWouldHaveToLook) {
  World world = rowOfChunks(3);
  EXPECT_EQ(world.unload(chunkAt(1, 0), {}), 1U);
  world.commit();
  const auto at = [](double x, double y) { return latticePoint({x, y}); };
  EXPECT_EQ(world.at(at(31.5, 3.5)).where, Spot::Where::inside);
  EXPECT_EQ(world.at(at(32, 3.5)).where, Spot::Where::unloaded);
  EXPECT_EQ(world.at(at(40.5, 3.5)).where, Spot::Where::unloaded);
  EXPECT_EQ(world.at(at(40.5, 3.5)).cell, (Cell{40, 3}));
  EXPECT_EQ(world.at(at(40.5, 32)).where, Spot::Where::unloaded);
  EXPECT_EQ(world.at(at(40.5, 32.5)).where, Spot::Where::outside);
  // From above: what is loaded is hit, unless the way there leads through what is not.
  EXPECT_TRUE(must(world.rayCast(at(10, 40), at(10, 20))).segment);
  EXPECT_EQ(world.rayCast(at(40, 40), at(40, 20)).error().cell, (Cell{39, 31}));
  EXPECT_FALSE(must(world.rayCast(at(40, 40), at(40, 33))).segment);
  EXPECT_EQ(world.rayCast(at(30, 34), at(40, 24)).error().code, ErrorCode::unloaded) << "it meets both at (32, 32)";
  EXPECT_EQ(world.rayCast(at(29, 40), at(39, 20)).error().code, ErrorCode::unloaded);
  EXPECT_TRUE(world.rayCast(at(20, 40), at(60, 20)).error().code == ErrorCode::unloaded);
  EXPECT_TRUE(world.rayCast(at(28, 33), at(36, 31)).error().code == ErrorCode::unloaded) << "it meets both at once";
  EXPECT_TRUE(must(world.rayCast(at(27, 33), at(35, 31))).segment) << "it is hit at (31, 32), and would go on";
  EXPECT_TRUE(world.rayCast(Point{63 * U, 33 * U}, Point{65 * U, 31 * U + 1})) << "half a unit beside the corner";
  EXPECT_TRUE(must(world.rayCast(at(31.4, 33), at(32.4, 31))).segment) << "it is hit, and in that row would go on";
  // The nearest segment, unless an unknown one may be as near.
  EXPECT_TRUE(must(world.nearest(at(10, 35), 10)).segment);
  EXPECT_EQ(must(world.nearest(at(30, 35), 10)).distance, 3.0);
  EXPECT_EQ(world.nearest(at(32, 35), 10).error().code, ErrorCode::unloaded);
  EXPECT_EQ(world.nearest(at(48, 35), 10).error().cell, (Cell{48, 31}));
  EXPECT_FALSE(must(world.nearest(at(48, 35), 2.5)).segment);
  EXPECT_EQ(must(world.nearest(at(200, 16), 200)).distance, 104.0) << "the nearer one is loaded";
}

TEST(UnloadedByHand, OfPlacesThatMayBeNearestTheFirstByRowsIsNamed) {
  std::vector<Cell> beside;
  for (std::int32_t j = -1; j <= 1; ++j)
    for (std::int32_t i = -1; i <= 1; ++i)
      if (i != 0 || j != 0) beside.push_back({i, j});
  const auto nearestCell = [](Cell chunk) {
    const auto along = [](std::int32_t c) { return c == 0 ? 16 : c < 0 ? -1 : 32; };
    return Cell{along(chunk.i), along(chunk.j)};
  };
  for (const Cell first : beside) {
    for (const Cell second : beside) {
      if (first == second) continue;
      World world;
      const ShapeId square = shapeOf(world, {unitSquare()});
      for (const Cell chunk : {first, second}) {
        EXPECT_TRUE(world.fill(chunkAt(chunk.i, chunk.j), square, 1));
        EXPECT_EQ(world.unload(chunkAt(chunk.i, chunk.j), {}), 1U);
      }
      world.commit();
      const Cell a = nearestCell(first), b = nearestCell(second);
      EXPECT_EQ(world.nearest({16 * U + 1, 16 * U + 1}, 30).error().cell,
                std::pair(a.j, a.i) < std::pair(b.j, b.i) ? a : b);
    }
  }
}

TEST(UnloadedByHand, TheFirstChunkBesideWakesTheBorder) {
  World world = rowOfChunks(1);
  EXPECT_EQ(world.unload(kEverywhere, {}), 1U);
  world.commit();
  EXPECT_EQ(segmentsOf(world), 0U);
  const ShapeId square = shapeOf(world, {unitSquare()});
  const std::vector<Placement> placed{{{32, 31}, square, 1}, {{-1, 32}, square, 1}};
  EXPECT_TRUE(world.addMany(placed));
  EXPECT_EQ(world.commit().added.size(), 7U) << "the side towards what is unloaded does not show";
  for (const SegmentId id : world.segments())
    if (const Segment s = *world.segment(id); s.start == Point{0, 32 * U}) {
      EXPECT_EQ(s.ghost1, (Point{U, 32 * U})) << "where two solids touch the outline turns";
    }
}

TEST(UnloadedByHand, AGroupThatIsNotKeptBringsChunksBack) {
  World world = rowOfChunks(2);
  const PolygonHandle there = world.polygons({3, 3})[0].handle;
  {
    const auto group = world.edit();
    EXPECT_EQ(world.unload(chunkAt(0, 0), {}), 1U);
    EXPECT_FALSE(world.polygon(there));
  }
  EXPECT_TRUE(world.polygon(there));
  const Changes& changes = world.commit();
  EXPECT_TRUE(changes.removed.empty() && changes.added.empty() && changes.relinked.empty());
}

TEST(UnloadedByHand, ChunksAtTheEndsOfTheWorldGoToo) {
  World world;
  for (const Cell cell : {Cell{kMaxCell, kMaxCell}, Cell{-kMaxCell, -kMaxCell}}) place(world, cell, unitSquare());
  world.commit();
  Shelf shelf;
  EXPECT_EQ(world.unload(kEverywhere, shelf.sink()), 2U);
  world.commit();
  EXPECT_EQ(world.at(toWorld({kMaxCell, kMaxCell}, {U, U})).where, Spot::Where::unloaded);
  for (const Cell corner : {Cell{kMaxCell, kMaxCell}, Cell{-kMaxCell, -kMaxCell}})
    EXPECT_TRUE(shelf.reload(world, corner));
  EXPECT_EQ(world.commit().added.size(), 8U);
}

TEST(UnloadedByHand, ThreadsSeeNoDifference) {
  World world = rowOfChunks(3);
  EXPECT_EQ(world.unload({{0, 0}, {95, 31}}, {}), 3U);
  world.commit();
  EXPECT_EQ(world.reloadEmpty(chunkAt(0, 0)), 1U);
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_TRUE(world.fill(chunkAt(0, 0), square, 1));
  const Executor inLine = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t k = 0; k < count; ++k) job(k);
  };
  EXPECT_EQ(world.commit(inLine).added.size(), 96U) << "no wall towards the second chunk";
}

TEST(UnloadedByHand, APlaceNeverSeenIsEmptyOrUnknownAsTheGameSays) {
  World world = rowOfChunks(1);
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_EQ(world.at({40 * U, U}).where, Spot::Where::outside);
  for (const Cell cell : {Cell{40, 1}, Cell{-40, 1}}) {  // on the right it is unknown what is there
    ASSERT_TRUE(world.add(cell, square, 1));
    ASSERT_TRUE(world.clear(cell));
  }
  Shelf shelf;
  EXPECT_EQ(world.unload(chunkAt(1, 0), shelf.sink()), 1U);
  EXPECT_TRUE(world.commit().removed.empty()) << "to the ground beside it, it is empty";
  EXPECT_EQ(world.at({40 * U, U}).where, Spot::Where::unloaded);
  EXPECT_EQ(world.add({40, 1}, square, 1).error().code, ErrorCode::unloaded);
  EXPECT_EQ(world.at({-40 * U, U}).where, Spot::Where::outside);
  EXPECT_EQ(world.reloadEmpty(chunkAt(1, 0)), 1U) << "now the game makes it";
  EXPECT_TRUE(world.add({40, 1}, square, 1));
}

TEST(UnloadedByHand, MemoryGoesDownAndStaysDown) {
  World world = rowOfChunks(1);
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_TRUE(world.fill({{0, 32}, {32 * 200 - 1, 63}}, square, 1));
  world.commit();
  const std::uint64_t full = world.stats().bytes;
  Shelf shelf;
  EXPECT_EQ(world.unload({{64, 32}, {32 * 200 - 1, 63}}, shelf.sink()), 198U);
  world.commit();
  const std::uint64_t empty = world.stats().bytes;
  EXPECT_LT(empty + 195U * 5'000, full) << "each chunk had its cells alone 5,120 bytes";
  std::uint64_t after = 0;
  for (int k = 0; k < 1'000; ++k) {
    EXPECT_TRUE(shelf.reload(world, {64, 32}));
    world.commit();
    EXPECT_EQ(world.unload(chunkAt(2, 1), {}), 1U);
    world.commit();
    if (k == 2) after = world.stats().bytes;
  }
  EXPECT_EQ(world.stats().bytes, after) << "a thousand goings and comings leave nothing";
  EXPECT_EQ(world.forget(kEverywhere), 197U);
  EXPECT_LT(world.stats().bytes, after - 197U * 60);
}

TEST(UnloadedByHand, AWalkLeavesLittleBehind) {
  World world;
  const ShapeId diamond = shapeOf(world, shapeNamed("diamond"));
  std::uint64_t before = 0;
  for (std::int32_t k = 0; k < 201; ++k) {
    EXPECT_TRUE(world.fill(chunkAt(k, 0), diamond, 1));
    world.commit();
    EXPECT_EQ(world.unload(chunkAt(k - 1, 0), {}), k == 0 ? 0U : 1U);
    world.commit();
    if (k == 100) before = world.stats().bytes;
  }
  EXPECT_LT(world.stats().bytes, before + 100U * 1'500) << "a chunk's lists of segments alone take 4,096";
}

TEST(UnloadedByHand, SegmentsThatWentGiveTheirMemoryBack) {
  World world;
  const ShapeId diamond = shapeOf(world, shapeNamed("diamond"));
  constexpr std::uint64_t kSegments = 64 * 1'024 * 4;
  EXPECT_TRUE(world.fill({{0, 0}, {255, 255}}, diamond, 1));
  EXPECT_EQ(world.commit().added.size(), kSegments);
  const World copy = world;
  std::uint64_t full = 0, left = 0;
  for (int k = 0; k < 10; ++k) {
    Shelf shelf;
    EXPECT_EQ(world.unload({{0, 32}, {255, 255}}, shelf.sink()), 56U);
    world.commit();
    if (k == 1) left = world.stats().bytes;
    EXPECT_LT(world.stats().bytes, k == 0 ? UINT64_MAX : full - 28 * kSegments / 2) << "a segment takes 28 bytes";
    const World part = world;
    EXPECT_EQ(part.segments().size(), 8U * 1'024 * 4);
    for (std::int32_t j = 1; j < 8; ++j)
      for (std::int32_t i = 0; i < 8; ++i) EXPECT_TRUE(shelf.reload(world, chunkAt(i, j).min));
    EXPECT_EQ(world.commit().added.size(), 7U * 8 * 1'024 * 4);
    full = world.stats().bytes;  // with the lists of changes, which are as long as they ever were
  }
  EXPECT_EQ(world.unload({{0, 32}, {255, 255}}, {}), 56U);
  world.commit();
  EXPECT_EQ(world.stats().bytes, left) << "goings and comings leave nothing";
  EXPECT_EQ(copy.segments().size(), kSegments);
}

// Its border is made of what its cells held then, and not of what the notes between two commits have left of that.
TEST(UnloadedByHand, AChunkThatGoesBackToBeingUnloadedHasTheBorderOfThen) {
  World world;
  Shelf shelf;
  const ShapeId square = shapeOf(world, {unitSquare()});
  EXPECT_TRUE(world.add({32, 5}, square, 1));
  EXPECT_EQ(world.unload(chunkAt(1, 0), shelf.sink()), 1U);
  world.commit();
  const Mark mark = world.checkpoint();
  EXPECT_TRUE(world.add({31, 5}, square, 1));  // it wakes the border
  EXPECT_EQ(world.commit().added.size(), 3U);
  EXPECT_TRUE(shelf.reload(world, {32, 0}));
  EXPECT_TRUE(world.clear(Cell{32, 5}));
  EXPECT_EQ(world.commit().added.size(), 1U);
  EXPECT_TRUE(world.rollBack(mark));
  EXPECT_TRUE(world.add({31, 5}, square, 1));
  EXPECT_EQ(world.commit().added.size(), 3U);
}

// The border of the unloaded chunk is to be settled anew, since the chunk beside it was forgotten. While a mark is held
// each commit does that again.
TEST(UnloadedByHand, CommitsUnderAMarkDoNotAddUp) {
  World world = rowOfChunks(3);
  ASSERT_TRUE(world.unload({{0, 0}, {31, 31}}, {}));
  world.commit();
  ASSERT_TRUE(world.clear(CellRect{{32, 0}, {63, 31}}));
  world.commit();
  ASSERT_EQ(world.forget(CellRect{{32, 0}, {63, 31}}), 1U);
  const Mark mark = world.checkpoint();
  for (int k = 0; k < 100; ++k) world.commit();
  const std::uint64_t before = world.stats().bytes;
  for (int k = 0; k < 1'000; ++k) world.commit();
  EXPECT_EQ(world.stats().bytes, before);
  EXPECT_TRUE(world.forget(mark));
}

TEST(UnloadedByHand, WhatABorderHeldIsForgotten) {
  World world;
  Shelf shelf;
  for (std::int32_t round = 0; round < 80; ++round) {
    for (std::int32_t i = 0; i < 32; ++i) place(world, {i, 0}, {{0, 0}, {1 + 32 * round + i, 0}, {0, 1}});
    world.commit();
    EXPECT_EQ(world.unload(kEverywhere, shelf.sink()), 1U);
    world.commit();
    if (round % 2 == 0) {
      EXPECT_TRUE(shelf.reload(world, {0, 0}));
      EXPECT_EQ(world.clear(chunkAt(0, 0)), 32U);
      world.commit();
    } else {
      EXPECT_EQ(world.forget(kEverywhere), 1U);
    }
  }
  EXPECT_LT(world.stats().contents, 1'200U) << "of 2,560 that there were";
}

}  // namespace
}  // namespace lgs::test
