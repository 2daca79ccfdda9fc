// Pieces by hand: contents that are degenerate on purpose, portals, whole cells, and what calls answer at their limits.
#include "oracle/views/piece_check.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

using oracle::CellPieces;
using oracle::faultOfPieces;
using oracle::PiecesByCell;
using oracle::piecesIn;
using Polygons = std::vector<LocalPolygon>;

/// The pieces of a cell with these polygons, once the reference is content with them.
CellPieces piecesOf(const Polygons& polygons, std::size_t maxVertices = 8) {
  World world;
  for (const LocalPolygon& polygon : polygons) place(world, {}, polygon);
  const Pieces pieces(world, {maxVertices});
  EXPECT_EQ(faultOfPieces(world, pieces, {Cell{}}), std::nullopt);
  return piecesIn(pieces, Cell{});
}

TEST(PiecesByHand, NothingAndAll) {
  EXPECT_EQ(piecesOf({}), (CellPieces{{}, {unitSquare()}}));
  EXPECT_EQ(piecesOf({unitSquare()}), (CellPieces{{{0, unitSquare()}}, {}}));
  EXPECT_EQ(piecesOf({ramp()}), (CellPieces{{{0, ramp()}}, {eighths({{0, 0}, {8, 8}, {0, 8}})}}));
}

TEST(PiecesByHand, TwoHundredAndTwentyFivePolygons) {
  constexpr std::int32_t kSide = U / 16;
  Polygons diamonds, dots;
  for (std::int32_t j = 0; j < 15; ++j) {
    for (std::int32_t i = 0; i < 15; ++i) {
      const LocalPoint p{i * kSide, j * kSide};
      diamonds.push_back({{p.x + kSide / 2, p.y},
                          {p.x + kSide, p.y + kSide / 2},
                          {p.x + kSide / 2, p.y + kSide},
                          {p.x, p.y + kSide / 2}});
      dots.push_back({{p.x, p.y}, {p.x + 1, p.y}, {p.x + 1, p.y + 1}, {p.x, p.y + 1}});
    }
  }
  EXPECT_EQ(piecesOf(diamonds).solid.size(), 225U);
  EXPECT_EQ(piecesOf(dots, 3).solid.size(), 450U);
}

TEST(PiecesByHand, AsManyVerticesAsThereMayBe) {
  LocalPolygon many;  // on an arc: convex, so that the limit alone cuts it
  for (std::int32_t k = 0; k < 200; ++k) many.push_back({k * 200, k * k});
  many.push_back({0, U});
  EXPECT_EQ(piecesOf({many}, kMaxVerticesPerCell).solid.size(), 1U);
  EXPECT_GE(piecesOf({many}, 8).solid.size(), 33U);  // of 199 triangles at most 6 fit in one
  EXPECT_EQ(piecesOf({many}, 3).solid.size(), 199U);
}

TEST(PiecesByHand, TheLimitIsWhatWasAskedFor) {
  const World world;
  EXPECT_EQ(Pieces(world).maxVertices(), 8U);
  EXPECT_EQ(Pieces(world, {3}).maxVertices(), 3U);
  EXPECT_EQ(Pieces(world, {kMaxVerticesPerCell}).maxVertices(), kMaxVerticesPerCell);
#ifndef NDEBUG
  EXPECT_DEATH(Pieces(world, {2}), "maxVertices");
  EXPECT_DEATH(Pieces(world, {kMaxVerticesPerCell + 1}), "maxVertices");
#endif
}

TEST(PiecesByHand, PortalsAcrossASideAreCutAtVerticesOfEither) {
  World world;
  place(world, {0, 0}, eighths({{0, 0}, {8, 0}, {8, 2}, {0, 2}}));  // a floor, and beside it a higher one with a gap
  place(world, {1, 0}, eighths({{0, 0}, {8, 0}, {8, 3}, {0, 3}}));
  place(world, {1, 0}, eighths({{0, 5}, {8, 5}, {8, 6}, {0, 6}}));
  const Pieces pieces(world);
  EXPECT_EQ(faultOfPieces(world, pieces, cellsOf({{-1, -1}, {2, 2}})), std::nullopt);
  std::vector<Portal> east;
  for (const Portal& portal : pieces.portals({{0, 0}, 0}))
    if (portal.to.cell == Cell{1, 0}) east.push_back(portal);
  const auto at = [](std::int64_t eighth) { return Point{U, eighth * U / 8}; };
  EXPECT_EQ(east, (std::vector<Portal>{{{{1, 0}, 0}, at(3), at(5)}, {{{1, 0}, 1}, at(6), at(8)}}));
}

TEST(PiecesByHand, BeyondTheLastCellIsNothing) {
  const World world;
  const Pieces pieces(world);
  const Cell last{kMaxCell, kMaxCell}, beyond{kMaxCell + 1, 0};
  EXPECT_EQ(pieces.freePieces(last).size(), 1U);
  EXPECT_EQ(pieces.portals({last, 0}).size(), 2U);
  EXPECT_TRUE(pieces.freePieces(beyond).empty());
  EXPECT_TRUE(pieces.solidPieces(beyond).empty());
  EXPECT_TRUE(pieces.portals({beyond, 0}).empty());
  EXPECT_EQ(pieces.freePieceAt({kMaxCoordinate, kMaxCoordinate}), (PieceId{last, 0}));
  EXPECT_EQ(pieces.freePieceAt({kMaxCoordinate + 1, 0}), std::nullopt);
}

TEST(PiecesByHand, WhereAPointIs) {
  World world;
  place(world, {0, 0}, unitSquare());
  place(world, {1, 0}, ramp());
  const Pieces pieces(world);
  const auto at = [&](std::int64_t x, std::int64_t y) { return pieces.freePieceAt({x * U / 2, y * U / 2}); };
  EXPECT_EQ(at(1, 1), std::nullopt);
  EXPECT_EQ(at(2, 1), (PieceId{{1, 0}, 0})) << "on the common side";
  EXPECT_EQ(at(3, 1), (PieceId{{1, 0}, 0})) << "on the slope";
  EXPECT_EQ(pieces.freePieceAt({3 * U / 2 + 1, U / 2}), std::nullopt);
  EXPECT_EQ(at(0, 0), (PieceId{{-1, -1}, 0})) << "in a corner the least cell comes first";
  EXPECT_EQ(at(0, 2), (PieceId{{-1, 0}, 0}));
}

TEST(PiecesByHand, EqualPolygonsAreWorkedOutOnce) {
  World world;
  const ShapeId shape = shapeOf(world, shapeNamed("comb"));
  ASSERT_TRUE(world.fill({{-20, -20}, {20, 20}}, shape, 1));
  world.commit();
  ASSERT_TRUE(world.followCells(true));
  Pieces pieces(world);
  EXPECT_EQ(pieces.stats(), (PiecesStats{41 * 41, 2, 1}));
  const Pieces copy = pieces;
  ASSERT_TRUE(world.clear({{-20, -20}, {20, 20}}));
  EXPECT_TRUE(pieces.update(world, world.commit()));
  EXPECT_EQ(pieces.changed().size(), 41U * 41U);
  EXPECT_EQ(pieces.stats(), (PiecesStats{0, 1, 1})) << "a content that no cell has is forgotten";
  EXPECT_EQ(copy.stats(), (PiecesStats{41 * 41, 2, 1}));
  EXPECT_FALSE(copy.solidPieces({20, -20}).empty()) << "a copy goes its own way";
}

}  // namespace
}  // namespace lgs::test
