// Open polylines that are one-way become thin polygons, if that is asked for.
#include "maps.h"

#include <cmath>
#include <limits>

namespace lgs::tiled {
namespace {

std::string polyline(const std::string& points, const std::string& attributes = "class='one-way'",
                     const std::string& properties = "") {
  return "<object id='1' x='0' y='8' " + attributes + ">" + properties + "<polyline points='" + points + "'/></object>";
}

Options thick(double pixels) {
  const Options options{.polylineThickness = pixels};
  return options;
}

TEST(TiledOneWay, ThePolygonLiesBelowThePolyline) {
  const Ring slab = px({{0, 20}, {32, 4}, {32, 8}, {0, 24}});
  for (const char* points : {"0,0 32,16", "32,16 0,0", "0,0 16,8 32,16"}) {
    for (const auto& map : bothWays(polyline(points), thick(4))) {
      EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{slab})) << points;
      EXPECT_THAT(noteTexts(map), ElementsAre("a one-way polyline became a polygon, 4 px thick"));
    }
  }
}

TEST(TiledOneWay, NeighbouringPiecesHaveNoSeam) {
  const auto map =
      mustImport(tilesetXml({polyline("0,0 32,-8"), polyline("0,-8 20,4 32,0")}) + csvLayer(2, 1, "1,2"), thick(3));
  EXPECT_EQ(areaInCells(map) * 1024, 2 * 32 * 3);
  EXPECT_EQ(worldOf(map).loops().size(), 1U);
}

TEST(TiledOneWay, OnlyOnRequestAndTheReportSaysHow) {
  const std::string how =
      "an open polyline has no area: as it is one-way, --polyline-thickness PIXELS makes a thin polygon";
  const std::string say =
      "an open polyline has no area: close it, or give it the class one-way, and it becomes a thin polygon";
  for (const auto& map : bothWays(polyline("0,0 32,0"))) {
    EXPECT_TRUE(map.placements.empty());
    EXPECT_THAT(noteTexts(map), ElementsAre(how));
  }
  for (const auto& map : {importTile(polyline("0,0 32,0", "class='rope'"), thick(4)),
                          mustImport(objectLayer(polyline("0,0 32,0", "")), thick(4))}) {
    EXPECT_TRUE(map.placements.empty());
    EXPECT_THAT(noteTexts(map), ElementsAre(say));
  }
  const std::string plain = "an open polyline has no area: close it, or draw a polygon instead";
  EXPECT_THAT(noteTexts(importTile(polyline("0,0 32,0", ""))), ElementsAre(plain));
  EXPECT_THAT(noteTexts(importTile(polyline("0,0 0,32", ""), thick(4))), ElementsAre(plain));
}

TEST(TiledOneWay, WhatSaysSo) {
  const auto taken = [](const std::string& content) { return !mustImport(content, thick(4)).placements.empty(); };
  const auto ofObject = [&](const std::string& attributes, const std::string& properties = "") {
    return taken(objectLayer(polyline("0,0 32,0", attributes, properties)));
  };
  for (const char* word : {"one-way", "OneWay", "one_way_slope", "One Way", "platform 3", "jump-through", "JumpThru"}) {
    EXPECT_TRUE(ofObject("class='" + std::string(word) + "'")) << word;
    EXPECT_TRUE(ofObject("type='" + std::string(word) + "'")) << word;
    EXPECT_TRUE(ofObject("name='" + std::string(word) + "'")) << word;
    EXPECT_TRUE(ofObject("", property(word, "true"))) << word;
    EXPECT_FALSE(ofObject("", property(word, "false"))) << word;
    EXPECT_TRUE(taken(objectLayer(polyline("0,0 32,0", ""), "name='Walls, " + std::string(word) + "'"))) << word;
    EXPECT_TRUE(taken(objectLayer(property(word, "1") + polyline("0,0 32,0", "")))) << word;
  }
  for (const char* word : {"", "one", "away", "jump", "way one"}) {
    EXPECT_FALSE(ofObject("class='" + std::string(word) + "'")) << word;
  }
  const auto ofTile = [&](const std::string& attributes, const std::string& properties) {
    return taken("<tileset firstgid='1' tilewidth='32' tileheight='32'><tile id='0' " + attributes + ">" + properties +
                 "<objectgroup>" + polyline("0,0 32,0", "") + "</objectgroup></tile></tileset>" + csvLayer(1, 1, "1"));
  };
  EXPECT_TRUE(ofTile("class='one-way'", ""));
  EXPECT_TRUE(ofTile("", property("oneWay", "true")));
  EXPECT_FALSE(ofTile("", property("oneWay", "0")));
  const std::string object = "<object id='3' gid='1' x='0' y='32' class='platform'/>";
  EXPECT_TRUE(taken(tilesetXml({polyline("0,0 32,0", "")}) + objectLayer(object)));
  const auto ofTemplate = [&](const std::string& here, const std::string& there) {
    const std::string instance = "<object id='1' template='a.tx' x='0' y='0'>" + here + "</object>";
    const std::string text = "<template>" + polyline("0,0 32,0", "", there) + "</template>";
    const Files files{{"maps/test.tmx", mapXml(objectLayer(instance))}, {"maps/a.tx", text}};
    return !mustImportFiles(files, thick(4)).placements.empty();
  };
  EXPECT_TRUE(ofTemplate("", property("oneWay", "true")));
  EXPECT_TRUE(ofTemplate(property("oneWay", "true"), property("oneWay", "false")));
  EXPECT_TRUE(ofTemplate(property("oneWay", "true"), ""));
  EXPECT_FALSE(ofTemplate(property("oneWay", "false"), property("oneWay", "true")));
}

TEST(TiledOneWay, OnlyFromLeftToRight) {
  for (const char* points : {"0,0 0,20", "0,0 8,0 8,8 16,8", "0,0 20,0 16,4", "0,0"}) {
    for (const auto& map : {importTile(polyline(points), thick(4)), mustImport(objectLayer(polyline(points)), thick(4)),
                            importTile(polyline(points))}) {  // a thickness would not help
      EXPECT_TRUE(map.placements.empty()) << points;
      EXPECT_THAT(noteTexts(map),
                  ElementsAre("an open polyline has no area: close it, or let it run from left to right, nowhere "
                              "upright, for a thin polygon"))
          << points;
    }
  }
}

TEST(TiledOneWay, ThinnerThanTheToleranceItStaysAsDrawn) {
  const auto map = importTile("<object id='1' class='oneway'><polyline points='0,0 32,0'/></object>", thick(1));
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 31, 32, 32)}));
}

TEST(TiledOneWay, TheThicknessIsANumberFromNothingOn) {
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(refusalOf(mapXml(""), thick(bad)),
              "maps/test.tmx: the thickness of polylines should be 0 or more (Options::polylineThickness)");
  }
}

}  // namespace
}  // namespace lgs::tiled
