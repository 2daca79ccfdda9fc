// Worlds of Tiled that place maps by patterns of file names.
#include "maps.h"

#include <unistd.h>
#include <filesystem>
#include <fstream>

namespace lgs::tiled {
namespace {

/// A map of 2 by 2 tiles of 32 px, full where the numbers are 1.
std::string squares(const std::string& csv) {
  return mapXml(tilesetXml({kFullTile}) + csvLayer(2, 2, csv), "width='2' height='2'");
}

std::string patternOf(const std::string& regexp, const std::string& more = "") {
  return "{\"regexp\":\"" + regexp + "\"" + more + "}";
}

std::string byPatterns(const std::string& patterns, const std::string& maps = "") {
  return "{\"maps\":[" + maps + "], \"patterns\":[" + patterns + "], \"type\":\"world\"}";
}

const std::string kBy64 = ", \"multiplierX\":64, \"multiplierY\":64";
const std::string kPlaces = patternOf("p(-?\\\\d+)_(-?\\\\d+)\\\\.tmx", kBy64);

/// The folder "maps" as a list, in the opposite order.
tl::expected<std::vector<std::string>, std::string> namesIn(const Files& files, const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& [path, text] : files) {
    if (path.starts_with(folder + "/")) names.insert(names.begin(), path.substr(folder.size() + 1));
  }
  if (names.empty()) return tl::unexpected<std::string>("no such folder");
  return names;
}

tl::expected<ImportedMap, ImportError> importWorld(const std::string& text, Files files, const Options& options = {}) {
  files["maps/test.world"] = text;
  return importMap("maps/test.world", options, readerOf(files),
                   [&](const std::string& folder) { return namesIn(files, folder); });
}

ImportedMap mustImportPatterns(const std::string& text, const Files& files) {
  ImportedMap map = test::must(importWorld(text, files));
  worldOf(map);
  return map;
}

std::vector<std::string> layersOf(const ImportedMap& map) {
  std::vector<std::string> paths;
  for (const LayerReport& layer : map.report.layers) paths.push_back(layer.path);
  return paths;
}

using Paths = std::vector<std::string>;

TEST(TiledWorldPatterns, PlaceMapsByTheirNames) {
  const Files files{{"maps/p0_0.tmx", squares("1,0,0,0")},
                    {"maps/p-1_2.tmx", squares("0,0,0,1")},
                    {"maps/p1_0.tmx", squares("0,1,0,0")},
                    {"maps/other.tmx", squares("1,1,1,1")},
                    {"maps/.p9_9.tmx", squares("1,1,1,1")}};
  const auto map = mustImportPatterns(byPatterns(kPlaces), files);
  EXPECT_EQ(cellsOf(map), (Cells{{-1, -6}, {0, -1}, {3, -1}}));
  EXPECT_EQ(layersOf(map), (Paths{"p-1_2/Ground", "p0_0/Ground", "p1_0/Ground"}))
      << "sorted; hidden files are not seen";
  EXPECT_EQ(map.report.width, 6);
  EXPECT_EQ(map.report.height, 6);
  EXPECT_TRUE(map.report.notes.empty());
}

TEST(TiledWorldPatterns, NumbersAreMultipliedAndMoved) {
  const Files files{{"maps/p2_3.tmx", squares("1,0,0,0")}};
  const auto cells = [&](const std::string& more) {
    return cellsOf(mustImportPatterns(byPatterns(patternOf("p(\\\\d+)_(\\\\d+)", more)), files));
  };
  EXPECT_EQ(cells(R"(, "multiplierX":64, "multiplierY":-32, "offsetX":-32, "offsetY":320)"), (Cells{{3, -8}}));
  EXPECT_EQ(cells(R"(, "multiplierX":32, "multiplierY":96, "mapWidth":7, "mapHeight":9)"), (Cells{{2, -10}}))
      << "a map is as large as it says";
  EXPECT_EQ(cells(R"(, "offsetX":30, "offsetY":29)"), (Cells{{1, -2}})) << "a multiplier is 1 if there is none";
  const Files plus{{"maps/p+2_3.tmx", squares("1,0,0,0")}};
  EXPECT_EQ(cellsOf(mustImportPatterns(byPatterns(patternOf("p([+]\\\\d)_(\\\\d)", kBy64)), plus)), (Cells{{4, -7}}));
}

TEST(TiledWorldPatterns, WhatIsPlacedStays) {
  const Files files{{"maps/p0_0.tmx", squares("1,0,0,0")}, {"maps/p1_0.tmx", squares("1,0,0,0")}};
  const std::string listed = R"({"fileName":"p1_0.tmx", "x":0, "y":-64})";
  const auto map = mustImportPatterns(byPatterns(kPlaces, listed), files);
  EXPECT_EQ(cellsOf(map), (Cells{{0, -1}, {0, 1}}));
  EXPECT_EQ(layersOf(map), (Paths{"p1_0/Ground", "p0_0/Ground"})) << "listed maps come first";
  const std::string later = patternOf("p(\\\\d)_(\\\\d)", R"(, "multiplierX":640, "multiplierY":640, "offsetX":32)");
  EXPECT_EQ(cellsOf(mustImportPatterns(byPatterns(kPlaces + "," + later), files)), (Cells{{0, -1}, {2, -1}}));
}

TEST(TiledWorldPatterns, NotesOfPatterns) {
  const Files files{{"maps/p0_0.tmx", squares("1,0,0,0")}, {"maps/p0_0.tmx.bak", squares("0,1,0,0")}};
  EXPECT_EQ(
      mustImportPatterns(byPatterns(kPlaces), files).report.notes,
      Paths{"the pattern 'p(-?\\d+)_(-?\\d+)\\.tmx' puts p0_0.tmx and p0_0.tmx.bak at one place. If one is a copy, "
            "end the pattern with $"});
  const std::string none = patternOf("q(\\\\d)(\\\\d)", kBy64), ended = patternOf("p(\\\\d)_(\\\\d)\\\\.tmx$", kBy64);
  EXPECT_EQ(mustImportPatterns(byPatterns(none + "," + ended), files).report.notes,
            Paths{"no file in the folder fits the pattern 'q(\\d)(\\d)'"});
}

std::string refusalBy(const std::string& text, const Files& files) { return refusalOf(importWorld(text, files)); }

TEST(TiledWorldPatterns, Refusals) {
  const Files files{
      {"maps/p0_x.tmx", squares("1,0,0,0")}, {"maps/p1_1.png", "\x89PNG"}, {"maps/p2_2.tsx", "<tileset/>"}};
  const std::string at = "maps/test.world: patterns/0 ";
  EXPECT_EQ(refusalBy(byPatterns(patternOf("p(\\\\d+")), files),
            at + "its regexp 'p(\\d+' is wrong at byte 6: missing closing parenthesis");
  EXPECT_EQ(refusalBy(byPatterns("{}"), files),
            at + "its regexp '' has 0 captures. It needs two: (…) for the column and (…) for the row");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("p(1)(2)(3)")), files),
            at + "its regexp 'p(1)(2)(3)' has 3 captures. It needs two: (…) for the column and (…) for the row");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("p(.)_(.)\\\\.tmx")), files),
            at + "takes p0_x.tmx, where it captures 'x': this is no whole number of 32 bits");
  const std::string px = patternOf("p(.)_(x|0)", ", \"multiplierX\":0");
  const Files zero{{"maps/p0_0.tmx", squares("1,0,0,0")}, {"maps/p4294967296_0.tmx", squares("1,0,0,0")}};
  EXPECT_EQ(refusalBy(byPatterns(px), zero), at + "multiplierX is 0, so all its maps would lie at one place");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("p(.+)_(.)")), zero),
            at + "takes p4294967296_0.tmx, where it captures '4294967296': this is no whole number of 32 bits");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("p(.)_(.)", ", \"offsetX\":0.5")), zero),
            at + "offsetX='0.5' should be a whole number from -2147483648 to 2147483647");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("p(.)_(.)", ", \"multiplierY\":[]")), zero),
            "maps/test.world: patterns/0 multiplierY='…' should be a whole number from -2147483648 to 2147483647");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("p(1)_(1)")), files),
            "maps/p1_1.png: is a PNG image, and no map. What is read: maps of Tiled (TMX or JSON), worlds of Tiled and "
            "projects of LDtk (it fits the pattern 'p(1)_(1)' of the world)");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("p(2)_(2)")), files),
            "maps/p2_2.tsx: its root should be <map>: this is not the kind of file expected here (it fits the pattern "
            "'p(2)_(2)' of the world)");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("test()().world")), files),
            at + "takes test.world, where it captures '': this is no whole number of 32 bits");
  EXPECT_EQ(refusalBy(byPatterns(patternOf("q(1)(2)")), files),
            "maps/test.world: <world> has no maps: no file fits its patterns");
  EXPECT_EQ(refusalBy(byPatterns("7"), files), at + "should be an object");
}

TEST(TiledWorldPatterns, HaveABoundOfWorkTogether) {
  Files files;
  for (int k = 0; k < 300; ++k) files["maps/" + std::to_string(1'000 + k) + std::string(100, 'a')] = "";
  const std::string costly = patternOf("(1)((?:a+)+)+[bc]");
  EXPECT_EQ(refusalBy(byPatterns(costly), files).substr(0, 84),
            "maps/test.world: patterns/0 its regexp '(1)((?:a+)+)+[bc]' takes too long to match: ");
  std::string many = patternOf("(2)(3)");
  for (int k = 0; k < 400; ++k) many += "," + patternOf("(2)(3)");
  EXPECT_THAT(refusalBy(byPatterns(many), files), HasSubstr("takes too long to match"))
      << "many patterns on many names";
}

TEST(TiledWorldPatterns, NeedAListOfTheFolder) {
  const Files files{{"maps/test.tmx", byPatterns(kPlaces)}};
  EXPECT_EQ(
      message(importFiles(files).error()),
      "maps/test.tmx: patterns/0 takes maps by the names of the files in its folder, and nothing lists them: give "
      "importMap() a FolderLister, or list the maps of the world as \"maps\"");
  const auto broken = importMap(
      "a.world", {}, [&](const std::string&) { return tl::expected<std::string, std::string>(byPatterns(kPlaces)); },
      [](const std::string& folder) -> tl::expected<std::vector<std::string>, std::string> {
        return tl::unexpected("no " + folder + " here");
      });
  EXPECT_EQ(message(broken.error()), "a.world: patterns/0 needs a list of its folder: no . here");
}

TEST(TiledWorldPatterns, FromTheDisk) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("lgs-patterns-" + std::to_string(::getpid()));
  fs::create_directories(folder / "p7_7.tmx");  // a folder is no map
  const auto put = [&](const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; };
  put("a.world", byPatterns(kPlaces));
  put("p0_0.tmx", squares("1,0,0,0"));
  put("p1_0.tmx", squares("1,0,0,0"));
  const auto map = importMap((folder / "a.world").string());
  EXPECT_EQ(map ? cellsOf(*map) : Cells{}, (Cells{{0, -1}, {2, -1}}));
  EXPECT_FALSE(listFolder((folder / "none").string()));
  EXPECT_EQ(listFolder(folder.string())->size(), 3U);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace lgs::tiled
