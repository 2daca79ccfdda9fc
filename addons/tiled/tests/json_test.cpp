// Tiled's JSON: it means what the same map in XML means, in all versions of the format; and what is said of bad files.
#include "maps.h"
#include "packed.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"

#include <array>
#include <iterator>
#include <ostream>
#include <random>

namespace lgs::tiled {
namespace {

/// A map of several files: chunks or not, tiles packed or not, groups, tile objects, templates, properties.
struct AnyFiles {
  std::vector<std::uint32_t> tiles;  ///< by rows of 4
  int encoding = 0;
  bool inChunks = false;
  int shift = 0;
  std::vector<int> objects;
  unsigned inJson = 0;  ///< which of the files, by bits
};

std::string dataOf(const AnyFiles& any) {
  const std::string raw = rawTiles(any.tiles);
  std::string csv;
  for (const std::uint32_t tile : any.tiles) csv += (csv.empty() ? "" : ",") + std::to_string(tile);
  const std::vector<std::pair<std::string, std::string>> forms{
      {"encoding='csv'", csv},
      {"encoding='base64'", base64(raw)},
      {"encoding='base64' compression='zlib'", base64(deflated(raw, 15))},
      {"encoding='base64' compression='gzip'", base64(deflated(raw, 15 + 16))},
      {"encoding='base64' compression='zstd'", base64(zstdPacked(raw))},
  };
  const auto& [attributes, text] = forms[static_cast<std::size_t>(any.encoding)];
  const std::string rows = std::to_string(any.tiles.size() / 4);
  const std::string content =
      any.inChunks ? "<chunk x='-4' y='-2' width='4' height='" + rows + "'>" + text + "</chunk>" : text;
  return "<layer name='Ground' width='4' height='" + rows + "'><data " + attributes + ">" + content + "</data></layer>";
}

Files filesOf(const AnyFiles& any) {
  const std::vector<std::string> kinds{
      "<object id='1' x='40.5' y='8' width='50' height='20' rotation='20' type='ice'/>",
      "<object id='2' x='-9' y='70' width='30' height='30' class='mud'><ellipse/></object>",
      "<object id='3' x='64' y='64'><polygon points='0,0 30.25,-20 60,15'/></object>",
      "<object id='4' x='64' y='0'><polyline points='0,0 30,0 30,30 0,0'/></object>",
      "<object id='5' x='3' y='3'><point/></object>",
      "<object id='6' x='10' y='90' width='40' height='10' rotation='-45'><capsule/></object>",
      "<object id='7' gid='2147483650' x='32' y='96' width='48' height='32' rotation='90'/>",
      "<object id='8' template='../kit/box.tx' x='100' y='40'/>",
      "<object id='9' template='../kit/box.tx' x='0' y='0' width='20' height='20'/>",
      "<object id='10' template='../kit/tile.tx' x='64' y='96'/>",
      "<object id='11' x='5' y='5' width='90' height='9' name='a \"name\"'><text wrap='1'>Hello</text></object>",
  };
  std::string objects;
  for (const int kind : any.objects) objects += kinds[static_cast<std::size_t>(kind)];
  return {{"maps/test.tmx",
           mapXml("<tileset firstgid='1' source='../kit/set.tsx'/><group name='G' offsetx='" +
                      std::to_string(any.shift) + "'>" + dataOf(any) + "</group><objectgroup name='O' offsety='" +
                      std::to_string(any.shift) + "' class='stone'><properties><property name='solid' type='bool' " +
                      "value='true'/></properties>" + objects + "</objectgroup>",
                  std::string("width='4' height='3' infinite='") + (any.inChunks ? "1'" : "0'"))},
          {"kit/set.tsx",
           "<tileset name='set' tilewidth='32' tileheight='32' tilecount='4'><tileoffset x='2' y='-3'/>"
           "<image source='set.png' width='64' height='64'/><tile id='0'><objectgroup>" +
               kFullTile +
               "</objectgroup></tile><tile id='1' type='water'><objectgroup><object id='1' x='0' y='32'><polygon "
               "points='0,0 32,0 32,-16'/></object></objectgroup></tile><tile id='2'><properties><property name='hard' "
               "type='int' value='2'/></properties></tile></tileset>"},
          {"kit/box.tx", "<template><object class='rock' width='64' height='32' rotation='10'/></template>"},
          {"kit/tile.tx",
           "<template><tileset firstgid='1' source='set.tsx'/><object gid='2' width='32' "
           "height='32'/></template>"}};
}

void showValue(const AnyFiles& any, std::ostream& out) {
  unsigned file = 1;
  for (const auto& [name, text] : filesOf(any)) {
    out << name << ((any.inJson & file) != 0 ? ", as JSON: " : ": ") << text << "\n";
    file *= 2;
  }
}

rc::Gen<AnyFiles> anyFiles() {
  const auto tile = rc::gen::map(rc::gen::pair(rc::gen::inRange(0U, 6U), rc::gen::inRange(0U, 8U)),
                                 [](std::pair<std::uint32_t, std::uint32_t> drawn) {
                                   return drawn.first == 0 ? 0 : drawn.first | drawn.second << 29;
                                 });
  const auto drawn =
      rc::gen::tuple(rc::gen::container<std::vector<std::uint32_t>>(12, tile), rc::gen::inRange(0, 5),
                     rc::gen::arbitrary<bool>(), rc::gen::inRange(-40, 40),
                     rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 11)), rc::gen::inRange(1U, 16U));
  return rc::gen::map(drawn, [](const auto& d) {
    return AnyFiles{std::get<0>(d), std::get<1>(d), std::get<2>(d), std::get<3>(d), std::get<4>(d), std::get<5>(d)};
  });
}

TEST(TiledJson, MeansWhatTheSameMapInXmlMeans) {
  const auto law = [](const AnyFiles& any) {
    const Options options{.solidIf = {"hard=2"}, .blockFrom = BlockFrom::tileClass};
    const Files files = filesOf(any);
    const auto json = test::must(asJson(files, [&](const std::string& name) {
      const auto at = std::distance(files.begin(), files.find(name));
      return (any.inJson >> at & 1U) != 0;
    }));
    ASSERT_NE(json, files);
    const auto a = test::must(importFiles(files, options)), b = test::must(importFiles(json, options));
    expectAlike(a, b);
    worldOf(b);
  };
  test::forAll(200, law, rc::gen::resize(rc::kNominalSize / 4, anyFiles()));
}

/// A map of 32×32 pixel tiles, 2 tiles wide and high, with these members.
std::string mapJson(const std::string& members) {
  return "{\"type\":\"map\", \"tilewidth\":32, \"tileheight\":32, \"width\":2, \"height\":2,\n" + members + "}";
}

const std::string kSetJson =
    R"("tilesets":[{"firstgid":1, "name":"set", "tilewidth":32, "tileheight":32, "tiles":[{"id":0, "objectgroup":)"
    R"({"type":"objectgroup", "objects":[{"id":1, "x":0, "y":0, "width":32, "height":32}]}}]}])";

std::string layerJson(const std::string& members) {
  return mapJson(kSetJson + R"(, "layers":[{"type":"tilelayer", "name":"L", "width":2, "height":2, )" + members + "}]");
}

TEST(TiledJson, FieldsThatXmlDoesNotHave) {
  const auto cells = [](const std::string& json, const Options& options = {}) {
    return cellsOf(mustImportFiles({{"maps/test.tmx", json}}, options));
  };
  EXPECT_EQ(cells(layerJson(R"("data":[1,0,0,1])")), (Cells{{1, -2}, {0, -1}}));
  EXPECT_EQ(cells("\xEF\xBB\xBF \n" + layerJson(R"("data":[1.0,0,0,0])")), (Cells{{0, -1}}));
  EXPECT_EQ(cells(layerJson(R"("data":[1,0,0,0], "startx":-3, "starty":5)")), (Cells{{-3, -6}}))
      << "an infinite map without chunks";
  EXPECT_EQ(cells(layerJson(R"("data":[1,0,0,0], "class":null, "properties":null, "chunks":null)")), (Cells{{0, -1}}));
  const std::string object = R"({"x":0, "y":0, "width":32, "height":64, "ellipse":false, "point":false})";
  EXPECT_EQ(cells(mapJson(R"("layers":[{"type":"objectgroup", "name":"wall", "objects":[)" + object + "]}]")),
            (Cells{{0, -2}, {0, -1}}));
  const auto map =
      mustImportFiles({{"maps/test.tmx", layerJson(R"("data":[1,0,0,0])")}}, {.blockFrom = BlockFrom::tileClass});
  EXPECT_EQ(map.blocks, (std::map<std::string, Block>{{"", 1}})) << "the type of a layer is no class";
}

/// Until Tiled 1.1 tiles and properties were objects, and until 0.18 files did not say what they are.
TEST(TiledJson, OldFormsOfTheFormat) {
  const std::string old = R"({"tilewidth":32, "tileheight":32, "width":2, "height":1,
    "layers":[{"type":"tilelayer", "name":"L", "width":4, "height":1, "data":[1,2,3,4], "properties":{"p":"q"}}],
    "tilesets":[{"firstgid":1, "source":"old.json"}]})";
  const std::string set = R"({"name":"old", "tilewidth":32, "tileheight":32,
    "tiles":{"1":{"type":"mud", "objectgroup":{"objects":[{"id":7, "x":0, "y":0, "width":32, "height":32}]}}, "3":{}},
    "tileproperties":{"1":{"a":1}, "2":{"solid":true}, "3":{"solid":false}}})";
  const auto map = mustImportFiles({{"maps/test.tmx", old}, {"maps/old.json", set}},
                                   {.solidIf = {"solid"}, .blockFrom = BlockFrom::tileClass});
  EXPECT_EQ(cellsOf(map), (Cells{{1, -1}, {2, -1}}));
  EXPECT_EQ(map.placements.at(0).object, 7U);
  EXPECT_EQ(map.blocks, (std::map<std::string, Block>{{"mud", 1}, {"", 2}}));
  EXPECT_EQ(mustImportFiles({{"maps/test.tmx", old}, {"maps/old.json", set}},
                            {.solidIf = {"p=q"}, .blockFrom = BlockFrom::tileClass})
                .placements.size(),
            4U);
}

TEST(TiledJson, ErrorsNameThePlace) {
  const auto objects = [](const std::string& object) {
    return mapJson(R"("layers":[{"type":"group", "layers":[{"type":"objectgroup", "name":"wall", "objects":[)" +
                   object + "]}]}]");
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {"{\"type\":\"map\",\n\"layers\":[\n{\"x\":1,}]}",
       ":3: is not well-formed JSON: syntax error while parsing object "
       "key - unexpected '}'; expected string literal"},
      {"{\"x\":\n\n1e999}", ":3: is not well-formed JSON: number overflow parsing '1e999'"},
      {"{\"x\":NaN}", ":1: is not well-formed JSON: syntax error while parsing value - invalid literal"},
      {"{\"x\":\n\"a\n\"}",
       ":2: is not well-formed JSON: syntax error while parsing value - invalid string: control character U+000A (LF) "
       "must be escaped to \\u000A or \\n"},
      {"[]", ": is JSON, but neither of Tiled (a map, tileset, template or world) nor an LDtk project"},
      {"{\"type\":\"tileset\"}", ": <tileset> should be <map>: this is not the kind of file expected here"},
      {"{\"type\":\"map\", \"tilewidth\":32}", ": <map> has no attribute 'tileheight'"},
      {mapJson("\"orientation\":\"isometric\""),
       ": <map> has the orientation 'isometric': only orthogonal maps have square cells"},
      {mapJson("\"layers\":7"), ": layers should be an array"},
      {mapJson("\"layers\":[7]"), ": layers/0 should be an object"},
      {mapJson("\"layers\":[{}]"), ": layers/0/type should be tilelayer, objectgroup, imagelayer or group"},
      {mapJson("\"tilesets\":[{\"firstgid\":1}]"), ": tilesets/0 has no attribute 'tilewidth'"},
      {mapJson("\"tilesets\":[{\"firstgid\":0, \"source\":\"no.tsj\"}]"),
       ": tilesets/0 'no.tsj' firstgid='0' should be a whole number from 1 to 268435455"},
      {layerJson("\"offsetx\":0"), ": layers/0 'L' has no <data>"},
      {layerJson("\"data\":[1,-1,0,0]"), ": layers/0/data tile 2 is not a tile number"},
      {layerJson("\"data\":[1,0,0,null]"), ": layers/0/data tile 4 is not a tile number"},
      {layerJson("\"data\":[1,0,0]"), ": layers/0/data holds 3 tiles where its size asks for 4"},
      {layerJson("\"data\":\"1,0,0,0\""),
       ": layers/0/data should be an array of tile numbers (a text needs \"encoding\": \"base64\")"},
      {layerJson("\"encoding\":\"base64\", \"data\":[1,0,0,0]"),
       ": layers/0/data should be a text, as its encoding is base64"},
      {layerJson("\"encoding\":\"base64\", \"data\":\"%\""), ": layers/0/data is not valid base64"},
      {layerJson("\"offsetx\":\"a\", \"data\":[1,0,0,0]"), ": layers/0 'L' offsetx='a' should be a finite number"},
      {layerJson("\"chunks\":[{\"x\":0, \"y\":0, \"width\":1, \"height\":1, \"data\":[]}]"),
       ": layers/0/chunks/0 holds 0 tiles where its size asks for 1"},
      {objects("{\"id\":1}, {\"id\":2, \"rotation\":\"far\"}"),
       ": layers/0/layers/0/objects/1 '2' rotation='far' should be a finite number"},
      {objects("{\"polygon\":[{\"x\":1, \"y\":2}, {\"x\":1}]}"),
       ": layers/0/layers/0/objects/0/polygon/1/y is missing"},
      {objects("{\"polygon\":[{\"x\":1, \"y\":\"2\"}]}"),
       ": layers/0/layers/0/objects/0/polygon/0/y should be a number"},
      {objects("{\"polygon\":{\"x\":1}}"), ": layers/0/layers/0/objects/0/polygon should be an array"},
  };
  for (const auto& [json, expected] : cases) EXPECT_EQ(refusalOf(json), "maps/test.tmx" + expected) << json;
}

TEST(TiledJson, ANumberOfAnotherTypeIsNamed) {
  const auto withoutNumber = [](const std::string& value) {
    const std::string is = "='" + std::string(value.size() > 3 ? value : "…") + "' should be a ";
    const std::string whole = is + "whole number from ", finite = is + "finite number";
    const auto objects = [&](const std::string& content) {
      return mapJson(R"("layers":[{"type":"objectgroup", "name":"Walls", "objects":[{)" + content + "}]}]");
    };
    const std::string object = ": layers/0/objects/0 ", set = R"("tilesets":[{"firstgid":1, "tilewidth":8, )";
    const std::vector<std::pair<std::string, std::string>> cases{
        {R"({"type":"map", "tilewidth":)" + value + R"(, "tileheight":8})", ": <map> tilewidth" + whole + "1 to 65536"},
        {objects("\"gid\":" + value), object + "gid" + whole + "0 to 4294967295"},
        {objects("\"x\":" + value), object + "x" + finite},
        {objects("\"rotation\":" + value), object + "rotation" + finite},
        {mapJson(set + "\"tileheight\":8, \"tileoffset\":{\"y\":" + value + "}}]"),
         ": tilesets/0/tileoffset y" + finite},
        {mapJson(set + "\"tileheight\":8, \"tiles\":[{\"id\":0, \"image\":\"i\", \"imagewidth\":" + value + "}]}]"),
         ": tilesets/0/tiles/0 width" + whole + "0 to 1048576"},
        {mapJson("\"layers\":[{\"type\":\"group\", \"offsety\":" + value + "}]"), ": layers/0 offsety" + finite},
        {mapJson("\"layers\":[{\"type\":\"group\", \"parallaxx\":" + value + "}]"), ": layers/0 parallaxx" + finite}};
    for (const auto& [json, expected] : cases) EXPECT_EQ(refusalOf(json), "maps/test.tmx" + expected) << json;
    EXPECT_EQ(refusalOf(objects("\"width\":8, \"height\":8, \"note\":" + value)), "accepted") << "nobody reads it";
  };
  for (const char* value : {"[]", "[8]", "{}", "true", "false"}) withoutNumber(value);
  EXPECT_EQ(refusalOf(R"({"type":"map", "tilewidth":"x", "tileheight":8})"),
            "maps/test.tmx: <map> tilewidth='x' should be a whole number from 1 to 65536");
  EXPECT_EQ(refusalOf(mapJson(R"("layers":[{"type":"group", "name":"G", "parallaxy":"x"}])")),
            "maps/test.tmx: layers/0 'G' parallaxy='x' should be a finite number");
}

TEST(TiledJson, HugeNumbersAndDeepNesting) {
  const auto nested = [](std::size_t depth) {
    const std::string layer = R"({"type":"group", "layers":[)", end = "]}";
    std::string open, close;
    for (std::size_t k = 0; k < depth; ++k) {
      open += layer;
      close += end;
    }
    return mapJson("\"layers\":[" + open + close + "]");
  };
  EXPECT_EQ(refusalOf(nested(60)), "accepted");
  EXPECT_THAT(refusalOf(nested(100)), HasSubstr("groups are nested too deeply"));
  const std::string tooDeep = "maps/test.tmx: has arrays and objects in each other, more than 512 deep";
  EXPECT_EQ(refusalOf(nested(300)), tooDeep);
  EXPECT_EQ(refusalOf(std::string(1'000'000, '[')), tooDeep);
  EXPECT_EQ(refusalOf(std::string(512, '[') + std::string(512, ']')),
            "maps/test.tmx: is JSON, but neither of Tiled (a map, tileset, template or world) nor an LDtk project");
  const std::string whole = " should be a whole number from 0 to 268435456";
  for (const char* width : {"1e300", "1.5", "-1", "18446744073709551615", "99999999999999999999", "\"2\\u0000\""}) {
    const std::string refusal =
        refusalOf(R"({"layers":[], "tilewidth":32, "tileheight":32, "width":)" + std::string(width) + "}");
    if (*width != '"') {
      EXPECT_THAT(refusal, HasSubstr(whole)) << width << ": " << refusal;
    } else {
      EXPECT_EQ(refusal, "accepted") << "a text ends at its first zero";
    }
  }
  EXPECT_THAT(refusalOf(layerJson(R"("data":[1,1,1,1], "offsetx":-1e300)")), HasSubstr("its offset is too large"));
}

/// A template whose tileset has a tile whose shape is of that template.
TEST(TiledJson, FilesThatNameEachOtherComeToAnEnd) {
  const auto map = mustImportFiles(
      {{"maps/test.tmx", mapJson(R"("layers":[{"type":"objectgroup", "name":"wall", "objects":[)"
                                 R"({"id":1, "template":"a.tj", "x":0, "y":32}]}])")},
       {"maps/a.tj", R"({"type":"template", "tileset":{"firstgid":1, "source":"a.tsj"},
                         "object":{"gid":1, "width":32, "height":32}})"},
       {"maps/a.tsj", R"({"type":"tileset", "tilewidth":32, "tileheight":32, "tiles":[{"id":0, "objectgroup":
                          {"objects":[{"id":1, "template":"a.tj", "x":0, "y":32}]}}]})"}});
  ASSERT_EQ(map.report.layers.at(0).notes.size(), 1U);
  EXPECT_EQ(map.report.layers.at(0).notes.at(0).text, "a shape of its tile is a tile object");
}

TEST(TiledJson, DamagedFilesNeverCrash) {
  const AnyFiles any{{1, 2, 3, 4, 0, 1, 2, 3, 1, 2, 3, 4}, 2, true, 5, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 0};
  const Files good = asJson(filesOf(any), [](const std::string&) { return true; }).value();
  std::mt19937 random(7);
  Options options;
  options.maxTiles = options.maxPlacements = 10'000;
  options.objects = std::vector<std::string>{"O"};
  int accepted = 0;
  for (int round = 0; round < 500; ++round) {
    Files bad = good;
    std::string& text = std::next(bad.begin(), static_cast<int>(random() % bad.size()))->second;
    for (unsigned edit = 0; edit <= random() % 4; ++edit) {
      const std::size_t at = random() % text.size();
      constexpr std::string_view kLetters = "0123456789{}[]:\",.-ex";
      switch (random() % 4) {
        case 0:
          text[at] = kLetters[random() % kLetters.size()];
          break;
        case 1:
          text.erase(at, 1 + random() % 10);
          break;
        case 2: {  // another value
          constexpr std::array kValues{"null", "true", "[]", "{}", "-1", "1e300", "\"\"", "[[1]]", "{\"x\":{}}"};
          const std::size_t colon = text.find(':', at), end = text.find_first_of(",}]", colon);
          if (end != std::string::npos) text.replace(colon + 1, end - colon - 1, kValues[random() % kValues.size()]);
          break;
        }
        default:
          text.insert(at, text.substr(random() % text.size(), 1 + random() % 20));
          break;
      }
    }
    const auto map = importFiles(bad, options);
    if (map) worldOf(*map);
    accepted += map.has_value();
  }
  EXPECT_GT(accepted, 50) << "most are refused at once: the test would show nothing";
}

}  // namespace
}  // namespace lgs::tiled
