// Files that are no maps, or maps of other programs: each is named.
#include "maps.h"

namespace lgs::tiled {
namespace {

TEST(TiledForeign, FilesAreNamed) {
  const std::string read = ". What is read: maps of Tiled (TMX or JSON), worlds of Tiled and projects of LDtk";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "is empty"},
      {" \n", "is neither XML nor JSON"},
      {"hello", "is neither XML nor JSON"},
      {"[gd_scene load_steps=4 format=3]\n", "is a Godot scene"},
      {"[gd_resource type=\"TileSet\"]\n", "is a Godot resource"},
      {"\x89PNG\r\n\x1A\n", "is a PNG image, and no map"},
      {std::string("PK\x03\x04\0", 5), "is a ZIP archive: unpack it"},
      {"\x1F\x8B\x08", "is packed by gzip: unpack it"},
      {"\xFF\xD8\xFF\xE0", "is a JPEG image, and no map"},
      {"GIF89a", "is a GIF image, and no map"},
      {"RIFF1234WEBP", "is an image or a sound, and no map"},
      {"(function(name,data){", "is a JavaScript export: save the map as TMX or JSON"},
      {"lgssnap", "is a saved world of lgs, and no map"},
      {"{\"expandedProjectPaths\":[]}", "is a Tiled session: import a map"},
      {"{\"frames\":{}, \"meta\":{}}", "is an atlas of sprites, and no map"},
      {"%YAML 1.1\n%TAG !u!", "is a file of Unity or another program that writes YAML"},
      {"version https://git-lfs.github.com/spec/v1\n",
       "is a pointer of Git LFS: fetch the file itself with 'git lfs pull'"},
      {"return {\n  version = \"1.10\",", "is a Lua export: save the map as TMX or JSON"},
      {"lgs-trace 1\n", "is a trace of lgs, and no map"},
      {"{\"ogmoVersion\":\"3.4.0\", \"layers\":[]}", "is an Ogmo project or level"},
      {"{\"automappingRulesFile\":\"\", \"folders\":[\".\"]}",
       "is a Tiled project, which only lists folders: import its maps"},
      {"{\"__header__\":{\"app\":\"LDtk\"}, \"layerInstances\":[]}",
       "is one level of an LDtk project: import the project (.ldtk) that names it"},
  };
  for (const auto& [text, is] : cases) EXPECT_EQ(refusalOf(text), "maps/test.tmx: " + is + read);
  EXPECT_EQ(refusalOf("<!DOCTYPE html>\n<html><body/></html>"),
            "maps/test.tmx:2: <html> is a web page: download the file itself" + read);
  for (const auto& [root, is] : {std::pair("svg", "an SVG image, and no map"),
                                 {"level", "a level of Ogmo or another editor"},
                                 {"ogmo", "an Ogmo project"},
                                 {"objecttypes", "a list of Tiled's object types"}}) {
    EXPECT_EQ(refusalOf(std::string("<") + root + "/>"),
              std::string("maps/test.tmx:1: <") + root + "> is " + is + read);
  }
  EXPECT_EQ(refusalOf("<OgmoProject/>"), "maps/test.tmx:1: <OgmoProject> is an Ogmo project" + read);
  EXPECT_EQ(refusalOf("<world/>"),
            "maps/test.tmx:1: <world> should be <map>: this is not the kind of file expected here");
  const auto map =
      importFiles({{"maps/test.tmx", mapXml("<tileset firstgid='1' source='a.png'/>")}, {"maps/a.png", "\x89PNG"}});
  ASSERT_FALSE(map);
  EXPECT_EQ(message(map.error()), "maps/a.png: is a PNG image, and no map" + read);
}

/// A map may name any JSON file of its project: what it does not understand stays there, keys too.
TEST(TiledForeign, KeysOfOtherFilesAreNotQuoted) {
  for (const char* tiles :
       {R"({"secret": 1})", R"({"secret": {}})", R"({"secret": {"objectgroup": {"objects": 1}}})"}) {
    const Files files{{"maps/test.tmx", mapXml("<tileset firstgid='1' source='a.json'/>")},
                      {"maps/a.json", R"({"tilewidth": 8, "tileheight": 8, "tiles": )" + std::string(tiles) + "}"}};
    const auto map = importMap("maps/test.tmx", {}, readerOf(files));
    ASSERT_FALSE(map);
    EXPECT_THAT(message(map.error()), AllOf(HasSubstr("maps/a.json"), Not(HasSubstr("secret"))));
  }
}

/// However many tilesets are missing, the first line of the report stays one that can be read.
TEST(TiledForeign, MissingTilesetsAreSummedUp) {
  std::string sets;
  for (int k = 1; k <= 1'000; ++k) sets += fmt::format("<tileset firstgid='{0}' source='a{0}.tsx'/>", k);
  const Files files{{"maps/test.tmx", mapXml(sets + csvLayer(1, 1, "1"))}};
  const auto map = test::must(importMap("maps/test.tmx", {}, readerOf(files)));
  EXPECT_THAT(map.report.partial, HasSubstr("a1.tsx"));
  EXPECT_THAT(map.report.partial, HasSubstr("and 992 more"));
}

}  // namespace
}  // namespace lgs::tiled
