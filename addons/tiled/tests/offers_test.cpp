// What is offered and what is said beside what was taken: a test for each thing that went wrong on real maps.
#include "evidence_maps.h"
#include "ldtk_projects.h"
#include "proptests/support/must.h"

namespace lgs::tiled {
namespace {

/// They may be things that move, or the ground that is drawn with pictures.
TEST(TiledEvidence, PlatformsWithPicturesAreSaidAndOffered) {
  const std::string figures = meant::objects("Platforms", meant::figure(1, 1) + meant::figure(5, 1));
  const auto map = import(meant::tiles("World", kHills) + figures, {}, meant::tile('a', property("collides", "true")));
  EXPECT_EQ(map.report.partial, "");
  EXPECT_EQ(map.report.also, "object layer Platforms, of which nothing is taken");
  EXPECT_THAT(offersOf(map), ElementsAre("--solid-if collides --solid-if layer=Platforms --objects Platforms"));
  EXPECT_EQ(map.report.suggestions.at(0).polygons, map.placements.size() + 2);
  const auto obstacles = import(meant::tiles("World", kHills) + replaced(figures, "Platforms", "obstacles"));
  EXPECT_EQ(obstacles.report.partial, "") << "they may be things with pictures";
}

TEST(TiledEvidence, WhatSaysThatItDoesNotCollideIsNotOffered) {
  const auto map = import(meant::tiles("World", kHills) + meant::tiles("NonCollidables", kPlatforms));
  EXPECT_EQ(map.placements.size(), import(meant::tiles("World", kHills)).placements.size());
  EXPECT_EQ(map.report.also, "");
}

/// Values without a name may be another ground; water is gone through in any case.
TEST(TiledEvidence, WallsAloneAreOfferedBeforeAllValues) {
  const std::string text = project(level("A", 0, 0, grid("1,2,3,1,0,0")));
  const auto map =
      test::must(importFiles({{"maps/test.tmx", replaced(replaced(text, "ice", "Water"), "dirt", "Walls")}}));
  EXPECT_EQ(map.placements.size(), 3U);
  EXPECT_EQ(offersOf(map).at(0), "--no-objects --not 3 --not Water");
}

TEST(TiledEvidence, BoxesWithoutANameBesideTheGroundAreSaid) {
  const std::string ground = meant::tiles("Ground", kHills), box = meant::box(0, 0, 2, 1);
  const auto map = import(ground + meant::objects("poly", box + meant::box(4, 0, 1, 1)));
  EXPECT_EQ(map.report.choice, "tile layer Ground: its name says 'ground' (--layer Ground --solid)");
  EXPECT_EQ(map.report.partial, "");
  EXPECT_EQ(map.report.also, "object layer poly, of which nothing is taken");
  EXPECT_THAT(offersOf(map), ElementsAre("--layer Ground --solid --objects poly"));
  EXPECT_EQ(import(ground + meant::objects("poly", box),
                   {.solidWithoutShapes = true, .layers = {"Ground"}, .objects = {{"poly"}}})
                .placements.size(),
            map.placements.size() + 2);
  for (const char* other : {"Background", "Enemies"})
    EXPECT_EQ(import(ground + meant::objects(other, box)).report.also, "") << other;
  EXPECT_EQ(import(ground + meant::objects("Places", meant::box(0, 0, 2, 1, "name='a'"))).report.also, "");
}

TEST(TiledEvidence, AValueOfLdtkCanBeLeftOut) {
  const std::string text = project(level("A", 0, 0, grid("1,2,0,2,3,0")));
  const auto map = test::must(importFiles({{"maps/test.tmx", text}}, {.leaveOut = {"ice"}}));
  EXPECT_EQ(cellsOf(map), (Cells{{1, -2}, {0, -1}}));
  EXPECT_THAT(map.report.notes, ElementsAre("left out, as asked: 2 uses of 'ice'"));
  EXPECT_EQ(
      importFiles({{"maps/test.tmx", text}}, {.solidWithoutShapes = true, .leaveOut = {"ice"}})->placements.size(), 2U)
      << "it stays free";
  EXPECT_THAT(
      importFiles({{"maps/test.tmx", text}}, {.solidWithoutShapes = true, .leaveOut = {"Ice"}})->report.notes,
      ElementsAre("no tile, object or layer has the class or name 'Ice'; there are 'ice', '3', 'Solid', 'dirt'"));
}

TEST(TiledEvidence, IntGridsThatAreCalledCollisionAreEnough) {
  const std::string acid = grid("0,0,0,0,1,0", "Acid", 2), both = acid + "," + grid("1,1,0,0,0,0", "Collisions", 1);
  const auto map = test::must(importFiles({{"maps/test.tmx", project(level("A", 0, 0, both))}}));
  EXPECT_EQ(map.placements.size(), 2U);
  EXPECT_EQ(importFiles({{"maps/test.tmx", project(level("A", 0, 0, acid))}})->placements.size(), 1U);
}

TEST(TiledEvidence, ValuesOfLdtkThatOneGoesThroughAreLeftOut) {
  const std::string text = project(level("A", 0, 0, grid("1,2,0,2,3,0")));
  const auto ladders = test::must(importFiles({{"maps/test.tmx", replaced(text, "ice", "Ladder_top")}}));
  EXPECT_EQ(cellsOf(ladders), (Cells{{1, -2}, {0, -1}}));
  EXPECT_EQ(ladders.report.choice, "IntGrid layers: Solid, without Ladder_top (--not Ladder_top)");
  EXPECT_EQ(cellsOf(test::must(importFiles({{"maps/test.tmx", replaced(text, "ice", "pit")}}))), cellsOf(ladders));
  const auto floors =
      test::must(importFiles({{"maps/test.tmx", replaced(replaced(text, "ice", "Floor"), "dirt", "Walls")}}));
  EXPECT_EQ(cellsOf(floors), (Cells{{1, -2}, {0, -1}})) << "a floor beside walls";
  const auto soil = test::must(importFiles({{"maps/test.tmx", replaced(text, "ice", "Wall")}}));
  EXPECT_EQ(soil.placements.size(), 4U);
  EXPECT_THAT(soil.report.suggestions.at(0).arguments, ElementsAre("--no-objects", "--not", "3", "--not", "dirt"))
      << "bodies may walk on what is no wall";
  const auto floorAlone = importFiles({{"maps/test.tmx", replaced(text, "ice", "Floor")}});
  EXPECT_EQ(floorAlone->placements.size(), 4U) << "a platformer stands on it";
  const std::string place = "\"px\":[8,8], \"width\":8, \"height\":8";
  const auto moving = test::must(
      importFiles({{"maps/test.tmx",
                    project(level("A", 0, 0, grid("1,0,0,0,0,0") + "," + things(entity("Platform", 13, place))))}}));
  EXPECT_EQ(moving.placements.size(), 1U) << "a platform that is an entity moves";
  const auto wall = test::must(importFiles(
      {{"maps/test.tmx", project(level("A", 0, 0, grid("1,0,0,0,0,0") + "," + things(entity("Wall", 12, place))))}}));
  EXPECT_EQ(wall.placements.size(), 2U);
  EXPECT_EQ(wall.report.choice, "IntGrid layers: Solid; object layer Things/Wall: its name says 'wall'");
  const auto water = test::must(importFiles(
      {{"maps/test.tmx", project(level("A", 0, 0,
                                       things(entity("Wall", 12, place) + "," +
                                              entity("Water", 14, "\"px\":[0,0], \"width\":8, \"height\":8"))))}}));
  EXPECT_EQ(water.report.also, "object layer Things/Water, of which nothing is taken");
  EXPECT_EQ(water.report.suggestions.at(0).polygons, 2U) << "the walls and the water";
  const auto marks = test::must(
      importFiles({{"maps/test.tmx", replaced(replaced(project(level("A", 0, 0, grid("1,1,2,0,0,0"))), "dirt", "floor"),
                                              "ice", "start")}}));
  EXPECT_EQ(marks.placements.size(), 2U) << "where one begins is no ground";
  const std::string only = replaced(project(level("A", 0, 0, grid("2,2,0,0,0,0"))), "ice", "ladder");
  EXPECT_EQ(importFiles({{"maps/test.tmx", only}})->placements.size(), 2U) << "else nothing would be left";
}

/// A map that says nothing: its only layer is taken, unless it is more than half full, or boxes are drawn.
TEST(TiledEvidence, TheOnlyLayerIsTakenIfItIsHalfEmpty) {
  const auto hills = import(meant::tiles("Tile Layer 1", kHills));
  EXPECT_EQ(hills.placements.size(), 16U);
  EXPECT_EQ(hills.report.choice,
            "tile layer Tile Layer 1, 50 % of the map: it is the only one that could be "
            "(--layer 'Tile Layer 1' --solid)");
  EXPECT_TRUE(import(meant::tiles("T", "aaaaaaaa/a......a/a......a/aaaaaaaa")).placements.empty());
  EXPECT_TRUE(import(meant::tiles("T", kHills) + meant::objects("O", meant::box(0, 0, 1, 1))).placements.empty());
  EXPECT_TRUE(import(meant::tiles("A", kHills) + meant::tiles("B", kHills)).placements.empty());
}

TEST(TiledEvidence, ObjectsAreTakenByAPropertyToo) {
  const std::string layer =
      meant::objects("Things", meant::box(0, 0, 1, 1) + "<object id='9' x='32' y='0' width='16' height='16'>" +
                                   property("rocky", "true") + "</object>");
  Options options{.solidIf = {"rocky"}};
  const auto map = import(layer, options);
  EXPECT_EQ(cellsOf(map), (Cells{{2, -1}}));
  EXPECT_TRUE(map.report.notes.empty());
  EXPECT_EQ(remarks(map).at(0), "Things: objects with the property that was asked for");
  options.objects.emplace();
  EXPECT_TRUE(import(layer, options).placements.empty()) << "--no-objects takes none";
}

TEST(TiledEvidence, AClassOfObjectsCanBeLeftOutOrTaken) {
  const std::string things =
      meant::objects("Things", meant::box(0, 0, 1, 1, "type='door'") + meant::box(2, 0, 1, 1, "type='rock'") +
                                   meant::box(4, 0, 1, 1, "name='rock'"));
  EXPECT_EQ(cellsOf(import(things, {.objects = {{"rock"}}})), (Cells{{2, -1}, {4, -1}}));
  EXPECT_EQ(cellsOf(import(things, {.leaveOut = {"door"}, .objects = {{"Things"}}})), (Cells{{2, -1}, {4, -1}}));
}

TEST(TiledEvidence, AMissingMapOfAWorldIsLeftOut) {
  const std::string world =
      R"({"type":"world", "maps":[{"fileName":"a.tmx", "x":0, "y":0}, {"fileName":"no.tmx", "x":64,
    "y":0}, {"fileName":"../out.tmx", "x":128, "y":0}]})";
  const std::string map = mapXml(tilesetXml({kFullTile}) + csvLayer(1, 1, "1"));
  Files files{{"maps/test.tmx", world}, {"maps/a.tmx", map}, {"out.tmx", map}};
  const auto two = test::must(importFiles(files));
  EXPECT_EQ(two.placements.size(), 2U);
  const std::string missing = "the map's file maps/no.tmx cannot be read: there is no such file";
  EXPECT_THAT(two.report.notes, ElementsAre("a map of the world is left out: " + missing));
  EXPECT_EQ(two.report.partial, missing);
  EXPECT_EQ(message(importFiles(files, {.allMaps = true}).error()), "maps/test.tmx: maps/1 " + missing);
  const auto read = [&](const std::string& path) -> tl::expected<std::string, std::string> { return files.at(path); };
  files["maps/no.tmx"] = map;
  const auto outside = importMap("maps/test.tmx", {}, read);
  ASSERT_FALSE(outside) << "what may not be read is not missing";
  EXPECT_THAT(message(outside.error()), HasSubstr("it is not in the folder maps"));
}

/// A map that is as costly as can be is not tried twelve times: what is tried shares one budget.
TEST(TiledEvidence, WhatIsTriedSharesOneBudget) {
  std::string layers;
  for (int k = 0; k < 20; ++k) layers += meant::tiles("L" + std::to_string(k), kHills);
  EXPECT_EQ(offersOf(import(layers)).size(), kMaxSuggestions);
  const Options strict{.maxPlacements = 40};  // each layer has 16
  EXPECT_EQ(offersOf(import(layers, strict)).size(), 2U);
}

/// The same for cells of objects: there are enough for three of the boxes, each in a layer of its own.
TEST(TiledEvidence, WhatIsTriedSharesTheCellsOfItsShapes) {
  constexpr std::size_t kCells = 400 * 200;
  std::string layers;
  for (int k = 0; k < 5; ++k) layers += meant::objects("L" + std::to_string(k), meant::box(0, 0, 400, 200));
  const std::string text = textOf(layers);
  ASSERT_LT(kObjectCellsPerByte * text.size(), 3 * kCells);
  Options options;
  for (const std::size_t less : {std::size_t{0}, std::size_t{1}}) {
    options.maxObjectCells = 3 * kCells - less - kObjectCellsPerByte * text.size();
    const auto map = test::must(importFiles({{"maps/test.tmx", text}}, options));
    EXPECT_EQ(offersOf(map).size(), 3U - less);
  }
}

}  // namespace
}  // namespace lgs::tiled
