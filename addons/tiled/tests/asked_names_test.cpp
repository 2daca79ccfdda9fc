// Names that the options ask for and that no map has: the report says so, and names a similar one.
#include "maps.h"

#include "addons/tiled/src/asked_names.h"

namespace lgs::tiled {
namespace {

using Notes = std::vector<std::string>;

/// A tile and a tile layer with properties and classes, and an object layer.
const std::string kContent =
    "<tileset firstgid='1' name='set' tilewidth='32' tileheight='32'><tile id='0' class='ice'>" +
    property("collides", "true") + "</tile><tile id='7' class='mud'>" + property("unused", "") + "<objectgroup>" +
    "<object id='1' name='Edge' class='rim' width='32' height='9'/></objectgroup></tile></tileset>" +
    "<group name='G'><layer name='Ground' width='1' height='1'>" + property("Kind", "rock") +
    "<data encoding='csv'>1</data></layer></group><objectgroup name='Walls' class='stone'>" + property("doors", "1") +
    "<object id='4' name='Gate' type='oak' width='9' height='9'/></objectgroup>";

Notes notesWithRules(const std::vector<std::string>& rules) {
  return mustImport(kContent, {.solidIf = rules}).report.notes;
}

TEST(TiledAskedNames, PropertiesThatNothingHas) {
  EXPECT_EQ(notesWithRules({"collides", "unused", "Kind=rock", "unused="}), Notes{}) << "all are there";
  EXPECT_EQ(notesWithRules({"colides", "colides=1"}),
            Notes{"no tile, tile layer or object has a property 'colides'; there are 'collides', 'Kind', 'class', "
                  "'layer', 'unused'"});
  EXPECT_EQ(notesWithRules({"kind=rock"}), Notes{"no tile, tile layer or object has a property 'kind'; there are "
                                                 "'Kind', 'class', 'collides', 'layer', 'unused'"});
  const std::string noDoors =
      "no tile, tile layer or object has a property 'doors'; there are 'Kind', 'class', 'collides', 'layer', 'unused'";
  EXPECT_EQ(notesWithRules({"doors"}), Notes{noDoors}) << "that of an object layer makes no tile solid";
}

TEST(TiledAskedNames, ValuesThatNothingHas) {
  const auto no = [](const std::string& value, const std::string& name) {
    return "no tile, tile layer or object has a property '" + name + "' with the value '" + value + "'";
  };
  EXPECT_EQ(notesWithRules({"Kind=rock", "Kind=sand"}), Notes{no("sand", "Kind") + "; there is 'rock'"});
  EXPECT_EQ(notesWithRules({"collides=yes", "collides"}), Notes{no("yes", "collides") + "; there is 'true'"});
  EXPECT_EQ(notesWithRules({"Kind="}), Notes{no("", "Kind") + "; there is 'rock'"});
}

/// Tiles whose property "kind" has these values, one layer that has another one, and "other" that has all of them.
Notes notesWithValues(const std::vector<std::string>& values, const std::string& rule) {
  std::string tiles;
  for (std::size_t k = 0; k < values.size(); ++k) {
    tiles += "<tile id='" + std::to_string(k) + "'>" + property("kind", values[k]) + "</tile>";
  }
  const Options options{.solidIf = {rule}};
  return mustImport("<tileset firstgid='1' name='set' tilewidth='32' tileheight='32'>" + tiles + "</tileset>" +
                        "<layer name='L' width='1' height='1'>" + property("other", "sand") +
                        "<data encoding='csv'>1</data></layer>",
                    options)
      .report.notes;
}

TEST(TiledAskedNames, SomeValuesAreNamed) {
  const std::string no = "no tile, tile layer or object has a property 'kind' with the value 'sand'; there ";
  EXPECT_EQ(notesWithValues({"c", "b", "a", "b"}, "kind=sand"), Notes{no + "are 'a', 'b', 'c'"});
  EXPECT_EQ(notesWithValues({"a", "b", "Sand", "send"}, "kind=sand"), Notes{no + "are 'Sand', 'send', 'a', 'b'"});
  EXPECT_EQ(notesWithValues({"a", "b", "c", "d", "e", "f"}, "kind=sand"),
            Notes{no + "are 'a', 'b', 'c', 'd', 'e', 'f'"});
  EXPECT_EQ(notesWithValues({"a", "b", "c", "d", "e", "f", "g", "sands"}, "kind=sand"),
            Notes{no + "are 'sands', 'a', 'b', 'c', 'd', 'e' and 2 more"});
  EXPECT_EQ(notesWithValues({std::string(50, 'x')}, "kind=sand"), Notes{no + "is '" + std::string(40, 'x') + "…'"});
}

Notes notesWithNumbers(BlockFrom from, const std::vector<std::string>& names) {
  Options options{.solidWithoutShapes = true, .blockFrom = from};
  for (const char* known : {"ice", "oak", "Gate", "G/Ground", "Walls"}) options.blocks[known] = 9;
  for (const std::string& name : names) options.blocks[name] = 9;
  const auto map = mustImport(kContent, options);
  return map.report.notes;
}

TEST(TiledAskedNames, NumbersOfNamesThatNothingHas) {
  const std::string noClass = "no tile, object or object layer has the class '";
  const std::string classes = "'; there are 'ice', 'mud', 'oak', 'rim', 'stone'";
  EXPECT_EQ(notesWithNumbers(BlockFrom::tileClass, {"", "mud", "rim", "stone", "Ice"}),
            (Notes{noClass + "G/Ground" + classes, noClass + "Gate" + classes, noClass + "Ice" + classes,
                   noClass + "Walls" + classes}));
  const std::string noName = "no tile, object or object layer has the class or name '";
  const auto named = notesWithNumbers(BlockFrom::name, {"Edge", "rim", "Gaet"});
  ASSERT_EQ(named.size(), 3U);
  EXPECT_EQ(named[1], noName + "Gaet'; there are 'Gate', 'Edge', 'ice', 'mud', 'oak', 'rim' and 1 more");
  const std::string noLayer = "no layer has the path '";
  EXPECT_EQ(notesWithNumbers(BlockFrom::layer, {"Wall"}),
            (Notes{noLayer + "Gate'; there are 'G/Ground', 'Walls'", noLayer + "Wall'; there are 'Walls', 'G/Ground'",
                   noLayer + "ice'; there are 'G/Ground', 'Walls'", noLayer + "oak'; there are 'G/Ground', 'Walls'"}));
  EXPECT_EQ(notesWithNumbers(BlockFrom::one, {}),
            Notes{"numbers of names are not used, as all polygons get block 1: choose whose names (--block)"});
}

TEST(TiledAskedNames, TemplatesHaveNamesToo) {
  const Files files{
      {"maps/test.tmx",
       mapXml("<objectgroup name='Walls'><object id='1' template='a.tx' x='0' y='32'/></objectgroup>")},
      {"maps/a.tx",
       "<template><tileset firstgid='1' source='a.tsx'/><object gid='1' type='crate' width='32' height='32'/>"
       "</template>"},
      {"maps/a.tsx",
       "<tileset tilewidth='32' tileheight='32'><tile id='0'>" + property("solid", "1") + "</tile></tileset>"}};
  const auto map =
      mustImportFiles(files, {.solidIf = {"solid"}, .blockFrom = BlockFrom::tileClass, .blocks = {{"crate", 3}}});
  EXPECT_EQ(map.report.polygons, 1U);
  EXPECT_EQ(map.report.notes, Notes{});
}

TEST(TiledAskedNames, OneMapOfAWorldIsEnough) {
  const std::string second = "<tileset firstgid='1' tilewidth='32' tileheight='32'/>" + csvLayer(1, 1, "1");
  const Files files{{"maps/test.tmx", R"({"type":"world", "maps":[{"fileName":"a.tmx", "x":0, "y":0},
                                         {"fileName":"b.tmx", "x":128, "y":0}]})"},
                    {"maps/a.tmx", mapXml(kContent)},
                    {"maps/b.tmx", mapXml(second)}};
  EXPECT_EQ(mustImportWorld(files, {.solidIf = {"collides", "unuse"}}).report.notes,
            Notes{"no tile, tile layer or object has a property 'unuse'; there are 'unused', 'Kind', 'class', "
                  "'collides', 'layer'"});
}

TEST(TiledAskedNames, SimilarNames) {
  for (const char* name : {"SOLID", "sold", "solids", "asolid", "solld", "solidd", "sloid", "Soldi"}) {
    EXPECT_TRUE(areSimilar(name, "solid")) << name;
    EXPECT_TRUE(areSimilar("Solid", name)) << name;
  }
  for (const char* name : {"", "wall", "sod", "dilos", "solid12", "szlzd", "osild"}) {
    EXPECT_FALSE(areSimilar(name, "solid")) << name;
  }
  EXPECT_FALSE(areSimilar("p", "q"));
  EXPECT_TRUE(areSimilar("", ""));
}

TEST(TiledAskedNames, WhatIsNotThereIsAPart) {
  const auto partial = [](const Options& options) {
    const std::string set = "<tileset firstgid='1' name='s' tilewidth='32' tileheight='32'><tile id='0'>" +
                            property("kind", "rock") + "</tile></tileset>";
    return mustImport(set + csvLayer(1, 1, "1"), options).report.partial;
  };
  EXPECT_EQ(partial({.solidIf = {"kind=rock", "kind=ice", "colides"}, .leaveOut = {"lava"}}),
            "nothing has what was asked for: colides, kind=ice, lava");
  EXPECT_EQ(partial({.solidIf = {"kind"}}), "");
}

}  // namespace
}  // namespace lgs::tiled
