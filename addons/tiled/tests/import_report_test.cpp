// The report and the errors as text. They are compared as a whole, since a person reads them in a terminal.
#include "maps.h"

#include <algorithm>

namespace lgs::tiled {
namespace {

Report smallest() {
  Report report;
  report.file = "a.tmx";
  report.width = 3;
  report.height = 2;
  report.tileWidth = 32;
  report.tileHeight = 16;
  return report;
}

TEST(TiledReport, OfAMapWithNothingInIt) {
  Report report = smallest();
  const std::string nothing = "a.tmx: nothing in it is solid\n";
  EXPECT_EQ(toText(report), nothing + "  3×2 tiles of 32×16 px; polygons in 0 cells\n");
  report.infinite = true;
  EXPECT_EQ(toText(report), nothing + "  3×2 tiles of 32×16 px, infinite; polygons in 0 cells\n");
}

TEST(TiledReport, HeadLayersBlocksAndNotes) {
  Report report = smallest();
  report.polygons = report.shapes = report.cells = 1;
  report.layers = {{"Höhle", true, 1, ""},
                   {"Boden", true, 20, "shifted by 8 px, 0 px against the grid: its polygons reach out of their cells"},
                   {"B", false, 7, "an image"},
                   {"Höhle/Wand", true, 0, ""}};
  report.blocks = {{"", 1, 1}, {"stone, ice", 20, 1'234}, {"Wüste", 70'000, 5}};
  report.notes = {"2 tiles belong to no tileset of the map", "and another"};
  EXPECT_EQ(
      toText(report),
      "a.tmx: 1 polygon (1 distinct), 17 % of the map\n"
      "  3×2 tiles of 32×16 px; polygons in 1 cell\n"
      "  layer Höhle       1 tile\n"
      "  layer Boden       20 tiles; shifted by 8 px, 0 px against the grid: its polygons reach out of their cells\n"
      "  layer B           passed over: an image\n"
      "  layer Höhle/Wand  0 tiles\n"
      "  block 1      1 polygon\n"
      "  block 20     1234 polygons  stone, ice\n"
      "  block 70000  5 polygons  Wüste\n"
      "  note: 2 tiles belong to no tileset of the map\n"
      "  note: and another\n");
}

/// A tile with a note of every kind.
TileReport tileWithNotes() {
  return {"set",
          4,
          "lava",
          2,
          true,
          {{NoteKind::leftOut, 1, 0, 0, {}, "left"},
           {NoteKind::leftOut, 2, 0, 1, {-3, 8}, "left at a place"},
           {NoteKind::carried, 4, 0, 0, {}, "carried"},
           {NoteKind::trimmed, 5, 0, 12, {0, -1}, "trimmed"},
           {NoteKind::approximated, 6, 0, 0, {}, "approximated"},
           {NoteKind::snapped, 7, 0, 0, {}, "snapped"},
           {NoteKind::nearMiss, 8, 0, 0, {}, "near miss"}}};
}

TEST(TiledReport, NotesByHowMuchTheyMatter) {
  Report report = smallest();
  report.tiles = {tileWithNotes(),
                  {"set", 5, "", 1, true, {}},
                  {"Höhle", 0, "", 1, true, {{NoteKind::leftOut, 9, 0, 0, {}, "left too"}}}};
  EXPECT_EQ(toText(report),
            "a.tmx: nothing in it is solid\n"
            "  3×2 tiles of 32×16 px; polygons in 0 cells\n"
            "\n"
            "Left out:\n"
            "  set #4 'lava', 2 uses\n"
            "    object 1: left\n"
            "    object 2: left at a place (1 place, first in cell -3, 8)\n"
            "  Höhle #0, 1 use\n"
            "    object 9: left too\n"
            "\n"
            "Changed on the way in:\n"
            "  set #4 'lava', 2 uses\n"
            "    object 4: carried\n"
            "    object 5: trimmed (12 places, first in cell 0, -1)\n"
            "    object 6: approximated\n"
            "    object 7: snapped\n"
            "\n"
            "Worth a look:\n"
            "  set #4 'lava', 2 uses\n"
            "    object 8: near miss\n");
}

/// All that is to be known before one goes on stands in the first line, and the next best reading in the second.
TEST(TiledReport, TheFirstLinesSayWhatWasTaken) {
  Report report = smallest();
  report.polygons = report.shapes = report.cells = 1;
  report.choice = "tile layer A: its name says 'wall'";
  report.partial = "tile layer B, of which 1 of 9 tiles are taken";
  report.also = "object layer C, of which nothing is taken";
  report.leftOut = "Deadly (3)";
  report.suggestions = {{"all of B", {"--layer", "B B"}, 9}, {"C", {}, 1}};
  const std::string text = toText(report, "lgs import a.tmx");
  EXPECT_EQ(
      text.substr(0, text.find("  3×2")),
      "a.tmx: 1 polygon (1 distinct), 17 % of the map: tile layer A: its name says 'wall'; IN PART: tile layer B, "
      "of which 1 of 9 tiles are taken; also there: object layer C, of which nothing is taken; left out as deadly "
      "or passable: Deadly (3)\n"
      "  or: lgs import a.tmx --layer 'B B'  (9 polygons: all of B)\n"
      "  or: lgs import a.tmx  (1 polygon: C)\n");
}

TEST(TiledReport, NamesCanNotSpeakToATerminal) {
  const std::string evil = "a\nb\x1b[31mc\x7f";
  Report report = smallest();
  report.file = evil;
  report.layers = {{evil, true, 1, evil, LayerKind::objects, 1, {{NoteKind::leftOut, 1, 0, 0, {}, evil}}}};
  report.blocks = {{evil, 1, 1}};
  report.tiles = {{evil, 1, evil, 1, true, {{NoteKind::snapped, 1, 0, 0, {}, evil}}}};
  report.notes = {evil};
  report.suggestions = {{evil, {}}};
  report.choice = report.partial = report.also = report.leftOut = evil;
  const std::string text = toText(report) + message({evil, 3, evil, evil});
  const auto isControl = [](char c) { return c != '\n' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7F); };
  EXPECT_EQ(std::ranges::count_if(text, isControl), 0) << text;
  EXPECT_THAT(text, Not(HasSubstr("a\nb")));
}

TEST(TiledReport, TilesWithoutShapesAreNamedUpToTwelve) {
  Report report = smallest();
  report.tiles = {{"set", 7, "", 1, false, {}}};
  const std::string head = toText(smallest());
  EXPECT_EQ(toText(report), head + "\nWithout collision shapes: 1 tile, 1 use\n  set #7\n");
  report.tiles.push_back({"set", 8, "", 50, true, {}});
  std::string names = "  set #7";
  for (std::uint32_t id = 20; id <= 30; ++id) {
    report.tiles.push_back({"b", id, "", 2, false, {}});
    names += ", b #" + std::to_string(id);
  }
  EXPECT_EQ(toText(report), head + "\nWithout collision shapes: 12 tiles, 23 uses\n" + names + "\n");
  report.tiles.push_back({"b", 31, "", 2, false, {}});
  EXPECT_EQ(toText(report), head + "\nWithout collision shapes: 13 tiles, 25 uses\n" + names + " and 1 more\n");
  report.tiles.push_back({"b", 32, "", 2, false, {}});
  EXPECT_EQ(toText(report), head + "\nWithout collision shapes: 14 tiles, 27 uses\n" + names + " and 2 more\n");
}

TEST(TiledReport, MessagesOfErrors) {
  EXPECT_EQ(message({"a.tmx", 12, "<layer> 'L'", "has no <data>", ""}), "a.tmx:12: <layer> 'L' has no <data>");
  EXPECT_EQ(message({"a.tmx", 0, "", "cannot be read", ""}), "a.tmx: cannot be read");
  EXPECT_EQ(message({"", 0, "", "is wrong", ""}), "the map: is wrong");
  EXPECT_EQ(message({"", 3, "<map>", "is wrong", ""}), "the map:3: <map> is wrong");
  EXPECT_EQ(message({"a.tmx", 0, "", "is too large", "maxTiles"}), "a.tmx: is too large (Options::maxTiles)");
}

/// A map in which something of every kind happens, and the report about it.
TEST(TiledReport, OfAWholeImport) {
  const std::string tiles = "<tile id='0' class='rock'><objectgroup>" + kFullTile + "</objectgroup></tile>" +
                            "<tile id='1' type='slope'><objectgroup>"
                            "<object id='1' x='0.5' y='32'><polygon points='0,0 31.75,0 31.5,-30.5'/></object>"
                            "<object id='2' class='ice' x='2' y='0' width='8' height='4'/>"
                            "<object id='3' x='20' y='2' width='6' height='6'><ellipse/></object>"
                            "<object id='4' x='20' y='9' width='6' height='3'><capsule/></object>"
                            "<object id='5'><point/></object></objectgroup></tile><tile id='2'/>";
  const std::string set = "<tileset firstgid='1' name='Höhle' tilewidth='32' tileheight='32'>" + tiles + "</tileset>";
  const Options options{.blockFrom = BlockFrom::tileClass};
  const auto map = mustImport(set + csvLayer(2, 2, "2,3,1,2") +
                                  "<layer name='More' width='2' height='2' offsety='32'><data encoding='csv'>"
                                  "2,0,0,0</data></layer><imagelayer name='Sky'/>",
                              options);
  EXPECT_EQ(
      toText(map.report),
      "maps/test.tmx: 9 polygons (5 distinct), 25 % of the map: the shapes of 4 tiles in Ground, More\n"
      "  or: --layer Ground --solid  (10 polygons: tile layer Ground, 100 % of the map: nothing says what it is)\n"
      "  4×3 tiles of 32×32 px; polygons in 3 cells\n"
      "  layer Ground  4 tiles\n"
      "  layer More    1 tile\n"
      "  layer Sky     passed over: an image\n"
      "  block 1  6 polygons  slope\n"
      "  block 2  2 polygons  ice\n"
      "  block 3  1 polygon  rock\n"
      "  note: blocks are numbered in the order of their first use: slope, ice, rock. An edit of the map may change "
      "the "
      "numbers. Choose them, or look them up by name\n"
      "\n"
      "Left out:\n"
      "  Höhle #1 'slope', 3 uses in layers Ground, More\n"
      "    object 5: a point has no area\n"
      "\n"
      "Changed on the way in:\n"
      "  Höhle #1 'slope', 3 uses in layers Ground, More\n"
      "    objects 1, 2, 3, 4, each: lies on what is there already: the common part was taken away (1 place in layer "
      "More, first in cell 0, -2)\n"
      "    object 4: lies on what is there already: the common part was taken away (2 places in layer Ground, first in "
      "cell 1, -2)\n"
      "    object 3: an ellipse became a polygon of 32 vertices\n"
      "    object 4: a capsule became a polygon of 32 vertices\n"
      "    object 1: 2 coordinates put on the grid, by up to 0.5 px\n"
      "\n"
      "Without collision shapes: 1 tile, 1 use\n"
      "  Höhle #2\n");
}

}  // namespace
}  // namespace lgs::tiled
