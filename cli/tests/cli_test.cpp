// The lgs command as a user meets it: exit statuses, messages, files.
#include "proptests/support/command.h"

#include <gmock/gmock.h>

namespace {

namespace fs = std::filesystem;
using ::lgs::test::Outcome;
using testing::HasSubstr, testing::Not;

class Command : public lgs::test::InAFolder {
 protected:
  Outcome lgs(const std::string& arguments, const std::string& errors = "2>&1") const {
    return lgs::test::outcomeOf("cd '" + folder_.string() + "' && '" LGS_COMMAND "' " + arguments + " " + errors);
  }

  void expect(const std::string& arguments, int status, const std::string& part) const {
    const Outcome outcome = lgs(arguments);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr(part)) << arguments << "\n" << outcome.text;
  }
};

const char* const kTwoSquares = "lgs-trace 1\nadd a 0 0 1  0 0 1 0 1 1 0 1\ncommit\nadd b 1 0 2  0 0 1 0 1 1 0 1\n";

TEST_F(Command, HelpAndVersionAreFine) {
  expect("--help", 0, "Exit status");
  expect("--version", 0, "lgs ");
  for (const std::string command : {"replay", "check", "import", "bench"}) expect(command + " --help", 0, "Example");
}

TEST_F(Command, BadUsageIsTwo) {
  put("t", kTwoSquares);
  expect("", 2, "subcommand");
  expect("play t", 2, "'play' is no command; there are replay, check, oracle, import, bench");
  expect("replay", 2, "TRACE");
  expect("replay t --chek", 2, "--chek");
  expect("replay t extra", 2, "extra");
  expect("replay t --check --oracle gods", 2, "gods");
  expect("check --cells 3by3", 2, "3by3");
  expect("check --cells 0x3", 2, "0x3");
  expect("check --cells 3x", 2, "3x");
  expect("check --edits 0", 2, "--edits");
  expect("check --edits many", 2, "many");
  for (const std::string seed : {"x", "-1", "1.5", "18446744073709551616"}) {
    expect("check --seed " + seed, 2, "'" + seed + "' is not a whole number from 0 to 18446744073709551615\n");
  }
  expect("check --case -1", 2, "'-1' is not a whole number from 0");
  expect("check --map t --whole-every -1", 2, "'-1' is not a whole number from 0");
  expect("import t.tmx --block colour", 2, "colour");
  expect("import t.tmx --block 1", 2, "1 not in {one,class,name,layer}");
  expect("import t.tmx --number water", 2, "NAME=NUMBER");
  expect("import t.tmx --tolerance -1", 2, "--tolerance");
  expect("bench --rounds 0", 2, "--rounds");
  expect("replay t --oracle cgal", 2, "--oracle requires --check");
  expect("replay t --html h", 2, "--html requires --check");
  expect("check --whole-every 5", 2, "--whole-every requires --map");
  for (const std::string option : {"--cells 3x3", "--case 1", "--case-edits 5"}) {
    expect("check --map t " + option, 2, " excludes --map");
  }
  for (const std::string outputs : {"replay t --dump - --svg -", "import t.tmx --svg -", "import t.tmx --report -"}) {
    expect(outputs, 2, "only one output can go to the standard output");
  }
}

TEST_F(Command, LostOutputIsTwo) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  put("t", kTwoSquares);
  for (const std::string arguments : {"--help", "replay t", "replay t --dump -", "check --edits 10"}) {
    const Outcome outcome = lgs(arguments, "2>&1 >/dev/full");
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_TRUE(outcome.text.ends_with("standard output: cannot write: No space left on device\n")) << outcome.text;
  }
}

TEST_F(Command, BadFilesAreTwo) {
  put("t", kTwoSquares);
  put("bad", "lgs-trace 1\nadd a 0 0 1  0 0 1 0\nmove a\n");
  put("worse", "lgs-trace 1\n\nadd a 0 0 1  0 0 1 0 1 1 0 one\n");
  put("bad.tmx", "<map");
  expect("replay missing", 2, "missing: cannot open the file");
  expect("replay .", 2, ".: there is no .trace in this folder");
  expect("replay bad", 2, "bad:2: ");
  expect("replay bad --check", 2, "bad:2: ");
  expect("replay worse", 2, "worse:3: the y of vertex 3, 'one': not a number");
  expect("replay t --dump no/such/folder/x", 2, "no/such/folder/x: cannot write the file");
  expect("replay t --svg no/such/folder/x", 2, "no/such/folder/x: cannot write the file");
  expect("check --edits 10 --out t", 2, "mismatch.trace: cannot write the file: Not a directory");
  expect("check --map missing", 2, "missing: cannot open the file");
  expect("check --map bad", 2, "bad:2: ");
  expect("import missing.tmx", 2, "missing.tmx");
  expect("import bad.tmx", 2, "bad.tmx");
  expect("check --edits 10 --svg no/such/folder/x", 2, "no/such/folder/x: cannot write the file");
}

TEST_F(Command, ReplayDumpsAndDraws) {
  put("t", kTwoSquares);
  expect("replay t --check --dump d --svg s.svg --html h.html", 0, "no mismatch");
  const std::string dump =
      "segment 0 0 65536 0 0 65536 131072 0 1\n"
      "segment 0 65536 0 0 65536 65536 65536 0 1\n"
      "segment 65536 0 131072 0 0 0 131072 65536 2\n"
      "segment 65536 65536 0 65536 131072 65536 0 0 1\n"
      "segment 131072 0 131072 65536 65536 0 65536 65536 2\n"
      "segment 131072 65536 65536 65536 131072 0 0 65536 2\n";
  EXPECT_EQ(get("d"), dump);
  EXPECT_THAT(get("s.svg"), HasSubstr("<svg"));
  EXPECT_THAT(get("h.html"), HasSubstr("add b 1 0 2"));
  EXPECT_EQ(lgs("replay t --dump -", "2>/dev/null").text, dump);  // nothing else on stdout
}

TEST_F(Command, ASavedWorldIsTakenWhereATraceIs) {
  put("t", kTwoSquares);
  expect("replay t --save w.lgs", 0, "2 polygons in 2 cells, 6 segments, 1 loop");
  EXPECT_EQ(get("w.lgs").substr(0, 7), "lgssnap");
  EXPECT_EQ(lgs("replay w.lgs --check --dump -", "2>/dev/null").text, lgs("replay t --dump -", "2>/dev/null").text);
  expect("replay w.lgs --check", 0, "no mismatch");
  expect("replay w.lgs --save again.lgs", 0, "6 segments");
  EXPECT_EQ(lgs("replay t --save -", "2>/dev/null").text, get("w.lgs"));
  expect("replay t --save no/such/folder/w.lgs", 2, "cannot write the file");
  expect("replay t --dump - --save -", 2, "only one output");
  put("cut.lgs", get("w.lgs").substr(0, 40));
  expect("replay cut.lgs", 2, "cut.lgs: byte 36: the snapshot is damaged, or cut: its checksum does not fit");
  put("none.lgs", kTwoSquares);
  expect("replay none.lgs", 2, "none.lgs: byte 3: this is no snapshot of a world");
  put("p", "lgs-trace 1\npreserve 1 2\nadd a 0 0 1  0 0 1 0 1 1 0 1\n");
  expect("replay p --save p.lgs", 0, "1 polygon");
  expect("replay p.lgs", 2, "preserve relation");
}

TEST_F(Command, CheckIsTheSameEachTime) {
  const auto withoutTime = [](std::string text) {
    const std::size_t time = text.find("time ");
    return text.erase(time, text.find('\n', time) - time);
  };
  const Outcome first = lgs("check --cells 3x3 --edits 400 --seed 5");
  EXPECT_EQ(first.status, 0) << first.text;
  EXPECT_THAT(first.text, HasSubstr("no mismatch"));
  EXPECT_THAT(first.text, Not(HasSubstr("\r"))) << "a progress line in a pipe";
  EXPECT_EQ(withoutTime(lgs("check --cells 3x3 --edits 400 --seed 5").text), withoutTime(first.text));
  expect("check --edits 10", 0, "edits      10, ");
  expect("check --case 3 --seed 5 --edits 1000000", 0, "cases      1;");
  EXPECT_TRUE(fs::is_empty(folder_)) << "a folder was made though there is no mismatch";
}

TEST_F(Command, CheckDigsInAMap) {
  put("t", kTwoSquares);
  expect("check --map t --edits 30", 0, "built by   2 edits\nedits      30, ");
  expect("check --map t --edits 200 --whole-every 7 --svg s.svg", 0, "no mismatch");
  EXPECT_THAT(get("s.svg"), HasSubstr("<svg"));
}

TEST_F(Command, ImportMakesATrace) {
  put("m.tmx",
      "<map version='1.10' orientation='orthogonal' width='2' height='1' tilewidth='16' tileheight='16' infinite='0'>"
      "<tileset firstgid='1' name='t' tilewidth='16' tileheight='16' tilecount='1' columns='1'>"
      "<tile id='0'><objectgroup><object id='1' x='0' y='8' width='16' height='8'/></objectgroup></tile></tileset>"
      "<layer id='1' name='l' width='2' height='1'><data encoding='csv'>1,1</data></layer></map>");
  expect("import ./m.tmx -o m.trace --svg m.svg", 0, "");
  EXPECT_THAT(get("m.svg"), HasSubstr("<title>m.tmx</title>")) << "the map's name";
  EXPECT_THAT(get("m.trace"), HasSubstr("add c1_-1_1 1 -1 1 "));
  expect("replay m.trace --check", 0, "2 polygons in 2 cells, 6 segments, 1 loop");
  EXPECT_EQ(lgs("import m.tmx", "2>/dev/null").text, get("m.trace"));
  expect("check --map m.tmx --edits 50", 0, "no mismatch");
}

TEST_F(Command, TheNextBestReadingStandsBesideTheWorld) {
  const auto layer = [](const char* name, const char* tiles) {
    return std::string("<layer width='2' height='1' name='") + name + "'><data encoding='csv'>" + tiles +
           "</data></layer>";
  };
  put("m.tmx",
      "<map orientation='orthogonal' width='2' height='1' tilewidth='16' tileheight='16'>"
      "<tileset firstgid='1' name='t' tilewidth='16' tileheight='16'/>" +
          layer("solid", "1,0") + layer("wall", "1,1") + "</map>");
  expect("import m.tmx -o m.trace --svg m.svg --strict", 0, "or: lgs import m.tmx --layer wall --solid  (2 polygons");
  EXPECT_THAT(get("m.svg"), HasSubstr("or: --layer wall --solid (2 polygons), on the right"));
}

TEST_F(Command, MapsOfEachFormatAreTakenByEachCommand) {
  const std::string map =
      R"({"type":"map", "tilewidth":16, "tileheight":16, "layers":[{"type":"objectgroup", "name":"wall", "objects":[)"
      R"({"id":1, "x":0, "y":8, "width":32, "height":8}]}]})";
  put("m.tmj", map);
  put("m.json", map);
  put("m.world", R"({"maps":[{"fileName":"m.tmj", "x":-32, "y":16}], "type":"world"})");
  put("m.ldtk", R"({"jsonVersion":"1.5.3", "levels":[{"identifier":"A", "worldX":0, "worldY":0, "layerInstances":[)"
                R"({"__type":"IntGrid", "__identifier":"G", "__gridSize":16, "__cWid":2, "__cHei":1, "layerDefUid":1, )"
                R"("intGridCsv":[1,2]}]}]})");
  for (const std::string name : {"m.tmj", "m.json", "m.world", "m.ldtk"}) {
    expect("import " + name + " -o m.trace", 0, "2 polygons (");
    expect("replay m.trace --check", 0, "2 polygons in 2 cells, 6 segments, 1 loop");
    expect("replay " + name, 0, "2 polygons in 2 cells");
    expect("check --map " + name + " --edits 20", 0, "no mismatch");
  }
  EXPECT_THAT(lgs("import m.world", "2>/dev/null").text, HasSubstr("add c-2_-2_1 -2 -2 1 "));
  EXPECT_THAT(lgs("import m.ldtk", "2>/dev/null").text, HasSubstr("add c1_-1_1 1 -1 2 "));
  put("m.tmx", "[gd_scene format=3]");
  expect("import m.tmx", 2, "m.tmx: is a Godot scene. What is read: maps of Tiled");
}

/// A map with a tile without shapes, and an object layer that nothing says is solid.
constexpr const char* kNothingSolid =
    "<map orientation='orthogonal' width='2' height='1' tilewidth='16' tileheight='16'>"
    "<tileset firstgid='1' name='t' tilewidth='16' tileheight='16'><tile id='0'><properties>"
    "<property name='hard' value='true'/></properties></tile></tileset>"
    "<layer name='l' width='2' height='1'><data encoding='csv'>1,0</data></layer>"
    "<objectgroup name='My boxes' class='one-way' visible='0'><object id='1' x='16' width='16' height='16'/>"
    "<object id='2' x='32' y='9'><polyline points='0,0 16,0'/></object></objectgroup></map>";

TEST_F(Command, AMapWithNothingSolidIsRefusedWithWhatCouldBeTaken) {
  put("m.tmx", kNothingSolid);
  expect("import m.tmx -o m.trace", 2, "m.tmx: nothing in it is solid\n");
  expect("import m.tmx -o m.trace", 2,
         "  or: lgs import m.tmx --layer l --solid  (1 polygon: tile layer l, 50 % of the map: nothing says what it "
         "is)\n");
  EXPECT_FALSE(fs::exists(folder_ / "m.trace"));
  expect("import m.tmx -o m.trace --allow-empty", 0, "nothing in it is solid");
  EXPECT_TRUE(fs::exists(folder_ / "m.trace"));
  for (const std::string command : {"check --map m.tmx", "replay m.tmx"}) {
    expect(command, 2, "  or: lgs import m.tmx --objects 'My boxes'");
    expect(command, 2, "m.tmx: not imported. `lgs import` has options for maps, and writes a trace to go on with\n");
  }
  expect("import m.tmx --solid-if Hards", 2,
         "note: no tile, tile layer or object has a property 'Hards'; there are 'hard'");
  expect("import m.tmx --solid-if hard --solid-if Hards --strict -o m.trace", 3,
         "IN PART: nothing has what was asked for: Hards\n");
  // A hint keeps what was asked for.
  expect("import m.tmx --layer l --visible --no-objects", 2,
         "  or: lgs import m.tmx --layer l --solid --no-objects --visible  (");
}

TEST_F(Command, AFileThatMayNotBeReadIsNamedWithTheCommandThatReadsIt) {
  const std::string after = "'/></map>", before =
                                             "<map width='2' height='1' tilewidth='16' tileheight='16'><layer "
                                             "name='solid' width='2' height='1'><data encoding='csv'>1,0</data>"
                                             "</layer><tileset firstgid='1' source='";
  put("m.tmx", before + "/no/a.tsx" + after);
  expect("import m.tmx -o m.trace --strict", 3, "files may lie anywhere: lgs import m.tmx --files-anywhere\n");
  fs::create_directories(folder_ / "game/.git");
  put("game/m.tmx", before + "../b c/a.tsx" + after);
  expect("import game/m.tmx -o m.trace", 0, "If the map can be trusted: lgs import game/m.tmx --files-in .\n");
}

TEST_F(Command, ErrorsOfTheImportNameOptionsOfTheCommand) {
  put("m.tmx", kNothingSolid);
  expect("import m.tmx --tolerance nan", 2, "--tolerance: 'nan' is not a number from 0 to 1000000\n");
  expect("import m.tmx --polyline-thickness nan", 2, "--polyline-thickness: 'nan' is not a number from 0 to 1000000\n");
  put("big.tmx",
      "<map width='9' height='9' tilewidth='16' tileheight='16'><layer name='l' width='5000' height='5000'>"
      "<data encoding='csv'/></layer></map>");
  const std::string tooBig = "big.tmx:1: <data> the map has more tiles than the limit; no option of lgs changes it\n";
  for (const std::string command : {"import", "check --map", "replay"}) expect(command + " big.tmx", 2, tooBig);
  const std::string worlds = R"({"identifier":"A", "worldLayout":"Free", "levels":[{"identifier":"L", "worldX":0,)"
                             R"( "worldY":0, "layerInstances":[{"__type":"IntGrid", "__identifier":"G", "__gridSize":)"
                             R"(16, "__cWid":1, "__cHei":1, "layerDefUid":1, "intGridCsv":[1]}]}]})";
  std::string other = worlds;
  other.replace(other.find('A'), 1, "B");
  put("m.ldtk", R"({"jsonVersion":"1.5.3", "worlds":[)" + worlds + "," + other + "]}");
  expect("import m.ldtk", 2, "which lie over each other: choose one of A, B (--layer)\n");
  expect("replay m.ldtk", 2, "which lie over each other: choose one of A, B (--layer)\n");
  expect("import m.ldtk --layer A", 0, "1 polygon");
}

/// Tiles of a layer "Blocks" of which one in three has a shape.
constexpr const char* kInPart =
    "<map orientation='orthogonal' width='6' height='2' tilewidth='16' tileheight='16'>"
    "<tileset firstgid='1' name='t' tilewidth='16' tileheight='16'><tile id='0'><objectgroup>"
    "<object id='1' width='16' height='16'/></objectgroup></tile></tileset>"
    "<layer name='Blocks' width='6' height='2'><data encoding='csv'>1,1,2,1,2,0,0,0,0,0,0,0</data></layer></map>";

TEST_F(Command, WhatIsTakenInPartIsSaid) {
  put("m.tmx", kInPart);
  const std::string part = "tile layer Blocks, of which 3 of 5 tiles are taken";
  const std::string summary =
      "m.tmx: 3 polygons (1 distinct), 25 % of the map: the shapes of 3 tiles in Blocks; IN PART: " + part +
      "\n  or: lgs import m.tmx --solid-if layer=Blocks  (5 polygons: the same with all of tile layer Blocks)\n";
  expect("import m.tmx -o m.trace", 0, summary);
  expect("import m.tmx -o m.trace --strict", 3, summary);
  expect("check --map m.tmx --edits 9", 0, summary);
  expect("import m.tmx --solid-if layer=Blocks --strict -o m.trace", 0, "5 polygons");
  expect("import m.tmx --layer Blocks --solid -o m.trace", 0, "5 polygons");
}

TEST_F(Command, TheSurveyIsATable) {
  fs::create_directories(folder_ / "maps/deep");
  put("maps/part.tmx", kInPart);
  put("maps/deep/none.tmx", kNothingSolid);
  put("maps/bad.tmx", "<map");
  put("maps/set.json", R"({"type":"tileset", "name":"t", "tilewidth":16, "tileheight":16})");
  put("maps/some.txt", "no map");
  put("maps/sprites.json", R"({"frames":[], "meta":{}})");
  put("maps/zcopy.tmx", kInPart);
  std::string whole = kInPart;
  for (std::size_t at = whole.find(",2,"); at != std::string::npos; at = whole.find(",2,")) whole[at + 1] = '1';
  put("maps/whole.tmx", whole);
  const Outcome table = lgs("import --survey maps");
  EXPECT_EQ(table.status, 0);
  for (const char* row :
       {"at once            5  maps/whole.tmx  |  42 % of the map: the shapes of 5 tiles in Blocks\n",
        "in part            3  maps/part.tmx  |  25 % of the map: tile layer Blocks, of which 3 of 5 tiles are taken\n",
        "by command         1  maps/deep/none.tmx  |  --objects 'My boxes'\n",
        "refused            0  maps/bad.tmx  |  maps/bad.tmx:1: ", "\n4 maps\n",
        "     1   25 %  at once     a world at the first try\n",
        "     1  refused: Error parsing start element tag\n"}) {
    EXPECT_THAT(table.text, HasSubstr(row)) << row << table.text;
  }
  expect("import --survey none", 2, "none: ");
  expect("import", 2, "MAP is required");
}

TEST_F(Command, ATableSaysWhatTilesAre) {
  put("m.tmx", kInPart);
  put("m.tiles", "lgs-tiles 1\n1 0 0, 1 0, 1 1\n");
  expect("import m.tmx --tiles m.tiles -o m.trace", 0, "5 polygons (2 distinct)");
  put("bad.tiles", "lgs-tiles 1\n\n1 half\n");
  expect("import m.tmx --tiles bad.tiles", 2, "bad.tiles:3: should say full, none, oneway");
  expect("import m.tmx --tiles none.tiles", 2, "none.tiles");
}

TEST_F(Command, AMapIsKnownByItsContentToo) {
  put("m.xml", "\n" + std::string(kNothingSolid));
  expect("check --map m.xml --edits 9", 2, "nothing in it is solid");
  expect("import m.xml --solid", 0, "");
  put("m.trace", "# <map>\nlgs-trace 1\n");
  expect("replay m.trace", 0, "0 edits");
  put("m.map", "{\"no\": \"map\"}");
  expect("replay m.map", 2, "m.map: ");
}

TEST_F(Command, OptionsOfTheImportChooseWhatIsSolid) {
  put("m.tmx", kNothingSolid);
  const auto polygons = [&](const std::string& options) {
    const Outcome import = lgs("import m.tmx --report m.txt " + options);
    EXPECT_EQ(import.status, 0) << import.text;
    return get("m.txt").substr(get("m.txt").find(' ') + 1, 10);
  };
  EXPECT_EQ(polygons("--solid-if hard"), "1 polygon ");
  EXPECT_EQ(polygons("--objects 'My boxes'"), "1 polygon ");
  EXPECT_EQ(polygons("--objects 'My boxes' --solid-if hard=true"), "2 polygons");
  EXPECT_EQ(polygons("--solid --no-objects --layer l --tolerance 0"), "1 polygon ");
  EXPECT_EQ(polygons("--objects 'My boxes' --solid --visible"), "1 polygon ");
  EXPECT_EQ(polygons("--objects 'My boxes' --solid --polyline-thickness 4.5"), "3 polygons");
  expect("import m.tmx --polyline-thickness -1", 2, "--polyline-thickness");
  expect("import m.tmx --objects none", 2, "has no object layer or group 'none'");
  expect("import m.tmx --objects 'My boxes' --no-objects", 2, "--objects excludes --no-objects");
}

}  // namespace
