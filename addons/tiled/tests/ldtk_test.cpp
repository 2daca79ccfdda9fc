// LDtk projects: where levels, cells and entities land, which blocks they get, and what is said of bad projects.
#include "ldtk_projects.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"

#include <array>
#include <random>

namespace lgs::tiled {
namespace {

TEST(TiledLdtk, CellsBecomeBlocksByTheirValue) {
  const auto map = mustImportProject(project(level("A", 0, 0, grid("1,0,2, 3,7,0"))));
  EXPECT_EQ(cellsOf(map), (Cells{{0, -2}, {1, -2}, {0, -1}, {2, -1}})) << "y points up";
  EXPECT_THAT(blocksOf(map), ElementsAre(3, 7, 1, 2));
  for (const auto& shape : map.shapes) EXPECT_EQ(shape, kSquare);
  std::vector<std::string> names;
  for (const BlockReport& block : map.report.blocks) names.push_back(block.name);
  EXPECT_THAT(names, ElementsAre("dirt", "ice", "3", "7"));
  EXPECT_EQ(map.report.tileWidth, 8);
  EXPECT_EQ(map.report.width, 3);
  EXPECT_EQ(map.report.height, 2);
  ASSERT_EQ(map.report.tiles.size(), 4U);
  EXPECT_EQ(map.report.tiles.at(1).tileset, "Solid");
  EXPECT_EQ(map.report.tiles.at(1).id, 2U) << "the value";
  EXPECT_EQ(map.report.tiles.at(1).className, "ice");
  EXPECT_TRUE(map.report.notes.empty());
  EXPECT_THAT(blocksOf(mustImportProject(project(level("A", 0, 0, grid("1,0,2, 3,7,0"))),
                                         {.blockFrom = BlockFrom::tileClass, .blocks = {{"ice", 40}}})),
              ElementsAre(3, 7, 1, 40));
  const auto byLayer = mustImportProject(project(level("A", 0, 0, grid("1,0,2, 3,7,0"))),
                                         {.blockFrom = BlockFrom::layer, .blocks = {{"ice", 40}}});
  EXPECT_EQ(byLayer.block("Solid"), 1U) << "of all levels";
}

TEST(TiledLdtk, ANameOfTwoValuesGetsTheNameOfItsLayer) {
  const auto map =
      mustImportProject(project(level("A", 0, 0, grid("0,2,0,0,0,0", "Other", 2) + "," + grid("1,0,0,0,0,0"))));
  EXPECT_THAT(blocksOf(map), ElementsAre(1, 2));
  EXPECT_EQ(map.block("dirt"), 1U);
  EXPECT_EQ(map.block("Other.dirt"), 2U);
}

TEST(TiledLdtk, ANameThatIsTakenTwiceGetsTheNumberOfTheValue) {
  const std::string defined = R"({"value":4, "identifier":"dirt"}, {"value":5, "identifier":"dirt"},
                                 {"value":6, "identifier":"Solid.dirt.5"}, )";
  std::string text = project(level("A", 0, 0, grid("1,4,5,6,0,0")));
  text.insert(text.find("{\"value\":2"), defined);
  const auto map = mustImportProject(text);
  EXPECT_EQ(map.block("dirt"), 1U);
  EXPECT_EQ(map.block("Solid.dirt"), 4U);
  EXPECT_EQ(map.block("Solid.dirt.5"), 5U);
  EXPECT_EQ(map.block("Solid.Solid.dirt.5"), 6U);
}

TEST(TiledLdtk, ALayerMayNotHaveALongName) {
  const auto named = [](std::size_t length) {
    return project(level("A", 0, 0, grid("1,0,0,0,0,0", std::string(length, 'x'))));
  };
  EXPECT_EQ(mustImportProject(named(255)).report.layers.at(0).path, "A/" + std::string(255, 'x'));
  EXPECT_EQ(refusalOf(named(256)),
            "maps/test.tmx: levels/0/layerInstances/0/__identifier should have at most 255 bytes");
}

TEST(TiledLdtk, LevelsLieInTheWorld) {
  const std::string one = grid("1,0,0,0,0,0");
  const std::string levels = level("A", 0, 0, one) + "," + level("B", 24, -16, one) + "," + level("C", -8, 16, one);
  for (const char* layout : {"Free", "GridVania"}) {
    const auto map = mustImportProject(project(levels, layout));
    EXPECT_EQ(cellsOf(map), (Cells{{-1, -3}, {0, -1}, {3, 1}})) << layout;
    EXPECT_EQ(map.report.width, 7);
    EXPECT_EQ(map.report.height, 6);
    EXPECT_EQ(map.report.layers.at(1).path, "B/Solid");
  }
  const std::string lined = level("A", -1, -1, one) + "," + level("B", -1, -1, one);
  EXPECT_EQ(cellsOf(mustImportProject(project(lined, "LinearHorizontal"))), (Cells{{0, -1}, {3, -1}}));
  EXPECT_EQ(cellsOf(mustImportProject(project(lined, "LinearVertical"))), (Cells{{0, -3}, {0, -1}}));
}

TEST(TiledLdtk, OffsetsOfLayersAndLevelsBesideTheGrid) {
  const std::string shifted = grid("1,0,0,0,0,0", "Solid", 1, "\"__pxTotalOffsetX\":8, \"__pxTotalOffsetY\":-20, ");
  const auto map = mustImportProject(project(level("A", 16, 20, shifted)));
  EXPECT_EQ(cellsOf(map), (Cells{{3, -1}}));
  EXPECT_EQ(map.report.layers.at(0).note, "") << "together these are whole cells";
  const auto rest = mustImportProject(project(level("A", 2, 0, grid("1,0,0,0,0,0"))));
  EXPECT_EQ(cellsOf(rest), (Cells{{0, -1}, {1, -1}}));
  EXPECT_EQ(rest.report.layers.at(0).note,
            "shifted by 2 px, 0 px against the grid: its polygons reach out of their cells");
}

TEST(TiledLdtk, TheLowestLayerComesFirst) {
  const std::string upper = grid("2,2,0,0,0,0"), lower = grid("1,0,1,0,0,0");
  const auto map = mustImportProject(project(level("A", 0, 0, upper + "," + lower)));
  EXPECT_THAT(blocksOf(map), ElementsAre(1, 2, 1)) << "LDtk lists the uppermost first";
}

TEST(TiledLdtk, EntitiesAreTakenByName) {
  const std::string wall = entity("Wall", 12, "\"px\":[8,0], \"__pivot\":[0,0], \"width\":8, \"height\":16");
  const std::string boulder = entity("Boulder", 11, "\"px\":[20,8], \"__pivot\":[0.5,1], \"width\":8, \"height\":8");
  const std::string spot = entity("Spot", 13, "\"px\":[0,0], \"width\":8, \"height\":8", ", \"__tags\":[\"solid\"]");
  const auto import = [&](const std::string& layer, std::optional<std::vector<std::string>> objects) {
    return mustImportProject(project(level("A", 0, 0, things(wall + "," + boulder, layer))),
                             {.tolerance = 0, .objects = std::move(objects)});
  };
  const auto byWord = import("Things", {});
  EXPECT_EQ(cellsOf(byWord), (Cells{{1, -3}, {1, -2}})) << "below the offset of the layer";
  EXPECT_EQ(byWord.report.layers.at(0).path, "A/Things/Wall");
  EXPECT_EQ(byWord.report.layers.at(0).note, "its name says 'wall'");
  EXPECT_FALSE(byWord.report.layers.at(1).imported);
  EXPECT_EQ(byWord.placements.at(0).object, 1U) << "the first of its layer";
  EXPECT_EQ(byWord.block("Wall"), 1U);
  const auto boulders = import("Things", std::vector<std::string>{"Boulder"});
  EXPECT_EQ(cellsOf(boulders), (Cells{{2, -2}}));
  EXPECT_NEAR(areaInCells(boulders), 0.78, 0.01) << "an ellipse, where its pivot puts it";
  EXPECT_EQ(boulders.placements.at(0).object, 2U);
  EXPECT_EQ(cellsOf(import("Things", std::vector<std::string>{"Things"})).size(), 3U);
  EXPECT_EQ(cellsOf(import("Things", std::vector<std::string>{})).size(), 0U);
  EXPECT_EQ(cellsOf(import("Collision", {})).size(), 3U) << "the layer says so";
  const auto byTag = mustImportProject(project(level("A", 0, 0, things(spot))));
  EXPECT_EQ(byTag.report.layers.at(0).note, "its property 'solid' says so");
  EXPECT_EQ(cellsOf(byTag), (Cells{{0, -2}}));
}

/// Entities get the numbers that no value of an IntGrid layer has.
TEST(TiledLdtk, EntitiesHaveBlocksOfTheirOwn) {
  const std::string wall = entity("Wall", 12, "\"px\":[8,0], \"width\":8, \"height\":8");
  const auto map = mustImportProject(project(level("A", 0, 0, things(wall) + "," + grid("1,0,0,0,0,4"))));
  EXPECT_THAT(blocksOf(map), ElementsAre(5, 4, 1));
  EXPECT_EQ(map.block("Wall"), 5U);
}

TEST(TiledLdtk, LevelsInFilesOfTheirOwn) {
  const std::string outside = R"({"identifier":"A", "worldX":8, "worldY":0, "pxWid":24, "pxHei":16,
    "layerInstances":null, "externalRelPath":"levels/A.ldtkl"})";
  const std::string content = level("A", 0, 0, grid("1,0,0,0,0,0"));
  EXPECT_EQ(cellsOf(mustImportProject(project(outside), {}, {{"maps/levels/A.ldtkl", content}})), (Cells{{1, -1}}))
      << "the project says where it lies";
  const auto refusal = [&](const Files& more) {
    Files files = more;
    files["maps/test.tmx"] = project(outside);
    return refusalOf(importFiles(files));
  };
  const std::string file = "maps/test.tmx: levels/0 ";
  EXPECT_EQ(refusal({}), file + "its file maps/levels/A.ldtkl cannot be read: there is no such file");
  EXPECT_EQ(refusal({{"maps/levels/A.ldtkl", "{\n}]"}}).substr(0, 80),
            file + "its file maps/levels/A.ldtkl:2 is not well-formed JSON: ");
  EXPECT_EQ(refusal({{"maps/levels/A.ldtkl", project(outside)}}),
            file + "(maps/levels/A.ldtkl)/layerInstances is missing")
      << "a project is no level: there are no cycles";
  EXPECT_EQ(refusal({{"maps/levels/A.ldtkl", "{}"}}), file + "(maps/levels/A.ldtkl)/layerInstances is missing");
  EXPECT_EQ(refusal({{"maps/levels/A.ldtkl", level("A", 0, 0, grid("1"))}}),
            file + "(maps/levels/A.ldtkl)/layerInstances/0/intGridCsv holds 1 tiles where its size asks for 6");
}

TEST(TiledLdtk, OneGridAtATime) {
  const std::string fine = grid("1,0,0,0,0,0", "Fine", 5, "\"__gridSize\":4, ");
  const std::string text = project(level("A", 0, 8, fine + "," + grid("1,0,0,0,0,0")));
  EXPECT_EQ(
      refusalOf(text, {.solidWithoutShapes = true, .layers = {"Fine", "Solid"}}),
      "maps/test.tmx: levels/0/layerInstances/0 'Fine' has a grid of 4 px, and A/Solid one of 8 px. One cell of the "
      "grid becomes one cell of the world, so choose layers that have one grid (Options::layers)");
  const auto chosen = mustImportProject(text, {.layers = {"Fine"}});
  EXPECT_EQ(chosen.report.tileWidth, 4);
  EXPECT_EQ(cellsOf(chosen), (Cells{{0, -3}}));
  EXPECT_EQ(cellsOf(mustImportProject(text, {.layers = {"Solid"}})), (Cells{{0, -2}}));
  const auto map = mustImportProject(text);
  EXPECT_EQ(cellsOf(map), (Cells{{0, -2}})) << "the one that fills more";
  EXPECT_EQ(map.report.choice,
            "IntGrid layers: Solid, without those whose cells are of another size: Fine (--layer Solid)");
}

TEST(TiledLdtk, LevelsAtDifferentDepthsGetANote) {
  const std::string deep = R"({"identifier":"B", "worldX":0, "worldY":0, "worldDepth":1, "layerInstances":[]})";
  const auto map = mustImportProject(project(level("A", 0, 0, grid("1,0,0,0,0,0")) + "," + deep));
  EXPECT_THAT(map.report.notes,
              ElementsAre("levels at different depths are imported over each other: choose some by --layer"));
}

TEST(TiledLdtk, Refusals) {
  const auto layer = [](const std::string& text) { return refusalOf(project(level("A", 0, 0, text))); };
  const std::string at = "maps/test.tmx: levels/0/layerInstances/0";
  const std::string old =
      at + "/intGridCsv is missing: the project is of LDtk 1.5.3, and should be saved with LDtk 1.0 or later";
  EXPECT_EQ(layer(R"({"__type":"IntGrid", "intGrid":[{"coordId":4, "v":0}]})"), old);
  EXPECT_EQ(layer(grid("1,0")), at + "/intGridCsv holds 2 tiles where its size asks for 6");
  const std::string whole = at + "/intGridCsv should hold whole numbers from 0 to 1048575";
  for (const char* value : {"-1", "1.5", "null", "1048576", "\"1\""}) {
    EXPECT_EQ(layer(grid(std::string(value) + ",0,0,0,0,0")), whole) << value;
  }
  EXPECT_EQ(layer(grid("1048575,0,0,0,0,0")), "accepted");
  EXPECT_EQ(layer(grid("1,0,0,0,0,0", "Solid", 1, "\"__gridSize\":0, ")),
            at + "/__gridSize should be a whole number from 1 to 65536");
  EXPECT_EQ(layer("{\"__type\":\"Hexes\"}"), at + "/__type should be IntGrid, Entities, Tiles or AutoLayer");
  EXPECT_EQ(layer(things(entity("E", 1, "\"px\":[1], \"width\":8, \"height\":8"))),
            at + "/entityInstances/0/px should be two numbers");
  EXPECT_EQ(layer(things(entity("E", 1, "\"px\":[1,2], \"width\":8"))), at + "/entityInstances/0/height is missing");
  EXPECT_EQ(refusalOf(project("{}")), "maps/test.tmx: levels/0/worldX is missing");
  EXPECT_EQ(refusalOf(project(level("A", 0, 0, ""), "Spiral")),
            "maps/test.tmx: worldLayout is Spiral, which is not known");
  EXPECT_EQ(refusalOf(project(level("A", 0, 0, grid("1,0,0,0,0,0")) + "," +
                              level("B", 2'000'000'000, 0, grid("1,0,0,0,0,0")))),
            "maps/test.tmx: levels/1/layerInstances/0 'Solid' its offset is too large");
  EXPECT_EQ(refusalOf(project(level("A", 0, 0, grid("1,0,0,0,0,0"))), {.layers = {"None"}}),
            "maps/test.tmx: <map> has no tile layer or group 'None'; there are 'A', 'Solid'");
  std::string many;
  for (int uid = 100; uid < 228; ++uid) many += (uid > 100 ? "," : "") + grid("0,0,0,0,0,0", "G", uid);
  EXPECT_EQ(layer(many).substr(0, 90),
            "maps/test.tmx: levels/0/layerInstances/0 is one IntGrid layer too many: there may be 127");
}

TEST(TiledLdtk, TheProjectsOwnQuarry) {
  const auto map = test::must(importMap(LGS_SOURCE_DIR "/examples/maps/quarry.ldtk",
                                        {.objects = std::vector<std::string>{"Boulder", "Plank"}}));
  worldOf(map);
  std::vector<std::string> blocks;
  for (const BlockReport& block : map.report.blocks) blocks.push_back(std::to_string(block.block) + " " + block.name);
  EXPECT_THAT(blocks, ElementsAre("1 grass", "2 stone", "3 ice", "4 Boulder", "5 Plank"));
}

/// Levels anywhere, with any values: each cell that is not empty is a square of its block, where it was drawn.
TEST(TiledLdtk, RandomLevels) {
  const auto law = [](const std::vector<std::vector<int>>& levels) {
    std::string text;
    std::map<std::pair<int, int>, Block> expected;  // by row from the bottom, column
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const int column = static_cast<int>(k) * 2 - 3, row = static_cast<int>(k) * 2;
      std::string csv;
      for (int at = 0; at < 6; ++at) {
        const int value = levels[k][static_cast<std::size_t>(at)];
        csv += (at > 0 ? "," : "") + std::to_string(value);
        if (value != 0) expected[{-1 - row - at / 3, column + at % 3}] = static_cast<Block>(value);
      }
      text += (k > 0 ? "," : "") + level("L" + std::to_string(k), column * 8, row * 8, grid(csv));
    }
    const auto map = mustImportProject(project(text));
    std::map<std::pair<int, int>, Block> found;
    for (const MapPolygon& p : map.placements) found[{p.cell.j, p.cell.i}] = p.block;
    EXPECT_EQ(found, expected);
    EXPECT_EQ(map.placements.size(), expected.size());
  };
  const auto values = rc::gen::container<std::vector<int>>(6, rc::gen::inRange(0, 5));
  test::forAll(100, law, rc::gen::resize(6, rc::gen::container<std::vector<std::vector<int>>>(values)));
}

TEST(TiledLdtk, DamagedProjectsNeverCrash) {
  const std::string good =
      project(level("A", 0, 0,
                    things(entity("Wall", 12, "\"px\":[8,0], \"__pivot\":[0,1], \"width\":8, \"height\":8")) + "," +
                        grid("1,0,2,3,0,0")) +
              "," + level("B", 24, 0, grid("0,0,2,3,0,0")));
  std::mt19937 random(7);
  Options options;
  options.maxTiles = options.maxPlacements = 10'000;
  int accepted = 0;
  for (int round = 0; round < 3'000; ++round) {
    std::string bad = good;
    for (unsigned edit = 0; edit <= random() % 3; ++edit) {
      const std::size_t at = random() % bad.size();
      constexpr std::array kValues{"null", "true", "[]", "{}", "-1", "1e300", "\"\"", "[[1]]", "{\"x\":{}}", "7"};
      const std::size_t colon = bad.find(':', at), end = bad.find_first_of(",}]", colon);
      if (end != std::string::npos) bad.replace(colon + 1, end - colon - 1, kValues[random() % kValues.size()]);
    }
    const auto map = importFiles({{"maps/test.tmx", bad}}, options);
    if (map) worldOf(*map);
    accepted += map.has_value();
  }
  EXPECT_GT(accepted, 300);
}

}  // namespace
}  // namespace lgs::tiled
