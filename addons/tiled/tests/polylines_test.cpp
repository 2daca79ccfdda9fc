// Open polylines become thin polygons, if that is asked for.
#include "meant_maps.h"

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

ImportedMap importMeant(const std::string& layers, const Options& options = {}) {
  return mustImportFiles({{"maps/test.tmx", "<map width='8' height='4' tilewidth='16' tileheight='16'>" +
                                                meant::mapOf("", layers) + "</map>"}},
                         options);
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

/// A chain of edges is all that the author drew.
TEST(TiledPolylines, AloneTheyAreOffered) {
  const std::string chain = "<object id='1' x='0' y='32'><polyline points='0,0 64,0 64,16 128,16'/></object>";
  const auto map =
      importMeant(meant::tiles("picture", "bbbbbbbb/bbbbbbbb/bbbbbbbb/bbbbbbbb") + meant::objects("collision", chain));
  EXPECT_TRUE(map.placements.empty());
  ASSERT_FALSE(map.report.suggestions.empty());
  EXPECT_THAT(map.report.suggestions.front().arguments,
              ElementsAre("--objects", "collision", "--polyline-thickness", "4"));
  Options asked{.objects = std::vector<std::string>{"collision"}};
  EXPECT_EQ(importMeant(meant::objects("collision", chain + meant::box(0, 0, 1, 1)), asked).report.partial,
            "object layer collision, of which 1 open polyline is left out")
      << "also if one has chosen";
  asked.polylineThickness = 2;
  EXPECT_EQ(importMeant(meant::objects("collision", chain), asked).report.partial, "");
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
