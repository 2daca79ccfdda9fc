// What a map from a stranger may read: regular files below its folder, unless an option opens more.
#include "addons/tiled/src/xml.h"
#include "maps.h"
#include "proptests/support/command.h"

#include <sys/stat.h>
#include <unistd.h>
#include <cstdlib>

namespace lgs::tiled {
namespace {

namespace fs = std::filesystem;

TEST(TiledBelow, IsDecidedByThePathAsItIsWritten) {
  for (const char* path : {"maps/a", "maps/b/c", "maps/b/../a", "./maps/a", "maps//a", "maps/..a"}) {
    EXPECT_TRUE(liesBelow("maps", path)) << path;
  }
  for (const char* path :
       {"maps", "maps/", "maps/.", "a", "maps/../a", "mapsa", "/maps/a", "../maps/a", "..", "", "."}) {
    EXPECT_FALSE(liesBelow("maps", path)) << path;
  }
  for (const char* path : {"a", "b/../a", "../a", "..a"}) EXPECT_TRUE(liesBelow("..", path)) << path;
  for (const char* path : {"..", "../..", "../../a", "/a", "."}) EXPECT_FALSE(liesBelow("..", path)) << path;
  EXPECT_TRUE(liesBelow("../..", "../../a/b"));
  EXPECT_TRUE(liesBelow("../maps", "../maps/a"));
  EXPECT_FALSE(liesBelow("../maps", "../a"));
  for (const char* folder : {"", ".", "./"}) {
    EXPECT_TRUE(liesBelow(folder, "a")) << folder;
    EXPECT_TRUE(liesBelow(folder, "b/../a")) << folder;
    for (const char* path : {"", ".", "..", "../a", "b/../../a", "/a", "//a/b"}) {
      EXPECT_FALSE(liesBelow(folder, path)) << folder << " " << path;
    }
  }
  EXPECT_TRUE(liesBelow("/srv/maps", "/srv/maps/a"));
  EXPECT_FALSE(liesBelow("/srv/maps", "/srv/other"));
  EXPECT_FALSE(liesBelow("/srv/maps", "srv/maps/a"));
}

/// All paths of up to four steps.
std::vector<std::string> shortPaths() {
  std::vector<std::string> paths{"", "..", ".", "a", "a.json"};
  for (std::size_t k = 1; k < 85; ++k)
    for (const char* step : {"..", ".", "a", "a.json"}) paths.push_back(paths[k] + "/" + step);
  return paths;
}

TEST(TiledBelow, TheFolderOfTwoFilesIsTheNearestThatHoldsBoth) {
  for (const std::string file : {"f", "a/f", "a/a/f", "../f", "../../a/f", "./f"}) {
    for (const std::string& other : shortPaths()) {
      if (other.empty()) continue;
      const std::string in = other + "/f";
      fs::path nearest = fs::path(file).parent_path();
      for (int up = 0; up < 9 && !liesBelow(nearest.generic_string(), in); ++up) nearest = nearest / "..";
      EXPECT_EQ(folderOfBoth(file, other), withoutSlash(nearest)) << file << " " << other;
      EXPECT_TRUE(liesBelow(folderOfBoth(file, other), file) && liesBelow(folderOfBoth(file, other), in)) << other;
    }
  }
}

constexpr const char* kOutside = "it is not in the folder maps. If the map can be trusted: Options::filesIn = ";
constexpr const char* kAbsolute =
    "its path is absolute. If the map can be trusted, files may lie anywhere: Options::filesAnywhere";
constexpr const char* kOtherKind = "it has not the extension of a tileset, such as .tsx";

/// What is said of a file that is not read; a tileset alone is no reason to refuse the map.
std::string whyNot(const tl::expected<ImportedMap, ImportError>& map) {
  return map ? map->report.partial : message(map.error());
}

/// What the import says, and which paths it has asked for.
std::string said(const std::string& text, std::vector<std::string>& asked, const std::string& other = "<tileset/>") {
  const auto map = importMap("maps/a.tmx", {}, [&](const std::string& path) -> tl::expected<std::string, std::string> {
    asked.push_back(path);
    return path == "maps/a.tmx" ? text : other;
  });
  return whyNot(map).empty() ? "accepted" : whyNot(map);
}

TEST(TiledStrangeMaps, NoReaderIsAskedForWhatLiesElsewhere) {
  for (const auto& [name, why] : std::map<std::string, const char*>{{"../a.tsx", kOutside},
                                                                    {"b/../../a.tsx", kOutside},
                                                                    {"..\\a.tsx", kOutside},
                                                                    {"/etc/passwd", kAbsolute},
                                                                    {"\\\\server\\share\\a.tsx", kAbsolute},
                                                                    {"//server/share/a.tsx", kAbsolute},
                                                                    {"\\etc\\a.tsx", kAbsolute},
                                                                    {"..", kOtherKind},
                                                                    {"a.png", kOtherKind},
                                                                    {".git/config", kOtherKind}}) {
    std::vector<std::string> asked;
    const std::string text = said(mapXml("<tileset firstgid='1' source='" + name + "'/>"), asked);
    EXPECT_NE(text.find(std::string(" cannot be read: ") + why), std::string::npos) << name << ": " << text;
    EXPECT_EQ(asked, std::vector<std::string>{"maps/a.tmx"}) << name;
  }
  std::vector<std::string> asked;
  const std::string box = "<objectgroup name='wall'><object id='1' template='../t.tx' x='0' y='0'/></objectgroup>";
  const std::string world = R"({"type":"world", "maps":[{"fileName":"../b.tmx", "x":0, "y":0}]})";
  EXPECT_EQ(said(mapXml(box), asked), "accepted") << "a template that can not be read spoils its object alone";
  EXPECT_NE(said(world, asked).find(kOutside), std::string::npos);
  EXPECT_EQ(asked, (std::vector<std::string>{"maps/a.tmx", "maps/a.tmx"}));
}

/// Whatever a file calls another one, the import ends, and asks for nothing that lies elsewhere.
TEST(TiledStrangeMaps, AnyNameOfAFileComesToAnEnd) {
  for (const std::string map : {"m.tmx", "maps/m.tmx", "../m.tmx", "../../maps/m.tmx", "/maps/m.tmx"}) {
    for (const std::string& name : shortPaths()) {
      const std::string box = "<object id='1' template='" + name + "' x='0' y='0'/>";
      for (const std::string& text : {mapXml("<tileset firstgid='1' source='" + name + "'/>"),
                                      mapXml("<objectgroup name='wall'>" + box + "</objectgroup>"),
                                      R"({"type":"world", "maps":[{"fileName":")" + name + R"(", "x":0, "y":0}]})"}) {
        const auto ended = importMap(map, {}, [&](const std::string& path) -> tl::expected<std::string, std::string> {
          EXPECT_TRUE(path == map || liesBelow(folderOf(map), path)) << map << " names " << name << ": " << path;
          return path == map ? text : "<tileset/>";
        });
        EXPECT_TRUE(ended || !message(ended.error()).empty());
      }
    }
  }
}

/// A file that the map names need not be the map's. Its text is in no error.
TEST(TiledStrangeMaps, OtherFilesAreNotQuoted) {
  for (const std::string secret :
       {"{\"key\": SECRET}", "{\"a\": \"SECRET", "[SECRET]", "<SECRET/>", "<a>SECRET", "<tileset firstgid='SECRET'",
        "<tileset name='SECRET' tilewidth='SECRET'/>", "<tileset tilewidth='1' tileheight='SECRET' id='SECRET'/>",
        "{\"type\":\"SECRET\"}", "{\"tilewidth\":\"SECRET\", \"type\":\"tileset\", \"name\":\"SECRET\"}", "SECRET",
        "<tileset tilewidth='1' tileheight='1'><tile id='0'><objectgroup><object name='SECRET' x='SECRET'/>"
        "</objectgroup></tile></tileset>",
        "<tileset tilewidth='1' tileheight='1'><tile id='0'><objectgroup><object><polygon points='SECRET'/></object>"
        "</objectgroup></tile></tileset>"}) {
    std::vector<std::string> asked;
    const std::string text =
        said(mapXml("<tileset firstgid='1' source='s.tsx'/>" + csvLayer(1, 1, "1")), asked, secret);
    EXPECT_NE(text, "accepted") << secret;
    EXPECT_EQ(text.find("SECRET"), std::string::npos) << text;
    for (const char* layer :
         {"<layer name='SECRET'><data encoding='SECRET'/></layer>", "", "<layer name='SECRET'/>",
          "<layer width='1' height='1'><data encoding='base64' compression='SECRET'>AAAAAA==</data></layer>",
          "<tileset firstgid='1' name='SECRET' tilewidth='1' tileheight='1'/>"
          "<tileset firstgid='1' name='b' tilewidth='1' tileheight='1'/>"}) {
      const std::string map = mapXml(layer, *layer != '\0' ? "" : "orientation='SECRET'");
      const std::string world = R"({"type":"world", "maps":[{"fileName":"b.tmx", "x":0, "y":0}]})";
      EXPECT_EQ(said(world, asked, map).find("SECRET"), std::string::npos) << said(world, asked, map);
    }
  }
  std::vector<std::string> asked;
  const std::string set = "<tileset firstgid='1' source='s.tsx'/>";
  EXPECT_EQ(said(mapXml(set + set), asked, "<tileset name='SECRET' tilewidth='1' tileheight='1'/>").find("SECRET"),
            std::string::npos);
  EXPECT_EQ(said(mapXml(set), asked, "[4e777]").find("4e777"), std::string::npos) << "a number that is too large";
  EXPECT_NE(said(mapXml("", "width='mine'"), asked).find("mine"), std::string::npos) << "the map's own text is";
}

class TiledDisk : public test::InAFolder {
 protected:
  void SetUp() override {
    InAFolder::SetUp();
    fs::create_directories(folder_ / "maps/sub");
    put("secret.tsx", kSet);
    put("maps/own.tsx", kSet);
    put("maps/sub/own.tsx", kSet);
  }

  /// What the import of a map that names a tileset says.
  std::string said(const std::string& source, bool anywhere = false) const {
    put("maps/a.tmx", mapXml("<tileset firstgid='1' source='" + source + "'/>" + csvLayer(1, 1, "1")));
    const auto map = importMap(path("maps/a.tmx"), {.filesIn = path("maps"), .filesAnywhere = anywhere});
    const std::string text = map ? map->report.partial : message(map.error());
    if (map && text.empty()) return "accepted";
    return (map ? "missing: " : "") + text.substr(std::min(text.size(), text.find("cannot be read: ") + 16));
  }

  static constexpr const char* kSet = "<tileset name='s' tilewidth='32' tileheight='32'/>";
};

TEST_F(TiledDisk, OnlyFilesBelowTheFolderOfTheMap) {
  EXPECT_EQ(said("own.tsx"), "accepted");
  EXPECT_EQ(said("sub/own.tsx"), "accepted");
  EXPECT_EQ(said("sub/../own.tsx"), "accepted");
  EXPECT_EQ(said("../secret.tsx"), "missing: it is not in the folder " + path("maps") +
                                       ". If the map can be trusted: Options::filesIn = " + folder_.string());
  EXPECT_EQ(said("../secret.tsx", true), "accepted");
  EXPECT_EQ(said(path("secret.tsx")), std::string("missing: ") + kAbsolute);
  EXPECT_EQ(said(path("maps/own.tsx")), std::string("missing: ") + kAbsolute) << "also where it may be read";
  EXPECT_EQ(said(path("secret.tsx"), true), "accepted");
  EXPECT_EQ(said("none.tsx"), "missing: there is no such file, or no permission to read it");
  fs::create_directory(folder_ / "maps/sub.tsx");
  EXPECT_EQ(said("sub.tsx"), "it is a folder");
}

TEST_F(TiledDisk, LinksLeadNowhereElse) {
  fs::create_symlink(folder_ / "secret.tsx", folder_ / "maps/out.tsx");
  fs::create_symlink(folder_ / "none.tsx", folder_ / "maps/broken.tsx");
  fs::create_directory_symlink(folder_, folder_ / "maps/up");
  fs::create_symlink("sub/own.tsx", folder_ / "maps/in.tsx");
  fs::create_symlink("loop.tsx", folder_ / "maps/loop.tsx");
  EXPECT_EQ(said("out.tsx"), "it is a symbolic link out of the folder");
  EXPECT_EQ(said("up/secret.tsx"), "it is a symbolic link out of the folder");
  EXPECT_EQ(said("out.tsx", true), "accepted");
  EXPECT_EQ(said("in.tsx"), "accepted") << "below the folder";
  for (const char* none : {"broken.tsx", "up/none.tsx", "loop.tsx"}) {
    EXPECT_EQ(said(none), "missing: there is no such file, or no permission to read it") << none;
  }
  fs::create_directory_symlink(folder_ / "maps", folder_ / "here");
  put("maps/a.tmx", mapXml("<tileset firstgid='1' source='own.tsx'/>"));
  EXPECT_TRUE(importMap(path("here/a.tmx"))) << "the map's own folder may be a link";
}

TEST_F(TiledDisk, NothingThatCouldBlock) {
  ASSERT_EQ(::mkfifo(path("maps/fifo.tsx").c_str(), 0600), 0);
  EXPECT_EQ(said("fifo.tsx"), "it is no regular file");
  EXPECT_EQ(said("fifo.tsx", true), "it is no regular file");
  EXPECT_EQ(said("/dev/zero", true), "it is no regular file");
  EXPECT_EQ(readFile(path("maps/fifo.tsx")).error(), "it is no regular file");
}

/// The folder of the project, as a path from the map's: "" is that of the map, ".." the one above.
TEST_F(TiledDisk, FilesMayLieInTheProjectOfTheMap) {
  const auto project = [&](const std::string& map) {
    return fs::relative(projectFolder(path(map)), fs::path(path(map)).parent_path()).generic_string();
  };
  const char* const home = std::getenv("HOME");
  const std::string before = home ? home : "";
  ::setenv("HOME", folder_.c_str(), 1);  // what others leave in the folder for temporary files marks nothing
  fs::create_directories(folder_ / "a/b/c/d");
  EXPECT_EQ(project("a/b/c/d/m.tmx"), "../..") << "of no project";
  put("a/package.json", "{}");
  EXPECT_EQ(project("a/b/c/d/m.tmx"), "../../..");
  put("a/b/game.tiled-project", "{}");
  EXPECT_EQ(project("a/b/c/d/m.tmx"), "../..") << "the nearest";
  EXPECT_EQ(project("a/b/m.tmx"), ".");
  ::setenv("HOME", path("a/b/c").c_str(), 1);
  fs::remove(folder_ / "a/b/game.tiled-project");
  EXPECT_EQ(project("a/b/c/d/m.tmx"), "..") << "not above the home folder";
  ::setenv("HOME", before.c_str(), 1);
  EXPECT_EQ(projectFolder("/m.tmx"), "/");
  EXPECT_EQ(projectFolder("/tmp/m.tmx"), "/tmp") << "never the root";
}

/// In a worktree or a submodule of Git `.git` is a file. What marks a project may be anything: nobody opens it.
TEST_F(TiledDisk, AMarkOfAProjectIsNotOpened) {
  fs::create_directories(folder_ / "a/b/c/d");
  ASSERT_EQ(::mkfifo(path("a/.git").c_str(), 0600), 0);
  EXPECT_EQ(projectFolder(path("a/b/c/d/m.tmx")), path("a"));
  put("a/b/.git", "gitdir: elsewhere");
  EXPECT_EQ(projectFolder(path("a/b/c/d/m.tmx")), path("a/b"));
  EXPECT_EQ(projectFolder(path("no/such/folder/m.tmx")), path("no/such/folder")) << "not even there";
}

/// A project above the home folder does not count, nor do the neighbours of a link to a map's folder.
TEST_F(TiledDisk, ALinkDoesNotMoveTheProject) {
  fs::create_directories(folder_ / "home/mine");
  fs::create_directories(folder_ / "else/game/maps");
  put("else/game/.git", "");
  put("package.json", "{}");
  put("home/secret.tsx", kSet);
  put("else/game/maps/a.tmx", mapXml("<tileset firstgid='1' source='../secret.tsx'/>" + csvLayer(1, 1, "1")));
  fs::create_directory_symlink(folder_ / "else/game/maps", folder_ / "home/link");
  const char* const home = std::getenv("HOME");
  const std::string before = home ? home : "";
  ::setenv("HOME", path("home").c_str(), 1);
  EXPECT_EQ(projectFolder(path("home/mine/m.tmx")), path("home"));
  EXPECT_EQ(projectFolder(path("home/link/a.tmx")), path("home/link"));
  EXPECT_THAT(whyNot(importMap(path("home/link/a.tmx"))), HasSubstr("it is not in the folder"));
  EXPECT_EQ(projectFolder(path("else/game/maps/a.tmx")), path("else/game"));
  fs::create_directories(folder_ / "home/got/from/a/stranger");
  put("home/package.json", "{}");
  EXPECT_EQ(projectFolder(path("home/got/from/a/stranger/m.tmx")), path("home/got/from")) << "home is no project";
  ::setenv("HOME", before.c_str(), 1);
}

TEST_F(TiledDisk, TheFolderThatIsNamedMayBeALink) {
  fs::create_directory_symlink(folder_ / "maps", folder_ / "link");
  fs::create_symlink(folder_ / "secret.tsx", folder_ / "maps/out.tsx");
  const auto said = [&](const char* source) {
    put("maps/sub/a.tmx", mapXml("<tileset firstgid='1' source='" + std::string(source) + "'/>"));
    return whyNot(importMap(path("link/sub/a.tmx"), {.filesIn = path("link")}));
  };
  EXPECT_EQ(said("../own.tsx"), "");
  EXPECT_THAT(said("../../secret.tsx"), HasSubstr("it is not in the folder"));
  EXPECT_THAT(said("../sub/../../maps/../secret.tsx"), HasSubstr("it is not in the folder")) << "by many steps";
  EXPECT_THAT(said("../out.tsx"), HasSubstr("a symbolic link out of the folder"));
}

TEST_F(TiledDisk, ATilesetInASiblingFolderIsRead) {
  fs::create_directories(folder_ / "game/maps");
  fs::create_directories(folder_ / "game/tilesets");
  put("game/project.godot", "");
  put("game/tilesets/Deco.tsx", kSet);
  const auto import = [&](const std::string& source) {
    put("game/maps/a.tmx", mapXml("<tileset firstgid='1' source='" + source + "'/>" + csvLayer(1, 1, "1")));
    return importMap(path("game/maps/a.tmx"));
  };
  EXPECT_TRUE(import("../tilesets/Deco.tsx").value().report.notes.empty());
  const auto other = import("../TileSets/deco.TSX");
  EXPECT_EQ(other.value().report.partial, "");
  EXPECT_THAT(other.value().report.notes, ElementsAre(HasSubstr("which differs by upper and lower case")));
  EXPECT_THAT(whyNot(import("../../secret.tsx")),
              HasSubstr("If the map can be trusted: Options::filesIn = " + folder_.string()));
  fs::create_symlink(folder_ / "secret.tsx", folder_ / "game/tilesets/out.tsx");
  EXPECT_THAT(message(import("../tilesets/out.tsx").error()), HasSubstr("a symbolic link out of the folder"));
  EXPECT_THAT(message(import("../tilesets/OUT.tsx").error()), HasSubstr("a symbolic link out of the folder"));
  ASSERT_EQ(::mkfifo(path("game/tilesets/fifo.tsx").c_str(), 0600), 0);
  EXPECT_THAT(message(import("../tilesets/fifo.tsx").error()), HasSubstr("it is no regular file"));
  put("game/tilesets/secret.tsx", "<SECRET>SECRET</SECRET>");
  EXPECT_THAT(message(import("../tilesets/secret.tsx").error()), Not(HasSubstr("SECRET")));
}

/// A template whose tile has a shape of that same template, and one that is its own.
TEST(TiledStrangeMaps, TemplatesMayNameEachOther) {
  const std::string shape = "<object id='1' template='a.tx'/>";
  const Files files{
      {"maps/test.tmx", mapXml("<objectgroup name='Walls'><object id='1' template='a.tx' x='0' y='32'/>"
                               "<object id='2' template='b.tx' x='64' y='32'/></objectgroup>")},
      {"maps/a.tx",
       "<template><tileset firstgid='1' source='a.tsx'/><object gid='1' width='32' height='32'/></template>"},
      {"maps/a.tsx", tilesOf32(tileXml(0, shape), "name='a'")},
      {"maps/b.tx", "<template><object template='b.tx' width='32' height='32'/></template>"}};
  const auto map = test::must(importMap("maps/test.tmx", {}, readerOf(files)));
  EXPECT_EQ(cellsOf(map), (Cells{{2, -2}})) << "the first has no shape";
}

TEST(TiledStrangeMaps, HugeNumbersTakeNoMemory) {
  std::vector<std::string> asked;
  const std::string huge = "268435456";
  const std::string sides = "width='" + huge + "' height='" + huge + "'";
  for (const char* data : {"<data encoding='csv'>1</data>", "<data encoding='base64' compression='zlib'>eJw=</data>"}) {
    EXPECT_THAT(said(mapXml("<layer name='solid' " + sides + ">" + data + "</layer>", sides), asked),
                HasSubstr("more tiles than the limit"));
  }
  EXPECT_EQ(said(mapXml("<tileset firstgid='1' tilewidth='32' tileheight='32' tilecount='268435455' columns='" + huge +
                        "'><image source='a.png' width='1048576' height='1048576'/></tileset>" + csvLayer(1, 1, "1")),
                 asked),
            "accepted");
  EXPECT_NE(said(mapXml("<objectgroup name='wall'><object id='1' width='131072' height='131072'/>"
                        "<object id='2' width='131072' height='131072'/></objectgroup>"),
                 asked),
            "accepted");
}

/// Its shapes and properties are not known; the tiles are.
TEST(TiledStrangeMaps, AMissingTilesetLosesItsShapesAlone) {
  std::vector<std::string> asked;
  const Files files{{"maps/test.tmx", mapXml("<tileset firstgid='1' source='no.tsx'/>" +
                                             csvLayer(2, 2, "0,0,1,1", "class='collision'"))}};
  const auto map = importMap("maps/test.tmx", {}, readerOf(files));
  EXPECT_EQ(cellsOf(map.value()), (Cells{{0, -2}, {1, -2}}));
  EXPECT_EQ(map->report.partial, "the tileset's file maps/no.tsx cannot be read: there is no such file");
  const FileReader secretive = [&](const std::string& path) -> tl::expected<std::string, std::string> {
    if (path == "maps/test.tmx") return files.at(path);
    return tl::unexpected<std::string>("it is nobody's business");
  };
  EXPECT_EQ(
      refusalOf(importMap("maps/test.tmx", {}, secretive)),
      "maps/test.tmx:3: <tileset> 'no.tsx' the tileset's file maps/no.tsx cannot be read: it is nobody's business");
}

TEST_F(TiledDisk, AReaderOfAFolderChecksItsPathsItself) {
  const FileReader reader = readerBelow(path("maps"));
  EXPECT_TRUE(reader(path("maps/own.tsx")));
  EXPECT_EQ(reader(path("maps/../secret.tsx")).error(), "it is not below the folder");
  EXPECT_EQ(reader("own.tsx").error(), "it is not below the folder");
}

}  // namespace
}  // namespace lgs::tiled
