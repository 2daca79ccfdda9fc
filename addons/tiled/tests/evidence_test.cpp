// What is taken by itself, what is offered, and what is said of the rest: a test for each thing that went wrong on real
// maps.
#include "ldtk_projects.h"
#include "meant_maps.h"
#include "proptests/support/must.h"

namespace lgs::tiled {
namespace {

const std::string kFull = "bbbbbbbb/bbbbbbbb/bbbbbbbb/bbbbbbbb", kHills = "......../..aa..../aaaa..aa/aaaaaaaa";
const std::string kRim = "aaaaaaaa/a......a/a......a/aaaaaaaa", kPlatforms = "......../.aaa..../....aaa./........";

std::string textOf(const std::string& layers, const std::string& tileset = "") {
  return "<map orientation='orthogonal' width='8' height='4' tilewidth='16' tileheight='16'>" +
         meant::mapOf(tileset, layers) + "</map>";
}

ImportedMap import(const std::string& layers, const Options& options = {}, const std::string& tileset = "") {
  return mustImportFiles({{"maps/test.tmx", textOf(layers, tileset)}}, options);
}

/// "--layer A --solid" of each offer.
std::vector<std::string> offersOf(const ImportedMap& map) {
  std::vector<std::string> result;
  for (const Suggestion& suggestion : map.report.suggestions) {
    std::string words;
    for (const std::string& argument : suggestion.arguments) words += (words.empty() ? "" : " ") + argument;
    result.push_back(words);
  }
  return result;
}

TEST(TiledEvidence, ATileLayerCalledCollisionComesBeforeObjects) {
  const std::string things = meant::objects("Things", meant::box(0, 0, 3, 3));
  EXPECT_EQ(import(things + meant::tiles("collision", kHills)).report.choice,
            "tile layer collision: its name says 'collision' (--layer collision --solid)");
  EXPECT_EQ(import(things + meant::tiles("ground", kHills)).report.choice,
            "tile layer ground: its name says 'ground' (--layer ground --solid)");
}

/// A map of 40×8 tiles has room for what is next to nothing.
ImportedMap importWide(const std::string& layers, const std::string& tileset = "") {
  return mustImportFiles({{"maps/test.tmx", "<map width='40' height='8' tilewidth='16' tileheight='16'>" +
                                                meant::mapOf(tileset, layers) + "</map>"}});
}
std::string wide(const std::string& name, const std::string& tiles) {
  std::string csv;
  for (const char c : tiles + std::string(320 - tiles.size(), '.'))
    csv += (csv.empty() ? "" : ",") + std::to_string(c == '.' ? 0 : c - 'a' + 1);
  return "<layer name='" + name + "' width='40' height='8'><data encoding='csv'>" + csv + "</data></layer>";
}

/// The author gave the slopes of the ground a property, and means the ground.
TEST(TiledEvidence, WhatIsNextToNothingDoesNotStandForTheLevel) {
  const std::string slope = meant::tile('b', property("slope", "45"));
  const auto map = importWide(wide("tiles", std::string(60, 'a') + "bbb"), slope);
  EXPECT_EQ(map.placements.size(), 63U);
  EXPECT_THAT(offersOf(map), ElementsAre("--solid-if slope"));
  EXPECT_EQ(importWide(wide("tiles", std::string(8, 'a') + "bbb"), slope).placements.size(), 3U) << "of much more";
  const auto few =
      importWide(wide("tiles", std::string(60, 'a')) + meant::objects("obstacles", meant::box(0, 0, 1, 1)));
  EXPECT_EQ(few.placements.size(), 1U);
  EXPECT_EQ(few.report.partial, "it is less than 3 % of the map");
  EXPECT_THAT(offersOf(few), ElementsAre("--layer tiles --solid"));
  EXPECT_EQ(importWide(wide("T1", std::string(60, 'a')) + wide("T2", "aaa")).placements.size(), 60U)
      << "a few tiles in another layer are no rival";
}

/// A game's code may stop bodies at more layers than those that say so.
TEST(TiledEvidence, OtherLayersBesideThoseThatAreTakenAreSaid) {
  const std::string rock = meant::tiles("obstacle", kRim), pond = "......../..aa..../......../........";
  const auto map = import(rock + meant::tiles("water", pond) + meant::tiles("decoration", pond));
  EXPECT_EQ(map.placements.size(), 20U);
  EXPECT_EQ(map.report.also, "tile layer water, of which 0 of 2 tiles are taken");
  EXPECT_THAT(offersOf(map), ElementsAre("--layer obstacle --layer water --solid"));
}

TEST(TiledEvidence, WhereBodiesWalkIsNoGround) {
  EXPECT_TRUE(import(meant::tiles("grass", kFull) + meant::tiles("navigation", kHills)).placements.empty());
  EXPECT_TRUE(import(meant::tiles("grass", kFull) + meant::tiles("walkable", kHills)).placements.empty());
}

TEST(TiledEvidence, GroundIsNotMixedWithCollision) {
  const std::string walked = "bbbbbbbb/bbbb..../bbbbbbbb/bbbbb...";
  for (const std::string& ground : {kFull, walked}) {
    const auto map = import(meant::tiles("Ground", ground) + meant::tiles("Collision", kRim));
    EXPECT_EQ(map.placements.size(), 20U);
    EXPECT_EQ(map.report.partial, "");
  }
}

/// The author gave shapes to the spikes, and means the platforms to be full squares.
TEST(TiledEvidence, FewShapesDoNotHideThePlatforms) {
  const std::string spikes = meant::tiles("Spikes", "......../......../......../...d.d..");
  const std::string platforms = meant::tiles("Platforms", kPlatforms);
  const auto map = import(spikes + platforms, {}, meant::tile('d', meant::kShape));
  EXPECT_EQ(cellsOf(map), cellsOf(import(platforms)));
  EXPECT_EQ(map.report.choice, "tile layer Platforms: its name says 'platform' (--layer Platforms --solid)");
}

/// The author means boulders and the walls around them to be solid, and drew both.
TEST(TiledEvidence, WallsDrawnBesideObstaclesAreTaken) {
  const std::string walls = meant::objects("Walls", meant::box(0, 2, 8, 2));
  const auto map = import(meant::tiles("Land", kFull) + walls + meant::objects("Obstacles", meant::box(3, 0, 1, 1)));
  EXPECT_EQ(map.placements.size(), 17U);
  EXPECT_EQ(map.report.partial, "");
}

/// Walls are then the picture of what was drawn: they are said, and nothing is missing.
TEST(TiledEvidence, WallsBesideCollisionsThatWereDrawnAreNoPart) {
  const std::string drawn = meant::objects("collisions", meant::box(0, 2, 8, 2)), walls = meant::tiles("walls", kRim);
  const auto map = import(walls + drawn);
  EXPECT_EQ(map.report.partial, "");
  EXPECT_EQ(map.report.also, "tile layer walls, of which 0 of 20 tiles are taken");
}

/// Where bodies are drawn, blocks with coins are, too; but coins that are picked up look the same.
TEST(TiledEvidence, BoxesBesideAGroundThatWasDrawnAreSaid) {
  const std::string drawn = meant::objects("Ground", meant::box(0, 2, 8, 2));
  const auto map = import(drawn + meant::objects("Coins", meant::box(1, 0, 1, 1)) +
                          meant::objects("Spikes", meant::box(5, 1, 1, 1)));
  EXPECT_EQ(map.report.also, "object layer Coins, of which nothing is taken");
  EXPECT_THAT(offersOf(map), ElementsAre("--objects Ground --objects Coins"));
}

/// What is drawn of the ground as a polyline is a part of it, and has no area.
TEST(TiledEvidence, APolylineOfTheGroundIsAPart) {
  const auto map = import(meant::objects("ground", meant::box(0, 2, 8, 2) + meant::line(0, 1, 3)));
  EXPECT_EQ(map.report.partial, "object layer ground, of which 1 open polyline is left out");
}

/// The author means spikes that hurt, with pictures whose tile has a shape, and platforms to stand on.
TEST(TiledEvidence, ThingsWithPicturesAreNoCollisionLayer) {
  const std::string spikes = meant::objects("obstacles", meant::figure(1, 1) + meant::figure(5, 1));
  const std::string platforms = meant::tiles("Platforms", kPlatforms), shape = meant::tile('e', meant::kShape);
  EXPECT_EQ(cellsOf(import(platforms + spikes, {}, shape)), cellsOf(import(platforms)));
}

TEST(TiledEvidence, WhatGivesNothingIsNotOffered) {
  const std::string spawns = meant::objects("Spawns", meant::figure(1, 1) + meant::figure(3, 1));
  EXPECT_THAT(offersOf(import(spawns + meant::tiles("A", kHills) + meant::tiles("B", kRim))),
              ElementsAre("--layer B --layer A --solid", "--layer B --solid", "--layer A --solid"));
  EXPECT_TRUE(offersOf(import(spawns)).empty());
}

TEST(TiledEvidence, EachLayerIsOfferedWithItsShareOfTheMap) {
  const auto map = import(meant::tiles("A", kFull) + meant::tiles("B", kHills) + meant::tiles("C", kRim));
  EXPECT_TRUE(map.placements.empty());
  EXPECT_THAT(offersOf(map), ElementsAre("--layer C --layer B --solid", "--layer C --solid", "--layer B --solid",
                                         "--layer A --solid"));
  EXPECT_EQ(map.report.suggestions.at(0).text, "tile layers C, B: nothing says what they are");
  EXPECT_EQ(map.report.suggestions.at(0).polygons, 26U);
  EXPECT_EQ(map.report.suggestions.at(1).text, "tile layer C, 63 % of the map: nothing says what it is");
  EXPECT_EQ(map.report.suggestions.at(1).polygons, 20U);
}

TEST(TiledEvidence, CollidablesAreNotLumpedWithEvents) {
  const auto map =
      import(meant::objects("Collidables", meant::box(0, 2, 8, 2)) + meant::objects("Events", meant::box(0, 0, 8, 1)));
  EXPECT_EQ(map.placements.size(), 16U);
  EXPECT_EQ(remarks(map).at(0), "Collidables: its name says 'collidable'");
}

TEST(TiledEvidence, WhatIsTakenInPartIsSaid) {
  const std::string shape = meant::tile('a', meant::kShape);
  const auto blocks = import(meant::tiles("Blocks", "......../..ba..../baaa..aa/bababbaa"), {}, shape);
  EXPECT_EQ(blocks.report.partial, "tile layer Blocks, of which 10 of 16 tiles are taken");
  EXPECT_THAT(offersOf(blocks), ElementsAre("--solid-if layer=Blocks"));
  EXPECT_EQ(blocks.report.suggestions.at(0).polygons, 16U);
  const std::string text = toText(blocks.report);
  EXPECT_THAT(text.substr(0, text.find('\n')), HasSubstr("; IN PART: tile layer Blocks")) << text;
  const auto lines =
      import(meant::objects("Collision", meant::line(0, 1, 3) + meant::line(4, 1, 3) + meant::box(0, 3, 1, 1)));
  EXPECT_EQ(lines.report.partial, "object layer Collision, of which 2 open polylines are left out");
  const auto line = import(meant::objects(
      "Collision", meant::line(0, 1, 3) + meant::box(0, 3, 1, 1) + meant::box(2, 3, 1, 1) + meant::box(4, 3, 1, 1)));
  EXPECT_EQ(line.report.partial, "object layer Collision, of which 1 open polyline is left out");
  EXPECT_THAT(offersOf(line), ElementsAre("--objects Collision --polyline-thickness 4"));
  const auto most = import(meant::tiles("Blocks", "......../..ab..../aaaa..aa/aaaaaaaa"), {}, shape);
  EXPECT_EQ(most.report.partial, "");
  EXPECT_EQ(most.report.also, "tile layer Blocks, of which 15 of 16 tiles are taken");
}

/// Whatever says that it is solid counts: shapes, names, properties, walls that were drawn. None hides another.
TEST(TiledEvidence, AllThatSaysSolidIsTakenTogether) {
  const std::string shape = meant::tile('a', meant::kShape);
  const auto solid =
      import(meant::tiles("World", kHills) + meant::tiles("Solid", "b......./......../......../........"), {}, shape);
  EXPECT_EQ(solid.placements.size(), 17U);
  EXPECT_EQ(solid.report.choice,
            "the shapes of 16 tiles in World; tile layer Solid: its name says 'solid' (--solid-if layer=Solid)");
  EXPECT_THAT(offersOf(solid), ElementsAre("--no-objects")) << "the shapes alone";
  const auto walls = import(meant::tiles("Main", kHills) + meant::objects("Walls", meant::box(0, 0, 1, 1)), {},
                            meant::tile('a', property("solid", "true")));
  EXPECT_EQ(walls.placements.size(), 17U);
  EXPECT_EQ(walls.report.partial, "");
}

/// A layer that says it is solid means all of its tiles, however many of them have shapes.
TEST(TiledEvidence, ASolidLayerMeansAllOfItsTiles) {
  const std::string shape = meant::tile('a', meant::kShape), way[] = {"solid", ""};
  for (const std::string& property : way) {
    const std::string name = property.empty() ? "Solid" : "Tile Layer 1";
    for (const char* picture : {"abb...../......../......../........", "aab...../......../......../........"}) {
      const auto map = import(meant::tiles(name, picture, property), {}, shape);
      EXPECT_EQ(map.placements.size(), 3U) << picture << toText(map.report);
      EXPECT_EQ(map.report.partial, "");
    }
  }
}

TEST(TiledEvidence, ALayerWithLessThanOneThatIsPassedOverIsNotTakenInSilence) {
  const std::string few = "......../.c....../......../........";
  const auto map = import(meant::tiles("bg", "......../......../aaa..aaa/aaa..aaa") + meant::tiles("things", few));
  EXPECT_TRUE(map.placements.empty());
  EXPECT_THAT(offersOf(map), ElementsAre("--layer things --solid", "--layer bg --solid"));
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

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
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
