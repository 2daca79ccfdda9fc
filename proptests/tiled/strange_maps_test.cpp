// What a map from a stranger may read: regular files below its folder, unless an option opens more.
#include "maps.h"

#include <sys/stat.h>
#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <random>

#include "lib/tiled/src/below.h"

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

constexpr const char* kOutside =
    "it is not below the map's folder. If the map can be trusted, files may lie anywhere: Options::filesAnywhere";

/// What the import says, and which paths it has asked for.
std::string said(const std::string& text, std::vector<std::string>& asked, const std::string& other = "<tileset/>") {
  const auto map = importMap("maps/a.tmx", {}, [&](const std::string& path) -> tl::expected<std::string, std::string> {
    asked.push_back(path);
    return path == "maps/a.tmx" ? text : other;
  });
  return map ? "accepted" : message(map.error());
}

TEST(TiledStrangeMaps, NoReaderIsAskedForWhatLiesElsewhere) {
  for (const std::string name : {"../a.tsx", "/etc/passwd", "b/../../a.tsx", "..\\a.tsx", "\\\\server\\share\\a.tsx",
                                 "//server/share/a.tsx", "..", "\\etc\\passwd"}) {
    std::vector<std::string> asked;
    const std::string text = said(mapXml("<tileset firstgid='1' source='" + name + "'/>"), asked);
    EXPECT_TRUE(text.ends_with(std::string(" cannot be read: ") + kOutside)) << name << ": " << text;
    EXPECT_EQ(asked, std::vector<std::string>{"maps/a.tmx"}) << name;
  }
  std::vector<std::string> asked;
  const std::string box = "<objectgroup name='wall'><object id='1' template='../t.tx' x='0' y='0'/></objectgroup>";
  const std::string world = R"({"type":"world", "maps":[{"fileName":"../b.tmx", "x":0, "y":0}]})";
  EXPECT_EQ(said(mapXml(box), asked), "accepted") << "a template that can not be read spoils its object alone";
  EXPECT_NE(said(world, asked).find(kOutside), std::string::npos);
  EXPECT_EQ(asked, (std::vector<std::string>{"maps/a.tmx", "maps/a.tmx"}));
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
    const std::string text = said(mapXml("<tileset firstgid='1' source='s'/>" + csvLayer(1, 1, "1")), asked, secret);
    EXPECT_NE(text, "accepted") << secret;
    EXPECT_EQ(text.find("SECRET"), std::string::npos) << text;
    for (const char* layer : {"<layer name='SECRET'><data encoding='SECRET'/></layer>", "", "<layer name='SECRET'/>"}) {
      const std::string map = mapXml(layer, *layer != '\0' ? "" : "orientation='SECRET'");
      const std::string world = R"({"type":"world", "maps":[{"fileName":"b.tmx", "x":0, "y":0}]})";
      EXPECT_EQ(said(world, asked, map).find("SECRET"), std::string::npos) << said(world, asked, map);
    }
  }
  std::vector<std::string> asked;
  EXPECT_NE(said(mapXml("", "width='mine'"), asked).find("mine"), std::string::npos) << "the map's own text is";
}

class TiledDisk : public testing::Test {
 protected:
  void SetUp() override {
    top_ = fs::temp_directory_path() / ("lgs_strange_" + std::to_string(std::random_device()()));
    fs::create_directories(top_ / "maps/sub");
    put("secret.tsx", kSet);
    put("maps/own.tsx", kSet);
    put("maps/sub/own.tsx", kSet);
  }
  void TearDown() override { fs::remove_all(top_); }

  void put(const std::string& name, const std::string& text) const { std::ofstream(top_ / name) << text; }

  /// What the import of a map that names a tileset says.
  std::string said(const std::string& source, bool anywhere = false) const {
    put("maps/a.tmx", mapXml("<tileset firstgid='1' source='" + source + "'/>" + csvLayer(1, 1, "1")));
    const auto map = importMap((top_ / "maps/a.tmx").string(), {.filesAnywhere = anywhere});
    if (map) return "accepted";
    const std::string text = message(map.error());
    return text.substr(std::min(text.size(), text.find("cannot be read: ") + 16));
  }

  static constexpr const char* kSet = "<tileset name='s' tilewidth='32' tileheight='32'/>";
  fs::path top_;
};

TEST_F(TiledDisk, OnlyFilesBelowTheFolderOfTheMap) {
  EXPECT_EQ(said("own.tsx"), "accepted");
  EXPECT_EQ(said("sub/own.tsx"), "accepted");
  EXPECT_EQ(said("sub/../own.tsx"), "accepted");
  EXPECT_EQ(said("../secret.tsx"), kOutside);
  EXPECT_EQ(said("../secret.tsx", true), "accepted");
  EXPECT_EQ(said((top_ / "secret.tsx").string()), kOutside);
  EXPECT_EQ(said((top_ / "secret.tsx").string(), true), "accepted");
  EXPECT_EQ(said("none.tsx"), "there is no such file, or no permission to read it");
  EXPECT_EQ(said("sub"), "it is a folder");
}

TEST_F(TiledDisk, LinksLeadNowhereElse) {
  fs::create_symlink(top_ / "secret.tsx", top_ / "maps/out.tsx");
  fs::create_symlink(top_ / "none.tsx", top_ / "maps/broken.tsx");
  fs::create_directory_symlink(top_, top_ / "maps/up");
  fs::create_symlink("sub/own.tsx", top_ / "maps/in.tsx");
  fs::create_symlink("loop.tsx", top_ / "maps/loop.tsx");
  EXPECT_EQ(said("out.tsx"), "it is a symbolic link out of the map's folder");
  EXPECT_EQ(said("up/secret.tsx"), "it is a symbolic link out of the map's folder");
  EXPECT_EQ(said("out.tsx", true), "accepted");
  EXPECT_EQ(said("in.tsx"), "accepted") << "below the folder";
  for (const char* none : {"broken.tsx", "up/none.tsx", "loop.tsx"}) {
    EXPECT_EQ(said(none), "there is no such file, or no permission to read it") << none;
  }
  fs::create_directory_symlink(top_ / "maps", top_ / "here");
  put("maps/a.tmx", mapXml("<tileset firstgid='1' source='own.tsx'/>"));
  EXPECT_TRUE(importMap((top_ / "here/a.tmx").string())) << "the map's own folder may be a link";
}

TEST_F(TiledDisk, NothingThatCouldBlock) {
  ASSERT_EQ(::mkfifo((top_ / "maps/fifo.tsx").c_str(), 0600), 0);
  EXPECT_EQ(said("fifo.tsx"), "it is no regular file");
  EXPECT_EQ(said("fifo.tsx", true), "it is no regular file");
  EXPECT_EQ(said("/dev/zero", true), "it is no regular file");
  EXPECT_EQ(readFile((top_ / "maps/fifo.tsx").string()).error(), "it is no regular file");
}

TEST_F(TiledDisk, AReaderOfAFolderChecksItsPathsItself) {
  const FileReader reader = readerBelow((top_ / "maps").string());
  EXPECT_TRUE(reader((top_ / "maps/own.tsx").string()));
  EXPECT_EQ(reader((top_ / "maps/../secret.tsx").string()).error(), "it is not below the folder");
  EXPECT_EQ(reader("own.tsx").error(), "it is not below the folder");
}

}  // namespace
}  // namespace lgs::tiled
