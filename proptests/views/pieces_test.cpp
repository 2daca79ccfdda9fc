// Pieces of each degenerate shape, with any limit. Those of any ground are law 15 (law15_views_test.cpp).
#include "oracle/views/piece_check.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace lgs::test {
namespace {

constexpr std::array<std::size_t, 4> kLimits{8, 3, 5, kMaxVerticesPerCell};

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
