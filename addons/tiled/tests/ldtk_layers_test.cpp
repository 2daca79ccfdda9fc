// LDtk projects: layers whose tiles are only drawn, and which of several worlds is read.
#include "ldtk_projects.h"

namespace lgs::tiled {
namespace {

TEST(TiledLdtk, LayersThatAreOnlyDrawn) {
  const std::string drawn = R"({"__identifier":"Deco", "__type":"AutoLayer", "layerDefUid":9, "__gridSize":4})";
  const auto map = mustImportProject(project(level("A", 0, 0, drawn + "," + grid("1,0,0,0,0,0", "Other", 2))));
  ASSERT_EQ(map.report.layers.size(), 2U);
  EXPECT_EQ(map.report.layers.at(0).note,
            "scrolls at its own speed (parallax); imported where it stands in the editor");
  EXPECT_EQ(map.report.layers.at(1).note, "tiles that are only drawn");
}

/// A tile layer of 8 px cells, by lists of "px" and number.
std::string tiles(const std::string& list, const std::string& type = "Tiles", const std::string& more = "") {
  return "{\"__identifier\":\"Deco\", \"__type\":\"" + type +
         "\", \"__gridSize\":8, \"layerDefUid\":9, \"__tilesetDefUid\":21, " + more + "\"" +
         (type == "Tiles" ? "gridTiles" : "autoLayerTiles") + "\":[" + list + "]}";
}

std::string tile(int x, int y, const std::string& number) {
  return "{\"px\":[" + std::to_string(x) + "," + std::to_string(y) + "], \"t\":" + number + "}";
}

std::string projectWithTiles(const std::string& layers, const std::string& size = "8") {
  std::string text = project(level("A", 8, 0, layers));
  return text.insert(text.find("\"entities\""), "\"tilesets\":[{\"uid\":21, \"tileGridSize\":" + size +
                                                    ", \"enumTags\":[{\"enumValueId\":\"Hard\", \"tileIds\":[4, 70, "
                                                    "-1]}, {\"enumValueId\":\"Soft\", \"tileIds\":[5]}]}], ");
}

TEST(TiledLdtk, TilesThatAreOnlyDrawnCanBeSolid) {
  const std::string two = tile(0, 0, "70") + "," + tile(16, 8, "5") + "," + tile(16, 8, "5");
  const std::string astray = tile(-8, 8, "70") + "," + tile(4, 0, "70");
  const std::string ground = grid("0,3,0,0,0,0");
  for (const char* type : {"Tiles", "AutoLayer"}) {
    const std::string text = projectWithTiles(tiles(two + "," + astray, type) + "," + ground);
    EXPECT_EQ(cellsOf(mustImportProject(text)), (Cells{{2, -1}}));
    const auto map = mustImportProject(text, {.solidWithoutShapes = true});
    EXPECT_EQ(cellsOf(map), (Cells{{0, -2}, {3, -2}, {1, -1}, {2, -1}}));
    EXPECT_THAT(blocksOf(map), ElementsAre(4, 4, 4, 3)) << "no block of a value";
    EXPECT_EQ(map.block("Deco"), 4U);
    EXPECT_EQ(map.report.layers.at(1).note, "1 tiles beside the grid are left out");
    EXPECT_EQ(map.report.layers.at(1).tiles, 3U) << "the same tile twice in a cell is one";
    EXPECT_EQ(cellsOf(mustImportProject(text, {.solidWithoutShapes = true, .layers = {"Deco"}})).size(), 3U);
    EXPECT_EQ(cellsOf(mustImportProject(text, {.solidIf = {"Hard"}})), (Cells{{0, -2}, {1, -1}, {2, -1}})) << "by tags";
  }
}

/// What is only drawn is no evidence beside the cells of an IntGrid layer, whatever it is called and its grid.
TEST(TiledLdtk, TilesThatAreOnlyDrawnDoNotSayWhatIsSolid) {
  const auto called = [](const std::string& name, const std::string& grid, std::string layer) {
    layer.replace(layer.find("Deco"), 4, name);
    layer.replace(layer.find("Size\":8") + 6, 1, grid);
    return layer;
  };
  const std::string two = tile(0, 0, "70") + "," + tile(16, 8, "5");
  EXPECT_TRUE(mustImportProject(projectWithTiles(called("Ground", "8", tiles(tile(0, 0, "70"))))).placements.empty());
  for (const char* name : {"Solid", "Cells"}) {  // one says that it is solid, one says nothing
    const auto map = mustImportProject(projectWithTiles(
        called("Walls", "8", tiles(two)) + "," + called("Ground", "4", tiles(two)) + "," + grid("0,3,0,0,0,0", name)));
    EXPECT_EQ(cellsOf(map), (Cells{{2, -1}})) << name;
    EXPECT_EQ(map.report.partial, "") << name;
    EXPECT_EQ(map.report.choice, std::string("IntGrid layers: ") + name);
  }
}

/// A project in which the value 2 of the first IntGrid layer has another name.
std::string withValue(const std::string& name, const std::string& layers) {
  std::string text = project(level("A", 0, 0, layers));
  return text.replace(text.find("\"ice\""), 5, '"' + name + '"');
}

TEST(TiledLdtk, NamesOfValuesAndLayersSayWhatIsNoGround) {
  EXPECT_EQ(cellsOf(mustImportProject(withValue("Empty", grid("2,1,0,0,0,0")))), (Cells{{1, -1}}));
  const auto terrain = mustImportProject(withValue("Terrain", grid("2,1,0,0,0,0")));
  EXPECT_EQ(terrain.placements.size(), 2U);
  ASSERT_FALSE(terrain.report.suggestions.empty());
  EXPECT_EQ(
      cellsOf(mustImportProject(withValue("Terrain", grid("2,1,0,0,0,0")), terrain.report.suggestions[0].options)),
      (Cells{{0, -1}}))
      << "first what says that it is ground is offered";
  const auto two = [](const char* a, const char* b) {
    return mustImportProject(project(level("A", 0, 0, grid("1,1,1,1,1,1", a) + "," + grid("0,1,0,0,0,0", b, 2))));
  };
  for (const auto& [none, ground] : {std::pair("Background", "Foreground"), {"Floor", "Walls"}}) {
    const auto map = two(none, ground);
    EXPECT_EQ(cellsOf(map), (Cells{{1, -1}})) << none;
    ASSERT_FALSE(map.report.suggestions.empty());
    EXPECT_EQ(map.report.suggestions.back().polygons, 6U) << "all of them are offered";
  }
  EXPECT_EQ(two("Ground", "Solid").placements.size(), 6U);
}

TEST(TiledLdtk, ALayerOfTilesHasABlockThatNoValueHas) {
  std::string text = projectWithTiles(tiles(tile(0, 0, "70")) + "," + grid("0,3,0,0,0,0"));
  text.replace(text.find("\"dirt\""), 6, "\"Deco\"");
  const auto map = mustImportProject(text, {.solidWithoutShapes = true});
  EXPECT_THAT(blocksOf(map), ElementsAre(4, 3));
  EXPECT_EQ(map.block("Deco.Deco"), 4U);
}

TEST(TiledLdtk, WhatIsSaidOfTilesThatAreOnlyDrawn) {
  const std::string text = projectWithTiles(tiles(tile(0, 0, "70")));
  EXPECT_EQ(refusalOf(text, {.layers = {"Deco"}}),
            "maps/test.tmx: 'Deco' is a layer of tiles that are only drawn: --solid --layer Deco");
  const auto empty = mustImportProject(text);
  ASSERT_EQ(empty.report.suggestions.size(), 1U);
  EXPECT_EQ(empty.report.suggestions[0].text, "tile layer Deco, 100 % of the map: nothing says what it is");
  EXPECT_THAT(empty.report.suggestions[0].arguments, ElementsAre("--layer", "Deco", "--solid"));
  const std::string at = "maps/test.tmx: levels/0/layerInstances/0";
  const std::string large = projectWithTiles(tiles(tile(0, 0, "70")) + "," + grid("1,0,0,0,0,0"), "16");
  EXPECT_EQ(cellsOf(mustImportProject(large, {.solidWithoutShapes = true, .layers = {"Deco"}})),
            (Cells{{1, -2}, {2, -2}, {1, -1}, {2, -1}}))
      << "from the upper left corner of its cell";
  EXPECT_EQ(refusalOf(projectWithTiles(tiles("{\"px\":[1], \"t\":1}"))), at + "/gridTiles/0/px should be two numbers");
  for (const char* bad : {"-1", "0.5", "1048576"}) {
    EXPECT_EQ(refusalOf(projectWithTiles(tiles(std::string("{\"px\":[8,8], \"t\":") + bad + "}"))),
              at + "/gridTiles/0/t should be a whole number from 0 to 1048575");
  }
  std::string many;
  for (int uid = 100; uid < 228; ++uid) {
    std::string one = tiles(tile(0, 0, "70"));
    one.replace(one.find("\"layerDefUid\":9"), 15, "\"layerDefUid\":" + std::to_string(uid));
    many += (uid > 100 ? "," : "") + one;
  }
  EXPECT_EQ(refusalOf(projectWithTiles(many), {.solidWithoutShapes = true, .layers = {"Solid"}}),
            "maps/test.tmx: <map> has no tile layer or group 'Solid'; there are 'A', 'Deco'");
  const auto all = mustImportProject(projectWithTiles(many), {.solidWithoutShapes = true});
  EXPECT_EQ(all.report.layers.back().note, "one layer of tiles too many: they are left out");
}

TEST(TiledLdtk, OneWorldAtATime) {
  const auto named = [](const std::string& world) {
    return "{\"identifier\":\"" + world + "\", \"worldLayout\":\"Free\", \"levels\":[" +
           level(world + "1", world == "Sea" ? 0 : 8, 0, grid("1,0,0,0,0,0")) + "]}";
  };
  const auto with = [&](const std::string& worlds) { return project("", "", "\"worlds\":[" + worlds + "],"); };
  EXPECT_EQ(cellsOf(mustImportProject(with(named("Sky")))), (Cells{{1, -1}}));
  const std::string both = with(named("Sky") + "," + named("Sea"));
  EXPECT_EQ(refusalOf(both),
            "maps/test.tmx: <map> has several worlds, which lie over each other: choose one of Sea, Sky "
            "(Options::layers)");
  EXPECT_EQ(cellsOf(mustImportProject(both, {.layers = {"Sky"}})), (Cells{{1, -1}}));
}

/// A world with the levels given, and one called "Sky".
std::string skyAnd(const std::string& world, const std::string& levels, const std::string& ofSky) {
  const auto named = [](const std::string& name, const std::string& all) {
    return "{\"identifier\":\"" + name + "\", \"worldLayout\":\"Free\", \"levels\":[" + all + "]}";
  };
  return project("", "", "\"worlds\":[" + named(world, levels) + "," + named("Sky", ofSky) + "],");
}

TEST(TiledLdtk, TheWorldThatIsChosenIsAllThatIsRead) {
  const std::string boulder = entity("Boulder", 11, "\"px\":[8,0], \"width\":8, \"height\":8");
  const std::string fine = grid("1,0,0,0,0,0", "Fine", 5, "\"__gridSize\":4, ");
  std::string deep = level("Sea2", 800, 0, fine);
  deep.replace(deep.find("\"worldDepth\":0"), 14, "\"worldDepth\":1");
  const std::string both = skyAnd("Sea", level("Sea1", 0, 0, things(boulder) + "," + fine) + "," + deep,
                                  level("Sky1", 0, 0, things(boulder) + "," + grid("1,0,0,0,0,0")));
  const auto sky = mustImportProject(both, {.layers = {"Sky"}, .objects = std::vector<std::string>{"Boulder"}});
  EXPECT_EQ(cellsOf(sky), (Cells{{1, -2}, {0, -1}})) << "not the boulder of the other world";
  EXPECT_EQ(sky.report.width, 3);
  EXPECT_EQ(sky.report.height, 2);
  EXPECT_EQ(sky.report.layers.size(), 2U);
  EXPECT_EQ(sky.report.layers.at(0).path, "Sky/Sky1/Solid");
  EXPECT_TRUE(sky.report.notes.empty() || sky.report.notes.at(0).find("depths") == std::string::npos);
  const auto sea = mustImportProject(both, {.layers = {"Sea"}, .objects = std::vector<std::string>{"Boulder"}});
  EXPECT_EQ(sea.report.tileWidth, 4);
  EXPECT_EQ(sea.report.width, 206);
  EXPECT_THAT(sea.report.notes.at(0), HasSubstr("depths"));
  EXPECT_THAT(refusalOf(both, {.layers = {"Sky", "Sea"}, .objects = std::vector<std::string>{"Boulder"}}),
              HasSubstr("choose one of Sea, Sky"));
}

}  // namespace
}  // namespace lgs::tiled
