// The questions about regions, by hand. For random strokes oracle/check/laws/strokes.cpp has them, and what stays.
#include "proptests/brush/strokes.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

constexpr std::int64_t kCellUnits = kUnitsPerCell;

Region rect(Point min, Point max) { return {{{min, {max.x, min.y}, max, {min.x, max.y}}}}; }

TEST(BrushRegionsByHand, WithoutSaysWhichRingWasRefused) {
  const Region region = rect({0, 0}, {3 * kCellUnits, kCellUnits}), far = rect({5, 5}, {kMaxCoordinate + 1, 9});
  const Region hole = rect({kCellUnits, 9}, {2 * kCellUnits, 90});
  EXPECT_EQ(
      without(region, hole)->rings,
      (std::vector<Ring>{region.rings[0], {hole.rings[0][0], hole.rings[0][3], hole.rings[0][2], hole.rings[0][1]}}));
  EXPECT_TRUE(without(hole, region)->rings.empty());
  EXPECT_EQ(without(far, region).error().polygon, 0);
  EXPECT_EQ(without(region, far).error().polygon, 1);
  const Region wide = rect({0, 0}, {(kMaxRegionCells + 1) * kCellUnits, 9});
  EXPECT_EQ(without(region, wide).error().polygon, -1) << "none of its rings, but all of it";
}

TEST(BrushRegionsByHand, BoundsAndCells) {
  const Region region = rect({5, 5}, {2 * kCellUnits, kCellUnits + 1});
  EXPECT_EQ(boundsOf(region).value(), (CellRect{{0, 0}, {1, 1}}));
  EXPECT_EQ(cellsOf(region)->size(), 4U);
  // Where its right edge runs from cell to cell it is rounded to the line on which it ends.
  const Region leaning{{{{9, -3 * kCellUnits}, {kCellUnits - 1, -3 * kCellUnits}, {kCellUnits, 3 * kCellUnits}}}};
  EXPECT_EQ(cellsOf(leaning)->size(), 6U) << "nothing of it is in the next column";
  EXPECT_TRUE(isEmpty(boundsOf(Region{}).value()));
  EXPECT_TRUE(isEmpty(boundsOf(rect({0, 0}, {0, 5})).value()));
  EXPECT_TRUE(cellsOf(Region{})->empty());
  const Region far = rect({5, 5}, {kMaxCoordinate + 1, 9});
  EXPECT_EQ(boundsOf(far).error().code, ErrorCode::outOfReach);
  EXPECT_EQ(cellsOf(far).error().code, ErrorCode::outOfReach);
  EXPECT_FALSE(meets(far, region.rings[0]));
  EXPECT_TRUE(meets(region, {{2 * kCellUnits, 9}, {2 * kCellUnits + 9, 9}, {2 * kCellUnits, 20}})) << "they touch";
  EXPECT_TRUE(meets(region, {{9, 9}, {20, 9}, {9, 20}})) << "inside";
  EXPECT_TRUE(meets(rect({9, 9}, {20, 20}), region.rings[0])) << "around";
  EXPECT_FALSE(meets(region, {{2 * kCellUnits + 1, 9}, {2 * kCellUnits + 9, 9}, {2 * kCellUnits + 1, 20}}));
  EXPECT_FALSE(
      meets({{region.rings[0], rect({7, 7}, {90, 90}).rings[0]}, FillRule::evenOdd}, {{20, 20}, {30, 20}, {20, 30}}))
      << "in a hole";
}

}  // namespace
}  // namespace lgs::test
