// Worlds of Tiled: maps side by side.
#include "maps.h"
#include "proptests/support/must.h"

#include <algorithm>

namespace lgs::tiled {
namespace {

/// A map of full tiles in its cells, 2 columns and rows.
std::string small(const std::string& csv, const std::string& more = "", const std::string& attributes = "") {
  return mapXml("<tileset firstgid='1' source='set.tsx'/>" + csvLayer(2, 2, csv, attributes) + more,
                "width='2' height='2'");
}

const std::string kSet =
    tilesOf32(tileXml(0, kFullTile, "type='rock'") +
                  tileXml(1, "<object id='1' x='0' y='32'><polygon points='0,0 40,0 40,-16'/></object>", "type='ice'"),
              "name='set'");

std::string entry(const std::string& file, const std::string& x, const std::string& y) {
  return "{\"fileName\":\"" + file + "\", \"x\":" + x + ", \"y\":" + y + ", \"width\":64, \"height\":64}";
}

std::string world(const std::string& entries) {
  return "{\"maps\":[" + entries + "], \"onlyShowAdjacentMaps\":false, \"type\":\"world\"}";
}

/// The world is maps/test.tmx (a file is known by its content), its maps a.tmx and b.tmx.
Files worldFiles(const std::string& entries, const std::string& a, const std::string& b) {
  return {{"maps/test.tmx", world(entries)}, {"maps/a.tmx", a}, {"maps/b.tmx", b}, {"maps/set.tsx", kSet}};
}

const std::string kBeside = entry("a.tmx", "0", "0") + "," + entry("b.tmx", "64", "-32");

TEST(TiledWorlds, MapsLieWhereTheWorldPutsThem) {
  const auto map = mustImportWorld(worldFiles(kBeside, small("1,0,0,0"), small("0,0,0,1")));
  EXPECT_EQ(cellsOf(map), (Cells{{0, -1}, {3, -1}}));
  EXPECT_EQ(map.report.file, "maps/test.tmx");
  EXPECT_EQ(map.report.width, 4);
  EXPECT_EQ(map.report.height, 3);
  EXPECT_EQ(map.report.tileWidth, 32);
  EXPECT_EQ(map.report.tileHeight, 32);
  EXPECT_EQ(map.report.tolerance, 1);
  EXPECT_FALSE(map.report.infinite);
  EXPECT_EQ(map.report.layers.at(0).path, "a/Ground");
  EXPECT_EQ(map.report.layers.at(1).path, "b/Ground");
  EXPECT_EQ(map.placements.at(1).layer, 1U);
  ASSERT_EQ(map.report.tiles.size(), 1U) << "both maps use the same tile";
  EXPECT_EQ(map.report.tiles.at(0).uses, 2U);
  const auto json = test::must(asJson(small("1,0,0,0")));
  expectAlike(map, mustImportWorld(worldFiles(kBeside, json, small("0,0,0,1"))));
}

/// What reaches out of a map goes into the next one, where nothing is in its way; what comes later loses what is
/// covered.
TEST(TiledWorlds, MapsMeetAtTheirBorders) {
  const auto reaches = mustImportWorld(
      worldFiles(entry("a.tmx", "0", "0") + "," + entry("b.tmx", "64", "0"), small("0,2,0,0"), small("0,0,1,0")));
  EXPECT_EQ(cellsOf(reaches), (Cells{{2, -2}, {1, -1}, {2, -1}}));
  const auto covers = mustImportWorld(
      worldFiles(entry("a.tmx", "0", "0") + "," + entry("b.tmx", "32", "0"), small("0,1,0,0"), small("2,1,0,0")));
  EXPECT_EQ(ringsIn(covers, {1, -1}), (Rings{kSquare}));
  EXPECT_NEAR(areaInCells(covers), 2, 0.001);
  const auto isTrimmed = [](const Note& note) { return note.kind == NoteKind::trimmed; };
  const std::vector<Note>& notes = covers.report.tiles.at(1).notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), isTrimmed));
}

TEST(TiledWorlds, AMapBesideTheGridIsShifted) {
  const auto map = mustImportWorld(
      worldFiles(entry("a.tmx", "0", "0") + "," + entry("b.tmx", "72", "0"), small("1,0,0,0"), small("1,0,0,0")));
  EXPECT_EQ(cellsOf(map), (Cells{{0, -1}, {2, -1}, {3, -1}}));
  EXPECT_EQ(ringsIn(map, {3, -1}), (Rings{pxBox(0, 0, 8, 32)}));
  EXPECT_EQ(map.report.layers.at(0).note, "");
  EXPECT_EQ(map.report.layers.at(1).note,
            "shifted by 8 px, 0 px against the grid: its polygons reach out of their cells");
}

TEST(TiledWorlds, NamesOfLayersAreTheSameInAllMaps) {
  const std::string walls =
      "<objectgroup name='Walls'><object id='1' x='0' y='32' width='32' height='32'/></objectgroup>";
  const Files files = worldFiles(kBeside, small("1,0,0,0", walls), small("0,0,0,1"));
  const auto cells = [&](const Options& options) { return cellsOf(mustImportWorld(files, options)); };
  const Cells box{{0, -2}}, a{{0, -2}, {0, -1}}, grounds{{0, -1}, {3, -1}}, ofB{{3, -1}};
  Options options{.layers = {"Ground"}};
  EXPECT_EQ(cells(options), grounds);
  options.layers = {"a"};
  EXPECT_EQ(cells(options), a);
  options.layers = {"b/Ground"};
  EXPECT_EQ(cells(options), ofB);
  options.layers = {"b"};
  options.objects = std::vector<std::string>{"Walls"};
  EXPECT_EQ(cells(options), (Cells{{0, -2}, {3, -1}}));
  options.objects = std::vector<std::string>{"a"};
  options.layers = {"Ground"};
  EXPECT_EQ(cells(options), (Cells{{0, -2}, {0, -1}, {3, -1}}));
  options.objects = std::vector<std::string>{"Doors"};
  const auto refused = test::refusal(importFiles(files, options));
  EXPECT_EQ(message(refused),
            "maps/test.tmx: <world> has no object layer or group 'Doors'; there are 'Walls', 'a', 'b'");
  for (const char* none : {"", "c", "Ground/b"}) {
    options = {};
    options.layers = {none};
    EXPECT_FALSE(importFiles(files, options)) << none;
  }
}

TEST(TiledWorlds, ATileNamesItsLayersInAllMaps) {
  const std::string hidden = csvLayer(2, 2, "0,2,0,0", "visible='0'");
  const Files files = worldFiles(kBeside, small("1,0,0,0", hidden), small("0,0,0,1"));
  const auto map = mustImportWorld(files);
  ASSERT_EQ(map.report.layers.size(), 3U);
  ASSERT_EQ(map.report.tiles.size(), 2U);
  EXPECT_EQ(map.report.tiles[0].layers, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(map.report.tiles[1].layers, (std::vector<std::uint32_t>{1}));
  EXPECT_THAT(toText(map.report), HasSubstr("in layer"));
  EXPECT_EQ(mustImportWorld(files, {.visibleOnly = true}).report.tiles.size(), 1U);
}

/// Two tilesets of one map may have one name; they are told apart by the classes of their tiles.
TEST(TiledWorlds, TilesetsOfOneNameAreToldApartInOneMap) {
  const auto set = [](const char* first, const char* type) {
    return "<tileset firstgid='" + std::string(first) + "' name='set' tilewidth='32' tileheight='32'>" +
           tileXml(0, kFullTile, type) + "</tileset>";
  };
  const std::string both =
      mapXml(set("1", "type='rock'") + set("9", "type='ice'") + csvLayer(2, 2, "1,9,0,0"), "width='2' height='2'");
  const auto map = mustImportWorld(worldFiles(kBeside, both, both));
  ASSERT_EQ(map.report.tiles.size(), 2U);
  EXPECT_EQ(map.report.tiles.at(0).className, "rock");
  EXPECT_EQ(map.report.tiles.at(1).className, "ice");
}

TEST(TiledWorlds, PathsOfLayersBeginWithTheMapOrNot) {
  const auto inGroup = [](const std::string& group) {
    const std::string layer = "<group name='" + group + "'>" + csvLayer(2, 2, "1,0,0,0") + "</group>";
    return mapXml("<tileset firstgid='1' source='set.tsx'/>" + layer +
                      "<layer name='Other' width='0' height='0'><data/>" + "</layer>",
                  "infinite='1'");
  };
  Files files = worldFiles(kBeside, "", "");
  files["maps/a.tmx"] = inGroup("Upper");
  files["maps/b.tmx"] = inGroup("Upper");
  const auto cells = [&](const char* layer) {
    const auto map = mustImportWorld(files, {.layers = {layer}});
    EXPECT_TRUE(map.report.infinite);
    return cellsOf(map);
  };
  files["maps/a.tmx"].replace(files["maps/a.tmx"].find("infinite='1'"), 12, "");
  files["maps/b.tmx"].replace(files["maps/b.tmx"].find("<data encoding='csv'>1,0,0,0"), 28,
                              "<data encoding='csv'><chunk x='0' y='0' width='1' height='1'>1</chunk>");
  EXPECT_EQ(cells("Upper/Ground"), (Cells{{0, -1}, {2, 0}}));
  EXPECT_EQ(cells("Upper"), (Cells{{0, -1}, {2, 0}}));
  EXPECT_EQ(cells("b/Upper/Ground"), (Cells{{2, 0}}));
  EXPECT_EQ(cells("a/Upper"), (Cells{{0, -1}}));
}

TEST(TiledWorlds, ANameHasOneBlockInAllMaps) {
  const Files files = worldFiles(kBeside, small("1,0,0,0"), small("2,0,0,1"));
  const auto byClass = mustImportWorld(files, {.blockFrom = BlockFrom::tileClass});
  EXPECT_EQ(byClass.blocks, (std::map<std::string, Block>{{"rock", 1}, {"ice", 2}}));
  ASSERT_EQ(byClass.report.blocks.size(), 2U);
  EXPECT_EQ(byClass.report.blocks.at(0).name, "rock");
  EXPECT_EQ(byClass.report.blocks.at(0).polygons, 2U);
  const auto byLayer = mustImportWorld(files, {.blockFrom = BlockFrom::layer});
  EXPECT_EQ(byLayer.blocks, (std::map<std::string, Block>{{"Ground", 1}})) << "whatever map it is in";
}

TEST(TiledWorlds, LimitsAreForAllMapsTogether) {
  const Files files = worldFiles(kBeside, small("1,1,0,0"), small("0,0,1,1"));
  EXPECT_EQ(mustImportWorld(files, {.maxTiles = 8, .maxPlacements = 4}).placements.size(), 4U);
  EXPECT_THAT(message(importFiles(files, {.maxTiles = 7, .maxPlacements = 4}).error()),
              HasSubstr("more tiles than the limit"));
  EXPECT_THAT(message(importFiles(files, {.maxTiles = 8, .maxPlacements = 3}).error()),
              HasSubstr("more polygons than the limit"));
  const auto map = importFiles(files, {.solidWithoutShapes = true, .maxTiles = 7});  // no census has counted them
  ASSERT_FALSE(map);
  EXPECT_THAT(message(map.error()), HasSubstr("more tiles than the limit"));
}

TEST(TiledWorlds, AnEmptyWorldSaysWhatCouldBeTaken) {
  const std::string boxes = "<objectgroup name='Boxes'><object id='1' width='32' height='32'/></objectgroup>";
  const auto map = mustImportWorld(worldFiles(kBeside, small("0,0,0,0", boxes), small("0,0,0,0")));
  ASSERT_EQ(map.report.suggestions.size(), 1U);
  EXPECT_THAT(map.report.suggestions.at(0).arguments, ElementsAre("--objects", "Boxes"));
  const auto one = mustImportWorld(worldFiles(kBeside, small("0,0,0,0", boxes), small("1,0,0,0")));
  EXPECT_EQ(one.report.also, "object layer Boxes, of which nothing is taken");
}

TEST(TiledWorlds, Refusals) {
  const auto refusal = [](const std::string& text) {
    Files files = worldFiles("", small("1,0,0,0"), "<map orientation='orthogonal' tilewidth='16' tileheight='32'/>");
    files["maps/test.tmx"] = text;
    files["maps/c.world"] = world(kBeside);
    return refusalOf(importFiles(files));
  };
  const std::string file = "maps/test.tmx: ";
  const std::string a = entry("a.tmx", "0", "0");
  EXPECT_EQ(refusal(world("")), file + "<world> lists no maps");
  EXPECT_EQ(refusal(world("7")), file + "maps/0 should be an object");
  EXPECT_EQ(refusal(world("{\"x\":0}")), file + "maps/0 has no fileName");
  EXPECT_EQ(refusal(world(a + "," + entry("../maps/a.tmx", "64", "0"))), file + "maps/1 ../maps/a.tmx is listed twice");
  EXPECT_EQ(refusal(world(entry("a.tmx", "\"far\"", "0"))), file + "maps/0 x='far' should be a finite number");
  EXPECT_EQ(refusal(world(entry("a.tmx", "1e300", "0"))), "maps/a.tmx:3: <layer> 'Ground' its offset is too large");
  EXPECT_EQ(refusal(world(entry("no.tmx", "0", "0"))),
            file + "maps/0 the map's file maps/no.tmx cannot be read: there is no such file");
  EXPECT_EQ(refusal(world(entry("set.tsx", "0", "0"))),
            "maps/set.tsx:1: <tileset> 'set' should be <map>: this is not the kind of file expected here");
  EXPECT_EQ(refusal(world(entry("c.world", "0", "0"))), file + "maps/0 c.world is no map of Tiled's");
  EXPECT_EQ(refusal(world(entry("test.tmx", "0", "0"))), file + "maps/0 test.tmx is no map of Tiled's") << "no cycles";
  EXPECT_EQ(refusal(world(a + "," + entry("b.tmx", "64", "0"))),
            file +
                "maps/1 b.tmx has tiles of another size than the maps before it. One tile becomes one cell of the "
                "world, so all must have the same");
}

}  // namespace
}  // namespace lgs::tiled
