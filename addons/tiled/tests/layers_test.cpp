// Layers of every kind, where their tiles land, and the limits of what is read.
#include "maps.h"

#include <cmath>
#include <limits>

namespace lgs::tiled {
namespace {

std::string oneTile(const std::string& attributes) {
  return "<layer width='1' height='1' " + attributes + "><data encoding='csv'>1</data></layer>";
}

TEST(TiledLayers, WhatIsSaidOfThem) {
  const std::string slow = ": scrolls at its own speed (parallax); imported where it stands in the editor";
  const std::string content =
      tilesetXml({kFullTile}) + "<properties><property name='p'/></properties>" + oneTile("name='A'") +
      oneTile("name='B' parallaxx='0.5'") + oneTile("name='C' parallaxx='1' parallaxy='2'") +
      "<objectgroup name='O'><object id='1' width='9' height='9'/></objectgroup><imagelayer name='I'/>" +
      "<group name='G' parallaxy='0.5'>" + oneTile("name='D'") + "<objectgroup name='O'/><group name='H'>" +
      oneTile("name='A'") + "</group></group>";
  const std::string objects = ": neither its name, its class nor a property says that it is solid]";
  EXPECT_THAT(remarks(mustImport(content)), ElementsAre("A", "B" + slow, "C" + slow, "[O" + objects, "[I: an image]",
                                                        "G/D" + slow, "[G/O" + objects, "G/H/A" + slow));
  Options options{.layers = {"G/H", "B"}};
  EXPECT_THAT(remarks(mustImport(content, options)),
              ElementsAre("[A: not chosen]", "B" + slow, "[C: not chosen]", "[O: not chosen]", "[I: an image]",
                          "[G/D: not chosen]", "[G/O: not chosen]", "G/H/A" + slow));
  for (const char* name : {"I", ""}) {  // these exist, but have nothing to import
    options.layers = {name};
    EXPECT_EQ(refusalOf(mapXml(content), options), "maps/test.tmx:2: <map> has no tile layer or group '" +
                                                       std::string(name) +
                                                       "'; there are 'A', 'B', 'C', 'G', 'G/D', 'G/H' and 1 more");
  }
}

TEST(TiledLayers, AShiftIsToldForEachAxis) {
  const auto shifted = [](const std::string& attributes) {
    const auto map = mustImport(tilesetXml({kFullTile}) + oneTile("name='L' " + attributes));
    return map.report.layers.at(0).note;
  };
  const std::string rest = " against the grid: its polygons reach out of their cells";
  EXPECT_EQ(shifted("offsetx='64' offsety='-32'"), "");
  EXPECT_EQ(shifted("offsetx='8.25'"), "shifted by 8.25 px, 0 px" + rest);
  EXPECT_EQ(shifted("offsety='70'"), "shifted by 0 px, 6 px" + rest);
  const auto map = mustImport(tilesetXml({kFullTile}) + oneTile("name='L' offsety='8'"));
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 0, 32, 24)}));
  EXPECT_EQ(ringsIn(map, {0, -2}), (Rings{pxBox(0, 24, 32, 32)}));
}

TEST(TiledLayers, ChunksAreReadWhateverTheMapSaysOfItself) {
  const std::string chunks =
      "<layer name='L' width='4' height='3'><data encoding='csv'><chunk x='1' y='2' width='1' height='1'>1</chunk>"
      "<chunk x='0' y='0' width='0' height='7'>none of this is read</chunk></data></layer>";
  for (const char* infinite : {"", "infinite='0'", "infinite='1'"}) {
    const auto map = mustImportFiles({{"maps/test.tmx", mapXml(tilesetXml({kFullTile}) + chunks, infinite)}});
    EXPECT_EQ(cellsOf(map), (Cells{{1, -3}})) << infinite;
  }
}

TEST(TiledLayers, OffsetsThatAreTooLarge) {
  const auto refusal = [](const std::string& attributes) {
    return refusalOf(mapXml(tilesetXml({kFullTile}) + oneTile("name='L' " + attributes)));
  };
  const std::string tooLarge = "maps/test.tmx:6: <layer> 'L' its offset is too large";
  for (const char* within : {"offsetx='4294967296'", "offsetx='-4294967296'", "offsety='4294967296'",  // 2^27 tiles
                             "offsety='-4294967296'"}) {
    EXPECT_EQ(refusal(within), "accepted") << within;
  }
  for (const char* beyond :
       {"offsetx='4294967328'", "offsetx='-4294967328'", "offsety='4294967328'", "offsety='-4294967328'"}) {
    EXPECT_EQ(refusal(beyond), tooLarge) << beyond;
  }
}

TEST(TiledLimits, Options) {
  for (const double bad : {-0.5, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_EQ(refusalOf(mapXml(""), {.tolerance = bad}),
              "maps/test.tmx: the tolerance should be 0 or more (Options::tolerance)")
        << bad;
  }
}

TEST(TiledLimits, TilesOfAllLayers) {
  const std::string content = tilesetXml({kFullTile}) + csvLayer(2, 1, "1,0") + csvLayer(2, 2, "0,0,0,1");
  EXPECT_EQ(mustImport(content, {.maxTiles = 6}).placements.size(), 2U);
  EXPECT_EQ(refusalOf(mapXml(content), {.maxTiles = 5}),
            "maps/test.tmx:7: <data> the map has more tiles than the limit (Options::maxTiles)");
}

TEST(TiledLimits, PolygonsPlacedAndCarried) {
  // Each tile has two polygons: one in its cell, one that is carried.
  const std::string content =
      tilesetXml({"<object id='1' x='16' width='32' height='8'/>"}) + csvLayer(4, 1, "1,0,1,1") + csvLayer(1, 1, "1");
  Options options{.maxPlacements = 8};
  EXPECT_EQ(mustImport(content, options).report.tiles.at(0).uses, 4U);
  for (std::size_t most = 0; most < 8; ++most) {
    options.maxPlacements = most;
    EXPECT_EQ(refusalOf(mapXml(content), options),
              "maps/test.tmx:2: <map> the map has more polygons than the limit (Options::maxPlacements)");
  }
}

TEST(TiledTilesets, ImagesOfTheirOwnSizes) {
  // A collection of images. The size of a tile is its own; if it has none, that of its image; else that of the tileset.
  const std::string set =
      "<tileset firstgid='1' tilewidth='64' tileheight='64'>"
      "<tile id='0' width='16' height='32'/><tile id='1'><image source='a' width='32' height='16'/></tile>"
      "<tile id='2' width='32' height='32'><image source='a' width='99' height='99'/></tile>"
      "<tile id='3' width='16'/><tile id='4' height='16'/></tileset>";
  const auto size = [&](int gid) {
    const auto map = mustImport(set + csvLayer(1, 1, std::to_string(gid)), {.solidWithoutShapes = true});
    return std::pair(cellsOf(map), map.shapes.at(0));
  };
  const Cells home{{0, -1}}, four{{0, -1}, {1, -1}, {0, 0}, {1, 0}};
  EXPECT_EQ(size(1), std::pair(home, pxBox(0, 0, 16, 32)));
  EXPECT_EQ(size(2), std::pair(home, pxBox(0, 0, 32, 16)));
  EXPECT_EQ(size(3), std::pair(home, kSquare));
  for (const int gid : {4, 5, 6}) EXPECT_EQ(size(gid), std::pair(four, kSquare)) << gid;
}

TEST(TiledTilesets, TurnedImagesAreFittedToo) {
  const std::string set =
      "<tileset firstgid='1' tilerendersize='grid' tilewidth='64' tileheight='16'><tile id='0'><objectgroup>"
      "<object id='1' width='16' height='16'/></objectgroup></tile></tileset>";  // its left quarter
  const auto turned = mustImport(set + csvLayer(1, 1, std::to_string(1 + 0x2000'0000)));
  EXPECT_EQ(ringsIn(turned, {0, -1}), (Rings{pxBox(0, 24, 32, 32)}));
  const auto straight = mustImport(set + csvLayer(1, 1, "1"));
  EXPECT_EQ(ringsIn(straight, {0, -1}), (Rings{pxBox(0, 0, 8, 32)}));
}

TEST(TiledBlocks, NamesThatShareANumber) {
  const std::string set = tilesOf32(tileXml(0, kFullTile, "class='ice'") + tileXml(1, kFullTile));
  const auto map = mustImport(set + csvLayer(3, 1, "1,2,2"),
                              {.blockFrom = BlockFrom::tileClass, .blocks = {{"", 4}, {"ice", 4}, {"unused", 9}}});
  ASSERT_EQ(map.report.blocks.size(), 1U);
  EXPECT_EQ(map.report.blocks[0].name, "(no class), ice");
  EXPECT_EQ(map.report.blocks[0].block, 4);
  EXPECT_EQ(map.report.blocks[0].polygons, 3U);
}

}  // namespace
}  // namespace lgs::tiled
