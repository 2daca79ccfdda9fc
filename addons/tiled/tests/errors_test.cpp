// Maps that cannot be read: each message names the file and the line and says what is wrong.
#include "maps.h"
#include "proptests/support/must.h"

#include <random>

namespace lgs::tiled {
namespace {

/// pugixml turns UTF-16 into UTF-8, which may be longer; where an error stands in that is nowhere in the file.
TEST(TiledErrors, ATextOfAnotherEncodingHasNoLines) {
  const auto wide = [](const std::string& text) {
    std::string bytes;
    for (const char c : text) bytes += {c, '\0'};
    return bytes;
  };
  EXPECT_EQ(refusalOf(wide("<map orientation='isometric'/>")),
            "maps/test.tmx: <map> has the orientation 'isometric': only orthogonal maps have square cells");
  std::string longer = wide("<map name='");
  for (int k = 0; k < 50; ++k) longer += {'\0', '\x4E'};
  EXPECT_THAT(refusalOf(longer), HasSubstr("maps/test.tmx: is not well-formed XML"));
}

TEST(TiledErrors, NameFileLineAndReason) {
  const std::string set = tilesetXml({kFullTile});
  const auto polygon = [](const std::string& points) {
    return mapXml(tilesetXml({"<object><polygon points='" + points + "'/></object>"}));
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"<map tilewidth='32'>\n<layer></map>", "maps/test.tmx:2: is not well-formed XML"},
      {"<tileset/>", "maps/test.tmx:1: <tileset> should be <map>"},
      {"<map orientation='isometric' tilewidth='32' tileheight='32'/>",
       "has the orientation 'isometric': only orthogonal maps"},
      {"<map tilewidth='32'/>", "maps/test.tmx:1: <map> has no attribute 'tileheight'"},
      {"<map tilewidth='0' tileheight='1'/>", "tilewidth='0' should be a whole number from 1 to 65536"},
      {mapXml("", "width='4x'"), "width='4x' should be a whole number"},
      {mapXml("", "width='-1'"), "width='-1' should be a whole number"},
      {mapXml("", "width='99999999999999999999'"), "should be a whole number"},
      {mapXml("<tileset firstgid='1'/>"), "maps/test.tmx:3: <tileset> has no attribute 'tilewidth'"},
      {mapXml("<tileset firstgid='0' tilewidth='1' tileheight='1'/>"), "firstgid='0' should be"},
      {mapXml(set + set), "has the same firstgid as the tileset 'set'"},
      {mapXml(set + "<layer name='L'/>"), "<layer> 'L' has no <data>"},
      {mapXml(set + "<layer name='L'><data encoding='csv'>1</data></layer>"), "<layer> 'L' has no attribute 'width'"},
      {mapXml(set + csvLayer(2, 2, "1,1,1")), "maps/test.tmx:6: <data> holds 3 tiles where its size asks for 4"},
      {mapXml(set + csvLayer(2, 2, "1,1,1,1,1")), "holds more than the 4 tiles of its size"},
      {mapXml(set + csvLayer(2, 2, "1,1,x,1")), "tile 3 is not a tile number"},
      {mapXml(set + csvLayer(2, 2, "1 1 1 1")), "has no comma after tile 1"},
      {mapXml(set + csvLayer(100000, 100000, "1")), "more tiles than the limit"},
      {mapXml(set + "<layer name='L' width='1' height='1'><data/></layer>"), "holds 0 <tile> elements"},
      {mapXml(set + "<layer name='L' width='1' height='1'><data encoding='json'/></layer>"), "unknown encoding 'json'"},
      {mapXml(set + "<layer name='L' width='1' height='1'><data encoding='base64'>%%</data></layer>"),
       "not valid base64"},
      {mapXml(set + csvLayer(1, 1, "1", "offsetx='1e300'")), "its offset is too large"},
      {mapXml(set + csvLayer(1, 1, "1", "offsetx='nan'")), "offsetx='nan' should be a finite number"},
      {polygon("0,0 1"), "points: '1' should be two finite numbers"},
      {polygon("0,0 1,inf 3,3"), "points: '1,inf' should be two finite numbers"},
      {mapXml(tilesetXml({"<object x='1,5'/>"})), "x='1,5' should be a finite number"},
  };
  for (const auto& [xml, expected] : cases) {
    EXPECT_THAT(refusalOf(xml), HasSubstr(expected)) << expected << "\n  but: " << refusalOf(xml);
  }
  EXPECT_THAT(refusalOf(mapXml(set), {.tolerance = -1}), HasSubstr("tolerance"));
  EXPECT_THAT(refusalOf(mapXml(set + csvLayer(2, 2, "1,1,1,1")), {.maxPlacements = 3}), HasSubstr("maxPlacements"));
  EXPECT_THAT(message(importMap("no/such/map.tmx").error()), HasSubstr("no/such/map.tmx: cannot be read"));
}

TEST(TiledErrors, ATilesetFileIsBlamedForItsOwnMistakes) {
  const auto error = test::refusal(
      importFiles({{"maps/test.tmx", mapXml("<tileset firstgid='1' source='bad.tsx'/>")},
                   {"maps/bad.tsx", "<tileset tilewidth='8' tileheight='8'>\n\n <tile id='x'/></tileset>"}}));
  EXPECT_EQ(error.file, "maps/bad.tsx");
  EXPECT_EQ(error.line, 3);
}

TEST(TiledErrors, DeepGroupsAndStrayTiles) {
  std::string open, close;
  for (int i = 0; i < 100; ++i) {
    open += "<group>";
    close += "</group>";
  }
  EXPECT_THAT(refusalOf(mapXml(open + close)), HasSubstr("nested too deeply"));
  const auto stray = mustImport(tilesetXml({kFullTile}, "tilecount='1'") + csvLayer(2, 1, "1,0"));
  EXPECT_TRUE(stray.report.notes.empty());
  const std::string sheet =
      "<tileset firstgid='5' tilewidth='32' tileheight='32' tilecount='2'><image source='x'/></tileset>";
  EXPECT_THAT(mustImport(sheet + csvLayer(2, 2, "1,5,7,6")).report.notes,
              ElementsAre("2 tiles belong to no tileset of the map"));
}

TEST(TiledErrors, APolygonTooManyForACell) {
  std::string objects;
  for (int i = 0; i < 300; ++i) {
    const int row = i / 20;
    const double x = 1.5 + i % 20 * 1.4, y = 1.5 + row * 1.4;
    objects += "<object id='" + std::to_string(i + 1) + "' x='" + std::to_string(x) + "' y='" + std::to_string(y) +
               "' width='1' height='1'/>";
  }
  // The polygons are not placed in a World. That takes quadratic time if so many share a cell.
  const auto map = test::must(
      importFiles({{"maps/test.tmx", mapXml(tilesetXml({objects}) + csvLayer(1, 1, "1"))}}, {.tolerance = 0}));
  EXPECT_EQ(map.placements.size(), kMaxPolygonsPerCell);
  EXPECT_EQ(noteKinds(map), std::vector<NoteKind>(300 - kMaxPolygonsPerCell, NoteKind::leftOut));
}

TEST(TiledErrors, DamagedFilesNeverCrash) {
  const std::string good =
      mapXml(tilesetXml({"<object id='1' x='3' rotation='30'><polygon points='0,0 20,0 9.5,40'/></object>",
                         "<object id='2' width='40' height='9'><ellipse/></object>"}) +
             "<group name='g' offsetx='5'>" + csvLayer(3, 2, "1,2,2147483649,3221225474,0,536870914") + "</group>");
  std::mt19937 random(7);
  Options options;
  options.maxTiles = options.maxPlacements = 10'000;
  for (int round = 0; round < 2'000; ++round) {
    std::string bad = good;
    for (unsigned edit = 0; edit <= random() % 4; ++edit) {
      const std::size_t at = random() % bad.size();
      switch (random() % 3) {
        case 0:
          bad[at] = "0123456789<>/'=-e.,x"[random() % 20];
          break;
        case 1:
          bad.erase(at, 1 + random() % 10);
          break;
        default:
          bad.insert(at, bad.substr(random() % bad.size(), 1 + random() % 20));
          break;
      }
    }
    const auto map = importFiles({{"maps/test.tmx", bad}}, options);
    if (map) worldOf(*map);
  }
}

}  // namespace
}  // namespace lgs::tiled
