// What is taken by itself, what is offered, and what is said of the rest: a test for each thing that went wrong on real
// maps.
#include "evidence_maps.h"
#include "ldtk_projects.h"
#include "proptests/support/must.h"

namespace lgs::tiled {
namespace {

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

}  // namespace
}  // namespace lgs::tiled
