// The usual cell comes out as it does by an arrangement.
#include "plain.h"
#include "cells.h"
#include "proptests/brush/same_edit.h"
#include "proptests/brush/strokes.h"
#include "proptests/support/law.h"

#include <gtest/gtest.h>

namespace lgs::test::plain {
namespace {

using brush::CellPolygon;

/// How many edits of empty cells and of full ones were plain, of those that change something.
struct Plain {
  std::size_t ofEmpty = 0, ofFull = 0;
};

/// Compares both in each cell that a region cuts.
void comparePlainCells(const Region& region, Plain& plain) {
  constexpr std::int64_t kEnd = kUnitsPerCell;
  const brush::Frame frame;
  const brush::List<CellPolygon> full{{{{0, 0}, {kEnd / 2, 0}, {kEnd, 0}, {kEnd, kEnd}, {0, kEnd}}, 1}};
  const std::vector<LocalPoint> vertices{{0, 0}, {kEnd / 2, 0}, {kEnd, 0}, {kEnd, kEnd}, {0, kEnd}};
  const std::vector<PlacedPolygon> placed{{{}, 1, vertices}};
  for (const brush::CutCell& cell : brush::coverage(region).cut) {
    for (const auto& polygons : {brush::List<CellPolygon>{}, full}) {
      for (const brush::Deed deed : {brush::Deed::carve, brush::Deed::fill, brush::Deed::replace}) {
        const brush::Stroke stroke{deed, 2, region.rule};
        const auto edit = plainEdit(polygons.empty() ? std::span<const PlacedPolygon>() : placed, cell.pieces, stroke);
        if (!edit) continue;
        if (!edit->placed.empty()) ++(polygons.empty() ? plain.ofEmpty : plain.ofFull);
        expectSame(*edit, arrangedEdit(polygons, cell.pieces, stroke));
      }
    }
  }
}

LGS_LAW(Brush, APlainCellComesOutAsArranged, 3'000, (const AnyRegion& any)) {
  Plain plain;
  comparePlainCells(any.region(), plain);
}

/// Triangles and squares that turn around a corner of four cells, in steps of a few units.
TEST(Brush, APlainCellComesOutAsArrangedNearACorner) {
  Plain plain;
  for (const std::int64_t size : {2, 5, 40, 50'000}) {
    for (int turn = 0; turn < 32; ++turn) {
      const Ring around = circle({0, 0}, size, 32).rings[0];
      for (const std::size_t step : {8U, 11U}) {
        for (std::int64_t x = -3; x <= 3; ++x) {
          for (std::int64_t y = -3; y <= 3; ++y) {
            Ring ring;
            for (std::size_t k = static_cast<std::size_t>(turn); k < 32U + static_cast<std::size_t>(turn); k += step)
              ring.push_back({kUnitsPerCell + x + around[k % 32].x, kUnitsPerCell + y + around[k % 32].y});
            comparePlainCells({{ring}}, plain);
          }
        }
      }
    }
  }
  EXPECT_GT(plain.ofEmpty, 70'000U) << "they are usual";
  EXPECT_GT(plain.ofFull, 70'000U);
}

}  // namespace
}  // namespace lgs::test::plain
