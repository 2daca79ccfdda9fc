// Open polylines become thin polygons, if that is asked for.
#include "maps.h"

#include <cmath>
#include <limits>

namespace lgs::tiled {
namespace {

std::string polyline(const std::string& points) {
  return "<object id='1' x='0' y='8' class='one-way'><polyline points='" + points + "'/></object>";
}

Options thick(double pixels) {
  const Options options{.polylineThickness = pixels};
  return options;
}

TEST(TiledPolylines, ThePolygonLiesBelowThePolyline) {
  const Ring slab = px({{0, 20}, {32, 4}, {32, 8}, {0, 24}});
  for (const char* points : {"0,0 32,16", "32,16 0,0"}) {
    for (const auto& map : bothWays(polyline(points), thick(4))) {
      EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{slab})) << points;
      EXPECT_THAT(noteTexts(map), ElementsAre("an open polyline became 4 px thick"));
    }
  }
}

TEST(TiledPolylines, NeighbouringPiecesHaveNoSeam) {
  const auto map =
      mustImport(tilesetXml({polyline("0,0 32,-8"), polyline("0,-8 20,4 32,0")}) + csvLayer(2, 1, "1,2"), thick(3));
  EXPECT_EQ(areaInCells(map) * 1024, 2 * 32 * 3);
  EXPECT_EQ(worldOf(map).loops().size(), 1U);
}

/// As a chain of edges is drawn: a floor, a wall, and a floor that runs back.
TEST(TiledPolylines, ASteepSegmentIsThickToTheRight) {
  for (const auto& map : bothWays(polyline("0,0 16,0 16,16 4,16"), thick(4))) {
    const Rings rings = ringsIn(map, {0, -1});
    EXPECT_THAT(rings, testing::Contains(pxBox(0, 20, 16, 24)));
    EXPECT_THAT(rings, testing::Contains(px({{4, 4}, {16, 4}, {16, 8}, {4, 8}})));
    EXPECT_EQ(areaInCells(map) * 1024, 4 * (16 + 16 + 12)) << "what two segments cover counts once";
  }
}

TEST(TiledPolylines, OnlyOnRequestAndTheReportSaysHow) {
  const char* const how = "an open polyline has no area: close it, or --polyline-thickness PIXELS makes it thick";
  for (const auto& map : bothWays(polyline("0,0 32,0"))) {
    EXPECT_TRUE(map.placements.empty());
    EXPECT_THAT(noteTexts(map), ElementsAre(how));
  }
  EXPECT_THAT(noteTexts(importTile(polyline("0,0"), thick(4))), ElementsAre(how)) << "it is a point";
}

TEST(TiledPolylines, ThinnerThanTheToleranceItStaysAsDrawn) {
  const auto map = importTile("<object id='1'><polyline points='0,0 32,0'/></object>", thick(1));
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 31, 32, 32)}));
}

TEST(TiledPolylines, TheThicknessIsANumberFromNothingOn) {
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(refusalOf(mapXml(""), thick(bad)),
              "maps/test.tmx: the thickness of polylines should be 0 or more (Options::polylineThickness)");
  }
}

}  // namespace
}  // namespace lgs::tiled
