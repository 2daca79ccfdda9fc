// Tiles that are solid by a property, words that say so, and what is suggested for a map from which nothing comes out.
#include "maps.h"

#include "addons/tiled/src/words.h"

namespace lgs::tiled {
namespace {

/// Tiles 1, 2, … without shapes, each with a property 'p' of this value.
std::string plainTiles(const std::vector<std::string>& values) {
  std::string xml = "<tileset firstgid='1' name='set' tilewidth='32' tileheight='32'>";
  for (std::size_t k = 0; k < values.size(); ++k) {
    xml += "<tile id='" + std::to_string(k) + "'>" + property("p", values[k]) + "</tile>";
  }
  return xml + "</tileset>";
}

std::string layer(const std::string& name, const std::string& csv, const std::string& properties = "") {
  return "<layer name='" + name + "' width='4' height='1'>" + properties + "<data encoding='csv'>" + csv +
         "</data></layer>";
}

TEST(TiledSolidIf, PropertiesOfTiles) {
  const std::string content = plainTiles({"true", "false", "0", "rock"}) + layer("L", "1,2,3,4");
  const auto cells = [&](std::vector<std::string> rules) {
    return cellsOf(mustImport(content, {.solidIf = std::move(rules)}));
  };
  EXPECT_EQ(cells({}), Cells{});
  EXPECT_EQ(cells({"p"}), (Cells{{0, -1}, {3, -1}}));
  EXPECT_EQ(cells({"p=rock"}), (Cells{{3, -1}}));
  EXPECT_EQ(cells({"p=false", "q", "p=0"}), (Cells{{1, -1}, {2, -1}}));
  EXPECT_EQ(cells({"q", "P", "p="}), Cells{});
}

TEST(TiledSolidIf, PropertiesOfLayers) {
  const std::string half = "<object id='1' y='16' width='32' height='16'/>";
  const std::string set = tilesetXml({half}, "") + "<tileset firstgid='7' tilewidth='32' tileheight='32'/>";
  const auto map =
      mustImport(set + layer("A", "7,0,0,0") + layer("B", "0,7,1,0", property("wall", "true")), {.solidIf = {"wall"}});
  EXPECT_EQ(cellsOf(map), (Cells{{1, -1}, {2, -1}}));
  EXPECT_EQ(ringsIn(map, {1, -1}), (Rings{kSquare}));
  EXPECT_NE(ringsIn(map, {2, -1}), (Rings{kSquare})) << "a tile with shapes keeps them";
  EXPECT_THAT(toText(map.report), HasSubstr("\nFull squares, as asked: 1 tile, 2 uses\n"));
}

TEST(TiledSolidIf, ValuesMayStandInTheElement) {
  const std::string set =
      "<tileset firstgid='1' tilewidth='32' tileheight='32'><tile id='0'><properties>"
      "<property name='p'>rock\nand stone</property></properties></tile></tileset>";
  EXPECT_EQ(cellsOf(mustImport(set + layer("L", "1,0,0,0"), {.solidIf = {"p=rock\nand stone"}})), (Cells{{0, -1}}));
}

/// "collision solid", "ground wall" or "-".
std::string said(const Saying& what) {
  return what.says == Says::nothing ? "-"
                                    : (what.says == Says::ground ? "ground " : "collision ") + std::string(what.word);
}

TEST(TiledWords, NamesThatSayThatSomethingIsSolid) {
  for (const auto& [name, what] : std::map<std::string, std::string>{{"TileCOLLISIONLayer", "collision collision"},
                                                                     {"Collidables", "collision collidable"},
                                                                     {"collides", "collision collides"},
                                                                     {"isSolid", "collision solid"},
                                                                     {"estSolide", "collision solid"},
                                                                     {"blockedLayer", "collision blocked"},
                                                                     {"isObstacle", "collision obstacle"},
                                                                     {"impassable", "collision impassable"},
                                                                     {"boundaries", "collision boundaries"},
                                                                     {"collision walls", "collision collision"},
                                                                     {"InnerWalls", "ground wall"},
                                                                     {"innerwalls", "ground wall"},
                                                                     {"Background and ground", "ground ground"},
                                                                     {"floor2", "ground floor"},
                                                                     {"Terrain/Deco", "ground terrain"},
                                                                     {"Platforms", "ground platform"},
                                                                     {"Plataformas", "ground platform"},
                                                                     {"Obsticles", "collision obstacle"},
                                                                     {"colider", "collision colid"},
                                                                     {"Geometry", "ground geom"},
                                                                     {"ramps", "ground ramps"},
                                                                     {"Slope left", "ground slope"},
                                                                     {"pendientes", "ground pendiente"},
                                                                     {"terrain_no_destructible", "ground terrain"},
                                                                     {"anti-gravity walls", "ground wall"},
                                                                     {"block", "ground block"}}) {
    EXPECT_EQ(said(saying(name)), what) << name;
  }
}

TEST(TiledWords, NamesThatAreForAnotherUse) {
  for (const char* name : {"Background",
                           "foreground",
                           "Middleground",
                           "playground",
                           "Wal l",
                           "firewall",
                           "Wallpaper",
                           "kill-collision",
                           "GroundEffects",
                           "groundeffects",
                           "noncollidable",
                           "unblockedLayer",
                           "BG Wall",
                           "Wall Decals",
                           "notSolid",
                           "wall_no_collision",
                           "not walls",
                           "trampoline",
                           "ladder_collision",
                           "NoCollision",
                           "Light-Collisions",
                           "camera-barrier",
                           "MovingPlatforms",
                           "speed",
                           "",
                           "animated"}) {
    EXPECT_EQ(said(saying(name)), "-") << name;
  }
}

TEST(TiledWords, PropertiesCanBeAboutCollision) {
  for (const char* name : {"collidesWith", "groundSpeed", "collision_mask", "wallId", "blockType"}) {
    EXPECT_EQ(said(sayingOfProperty(name)), "-") << name;
  }
  EXPECT_EQ(said(sayingOfProperty("collides")), "collision collides");
  EXPECT_EQ(said(sayingOfProperty("is_wall")), "ground wall");
}

/// Each suggestion: "TEXT | ARGUMENTS".
std::vector<std::string> suggestionsOf(const std::string& content, const Options& options = {}) {
  std::vector<std::string> result;
  for (const Suggestion& suggestion : mustImport(content, options).report.suggestions) {
    std::string text = suggestion.text + " |";
    for (const std::string& argument : suggestion.arguments) text += " " + argument;
    result.push_back(text);
  }
  return result;
}

TEST(TiledSuggestions, NoneIfSomethingCameOut) {
  EXPECT_TRUE(suggestionsOf(tilesetXml({kFullTile}) + csvLayer(1, 1, "1")).empty());
  EXPECT_TRUE(suggestionsOf(csvLayer(1, 1, "0")).empty()) << "there is nothing to take";
}

TEST(TiledSuggestions, WhatLooksLikeCollisionIsTakenByItself) {
  const std::string tiles = "<tileset firstgid='1' tilewidth='32' tileheight='32'><tile id='0'>" +
                            property("collides", "true") + "</tile><tile id='1'>" + property("collides", "1") +
                            "</tile><tile id='2'>" + property("collides", "false") + "</tile><tile id='3'>" +
                            property("speed", "2") + "</tile></tileset>";
  const auto choice = [](const std::string& content) { return mustImport(content).report.choice; };
  EXPECT_EQ(choice(tiles + layer("L", "1,2,3,1")), "what has a property: collides (3 tiles) (--solid-if collides)");
  EXPECT_THAT(
      suggestionsOf(tiles + layer("L", "4,4,0,3")),
      ElementsAre("tile layer L, 75 % of the map: nothing says what it is | --layer L --solid --not collides=false"));
  EXPECT_EQ(choice(tiles + layer("Walls", "4,4,0,3") + layer("Solid", "0,0,0,0")),
            "tile layer Walls: its name says 'wall' (--layer Walls --solid --not collides=false)");
  EXPECT_EQ(choice(tiles + layer("L", "4,4,0,3", property("blocking", "true"))),
            "what has a property: blocking (2 tiles) (--solid-if blocking)");
}

TEST(TiledSuggestions, FullSquaresOnlyWhereTheyHelp) {
  const std::string shapeless = "<tileset firstgid='1' tilewidth='32' tileheight='32'/>";
  EXPECT_THAT(suggestionsOf(shapeless + layer("A", "1,1,1,0") + layer("B", "1,0,0,0"), {.layers = {"A"}}),
              ElementsAre("tile layer A, 75 % of the map: nothing says what it is | --layer A --solid"));
  const std::string open = "<object id='1'><polyline points='0,0 32,0'/></object>";
  for (const char* name : {"L", "Ground"}) {
    EXPECT_TRUE(suggestionsOf(tilesetXml({open}) + layer(name, "1,1,0,0")).empty()) << "the tile has a shape, left out";
  }
}

TEST(TiledSuggestions, NotForObjectsThatHaveNoArea) {
  const std::string spawn = "<object id='1'><point/></object>", sign = "<object id='2'><text>Exit</text></object>";
  EXPECT_TRUE(suggestionsOf("<objectgroup name='Spawns'>" + spawn + sign + "</objectgroup>").empty());
}

TEST(TiledSuggestions, ObjectLayersThatWerePassedOver) {
  const std::string box = "<object id='1' width='9' height='9'/>";
  const auto group = [](const std::string& name, const std::string& objects) {
    return "<objectgroup name='" + name + "'>" + objects + "</objectgroup>";
  };
  EXPECT_THAT(suggestionsOf(group("A", box + box) + group("B", "") + "<group name='G'>" + group("C", box) + "</group>"),
              ElementsAre("object layer A, 2 objects: nothing says what it is | --objects A",
                          "object layer G/C, 1 object: nothing says what it is | --objects G/C"));
  const auto named = mustImport(group("A", box) + group("B", "<object id='2' name='wall' width='9' height='9'/>"));
  EXPECT_EQ(named.report.choice, "objects that are called wall (--objects wall)");
}

TEST(TiledSuggestions, AreInTheReport) {
  const auto map = mustImport("<objectgroup name='My boxes'><object id='1' width='9' height='9'/></objectgroup>");
  EXPECT_EQ(
      toText(map.report),
      "maps/test.tmx: nothing in it is solid\n"
      "  or: --objects 'My boxes'  (1 polygon: object layer My boxes, 1 object: nothing says what it is)\n"
      "  4×3 tiles of 32×32 px; polygons in 0 cells\n"
      "  layer My boxes  passed over, 1 object: neither its name, its class nor a property says that it is solid\n");
}

}  // namespace
}  // namespace lgs::tiled
