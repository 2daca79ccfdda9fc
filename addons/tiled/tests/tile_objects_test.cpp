// Tile objects bring the shapes of their tile, scaled, flipped and turned. Templates fill up what an object does not
// say.
#include "maps.h"

namespace lgs::tiled {
namespace {

/// The lower left quarter of the tile is a triangle, so that every flip shows.
const std::string kRamp = "<object id='1' x='0' y='32'><polygon points='0,0 0,-16 16,0'/></object>";

std::string firstNote(const ImportedMap& map) {
  for (const LayerReport& layer : map.report.layers) {
    if (!layer.notes.empty()) return layer.notes.front().text;
  }
  return {};
}

Rings ringsOf(const ImportedMap& map) {
  Rings rings;
  for (const MapPolygon& p : map.placements) rings.push_back(map.shapes[p.shape]);
  return rings;
}

/// The ramp as a tile object.
ImportedMap importRamp(const std::string& attributes) {
  return mustImport(tilesetXml({kRamp}) + objectLayer("<object id='3' " + attributes + "/>"));
}

TEST(TiledTileObjects, StandOnTheirPlaceAndAreScaled) {
  const auto map = importRamp("gid='1' x='32' y='64' width='32' height='32'");
  EXPECT_EQ(cellsOf(map), (Cells{{1, -2}}));
  EXPECT_EQ(ringsOf(map), (Rings{px({{0, 0}, {16, 0}, {0, 16}})}));
  EXPECT_EQ(map.placements.at(0).object, 3U);
  const auto large = importRamp("gid='1' x='32' y='64' width='128' height='64'");
  EXPECT_NEAR(areaInCells(large), 1, 1e-4);  // of 4×2 cells
  EXPECT_EQ(cellsOf(large), (Cells{{1, -2}, {2, -2}}));
  EXPECT_EQ(ringsOf(importRamp("gid='1' x='32' y='64'")), ringsOf(map)) << "without a size they have that of the tile";
}

TEST(TiledTileObjects, AreFlippedAndTurned) {
  const auto rings = [](std::uint32_t gid) {
    return ringsOf(importRamp(fmt::format("gid='{}' x='0' y='32' width='32' height='32' rotation='0'", gid)));
  };
  EXPECT_EQ(rings(0x8000'0001), (Rings{px({{16, 0}, {32, 0}, {32, 16}})}));
  EXPECT_EQ(rings(0x4000'0001), (Rings{px({{0, 16}, {16, 32}, {0, 32}})}));
  EXPECT_EQ(rings(0xC000'0001), (Rings{px({{16, 32}, {32, 16}, {32, 32}})}));
  EXPECT_EQ(rings(0x2000'0001), (Rings{px({{16, 32}, {32, 16}, {32, 32}})}));
  // A quarter turn clockwise around the lower left corner: into the cell below.
  const auto turned = importRamp("gid='1' x='0' y='32' width='32' height='32' rotation='90'");
  EXPECT_EQ(cellsOf(turned), (Cells{{0, -2}}));
  EXPECT_EQ(ringsOf(turned), (Rings{px({{0, 16}, {16, 32}, {0, 32}})}));
}

TEST(TiledTileObjects, TheTilesetSaysWhereTheirPlaceIs) {
  const auto cells = [](const std::string& attributes, const std::string& content = "") {
    const std::string set = tilesOf32(content + tileXml(0, kFullTile), "firstgid='1' " + attributes);
    return cellsOf(mustImport(set + objectLayer("<object id='3' gid='1' x='64' y='64' width='64' height='64'/>")));
  };
  const auto square = [](std::int32_t i, std::int32_t j) {
    return Cells{{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}};
  };
  EXPECT_EQ(cells(""), square(2, -2));
  EXPECT_EQ(cells("objectalignment='unspecified'"), square(2, -2));
  EXPECT_EQ(cells("objectalignment='bottomleft'"), square(2, -2));
  EXPECT_EQ(cells("objectalignment='topleft'"), square(2, -4));
  EXPECT_EQ(cells("objectalignment='topright'"), square(0, -4));
  EXPECT_EQ(cells("objectalignment='top'"), square(1, -4));
  EXPECT_EQ(cells("objectalignment='center'"), square(1, -3));
  EXPECT_EQ(cells("objectalignment='left'"), square(2, -3));
  EXPECT_EQ(cells("objectalignment='right'"), square(0, -3));
  EXPECT_EQ(cells("objectalignment='bottom'"), square(1, -2));
  EXPECT_EQ(cells("objectalignment='bottomright'"), square(0, -2));
  EXPECT_EQ(cells("", "<tileoffset x='16' y='-32'/>"), square(3, 0)) << "the offset is scaled, too";
}

TEST(TiledTileObjects, ClassesFromTheNearestThatHasOne) {
  const auto block = [](const std::string& shape, const std::string& object, const std::string& tile) {
    const std::string full = "<object id='1' class='" + shape + "' width='32' height='32'/>";
    const std::string placed = "<object id='3' gid='1' class='" + object + "' x='0' y='32'/>";
    const Options options{.blockFrom = BlockFrom::tileClass,
                          .blocks = {{"shape", 1}, {"object", 2}, {"tile", 3}, {"layer", 4}}};
    const std::string content =
        tilesOf32(tileXml(0, full, "class='" + tile + "'")) + objectLayer(placed, "name='Walls' class='layer'");
    return blocksOf(mustImport(content, options)).at(0);
  };
  EXPECT_EQ(block("shape", "object", "tile"), 1U);
  EXPECT_EQ(block("", "object", "tile"), 2U);
  EXPECT_EQ(block("", "", "tile"), 3U);
  EXPECT_EQ(block("", "", ""), 4U);
}

TEST(TiledTileObjects, WithoutShapesTheyAreSquaresIfAskedFor) {
  const std::string set =
      "<tileset firstgid='1' tilewidth='32' tileheight='32'><tile id='0'><properties>"
      "<property name='hard' type='bool' value='true'/></properties></tile></tileset>";
  const std::string content = set + objectLayer(
                                        "<object id='3' gid='1' x='0' y='32' width='64' height='32'/>"
                                        "<object id='4' gid='2' x='0' y='64' width='32' height='32'/>");
  EXPECT_TRUE(mustImport(content).placements.empty());
  EXPECT_EQ(cellsOf(mustImport(content, {.solidIf = {"hard"}})), (Cells{{0, -1}, {1, -1}}));
  EXPECT_EQ(cellsOf(mustImport(content, {.solidWithoutShapes = true, .solidIf = {"hard"}})),
            (Cells{{0, -2}, {0, -1}, {1, -1}}));
}

Files templateFiles(const std::string& objects, const std::string& text) {
  return {{"maps/test.tmx", mapXml(tilesetXml({kFullTile}) + objectLayer(objects))},
          {"kit/a.tx", text},
          {"kit/set.tsx", tilesOf32(tileXml(4, kRamp), "")}};
}

ImportedMap withTemplate(const std::string& objects, const std::string& text) {
  return mustImportFiles(templateFiles(objects, text));
}

TEST(TiledTemplates, FillUpWhatAnObjectDoesNotSay) {
  const std::string box = "<template><object class='rock' width='64' height='32'/></template>";
  EXPECT_EQ(cellsOf(withTemplate("<object id='3' template='../kit/a.tx' x='32' y='32'/>", box)),
            (Cells{{1, -2}, {2, -2}}));
  EXPECT_EQ(cellsOf(withTemplate("<object id='3' template='..\\kit\\a.tx' x='32' y='32' width='32'/>", box)),
            (Cells{{1, -2}}));
  const std::string triangle = "<template><object><polygon points='0,0 32,0 0,32'/></object></template>";
  const std::string here = "id='3' template='../kit/a.tx' x='0' y='0'";
  EXPECT_NEAR(areaInCells(withTemplate("<object " + here + "/>", triangle)), 0.5, 1e-4);
  const auto changed = withTemplate("<object " + here + "><polygon points='0,0 64,0 64,32 0,32'/></object>", triangle);
  EXPECT_EQ(cellsOf(changed), (Cells{{0, -1}, {1, -1}}));
  EXPECT_EQ(changed.placements.at(0).object, 3U);
}

TEST(TiledTemplates, HaveTilesetsOfTheirOwn) {
  const std::string tile =
      "<template><tileset firstgid='1' source='set.tsx'/><object gid='5' width='32' height='32'/>"
      "</template>";
  const auto map = withTemplate(
      "<object id='3' template='../kit/a.tx' x='0' y='32'/>"
      "<object id='4' template='../kit/a.tx' x='32' y='32'/>"
      "<object id='5' template='../kit/a.tx' gid='1' x='64' y='32'/>",
      tile);
  const Ring ramp = px({{0, 0}, {16, 0}, {0, 16}});
  EXPECT_EQ(ringsOf(map), (Rings{ramp, ramp, kSquare})) << "a number of the map's is of the map's tileset";
}

TEST(TiledTemplates, OfShapesOfTiles) {
  const auto map = mustImportFiles(
      {{"maps/test.tmx", mapXml("<tileset firstgid='1' source='../kit/set.tsx'/>" + csvLayer(1, 1, "1"))},
       {"kit/set.tsx", tilesOf32(tileXml(0, "<object id='1' template='a.tx' x='16' y='16'/>"), "")},
       {"kit/a.tx", "<template><object width='16' height='16'/></template>"}});
  EXPECT_EQ(ringsOf(map), (Rings{pxBox(16, 0, 32, 16)}));
}

TEST(TiledTemplates, ThatCannotBeReadAreNamed) {
  const std::string object = "<object id='3' template='../kit/a.tx' x='0' y='32'/>";
  const auto reason = [&](const std::string& text) {
    return firstNote(importFiles(templateFiles(object, text)).value());
  };
  EXPECT_EQ(firstNote(withTemplate("<object id='3' template='b.tx'/>", "")),
            "its template maps/b.tx: cannot be read: there is no such file");
  EXPECT_EQ(reason("<template/>"), "its template ../kit/a.tx has no <object>");
  EXPECT_EQ(reason("<map/>"),
            "its template kit/a.tx:1: <map> should be <template>: this is not the kind of file expected here");
  EXPECT_EQ(reason("<template><tileset firstgid='1' source='no.tsx'/><object gid='1'/></template>"),
            "its template kit/a.tx:1: <tileset> 'no.tsx' the tileset's file kit/no.tsx cannot be read: there is no "
            "such file");
  EXPECT_EQ(reason("<template><object gid='1'/></template>"), "its tile belongs to no tileset");
}

}  // namespace
}  // namespace lgs::tiled
