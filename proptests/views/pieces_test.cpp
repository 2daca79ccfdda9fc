// Pieces are the parts of what is solid and of what is free, in any content, with any limit, however it came about.
#include "oracle/views/piece_check.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace lgs::test {
namespace {

constexpr std::array<std::size_t, 4> kLimits{8, 3, 5, kMaxVerticesPerCell};

/// Pieces of a world that is read once.
void expectPieces(const World& world, std::size_t maxVertices) {
  const Pieces pieces(world, {maxVertices});
  EXPECT_EQ(pieces.maxVertices(), maxVertices);
  failIf(oracle::PieceCheck().begin(world, pieces));
}

LGS_LAW(Pieces, MakeUpAnyGround, 1'000, (const GoodTrace& trace, Chance chance)) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  expectPieces(player.world(), kLimits[chance.below(kLimits.size())]);
}

// What follows from the polygons does not depend on how they came there, nor on the vertices that they begin with.
LGS_LAW(Pieces, DoNotDependOnHistory, 150, (const PlainTrace& trace, Chance chance)) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  const World& world = player.world();
  std::vector<std::pair<Cell, LocalPolygon>> polygons;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    polygons.emplace_back(cell, LocalPolygon(p.vertices.begin(), p.vertices.end()));
  });
  chance.shuffle(polygons);
  World other;
  for (auto& [cell, polygon] : polygons) {
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(chance.below(polygon.size())),
                polygon.end());
    place(other, cell, polygon, static_cast<Block>(chance.below(3)));
  }
  const std::vector<Cell> cells = cellsOf(world.bounds().value_or(CellRect{}));
  const lgs::Pieces one(world), two(other);
  EXPECT_EQ(oracle::piecesIn(one, cells), oracle::piecesIn(two, cells));
  EXPECT_EQ(one.stats().contents, two.stats().contents);
  for (const Cell cell : cells) {  // each solid piece is in the polygon that it names
    const auto placed = polygonsByPieces(world, cell), again = polygonsByPieces(other, cell);
    ASSERT_EQ(placed.size(), again.size());
    for (std::size_t k = 0; k < placed.size(); ++k)
      EXPECT_TRUE(std::is_permutation(placed[k].vertices.begin(), placed[k].vertices.end(), again[k].vertices.begin(),
                                      again[k].vertices.end()));
  }
}

TEST(PiecesOf, EveryDegenerateShapeTurned) {
  for (const oracle::NamedShape& shape : oracle::degenerateShapes()) {
    for (int symmetry = 0; symmetry < 8; ++symmetry) {
      World world;
      for (const LocalPolygon& polygon : shape.polygons) place(world, {}, oracle::turned(polygon, symmetry));
      for (const std::size_t limit : kLimits) {
        const auto fault = oracle::faultOfPieces(world, lgs::Pieces(world, {limit}), {Cell{}});
        EXPECT_EQ(fault, std::nullopt) << shape.name << ", turned by " << symmetry << ", at most " << limit
                                       << " vertices";
      }
    }
  }
}

}  // namespace
}  // namespace lgs::test
