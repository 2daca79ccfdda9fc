// Bodies as convex parts, and bodies that come back into the ground as they lie.
#include "examples/area/area_by_block.h"
#include "oracle/cgal/partition.h"
#include "proptests/laws/calls.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <lgs/falling.h>
#include <lgs/islands.h>
#include <lgs/pieces.h>

#include <gtest/gtest.h>

#include <cmath>

namespace lgs::test {
namespace {

/// All that a world holds, as a body.
Body allOf(const World& world) {
  Body body;
  body.cells = world.bounds().value_or(CellRect{});
  body.origin = body.cells.min;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    body.polygons.push_back(
        {{cell.i - body.origin.i, cell.j - body.origin.j}, p.block, {p.vertices.begin(), p.vertices.end()}});
  });
  body.mass = massOf(body.polygons);
  return body;
}

/// The parts of one block in a cell: of a rectangle the square that is in it.
std::map<Cell, oracle::PieceList> byCell(const std::vector<ConvexPart>& parts, Block block) {
  std::map<Cell, oracle::PieceList> out;
  for (const ConvexPart& part : parts) {
    if (part.block != block) continue;
    Point min = part.vertices.front(), max = min;
    for (const Point p : part.vertices) {
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    const Cell first = cellAt(min), last = cellAt({max.x - 1, max.y - 1});
    const bool isOne = first == last;
    for (Cell c = first; c.j <= last.j; ++c.j) {
      for (c.i = first.i; c.i <= last.i; ++c.i) {
        oracle::LocalPolygon piece(kUnitSquare.begin(), kUnitSquare.end());
        if (isOne) {
          piece.clear();
          for (const Point p : part.vertices) {
            const Point corner = toWorld(c, {});
            piece.push_back({static_cast<std::int32_t>(p.x - corner.x), static_cast<std::int32_t>(p.y - corner.y)});
          }
        } else if (part.vertices.size() != 4 || part.vertices[2] != max || min.x % kUnitsPerCell != 0 ||
                   min.y % kUnitsPerCell != 0 || max.x % kUnitsPerCell != 0 || max.y % kUnitsPerCell != 0) {
          ADD_FAILURE() << "a part of several cells is no rectangle of whole cells";
        }
        out[c].push_back(piece);
      }
    }
  }
  return out;
}

// That free pieces are what polygons leave is a law of its own (pieces_test.cpp). So parts are right if they and the
// free pieces of their block alone make up each cell.
LGS_LAW(Falling, PartsOfEachBlockMakeUpItsPolygons, 300, (const PlainTrace& trace)) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  const Body body = allOf(player.world());
  const auto parts = must(convexParts(body, 8));
  std::map<Block, World> byBlock;
  for (const BodyPolygon& p : body.polygons) place(byBlock[p.block], p.cell, p.vertices, p.block);
  std::size_t count = 0;
  for (auto& [block, world] : byBlock) {
    world.commit();
    const Pieces pieces(world);
    auto lists = byCell(parts, block);
    world.forEachPolygon([&](Cell cell, const PlacedPolygon&) { lists.try_emplace(cell); });
    for (const auto& [cell, list] : lists) {
      count += list.size();
      std::vector<oracle::PieceList> solid;
      for (const oracle::LocalPolygon& piece : list) {
        EXPECT_LE(piece.size(), 8U);
        solid.push_back({piece});
      }
      oracle::PieceList free;
      for (const Piece& piece : pieces.freePieces(cell))
        free.emplace_back(piece.vertices.begin(), piece.vertices.end());
      failIf(oracle::notAPartition(list, solid, free));
    }
  }
  EXPECT_GE(count, parts.size());
}

TEST(FallingByHand, WholeCellsOfOneBlockAreMerged) {
  World world;
  for (std::int32_t i = 0; i < 40; ++i)
    for (std::int32_t j = 0; j < 2; ++j) place(world, {i, j}, unitSquare(), i == 5 ? 2U : 1U);
  const auto parts = must(convexParts(allOf(world)));
  EXPECT_EQ(parts.size(), 4U) << "left and right of the other block, beyond 32 cells, and that block";
  EXPECT_EQ(convexParts(allOf(world), 3)->size(), 160U) << "triangles";
}

/// Twice the area in square units, of all blocks, and the length of all edges.
struct Extent {
  double doubleArea = 0, length = 0;
};
Extent extentOf(const World& world) {
  Extent out;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) {
    for (std::size_t k = 0; k < p.vertices.size(); ++k) {
      const LocalPoint a = p.vertices[k], b = p.vertices[k + 1 == p.vertices.size() ? 0 : k + 1];
      out.doubleArea += double{1} * a.x * b.y - double{1} * a.y * b.x;
      out.length += std::hypot(a.x - b.x, a.y - b.y);
    }
  });
  return out;
}

// Turns by a quarter and whole cells need no rounding: nothing is gained and nothing lost. (Ground that is thinner than
// a lattice unit may go, as by any brush.)
TEST(FallingByHand, AQuarterTurnKeepsTheAreaOfEachBlock) {
  constexpr int kSines[] = {0, 1, 0, -1};
  constexpr std::int32_t U = kUnitsPerCell;
  World original;
  place(original, {5, 5}, unitSquare(), 1);
  place(original, {6, 5}, {{0, 0}, {U / 3, 0}, {0, U}}, 2);
  place(original, {6, 5}, {{U / 3, 0}, {U, 0}, {U, U / 2}, {0, U}}, 3);
  place(original, {6, 6}, {{0, 0}, {U / 7, 0}, {U / 7, U / 9}}, 2);
  original.commit();
  for (std::size_t turn = 0; turn < 4; ++turn) {
    World world;
    const Placing placing{{7, -3}, static_cast<double>(kSines[(turn + 1) % 4]), static_cast<double>(kSines[turn])};
    ASSERT_TRUE(putAsItLies(world, allOf(original), placing));
    world.commit();
    EXPECT_EQ(examples::AreaByBlock(world).areas(), examples::AreaByBlock(original).areas());
    EXPECT_EQ(Islands(world).all().size(), 1U);
    // Above the first corner of the square, as it lies now.
    const Point inside{7 * U + (turn == 0 || turn == 3 ? 1 : -1) * U / 4, -3 * U + (turn < 2 ? 1 : -1) * U / 4};
    EXPECT_EQ(world.at(inside).block, 1U);
  }
}

LGS_LAW(Falling, AnyTurnKeepsTheAreaButForRounding, 200, (const PlainTrace& trace, Chance chance)) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  constexpr Block kGround = 1'000'000;
  World world;
  for (std::int32_t i = -8; i <= 8; ++i) place(world, {i, 200}, unitSquare(), kGround);  // where no body comes to lie
  const double angle = 0.001 * static_cast<double>(chance.below(6'283));
  const Placing placing{{0.37, 0.0001 * static_cast<double>(chance.below(10'000))}, std::cos(angle), std::sin(angle)};
  const Extent before = extentOf(player.world());
  const double ground = extentOf(world).doubleArea;
  ASSERT_TRUE(putAsItLies(world, allOf(player.world()), placing));
  const Extent after = extentOf(world);
  // Each edge moves by less than two units: one by rounding here, one by the brush.
  EXPECT_NEAR(after.doubleArea - ground, before.doubleArea, 4 * (before.length + after.length) + 16);
  world.commit();
  EXPECT_EQ(examples::AreaByBlock(world).areas().at(kGround).cells, 17);
}

TEST(FallingByHand, WhatIsSolidStaysAndTheRestIsPainted) {
  World world;
  place(world, {0, 0}, unitSquare(), 1);
  Body body;
  body.polygons.push_back({{0, 0}, 2, {kUnitSquare.begin(), kUnitSquare.end()}});
  ASSERT_TRUE(putAsItLies(world, body, {.origin = {0.5, 0}}));
  world.commit();
  const auto areas = examples::AreaByBlock(world).areas();
  EXPECT_EQ(areas.at(1).cells, 1);
  EXPECT_EQ(areas.at(2).halfUnits, examples::Area::kCell / 2);
}

TEST(FallingByHand, WhatIsRefusedChangesNothing) {
  World world;
  Body body;
  body.polygons.push_back({{0, 0}, 1, {kUnitSquare.begin(), kUnitSquare.end()}});
  body.polygons.push_back({{0, 1}, 2, {kUnitSquare.begin(), kUnitSquare.end()}});
  body.polygons.push_back({{kMaxCell, 0}, 2, {kUnitSquare.begin(), kUnitSquare.end()}});
  const auto tooWide = refusal(putAsItLies(world, body, {}));
  EXPECT_EQ(tooWide.code, ErrorCode::outOfReach);
  EXPECT_TRUE(world.isEmpty({0, 0})) << "the first block would fit";
  body.polygons.pop_back();
  body.polygons.back() = {{0, 0}, 2, {kUnitSquare.begin(), kUnitSquare.end()}};
  EXPECT_EQ(putAsItLies(world, body, {}).error().index, 1);
  EXPECT_EQ(convexParts(body).value().size(), 2U) << "each block by itself fits";
  body.polygons.back().block = 1;
  EXPECT_EQ(convexParts(body).error().code, ErrorCode::overlap);
  EXPECT_TRUE(world.isEmpty({0, 0}));
}

}  // namespace
}  // namespace lgs::test
