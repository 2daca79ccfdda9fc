// Reading Tiled maps: encodings, layers, flips, objects, blocks, and the project's own map.
#include "maps.h"
#include "packed.h"
#include "proptests/support/must.h"

namespace lgs::tiled {
namespace {

TEST(TiledEncodings, AllGiveTheSameTiles) {
  const std::string raw = rawTiles({1, 0, 1, 0, 1, 0});
  const std::vector<std::string> layers = {
      "<data encoding='csv'>1,0,1,\n0,1,0\n</data>",
      "<data><tile gid='1'/><tile/><tile gid='1'/><tile gid='0'/><tile gid='1'/><tile/></data>",
      "<data encoding='base64'>\n   " + base64(raw) + "\n  </data>",
      "<data encoding='base64' compression='zlib'>" + base64(deflated(raw, 15)) + "</data>",
      "<data encoding='base64' compression='gzip'>" + base64(deflated(raw, 15 + 16)) + "</data>",
      "<data encoding='base64' compression='zstd'>" + base64(zstdPacked(raw)) + "</data>",
  };
  for (const std::string& layer : layers) {
    EXPECT_EQ(cellsOf(mustImport(dataLayer(layer))), (Cells{{1, -2}, {0, -1}, {2, -1}})) << layer;
  }
}

TEST(TiledEncodings, BombsAndDamageAreRefused) {
  const auto refusal = [](const std::string& attributes, const std::string& bytes) {
    return refusalOf(mapXml(dataLayer("<data encoding='base64' " + attributes + ">" + base64(bytes) + "</data>")));
  };
  const std::string bomb(8'000'000, '\0');
  const std::string zlib = deflated(rawTiles({1, 0, 1, 0, 1, 0}), 15);
  EXPECT_THAT(refusal("compression='zlib'", deflated(bomb, 15)), HasSubstr("more than the 6 tiles"));
  EXPECT_THAT(refusal("compression='zstd'", zstdPacked(bomb)), HasSubstr("more than the 6 tiles of its size"));
  EXPECT_THAT(refusal("compression='zlib'", zlib.substr(0, 8)), HasSubstr("damaged"));
  EXPECT_THAT(refusal("compression='zstd'", zlib), HasSubstr("Unknown frame"));
  EXPECT_THAT(refusal("compression='lzma'", zlib), HasSubstr("unknown compression 'lzma'"));
  EXPECT_THAT(refusal("", rawTiles({1, 2})), HasSubstr("holds 2 tiles where its size asks for 6"));
}

TEST(TiledLayers, InfiniteMapsHaveNegativeCells) {
  const std::string layer =
      "<layer name='L' width='30' height='20'><data encoding='csv'>"
      "<chunk x='-16' y='-16' width='2' height='2'>0,0,0,1</chunk><chunk x='0' y='0' width='2' height='1'>1,0</chunk>"
      "</data></layer>";
  const auto map = mustImportFiles({{"maps/test.tmx", mapXml(tilesetXml({kFullTile}) + layer, "infinite='1'")}});
  EXPECT_EQ(cellsOf(map), (Cells{{0, -1}, {-15, 14}}));
  const std::string empty = "<layer name='L' width='30' height='20'><data encoding='csv'/></layer>";
  EXPECT_TRUE(mustImportFiles({{"maps/test.tmx", mapXml(empty, "infinite='1'")}}).placements.empty());
}

TEST(TiledLayers, GroupsOffsetsAndChoice) {
  const std::string content =
      tilesetXml({kFullTile}) + "<group name='World' offsetx='32'>" +
      "<layer name='A' width='1' height='1' offsety='-64'><data encoding='csv'>1</data></layer>" +
      "<layer name='B' width='1' height='1'><data encoding='csv'>1</data></layer></group>" +
      "<layer name='A' width='1' height='1'><data encoding='csv'>1</data></layer>";
  EXPECT_EQ(cellsOf(mustImport(content)), (Cells{{0, -1}, {1, -1}, {1, 1}}));
  EXPECT_EQ(cellsOf(mustImport(content, {.layers = {"World/B"}})), (Cells{{1, -1}}));
  EXPECT_EQ(cellsOf(mustImport(content, {.layers = {"World"}})), (Cells{{1, -1}, {1, 1}}));
  EXPECT_EQ(cellsOf(mustImport(content, {.layers = {"A"}})), (Cells{{0, -1}, {1, 1}}));
  EXPECT_THAT(refusalOf(mapXml(content), {.layers = {"C"}}), HasSubstr("has no tile layer or group 'C'"));
}

TEST(TiledTilesets, OneThatTiledHasInItselfIsNoFile) {
  const auto map = mustImport(tilesetXml({kFullTile}) + "<tileset firstgid='9' source=':/automap-tiles.tsx'/>" +
                              csvLayer(2, 1, "1,9"));
  EXPECT_EQ(cellsOf(map), (Cells{{0, -1}}));
  EXPECT_EQ(map.report.partial, "") << "nothing is missing";
}

TEST(TiledLayers, AShiftAgainstTheGridIsCarried) {
  const auto map = mustImport(tilesetXml({kFullTile}) + csvLayer(1, 1, "1", "offsetx='8' offsety='0'"));
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(8, 0, 32, 32)}));
  EXPECT_EQ(ringsIn(map, {1, -1}), (Rings{pxBox(0, 0, 8, 32)}));
}

TEST(TiledTilesets, ExternalFilesAreFoundBesideTheMap) {
  const Files files = {
      {"maps/test.tmx", mapXml("<tileset firstgid='1' source='../sets/a.tsx'/><tileset firstgid='10' source='b.tsx'/>" +
                               csvLayer(3, 1, "1,10,11"))},
      {"sets/a.tsx", tilesOf32(tileXml(0, kFullTile), "")},
      {"maps/b.tsx", tilesOf32(tileXml(1, kFullTile), "name='b'")}};
  const auto map = mustImportFiles(files);
  EXPECT_EQ(cellsOf(map), (Cells{{0, -1}, {2, -1}}));
  ASSERT_EQ(map.report.tiles.size(), 3U);
  EXPECT_EQ(map.report.tiles[0].tileset, "a");
  EXPECT_FALSE(map.report.tiles[1].hasShapes);
  EXPECT_EQ(cellsOf(mustImportFiles(files, {.solidWithoutShapes = true})), (Cells{{0, -1}, {1, -1}, {2, -1}}));
}

TEST(TiledTilesets, LargerTilesStandOnTheirCellAndReachIntoOthers) {
  const std::string large =
      "<tileset firstgid='1' tilewidth='64' tileheight='48'><tileoffset x='0' y='16'/><tile id='0'>"
      "<objectgroup><object id='1' x='0' y='0' width='64' height='48'/></objectgroup></tile></tileset>";
  const auto map = mustImport(large + csvLayer(1, 2, "0,1"));
  // The image is 48 high and hangs 16 below its cell's lower edge.
  EXPECT_EQ(cellsOf(map), (Cells{{0, -3}, {1, -3}, {0, -2}, {1, -2}}));
  EXPECT_EQ(ringsIn(map, {1, -3}), (Rings{pxBox(0, 16, 32, 32)}));
  EXPECT_EQ(ringsIn(map, {1, -2}), (Rings{kSquare}));
  std::string fitted = large;
  fitted.insert(fitted.find(" firstgid"), " tilerendersize='grid'");
  fitted.replace(fitted.find("y='16'"), 6, "y='0' ");
  EXPECT_EQ(ringsIn(mustImport(fitted + csvLayer(1, 1, "1")), {0, -1}), (Rings{kSquare}));
}

TEST(TiledFlips, AllEight) {
  const std::string tile =
      "<object id='1' x='0' y='0'><polygon points='0,32 0,0 8,16'/></object>";  // on the left side, 8 wide
  const std::uint32_t h = 0x80000000, v = 0x40000000, d = 0x20000000;
  const std::vector<std::pair<std::uint32_t, Ring>> cases = {
      {0, px({{0, 0}, {8, 16}, {0, 32}})},     {h, px({{24, 16}, {32, 0}, {32, 32}})},
      {v, px({{0, 0}, {8, 16}, {0, 32}})},     {h | v, px({{24, 16}, {32, 0}, {32, 32}})},
      {d, px({{0, 32}, {16, 24}, {32, 32}})},  {d | h, px({{0, 32}, {16, 24}, {32, 32}})},
      {d | v, px({{0, 0}, {32, 0}, {16, 8}})}, {d | h | v, px({{0, 0}, {32, 0}, {16, 8}})}};
  const std::string skew =
      "<object id='1' x='0' y='0'><polygon points='0,0 16,0 0,8'/></object>";  // it looks different in all eight flips
  const std::vector<std::pair<std::uint32_t, Ring>> skewCases = {
      {0, px({{0, 24}, {16, 32}, {0, 32}})},  {h, px({{16, 32}, {32, 24}, {32, 32}})},
      {v, px({{0, 0}, {16, 0}, {0, 8}})},     {h | v, px({{16, 0}, {32, 0}, {32, 8}})},
      {d, px({{0, 16}, {8, 32}, {0, 32}})},   {d | h, px({{24, 32}, {32, 16}, {32, 32}})},
      {d | v, px({{0, 0}, {8, 0}, {0, 16}})}, {d | h | v, px({{24, 0}, {32, 0}, {32, 16}})}};
  for (const auto& [object, flips] : {std::pair(tile, cases), {skew, skewCases}}) {
    for (const auto& [flags, ring] : flips) {
      const auto map = mustImport(tilesetXml({object}) + csvLayer(1, 1, std::to_string(1 + flags)));
      EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{ring})) << object << ": " << std::hex << flags;
    }
  }
}

TEST(TiledObjects, OffsetsAndRotation) {
  const Ring lowerHalf = pxBox(0, 0, 32, 16);
  for (const char* objects :
       {"<object id='1' x='0' y='16' width='32' height='16'/>",
        "<object id='1' x='32' y='16' width='16' height='32' rotation='90'/>",
        "<object id='1' x='32' y='32' width='32' height='16' rotation='-180'/>",
        "<object id='1' x='0' y='32' width='16' height='32' rotation='270'/>",
        "<object id='1' x='10' y='26' rotation='360'><polygon points='-10,6 -10,-10 22,-10 22,6'/></object>"}) {
    EXPECT_EQ(ringsIn(importTile(objects), {0, -1}), (Rings{lowerHalf})) << objects;
  }
  const std::string shifted =
      "<tileset firstgid='1' tilewidth='32' tileheight='32'><tile id='0'><objectgroup offsetx='4' "
      "offsety='8'><object x='-4' y='8' width='32' height='16'/></objectgroup></tile></tileset>";
  EXPECT_EQ(ringsIn(mustImport(shifted + csvLayer(1, 1, "1")), {0, -1}), (Rings{lowerHalf}));
  const auto diamond = importTile("<object id='1' x='16' y='2' width='16' height='16' rotation='45'/>");
  EXPECT_NEAR(areaInCells(diamond), 0.25, 1e-4);
}

TEST(TiledObjects, CurvesArePolygonsAndTheRestIsLeftOut) {
  const Options exact{.tolerance = 0};
  const auto ellipse = importTile("<object id='7' x='0' y='8' width='32' height='16'><ellipse/></object>", exact);
  EXPECT_EQ(ellipse.shapes.at(0).size(), static_cast<std::size_t>(kCurveVertices));
  EXPECT_NEAR(areaInCells(ellipse), 3.14159 / 8, 0.003);
  const auto capsule = importTile("<object id='7' x='8' y='0' width='16' height='32'><capsule/></object>", exact);
  EXPECT_EQ(capsule.shapes.at(0).size(), static_cast<std::size_t>(kCurveVertices) + 2);
  EXPECT_NEAR(areaInCells(capsule), 0.25 + 3.14159 / 16, 0.003);
  EXPECT_THAT(noteKinds(capsule), ElementsAre(NoteKind::approximated));
  const auto rest = importTile(
      "<object id='1' x='1' y='1'><point/></object><object id='2'><polyline points='0,0 4,4'/></object>"
      "<object id='3' width='9' height='9'><text>hi</text></object><object id='4' width='0' height='5'/>"
      "<object id='5' template='a.tx'/><object id='6' gid='1' width='32' height='32'/>"
      "<object id='7' x='1e300' width='4' height='4'/><object id='8'><polygon points='0,0 9,9 18,18'/></object>"
      "<object id='9'><polygon points='0,0 9,9'/></object>");
  EXPECT_TRUE(rest.placements.empty());
  EXPECT_EQ(noteKinds(rest), std::vector<NoteKind>(9, NoteKind::leftOut));
}

TEST(TiledBlocks, ByClassAndByLayer) {
  const std::string halves =
      "<object id='1' width='32' height='16'/><object id='2' class='ice' y='16' width='32' height='16'/>";
  const std::string set =
      tilesOf32(tileXml(0, halves, "class='stone'") + tileXml(1, kFullTile, "type='lava'") + tileXml(2, kFullTile));
  const std::string layers =
      "<layer name='A' width='3' height='1'><data encoding='csv'>1,2,3</data></layer>"
      "<layer name='B' width='3' height='2'><data encoding='csv'>0,0,0,2,0,0</data></layer>";
  const auto blocks = [&](const Options& options) {
    return blocksOf(mustImport(set + layers, options));  // the lower row first
  };
  EXPECT_THAT(blocks({}), ElementsAre(1, 1, 1, 1, 1));
  EXPECT_THAT(blocks({.blockFrom = BlockFrom::tileClass}), ElementsAre(3, 1, 2, 3, 4));
  EXPECT_THAT(blocks({.blockFrom = BlockFrom::tileClass, .blocks = {{"lava", 1}, {"ice", 90}}}),
              ElementsAre(1, 2, 90, 1, 3));
  EXPECT_THAT(blocks({.blockFrom = BlockFrom::layer, .blocks = {{"B", 7}}}), ElementsAre(7, 1, 1, 1, 1));
}

TEST(TiledMap, SidesAreWholeNumbersFromNothingOn) {
  const std::string content = tilesetXml({kFullTile}) + csvLayer(1, 1, "1");
  for (const char* size : {"width='1' height='1'", "width='0' height='0'", ""})
    EXPECT_EQ(refusalOf(mapXml(content, size)), "accepted") << size;
  for (const char* size : {"width='-1' height='1'", "width='1' height='-1'", "width='1.5' height='1'"})
    EXPECT_THAT(refusalOf(mapXml(content, size)), HasSubstr("should be a whole number from 0 to ")) << size;
}

TEST(TiledMap, TilesetsMayBeEmptyAndTilesAPixel) {
  EXPECT_EQ(refusalOf(mapXml("<tileset firstgid='1' tilewidth='1' tileheight='1' tilecount='0'><image/></tileset>")),
            "accepted");
  for (const char* wrong : {"tilewidth='0' tileheight='1' tilecount='1'", "tilewidth='1' tileheight='0' tilecount='1'",
                            "tilewidth='1' tileheight='1' tilecount='-1'"})
    EXPECT_THAT(refusalOf(mapXml("<tileset firstgid='1' " + std::string(wrong) + "><image/></tileset>")),
                HasSubstr("should be a whole number"))
        << wrong;
}

TEST(TiledMap, TilesetsMayComeInAnyOrder) {
  const auto tileset = [](int first, const std::string& object) {
    return tilesOf32(tileXml(1, object), fmt::format("firstgid='{}' tilecount='2'", first));
  };
  const std::string first = tileset(1, kFullTile), half = "<object id='1' width='32' height='16'/>";
  const std::string second = tileset(3, half), third = tileset(5, kFullTile), layer = csvLayer(3, 1, "2,4,6");
  const ImportedMap sorted = mustImport(first + second + third + layer);
  ASSERT_EQ(ringsIn(sorted, {0, -1}), Rings{kSquare});
  ASSERT_NE(ringsIn(sorted, {1, -1}), Rings{kSquare});
  const ImportedMap turned = mustImport(third + second + first + layer);
  for (const std::int32_t i : {0, 1, 2}) EXPECT_EQ(ringsIn(turned, {i, -1}), ringsIn(sorted, {i, -1})) << i;
}

TEST(TiledBlocks, AreFoundByName) {
  const std::string set = "<tileset firstgid='1' tilewidth='16' tileheight='16' tilecount='2'>" +
                          tileXml(0, kFullTile, "class='ice'") + tileXml(1, kFullTile) + "</tileset>";
  const auto import = [&](const std::string& tiles, const Options& options) {
    return mustImport(set + "<layer name='A' width='2' height='1'><data encoding='csv'>" + tiles + "</data></layer>",
                      options);
  };
  Options options{.blocks = {{"lava", 5}}};
  EXPECT_EQ(import("1,2", options).block("lava"), std::nullopt) << "all are of one block";
  EXPECT_EQ(import("1,2", options).report.notes.size(), 1U) << "that the number is not used";

  options.blockFrom = BlockFrom::tileClass;
  for (const char* tiles : {"1,2", "2,1"}) {  // whichever comes first
    const ImportedMap map = import(tiles, options);
    for (const MapPolygon& p : map.placements)
      EXPECT_EQ(p.block, map.block((tiles[0] == '1') == (p.cell.i == 0) ? "ice" : ""));
    EXPECT_NE(map.block("ice"), map.block(""));
    EXPECT_EQ(map.block("lava"), 5U) << "the map does not use it";
    EXPECT_EQ(map.block("water"), std::nullopt);
  }
  EXPECT_THAT(import("1,2", options).report.notes,
              ElementsAre("blocks are numbered in the order of their first use: ice, (no class). An edit of "
                          "the map may change the numbers. Choose them, or look them up by name",
                          "no tile, object or object layer has the class 'lava'; there is 'ice'"));
  options.blocks = {{"", 2}, {"ice", 7}};
  EXPECT_EQ(import("1,2", options).block("ice"), 7U);
  EXPECT_TRUE(import("1,2", options).report.notes.empty()) << "all numbers were chosen";
}

TEST(TiledMap, TheProjectsOwn) {
  const auto map =
      test::must(importMap(LGS_SOURCE_DIR "/examples/maps/landscape.tmx", {.blockFrom = BlockFrom::tileClass}));
  const World world = worldOf(map);
  EXPECT_GE(map.report.width, 150);
  EXPECT_GE(map.report.height, 40);
  EXPECT_GT(map.report.polygons, 3'000U);
  EXPECT_EQ(map.report.blocks.size(), 5U);
  EXPECT_GT(world.loops().size(), 10U);
  const std::string text = toText(map.report);
  EXPECT_THAT(text, HasSubstr("coordinates put on the grid, by up to 0.4 px"));
  EXPECT_THAT(text, Not(HasSubstr("Left out")));
}

}  // namespace
}  // namespace lgs::tiled
