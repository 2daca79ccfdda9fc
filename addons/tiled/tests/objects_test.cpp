// Object layers: which are taken, where their objects land, and what is left out.
#include "maps.h"
#include "proptests/support/must.h"

#include <numbers>

namespace lgs::tiled {
namespace {

std::string rectangle(int x, int y, int width, int height, const std::string& attributes = "id='1'") {
  return fmt::format("<object {} x='{}' y='{}' width='{}' height='{}'/>", attributes, x, y, width, height);
}

/// The notes of all object layers: "LAYER OBJECT: text".
std::vector<std::string> layerNotes(const ImportedMap& map) {
  std::vector<std::string> result;
  for (const LayerReport& layer : map.report.layers) {
    for (const Note& note : layer.notes) {
      result.push_back(fmt::format("{} {}: {}", layer.path, note.object, note.text));
    }
  }
  return result;
}

TEST(TiledObjectLayers, AnObjectMayHaveAnySize) {
  const auto map = mustImport(objectLayer("", "name='Other'") + objectLayer(rectangle(32, 16, 96, 64, "id='9'")));
  EXPECT_EQ(cellsOf(map), (Cells{{1, -3}, {2, -3}, {3, -3}, {1, -2}, {2, -2}, {3, -2}, {1, -1}, {2, -1}, {3, -1}}));
  EXPECT_EQ(ringsIn(map, {2, -1}), (Rings{pxBox(0, 0, 32, 16)}));
  EXPECT_EQ(ringsIn(map, {2, -2}), (Rings{kSquare}));
  EXPECT_EQ(ringsIn(map, {2, -3}), (Rings{pxBox(0, 16, 32, 32)}));
  for (const MapPolygon& p : map.placements) {
    EXPECT_EQ(p.tile, kNoTile);
    EXPECT_EQ(p.object, 9U);
    EXPECT_EQ(p.layer, 1U);
  }
  EXPECT_EQ(worldOf(map).loops().size(), 1U) << "no seam inside";
}

TEST(TiledObjectLayers, ObjectsOfEachKind) {
  const Ring lowerHalf = pxBox(0, 0, 32, 16);
  for (const char* object :
       {"<object id='1' x='32' y='48' width='32' height='16'/>",
        "<object id='1' x='64' y='48' width='16' height='32' rotation='90'/>",
        "<object id='1' x='64' y='64' width='32' height='16' rotation='-180'/>",
        "<object id='1' x='40' y='50'><polygon points='-8,14 -8,-2 24,-2 24,14'/></object>",
        "<object id='1' x='40' y='50'><polyline points='-8,14 -8,-2 24,-2 24,14 -8,14'/></object>"}) {
    const auto map = mustImport(objectLayer(object));
    EXPECT_EQ(cellsOf(map), (Cells{{1, -2}})) << object;
    EXPECT_EQ(ringsIn(map, {1, -2}), (Rings{lowerHalf})) << object;
  }
  const Options exact{.tolerance = 0};
  const auto ellipse = mustImport(objectLayer("<object id='1' width='128' height='64'><ellipse/></object>"), exact);
  EXPECT_NEAR(areaInCells(ellipse), 2 * std::numbers::pi, 0.06);
  const auto capsule = mustImport(objectLayer("<object id='1' width='128' height='64'><capsule/></object>"), exact);
  EXPECT_NEAR(areaInCells(capsule), 4 + std::numbers::pi, 0.03);
  EXPECT_THAT(layerNotes(capsule), ElementsAre("Walls 1: a capsule became a polygon of 32 vertices"));
}

TEST(TiledObjectLayers, OffsetsOfGroupsAndLayersAddUp) {
  const std::string group = "<group name='G' offsetx='32' offsety='-64'>" +
                            objectLayer(rectangle(0, 0, 32, 32), "name='Walls' offsetx='-64' offsety='32'") +
                            "</group>";
  EXPECT_EQ(cellsOf(mustImport(group)), (Cells{{-1, 0}}));
}

TEST(TiledObjectLayers, WhatIsNearAGridLineSnaps) {
  const std::string object = "<object id='4' x='32.5' y='0.25' width='62.75' height='32'/>";
  EXPECT_EQ(areaInCells(mustImport(objectLayer(object))), 2);
  EXPECT_THAT(layerNotes(mustImport(objectLayer(object))),
              ElementsAre("Walls 4: 8 coordinates put on the grid, by up to 0.75 px"));
  EXPECT_EQ(areaInCells(mustImport(objectLayer(object), {.tolerance = 0})), 62.75 / 32);
}

TEST(TiledObjectLayers, ThoseAreTakenThatSaySo) {
  const auto remark = [](const std::string& attributes, const std::string& properties = "") {
    const auto map = mustImport(objectLayer(properties + rectangle(0, 0, 32, 32), attributes));
    EXPECT_EQ(map.report.layers.at(0).imported, !map.placements.empty());
    EXPECT_EQ(map.report.layers.at(0).objects, 1U);
    EXPECT_EQ(map.report.layers.at(0).kind, LayerKind::objects);
    return map.placements.empty() ? "" : map.report.layers.at(0).note;
  };
  EXPECT_EQ(remark("name='COLLISIONS'"), "its name says 'collision'");
  EXPECT_EQ(remark("name='innerWalls'"), "its name says 'wall'");
  EXPECT_EQ(remark("name='background and ground'"), "its name says 'ground'");
  for (const char* name : {"collider", "Solids", "terrain_1", "isBlocked", "Underground"}) {
    EXPECT_NE(remark("name='" + std::string(name) + "'"), "") << name;
  }
  EXPECT_EQ(remark("name='A' class='Solid'"), "its class says 'solid'");
  EXPECT_EQ(remark("name='A'", property("isSolid", "true")), "its property 'isSolid' says so");
  for (const char* name : {"Background", "FOREGROUND", "Objects", ""}) {
    EXPECT_EQ(remark("name='" + std::string(name) + "'"), "") << name;
  }
  for (const char* value : {"false", "0"}) EXPECT_EQ(remark("name='A'", property("solid", value)), "") << value;
  EXPECT_EQ(remark("name='A'", property("solid", "")), "its property 'solid' says so") << "games ask if there is one";
  EXPECT_EQ(remark("name='A'", property("speed", "9")), "");
}

TEST(TiledObjectLayers, TheyCanBeChosen) {
  const std::string content = objectLayer(rectangle(0, 0, 32, 32), "name='A'") + "<group name='G'>" +
                              objectLayer(rectangle(32, 0, 32, 32), "name='A'") +
                              objectLayer(rectangle(64, 0, 32, 32)) + "</group>" + csvLayer(1, 1, "0");
  const auto cells = [&](std::optional<std::vector<std::string>> objects, std::vector<std::string> layers = {}) {
    return cellsOf(mustImport(content, {.layers = std::move(layers), .objects = std::move(objects)}));
  };
  EXPECT_EQ(cells(std::nullopt), (Cells{{2, -1}}));
  EXPECT_EQ(cells({{}}), Cells{});
  EXPECT_EQ(cells({{"A"}}), (Cells{{0, -1}, {1, -1}}));
  EXPECT_EQ(cells({{"G/A"}}), (Cells{{1, -1}}));
  EXPECT_EQ(cells({{"G"}}), (Cells{{1, -1}, {2, -1}}));
  EXPECT_EQ(cells(std::nullopt, {"Ground"}), Cells{}) << "only this layer";
  EXPECT_EQ(cells(std::nullopt, {"G"}), (Cells{{2, -1}}));
  EXPECT_EQ(cells({{"A"}}, {"Ground"}), (Cells{{0, -1}, {1, -1}}));
  EXPECT_EQ(refusalOf(mapXml(content), {.objects = {{"Ground"}}}),
            "maps/test.tmx: 'Ground' is a tile layer: --layer Ground");
}

TEST(TiledObjectLayers, WhatComesFirstStays) {
  const std::string tiles = tilesetXml({"<object id='1' y='16' width='32' height='16'/>"}) + csvLayer(2, 1, "1,0");
  const std::string layer = objectLayer(rectangle(0, 0, 64, 32, "id='5'") + rectangle(40, 8, 8, 8, "id='6'") +
                                        rectangle(0, 0, 16, 16, "id='7'") + rectangle(32, 16, 64, 16, "id='8'"));
  const auto map = mustImport(layer + tiles);
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 0, 32, 16), pxBox(0, 16, 32, 32)}));
  EXPECT_EQ(ringsIn(map, {1, -1}), (Rings{kSquare}));
  EXPECT_EQ(map.placements.size(), 4U);
  EXPECT_EQ(map.placements.at(3).object, 8U);
  EXPECT_THAT(layerNotes(map), ElementsAre("Walls 5: lies on what is there already: the common part was taken away",
                                           "Walls 6: lies on what is there already: the common part was taken away",
                                           "Walls 7: lies on what is there already: the common part was taken away",
                                           "Walls 8: lies on what is there already: the common part was taken away"));
}

TEST(TiledObjectLayers, AnOutlineThatGoesAroundTwiceHasNoArea) {
  const auto map =
      mustImport(objectLayer("<object id='1'><polygon points='0,0 32,0 32,32 0,32 0,0 32,0 32,32 0,32'/></object>"));
  EXPECT_EQ(map.placements.size(), 0U);
  EXPECT_THAT(layerNotes(map), ElementsAre("Walls 1: it has no area: what its outline goes around twice is not solid"));
}

TEST(TiledObjectLayers, NotesAreOfTheirLayer) {
  const std::string object = rectangle(0, 0, 32, 32, "id='5'");
  const auto map = mustImport(tilesetXml({"<object id='1' y='8' width='32' height='8'/>"}) + csvLayer(2, 1, "1,1") +
                              objectLayer(object) + objectLayer(rectangle(32, 0, 32, 32, "id='5'"), "name='Ground'"));
  const std::string text = " 5: lies on what is there already: the common part was taken away";
  EXPECT_THAT(layerNotes(map), ElementsAre("Walls" + text, "Ground" + text));
}

TEST(TiledObjectLayers, NotesOfTilesNameTheLayersToo) {
  const std::string tiles = tilesetXml({kFullTile, "<object id='2' y='-8' width='32' height='32'/>"});
  const auto map = mustImport(tiles + csvLayer(2, 1, "1,2") +
                              "<layer name='More' width='2' height='1' offsety='32'><data encoding='csv'>2,2</data>"
                              "</layer>");
  const std::string text = toText(map.report);
  EXPECT_THAT(text, HasSubstr("  set #1, 3 uses in layers Ground, More\n"));
  EXPECT_THAT(text, Not(HasSubstr("set #0"))) << "nothing is to be said of it\n" << text;
  EXPECT_EQ(map.report.tiles.at(0).layers, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(map.report.tiles.at(1).layers, (std::vector<std::uint32_t>{0, 1}));
  const std::string trimmed = "object 2: lies on what is there already: the common part was taken away ";
  EXPECT_THAT(text, HasSubstr(trimmed + "(1 place in layer More, first in cell 0, -1)\n"));
  const auto flipped = mustImport(tiles + csvLayer(2, 1, "2,2147483650"));
  EXPECT_THAT(toText(flipped.report), HasSubstr("  set #1, 2 uses in layer Ground\n"));
}

TEST(TiledObjectLayers, BlocksByClassOrLayer) {
  const std::string content = objectLayer(rectangle(0, 0, 32, 32) + rectangle(32, 0, 32, 32, "id='2' class='ice'"),
                                          "name='Walls' class='rock'") +
                              objectLayer(rectangle(64, 0, 32, 32), "name='Ground'");
  const auto byClass = mustImport(content, {.blockFrom = BlockFrom::tileClass});
  EXPECT_THAT(blocksOf(byClass),
              ElementsAre(byClass.block("rock").value(), byClass.block("ice").value(), byClass.block("").value()));
  EXPECT_THAT(blocksOf(mustImport(content, {.blockFrom = BlockFrom::layer, .blocks = {{"Ground", 7}}})),
              ElementsAre(1, 1, 7));
}

TEST(TiledObjectLayers, BlocksByName) {
  const Options options{.blockFrom = BlockFrom::name, .blocks = {{"lava", 9}, {"rock", 5}}};
  const auto map =
      mustImport(objectLayer(rectangle(0, 0, 32, 32, "id='1' name='lava' type='rock'") +
                                 rectangle(32, 0, 32, 32, "id='2' type='rock'") + rectangle(64, 0, 32, 32, "id='3'"),
                             "name='Walls'"),
                 options);
  ASSERT_EQ(map.placements.size(), 3U);
  EXPECT_EQ(map.placements[0].block, 9U);
  EXPECT_EQ(map.placements[1].block, 5U) << "without a name it is the class";
  EXPECT_EQ(map.placements[2].block, map.block("").value());
}

TEST(TiledObjectLayers, AnOutlineMayCrossItself) {
  const auto map = mustImport(objectLayer("<object id='1'><polygon points='0,0 128,64 128,0 0,64'/></object>"));
  EXPECT_NEAR(areaInCells(map), 4, 1e-3);
  // A ring that runs around twice: what Tiled fills is where it runs around once.
  const auto twice = mustImport(
      objectLayer("<object id='1'><polygon points='0,0 96,0 96,96 0,96 0,0 32,32 64,32 64,64 32,64 32,32'/></object>"));
  EXPECT_NEAR(areaInCells(twice), 8, 1e-3);
}

TEST(TiledObjectLayers, WhatIsLeftOutAndWhy) {
  const auto reason = [](const std::string& object, const Options& options = {}) {
    const auto map = mustImport(tilesetXml({}) + objectLayer(object), options);
    EXPECT_TRUE(map.placements.empty()) << object;
    const auto notes = layerNotes(map);
    EXPECT_FALSE(notes.empty()) << object;
    return notes.empty() ? "" : notes.back();
  };
  EXPECT_EQ(reason("<object id='1'><polyline points='0,0 64,64 64,0'/></object>"),
            "Walls 1: an open polyline has no area: close it, or --polyline-thickness PIXELS makes it thick");
  EXPECT_EQ(reason("<object id='1'><polyline points='0,0 64,64 0,0'/></object>"),
            "Walls 1: an open polyline has no area: close it, or --polyline-thickness PIXELS makes it thick");
  EXPECT_EQ(reason("<object id='1'><point/></object>"), "Walls 1: a point has no area");
  EXPECT_EQ(reason("<object id='1' width='9' height='9'><text/></object>"), "Walls 1: a text is no shape");
  EXPECT_EQ(reason(rectangle(0, 0, 64, 0)), "Walls 1: it has no area: its width or height is 0");
  EXPECT_EQ(reason("<object id='1' x='1e300' width='9' height='9'/>"), "Walls 1: it is too far away");
  EXPECT_EQ(reason(rectangle(0, 0, 4'097 * 32, 9)), "Walls 1: it is more than 4096 cells wide or high");
  EXPECT_EQ(reason(rectangle(0, 0, 9, 4'097 * 32)), "Walls 1: it is more than 4096 cells wide or high");
  EXPECT_EQ(mustImport(objectLayer(rectangle(0, 0, 4'096 * 32, 9))).placements.size(), 4'096U);
  EXPECT_THAT(layerNotes(mustImport(objectLayer("<object id='1' gid='1' width='9' height='9'/>"))),
              ElementsAre("Walls 1: its tile belongs to no tileset"));
  EXPECT_EQ(reason("<object id='1' gid='1' width='9' height='9'/>"), "Walls 1: its tile has no collision shapes");
}

TEST(TiledObjectLayers, TheLimitCountsTheCellsOfTheirBoxes) {
  constexpr std::size_t kCells = 1'000 * 1'000;
  const auto limit = [](const std::string& xml, std::size_t cells) {
    const Options options{.maxObjectCells = cells - kObjectCellsPerByte * xml.size()};
    return options;
  };
  const std::string xml = mapXml(objectLayer(rectangle(0, 0, 32'000, 32'000)));
  EXPECT_EQ(refusalOf(xml, limit(xml, kCells - 1)),
            "maps/test.tmx:3: <objectgroup> 'Walls' its shapes are larger than the limit for a map of this size "
            "(Options::maxObjectCells)");
  EXPECT_EQ(refusalOf(xml, limit(xml, kCells)), "accepted");
  const std::string two = mapXml(objectLayer(rectangle(0, 0, 32'000, 32'000) + rectangle(0, 0, 32'000, 32'000)));
  EXPECT_NE(refusalOf(two, limit(two, 2 * kCells - 1)), "accepted") << "what is covered already counts, too";
  EXPECT_EQ(refusalOf(two, limit(two, 2 * kCells)), "accepted");
}

TEST(TiledObjectLayers, TheReportTellsAllOfThem) {
  const auto map = mustImport(objectLayer("<object id='3'><point/></object><object id='4'><point/></object>" +
                                          rectangle(0, 0, 32, 32, "id='5'")) +
                              objectLayer(rectangle(0, 0, 32, 32), "name='Doors'"));
  EXPECT_EQ(toText(map.report),
            "maps/test.tmx: 1 polygon (1 distinct), 8 % of the map: object layer Walls: its name says 'wall'\n"
            "  4×3 tiles of 32×32 px; polygons in 1 cell\n"
            "  layer Walls  3 objects; its name says 'wall'\n"
            "  layer Doors  passed over, 1 object: neither its name, its class nor a property says that it is solid\n"
            "  block 1  1 polygon\n"
            "\n"
            "Left out:\n"
            "  layer Walls\n"
            "    objects 3, 4, each: a point has no area\n");
}

TEST(TiledObjectLayers, ANoteOfSeveralIsOfEachOfThem) {
  const auto map = mustImport(objectLayer(rectangle(0, 0, 9, 0, "id='2'") + rectangle(0, 0, 0, 9, "id='4'")));
  EXPECT_THAT(toText(map.report), HasSubstr("objects 2, 4, each: it has no area: its width or height is 0\n"));
}

TEST(TiledObjectLayers, ALayerOfTheOtherKindIsNamedWithItsOption) {
  const std::string content = csvLayer(1, 1, "0") + "<group name='G'>" + objectLayer("", "name='Boxes'") + "</group>";
  for (const char* name : {"Boxes", "G/Boxes"}) {
    const std::string text = name;
    EXPECT_EQ(refusalOf(mapXml(content), {.layers = {name}}),
              "maps/test.tmx: '" + text + "' is an object layer: --objects " + text);
  }
  EXPECT_EQ(refusalOf(mapXml(content), {.objects = {{"Ground"}}}),
            "maps/test.tmx: 'Ground' is a tile layer: --layer Ground");
  EXPECT_EQ(refusalOf(mapXml(content), {.layers = {"G"}, .objects = {{"Boxes"}}}), "accepted");
}

TEST(TiledObjectLayers, TheProjectsOwnCave) {
  const auto map = test::must(importMap(LGS_SOURCE_DIR "/examples/maps/cave.tmx", {.blockFrom = BlockFrom::tileClass}));
  EXPECT_EQ(worldOf(map).loops().size(), 2U) << "the plank, and all else";
  EXPECT_EQ(map.report.blocks.size(), 3U);
  EXPECT_EQ(layerNotes(map).front(),
            "Walls 10: an open polyline has no area: close it, or --polyline-thickness PIXELS makes it thick");
}

}  // namespace
}  // namespace lgs::tiled
