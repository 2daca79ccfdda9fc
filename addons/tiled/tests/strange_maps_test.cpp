// What a map from a stranger may read: regular files below its folder, unless an option opens more.
#include "maps.h"
#include "proptests/support/command.h"

#include <sys/stat.h>
#include <unistd.h>
#include "addons/tiled/src/below.h"

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
    EXPECT_TRUE(text.ends_with(fmt::format(" cannot be read: {}", kOutside))) << name << ": " << text;
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
    const auto map = importMap(path("maps/a.tmx"), {.filesAnywhere = anywhere});
    if (map) return "accepted";
    const std::string text = message(map.error());
    return text.substr(std::min(text.size(), text.find("cannot be read: ") + 16));
  }

  static constexpr const char* kSet = "<tileset name='s' tilewidth='32' tileheight='32'/>";
};

TEST_F(TiledDisk, OnlyFilesBelowTheFolderOfTheMap) {
  EXPECT_EQ(said("own.tsx"), "accepted");
  EXPECT_EQ(said("sub/own.tsx"), "accepted");
  EXPECT_EQ(said("sub/../own.tsx"), "accepted");
  EXPECT_EQ(said("../secret.tsx"), kOutside);
  EXPECT_EQ(said("../secret.tsx", true), "accepted");
  EXPECT_EQ(said(path("secret.tsx")), kOutside);
  EXPECT_EQ(said(path("secret.tsx"), true), "accepted");
  EXPECT_EQ(said("none.tsx"), "there is no such file, or no permission to read it");
  EXPECT_EQ(said("sub"), "it is a folder");
}

TEST_F(TiledDisk, LinksLeadNowhereElse) {
  fs::create_symlink(folder_ / "secret.tsx", folder_ / "maps/out.tsx");
  fs::create_symlink(folder_ / "none.tsx", folder_ / "maps/broken.tsx");
  fs::create_directory_symlink(folder_, folder_ / "maps/up");
  fs::create_symlink("sub/own.tsx", folder_ / "maps/in.tsx");
  fs::create_symlink("loop.tsx", folder_ / "maps/loop.tsx");
  EXPECT_EQ(said("out.tsx"), "it is a symbolic link out of the map's folder");
  EXPECT_EQ(said("up/secret.tsx"), "it is a symbolic link out of the map's folder");
  EXPECT_EQ(said("out.tsx", true), "accepted");
  EXPECT_EQ(said("in.tsx"), "accepted") << "below the folder";
  for (const char* none : {"broken.tsx", "up/none.tsx", "loop.tsx"}) {
    EXPECT_EQ(said(none), "there is no such file, or no permission to read it") << none;
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

TEST_F(TiledDisk, AReaderOfAFolderChecksItsPathsItself) {
  const FileReader reader = readerBelow(path("maps"));
  EXPECT_TRUE(reader(path("maps/own.tsx")));
  EXPECT_EQ(reader(path("maps/../secret.tsx")).error(), "it is not below the folder");
  EXPECT_EQ(reader("own.tsx").error(), "it is not below the folder");
}

}  // namespace
}  // namespace lgs::tiled
