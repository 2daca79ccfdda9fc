// Tables of what tiles are by their numbers, and the one of the examples.
#include "maps.h"

#include <fstream>
#include <sstream>

namespace lgs::tiled {
namespace {

TileTable tableOf(const std::string& rows) {
  auto table = parseTileTable("lgs-tiles 1\n" + rows);
  EXPECT_TRUE(table) << table.error();
  return table ? *table : TileTable{};
}

/// Tiles without shapes, the numbers 1 to 4 in a row; and with these options.
ImportedMap importRow(const std::string& rows, Options options = {}, const std::string& set = "") {
  options.tiles = tableOf(rows);
  return mustImport(tilesetXml({}, "") + set + csvLayer(4, 1, "1,2,3,4"), options);
}

TEST(TiledTileTable, PolygonsSquaresAndNothing) {
  const auto map = importRow("0 full\n1,3 0 0, 1 0, 1 1/2  # a slope\n2 none");
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{kSquare}));
  EXPECT_EQ(ringsIn(map, {1, -1}), (Rings{px({{0, 0}, {32, 0}, {32, 16}})}));
  EXPECT_TRUE(ringsIn(map, {2, -1}).empty());
  EXPECT_EQ(ringsIn(map, {3, -1}), ringsIn(map, {1, -1}));
  EXPECT_EQ(cellsOf(importRow("2 none", {.solidWithoutShapes = true})), (Cells{{0, -1}, {1, -1}, {3, -1}}))
      << "it stays free";
}

TEST(TiledTileTable, OneWayPlatforms) {
  const auto map = importRow("0 oneway 0 1, 1 1", {.blockFrom = BlockFrom::tileClass, .polylineThickness = 8});
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 24, 32, 32)}));
  EXPECT_TRUE(map.block("one-way"));
  EXPECT_TRUE(importRow("0 oneway 0 1, 1 1").placements.empty()) << "it has no area";
}

TEST(TiledTileTable, ShapesOfATilesetReplaceItsOwn) {
  const auto map = mustImport(tilesetXml({kFullTile, kFullTile}) + csvLayer(2, 1, "1,2"),
                              {.tiles = tableOf("tileset other\n0 none\ntileset set\n0 0 0, 1/2 0, 0.5 1, 0 1")});
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 0, 16, 32)}));
  EXPECT_EQ(ringsIn(map, {1, -1}), (Rings{kSquare})) << "the table does not name it";
  EXPECT_THAT(map.report.notes, ElementsAre("the map has no tileset 'other'; there is 'set'"));
}

TEST(TiledTileTable, Refusals) {
  const auto refusal = [](const std::string& text) {
    const auto table = parseTileTable(text);
    return table ? "accepted" : table.error();
  };
  EXPECT_EQ(refusal(""), "1: should begin with \"lgs-tiles 1\"");
  EXPECT_EQ(refusal("# a table\nlgs-tiles 2\n"), "2: should begin with \"lgs-tiles 1\"");
  EXPECT_EQ(refusal("lgs-tiles 1\n"), "accepted");
  const std::string head = "lgs-tiles 1\n", ids = "2: should begin with the numbers of tiles";
  for (const char* row : {"x full", "3-1 full", "-1 full", "1,,2 full", "999999999999 full", "0-99999999 full"}) {
    EXPECT_EQ(refusal(head + row).substr(0, ids.size()), ids) << row;
  }
  const std::string shape = "2: should say full, none, oneway with x y of two points or more, or x y of three or more";
  for (const char* row : {"1 half", "1 0 0, 1 0, nan 1", "1 0 0, 1 0, 1/0 1"}) EXPECT_EQ(refusal(head + row), shape);
  for (const char* row : {"1", "1 0 0, 1 0", "1 0 0 1 0 1", "1 oneway 0 1"}) {
    EXPECT_THAT(refusal(head + row), HasSubstr(" points or more")) << row;
  }
  EXPECT_EQ(refusal(head + "1 full 2"), shape);
  EXPECT_EQ(refusal(head + "1-3 full\n2 none"), "3: tile 2 has a row already");
  EXPECT_EQ(refusal(head + "0-40000 full\ntileset b\n0-40000 full"), "4: has more than 65536 tiles");
}

/// The table for a game is one, and has slopes of each kind.
TEST(TiledTileTable, TheOneOfTheExamples) {
  std::ifstream file(std::string(LGS_SOURCE_DIR) + "/examples/maps/supertux-advance.tiles");
  std::stringstream table;
  table << file.rdbuf();
  const auto parsed = parseTileTable(table.str());
  ASSERT_TRUE(parsed) << parsed.error();
  const auto& solid = parsed->at("solid");
  EXPECT_EQ(solid.size(), 54U);
  for (const auto& [id, shape] : solid) {
    double area = 0;
    for (std::size_t k = 0; k < shape.outline.size(); ++k) {
      const DoublePoint a = shape.outline[k], b = shape.outline[(k + 1) % shape.outline.size()];
      area += (a.x * b.y - b.x * a.y) / 2;
    }
    EXPECT_TRUE(shape.oneWay || (area > 0 && area <= 1)) << id << ": its vertices run counter-clockwise, in the tile";
  }
}

}  // namespace
}  // namespace lgs::tiled
