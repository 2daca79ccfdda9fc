// Files and their content: reading from the disk, numbers, names as messages quote them, packed tiles.
#include "maps.h"
#include "packed.h"
#include "proptests/support/command.h"

namespace lgs::tiled {
namespace {

class TiledReadFile : public test::InAFolder {
 protected:
  std::string file(const std::string& content) const {
    put("file", content);
    return path("file");
  }
};

std::string whyNot(const std::string& path) {
  const auto text = readFile(path);
  return text ? "it was read" : text.error();
}

// Nothing of the importer's is lost on the way: the sanitizers see to that.
TEST(TiledReader, WhatAReaderThrowsComesThrough) {
  const FileReader throws = [](const std::string& path) -> tl::expected<std::string, std::string> {
    if (path == "a.tmx") return mapXml("<tileset firstgid='1' source='b.tsx'/>");
    throw std::runtime_error(path);
  };
  EXPECT_THROW(static_cast<void>(importMap("a.tmx", {}, throws)), std::runtime_error);
  EXPECT_THROW(static_cast<void>(importMap("c.tmx", {}, throws)), std::runtime_error);
}

TEST_F(TiledReadFile, GivesTheContentByteForByte) {
  std::string bytes = "a\r\nb\n";
  bytes += '\0';
  bytes += "\xC3\xB6";
  EXPECT_EQ(readFile(file(bytes)), bytes);
  EXPECT_EQ(readFile(file("")), "");
}

TEST_F(TiledReadFile, OrSaysWhyNot) {
  EXPECT_EQ(whyNot(folder_.string()), "it is a folder");
  EXPECT_EQ(whyNot(path("none")), "there is no such file, or no permission to read it");
  EXPECT_EQ(message(importMap(folder_.string()).error()), folder_.string() + ": cannot be read: it is a folder");
}

TEST_F(TiledReadFile, UpToAGigabyte) {
  const std::string path = file("");
  std::error_code failed;
  std::filesystem::resize_file(path, (std::uintmax_t{1} << 30) + 1, failed);  // sparse: takes no room on the disk
  if (failed) GTEST_SKIP() << "no files of that size here: " << failed.message();
  EXPECT_EQ(whyNot(path), "it is larger than 1 GiB");
}

TEST_F(TiledReadFile, NoticesThatAFileEndsEarly) {
  const std::string path = "/sys/devices/system/cpu/online";  // it says that it has 4096 characters, and has a few
  std::error_code failed;
  if (std::filesystem::file_size(path, failed) != 4'096 || failed) GTEST_SKIP() << "no such file here";
  EXPECT_EQ(whyNot(path), "reading stopped half-way");
}

TEST(TiledEncodings, ListsOfNumbersMayBeEmptyOrEndWithAComma) {
  const auto csv = [](const std::string& text) { return dataLayer("<data encoding='csv'>" + text + "</data>"); };
  EXPECT_EQ(mustImport(csv("1,0,0,0,0,0,")).placements.size(), 1U);
  EXPECT_EQ(mustImport(csv("1,0,0,0,0,0 , \n")).placements.size(), 1U);
  EXPECT_EQ(refusalOf(mapXml(csv(" \n "))), "maps/test.tmx:6: <data> holds 0 tiles where its size asks for 6");
  EXPECT_EQ(refusalOf(mapXml(csv(","))), "maps/test.tmx:6: <data> tile 1 is not a tile number");
}

/// The message about a layer of 100×100 tiles with this packed data.
std::string refusalOfPacked(const std::string& compression, const std::string& bytes) {
  return refusalOf(mapXml("<layer name='L' width='100' height='100'><data encoding='base64' compression='" +
                          compression + "'>" + base64(bytes) + "</data></layer>"));
}

TEST(TiledEncodings, PackedTilesThatEndEarly) {
  const std::string raw(40'000, '\0');
  EXPECT_EQ(refusalOfPacked("zlib", deflated(raw, 15)), "accepted");
  EXPECT_EQ(refusalOfPacked("zlib", deflated(raw, 15).substr(0, 38)),
            "maps/test.tmx:3: <data> cannot be decompressed: damaged");  // 38 · 1032 bytes might still be enough
  EXPECT_EQ(refusalOfPacked("zlib", deflated(raw, 15).substr(0, 37)),
            "maps/test.tmx:3: <data> is too short for its size");
  EXPECT_EQ(refusalOfPacked("zstd", zstdPacked(raw)), "accepted");
  EXPECT_EQ(refusalOfPacked("zstd", zstdPacked(raw).substr(0, 12)),
            "maps/test.tmx:3: <data> cannot be decompressed: Src size is incorrect");
}

TEST(TiledEncodings, ZstdNeedNotSayHowMuchItHolds) {
  const auto streamed = [](const std::string& bytes) {
    std::string packed(ZSTD_compressBound(bytes.size()), '\0');
    ZSTD_CCtx* context = ZSTD_createCCtx();
    ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
    packed.resize(ZSTD_compress2(context, packed.data(), packed.size(), bytes.data(), bytes.size()));
    ZSTD_freeCCtx(context);
    return packed;
  };
  const auto layer = [&](const std::vector<std::uint32_t>& gids) {
    return dataLayer("<data encoding='base64' compression='zstd'>" + base64(streamed(rawTiles(gids))) + "</data>");
  };
  EXPECT_EQ(cellsOf(mustImport(layer({1, 0, 1, 0, 1, 0}))), (Cells{{1, -2}, {0, -1}, {2, -1}}));
  EXPECT_EQ(refusalOf(mapXml(layer({1, 0, 1, 0, 1}))),
            "maps/test.tmx:6: <data> holds 5 tiles where its size asks for 6");
}

TEST(TiledXml, NumbersMayHaveASign) {
  EXPECT_EQ(ringsIn(importTile("<object id='+1' x='+4' y='-0' width=' +28 ' height='32'/>"), {0, -1}),
            (Rings{pxBox(4, 0, 32, 32)}));
  const std::string should = " should be a whole number from 0 to 268435456";
  EXPECT_EQ(refusalOf(mapXml("", "width='++1'")), "maps/test.tmx:2: <map> width='++1'" + should);
  EXPECT_EQ(refusalOf(mapXml("", "width=''")), "maps/test.tmx:2: <map> width=''" + should);
  EXPECT_EQ(refusalOf(mapXml("", "width='268435456'")), "accepted");
  EXPECT_EQ(refusalOf(mapXml("", "width='268435457'")), "maps/test.tmx:2: <map> width='268435457'" + should);
}

TEST(TiledXml, QuotesAreShortAndOfOneLine) {
  const std::string forty(40, '7');
  const std::string should = " should be a whole number from 0 to 268435456";
  EXPECT_EQ(refusalOf(mapXml("", "width='" + forty + "'")), "maps/test.tmx:2: <map> width='" + forty + "'" + should);
  EXPECT_EQ(refusalOf(mapXml("", "width='" + forty + "8'")), "maps/test.tmx:2: <map> width='" + forty + "…'" + should);
  EXPECT_EQ(refusalOf(mapXml("", "width='1&#10;&#31;2'")), "maps/test.tmx:2: <map> width='1  2'" + should);
}

TEST(TiledTilesets, TheFirstMistakeIsTheOneThatIsTold) {
  const auto refusal = [](const std::string& attributes, const std::string& tsx) {
    return refusalOf(importFiles({{"maps/test.tmx", mapXml("<tileset " + attributes + "/>")}, {"maps/a.tsx", tsx}}));
  };
  EXPECT_EQ(refusal("firstgid='1' source='a.tsx'", "<tileset tilewidth='8' tileheight='8'/>"), "accepted");
  EXPECT_EQ(refusal("firstgid='0' source='a.tsx'", "<tileset/>"),
            "maps/test.tmx:3: <tileset> 'a.tsx' firstgid='0' should be a whole number from 1 to 268435455");
  EXPECT_EQ(refusal("firstgid='0' source='none.tsx'", ""),
            "maps/test.tmx:3: <tileset> 'none.tsx' firstgid='0' should be a whole number from 1 to 268435455");
  EXPECT_EQ(refusal("source='none.tsx'", ""), "maps/test.tmx:3: <tileset> 'none.tsx' has no attribute 'firstgid'");
  EXPECT_EQ(refusal("firstgid='1' source='a.tsx'", "<tileset>\n</map>"),
            "maps/a.tsx:2: is not well-formed XML: Start-end tags mismatch");
  EXPECT_EQ(refusal("firstgid='1' source='a.tsx'", "<map/>"),
            "maps/a.tsx:1: <map> should be <tileset>: this is not the kind of file expected here");
}

}  // namespace
}  // namespace lgs::tiled
