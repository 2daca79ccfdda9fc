// The trace and dump formats: what is read, what is refused and how, what is written.
#include "oracle/trace/trace.h"
#include "oracle/generate/generator.h"
#include "oracle/trace/coordinate.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/file.h"
#include "proptests/support/must.h"
#include "read_traces.h"

#include <filesystem>

namespace lgs::oracle {
namespace {

using namespace std::string_literals;

TEST(Coordinate, RoundsExactly) {
  const std::string nines(900, '9'), manyNines = nines.substr(0, 400);
  const std::vector<std::pair<std::int64_t, std::vector<std::string>>> rows{
      {0, {"0", "-0", "-0.0", "0/7", "1e-1000"}},
      {65'536, {"1", "1.0000", "1.", "0." + nines, manyNines + "/" + manyNines}},
      {7 * 65'536, {"007"}},
      {16'384, {"0.25", "25E-2"}},
      {32'768, {".5"}},
      {-98'304, {"-1.5"}},
      {163'840, {"2.5e+0"}},
      {21'845, {"1/3"}},
      {43'691, {"2/3"}},
      {-21'845, {"-1/3"}},
      {131'072, {"12/6"}},
      {1, {"1/131072", "0.00000762939453125"}},  // half a unit, 2^-17: away from zero
      {-1, {"-1/131072"}},
      {0, {"1/131073", "0.00000762939453124", "0.00000762939453124" + nines}},  // a little less than half
      {1, {"1.52587890625e-05"}},                                               // 2^-16, as Python prints it
      {2, {"3/131072"}},
      {32'767 * 65'536, {"32767"}},
  };
  for (const auto& [units, words] : rows) {
    for (const std::string& word : words) {
      const auto parsed = parseCoordinate(word);
      ASSERT_TRUE(parsed) << word << ": " << parsed.error();
      EXPECT_EQ(*parsed, units) << word;
    }
  }
}

TEST(Coordinate, SaysWhatIsWrong) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> rows{
      {"not a number", {"x", "", "-", "+1", ".", "1.2.3", "0x10", "nan", "inf", "1e", "e5", "--1", "1e5.5"}},
      {"division by zero", {"1/0", "0/0", "1/000"}},
      {"a fraction is two integers, like 1/3 or -1/3", {"1/", "/3", "1/-3", "0.5/3", "1/2/3"}},
      {"far outside the cell, which is 0 to 1 on both axes", {"32768", "-1e9"}},
      {"the exponent is beyond 1000", {"1e1001", "1e99999999999999999999"}},
      {"a number of more than 1000 characters", {std::string(1'001, '1')}},
  };
  for (const auto& [fault, words] : rows) {
    for (const std::string& word : words) {
      const auto units = parseCoordinate(word);
      EXPECT_EQ(units ? "accepted" : units.error(), fault) << word;
    }
  }
}

TEST(Coordinate, PrintsExactly) {
  EXPECT_EQ(printCoordinate(0), "0");
  EXPECT_EQ(printCoordinate(65'536), "1");
  EXPECT_EQ(printCoordinate(-65'536), "-1");
  EXPECT_EQ(printCoordinate(32'768), "0.5");
  EXPECT_EQ(printCoordinate(-4'096), "-0.0625");
  EXPECT_EQ(printCoordinate(2'048), "1/32");
  EXPECT_EQ(printCoordinate(21'845), "21845/65536");
  for (std::int32_t units = -70'000; units <= 70'000; ++units) {
    ASSERT_EQ(parseCoordinate(printCoordinate(units)), units) << printCoordinate(units);
  }
}

TEST(Trace, ReadsEveryLine) {
  const Trace trace = mustParse(
      "\n  # before the header\r\nlgs-trace 1 # the header\r\npreserve 2 1\npreserve 1 2\n\t\n"
      "add a -3 4 4294967295 0 0, 1 0, 1/2 0.5 #no more\n"
      "  add b#2,0,0,7,0,0,1,0,1,1\ncommit\nremove a\ncommit");
  EXPECT_EQ(trace.preserve.pairs().size(), 1U);
  EXPECT_TRUE(trace.preserve(1, 2));
  ASSERT_EQ(trace.calls.size(), 5U);
  EXPECT_EQ(trace.calls[0], Call::add("a", {{-3, 4}, 4'294'967'295, {{0, 0}, {65'536, 0}, {32'768, 32'768}}}));
  EXPECT_EQ(trace.calls[0].line, 7U);
  EXPECT_EQ(trace.calls[1].name(), "b#2");
  EXPECT_EQ(trace.calls[2], Call::commit());
  EXPECT_EQ(trace.calls[3], Call::remove("a"));
  EXPECT_EQ(trace.calls[4].line, 11U);
}

TEST(Trace, RoundTrips) {
  const Trace trace = mustParse(
      "lgs-trace 1\npreserve 9 3\nadd a 1073741824 -1073741824 0 0 0 1/3 0 1 1\nadd b 0 0 4 -5 12 0.1 0.2\n"
      "commit\ncommit\nremove a\n");
  const std::string text = printTrace(trace);
  EXPECT_EQ(mustParse(text), trace) << text;
  EXPECT_EQ(printTrace(mustParse(text)), text);
}

// Version 3 said by other words how edits are made.
TEST(Trace, OfVersion3HasPlainEdits) {
  const std::string square = "0 0 1 0 1 1 0 1";
  const Trace trace = mustParse("lgs-trace 3\nadd by 0 0 1  " + square + " by fill 3 undone\nadd b 1 0 1  " + square +
                                " by fill too\ncommit by 2\nremove by by 7 marked\n");
  EXPECT_EQ(printTrace(trace),
            "lgs-trace 1\nadd by 0 0 1  " + square + "\nadd b 1 0 1  " + square + "\ncommit\nremove by\n");
}

TEST(Trace, OfVersion4HasAllCalls) {
  const std::string text =
      "lgs-trace 4\nadd a 0 0 1  0 0 1 0 1 1 0 1\nadd - 1 0 1  0 0 1 0 1 1  in floats 2\n"
      "place 2 0 1  0 0 1 0 1 1  |  0 0 1 1 0 1  as b c  room 2\nmany 3 0 1  0 0 1 0 1 1 ; 4 0 1  id 7\nmany\n"
      "replace 5 0 1  none  in list\nexchange 0 0 a 0:0#1 0:0#all given#3 beside#4 handle#7:2 with 1  0 0 1 0 1 1  as "
      "d "
      "; 2  0 0 1 1 0 1\nexchange 1 0\nremove b\nremoveMany b c\nsetBlock c 4294967295\nfill 0 0 3 3 1  0 0 1 0 1 1\n"
      "clear 0 0 -1 -1\nshape  0 0 -32768 0 1 1\ngroup all\nremove a\nclear 0 0 0 0\nend\ncommit\ncommit 3\nmark\n"
      "back 2 keep\nback 0\nforward 1\nforget 0\nleave 0 0 31 31\ncopy\nload\nunload 0 0 31 31\n"
      "reload 0 0 31 31 1\nreloadEmpty 0 0 31 31\npaint 1 fill  0 0 1 0 1 1 united around 1 2\ncarve  0 0 1 0 1 1\n"
      "repeat 300\nplace 0 0 1  0 0 1 0 1 1\nclear 0 0 0 0\nend\ntake 0:0#1\ntake a 3\nput 0\nput 2 by -1 3 turned 5\n"
      "foresee\ntake given#0\nput 1 turned 7\nend\n";
  const Trace trace = mustParse(text);
  EXPECT_EQ(printTrace(trace), text);
  EXPECT_EQ(mustParse(printTrace(trace)), trace);
}

TEST(Trace, APolygonWithoutVerticesIsWrittenAsItIsRead) {
  const std::string text = "lgs-trace 1\nadd a 0 0 1\n";
  EXPECT_EQ(printTrace(mustParse(text)), text);
}

TEST(Trace, AnyRandomCallsCanBeReadBack) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Trace trace = randomCase({.edits = 60, .isOfCalls = true, .brushes = true}, seed);
    ASSERT_EQ(mustParse(printTrace(trace)), trace) << seed;
  }
}

const std::string kHeadLine = "lgs-trace 1\n";
const std::string kSquareLine = "add p 0 0 1  0 0 1 0 1 1 0 1\n";

TEST(Trace, BadWordsSayFileLineAndReason) {
  expectFaults({
      {"", "bad.trace:1: the trace ends before its first line, 'lgs-trace 1'"},
      {"# nothing\n\n", "bad.trace:2: the trace ends before its first line"},
      {"add p 0 0 1 0 0 1 0 1 1\n", "bad.trace:1: not a trace: the first line must be 'lgs-trace 1', not 'add'"},
      {"lgs-trace\n", "bad.trace:1: the first line must be 'lgs-trace 1'"},
      {"lgs-trace 5\n",
       "bad.trace:1: the first line must be 'lgs-trace 1', or 'lgs-trace 2' if brushes paint or carve"},
      {"lgs-trace 2 3\n", "bad.trace:1: the first line must be 'lgs-trace 1', or 'lgs-trace 2'"},
      {kHeadLine + "lgs-trace 1\n", "bad.trace:2: unknown word 'lgs-trace'"},
      {kHeadLine + "# fine\nmove p\n", "bad.trace:3: unknown word 'move'; a line starts with"},
      {kHeadLine + "ADD p\n", "bad.trace:2: unknown word 'ADD'"},
      {kHeadLine + "commit now\n", "bad.trace:2: commit stands alone on its line; found 'now' after it"},
      {kHeadLine + "preserve 1\n", "bad.trace:2: preserve needs two blocks; found 1"},
      {kHeadLine + "preserve 1 2 3\n", "bad.trace:2: preserve needs two blocks; found 3"},
      {kHeadLine + "preserve a 2\n", "bad.trace:2: the block 'a' is not an integer"},
      {kHeadLine + kSquareLine + "preserve 1 2\n", "bad.trace:3: preserve must stand before the first edit"},
      {"lgs-trace 4\nend\n", "bad.trace:2: end without the begin of a group"},
      {"lgs-trace 4\ngroup keep\n", "bad.trace:2: the trace ends within a group"},
      {"lgs-trace 4\ngroup keep\nmark\nend\n", "bad.trace:3: mark can not stand in a group"},
      {"lgs-trace 4\nforesee\ncommit\nend\n", "bad.trace:3: commit can not stand in a group"},
      {"lgs-trace 4\nput 0 turned 8\n", "bad.trace:2: the symmetries of a cell are 0 to 7"},
      {"lgs-trace 4\ngroup maybe\n", "bad.trace:2: the end of a group is one of drop, keep, all, not 'maybe'"},
      {"lgs-trace 4\nremove 0:x#1\n", "bad.trace:2: the number after ':' 'x' is not an integer"},
      {"lgs-trace 4\nback\nforward one\n", "bad.trace:3: the number 'one' is not an integer"},
      {"lgs-trace 4\ncopy 1\n", "bad.trace:2: '1' is too much for copy"},
      {"lgs-trace 4\nfill 0 0 1\n", "bad.trace:2: fill ends before the cell index"},
      {"lgs-trace 4\nadd p 0 0 1  0 0 1 0 1 1  in ink\n", "bad.trace:2: the notation is one of lattice, list"},
      {kHeadLine + "remove p by fill\n", "bad.trace:2: remove needs one name; found 3"},
      {kHeadLine + "remove p q\n", "bad.trace:2: remove needs one name; found 2"},
      {kHeadLine + "remove p\n", "bad.trace:2: there is no polygon named 'p' to remove"},
      {kHeadLine + kSquareLine + "remove p\nremove p\n", "bad.trace:4: there is no polygon named 'p' to remove"},
      {kHeadLine + "remove p\nnonsense\n", "bad.trace:2: there is no polygon named 'p'"},  // the first bad line
  });
}

TEST(Trace, BadEditsSayFileLineAndReason) {
  expectFaults({
      {kHeadLine + "add\n",
       "bad.trace:2: add needs a name, a cell i j and a block before its coordinates; found only 0"},
      {kHeadLine + "add p 0 0\n", "bad.trace:2: add needs a name, a cell i j and a block"},
      {kHeadLine + "add p 0.5 0 1 0 0 1 0 1 1\n", "bad.trace:2: the cell index '0.5' is not an integer"},
      {kHeadLine + "add p 1073741825 0 1 0 0 1 0 1 1\n",
       "bad.trace:2: the cell index '1073741825' is out of range, which is -1073741824 to 1073741824"},
      {kHeadLine + "add p 0 -99999999999999999999 1 0 0 1 0 1 1\n", "bad.trace:2: the cell index '-99999999999999"},
      {kHeadLine + "add p 0 0 4294967296 0 0 1 0 1 1\n",
       "bad.trace:2: the block '4294967296' is out of range, which is 0 to 4294967295"},
      {kHeadLine + "add p 0 0 -1 0 0 1 0 1 1\n", "bad.trace:2: the block '-1' is out of range"},
      {kHeadLine + "add p 0 0 1 0 0 1 0 1\n", "bad.trace:2: 5 coordinates: they come in pairs x y"},
      {kHeadLine + "add p 0 0 1 0 0 1 zero 1 1\n", "bad.trace:2: the y of vertex 1, 'zero': not a number"},
      {kHeadLine + "add p 0 0 1 0 0 1/0 0 1 1\n", "bad.trace:2: the x of vertex 1, '1/0': division by zero"},
      {kHeadLine + "add p 0 0 1 0 0 1e9 0 1 1\n", "bad.trace:2: the x of vertex 1, '1e9': far outside the cell"},
      {kHeadLine + "remove\n", "bad.trace:2: remove needs one name; found 0"},
      {kHeadLine + kSquareLine + kSquareLine, "bad.trace:3: the name 'p' is in use"},
      {kHeadLine + "add p 0 0 1\n", "bad.trace:2: cell (0, 0): a polygon needs"},
      {kHeadLine + "add p 0 0 1 0 0 1 0\n", "bad.trace:2: cell (0, 0): a polygon needs at least 3 vertices"},
      {kHeadLine + "add p 0 0 1 0 0 1 0 1 1.5\n", "bad.trace:2: cell (0, 0): vertex 2 is outside the cell"},
      {kHeadLine + "add p 0 0 1 0 0 1 0 1 0 0 1\n",
       "bad.trace:2: cell (0, 0): vertex 1 and vertex 2 are the same lattice point"},
      {kHeadLine + "add p 0 0 1 0 0 0.5 0.5 1 1\n", "bad.trace:2: cell (0, 0): the polygon has no area"},
      {kHeadLine + "add p 0 0 1 0 0 0 1 1 1\n", "bad.trace:2: cell (0, 0): the polygon runs clockwise"},
      {kHeadLine + "add p 0 0 1 0 0 1 1 1 0 0 1\n", "bad.trace:2: cell (0, 0): the polygon has no area"},
      {kHeadLine + kSquareLine + "add q 0 0 1 0 0 1 0 1 1\n", "bad.trace:3: cell (0, 0): its interior overlaps 'p'"},
  });
}

TEST(Trace, BytesThatAreNoTextAreRefused) {
  expectFaults({
      {"\xef\xbb\xbf" + kHeadLine + "move p\n", "bad.trace:2: unknown word"},
      {kHeadLine + "add p\0 0 0 1 0 0 1 0 1 1\n"s, "bad.trace:2: byte 0x00 in the line: a trace is plain text"},
      {"\x7f\x45LF\x02\x01", "bad.trace:1: byte 0x7f in the line"},
      {kHeadLine + "# \x1b[31m\n", "bad.trace:2: byte 0x1b in the line"},
      {kHeadLine + "com\rmit\n", "bad.trace:2: byte 0x0d in the line"},
      {kHeadLine + std::string(2'000'000, 'x'), "bad.trace:2: the line is longer than 1048576 bytes"},
      {kHeadLine + std::string(2'000, 'x'), "bad.trace:2: unknown word 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx…'"},
  });
}

TEST(Trace, FilesThatCanNotBeRead) {
  const auto fault = [](const std::string& path) { return message(test::refusal(readTrace(path)), "f"); };
  EXPECT_EQ(fault("no/such/file.trace"), "f: cannot open the file: No such file or directory");
  EXPECT_EQ(fault(std::filesystem::temp_directory_path().string()), "f: cannot read the file: Is a directory");
  EXPECT_FALSE(writeFile("no/such/folder/file", "x"));
}

TEST(Player, KeepsSceneAndWorldAlike) {
  const Trace trace = mustParse(
      "lgs-trace 1\nadd a 0 0 1  0 0 1 0 1 1 0 1\nadd b 1 0 2  0 0 1 0 1 1 0 1\ncommit\nremove a\nadd a 5 5 3 0 0 1 0 "
      "1 1\n");
  Player player(trace.preserve);
  std::vector<std::size_t> segments;
  ASSERT_TRUE(play(trace, player, [&](Player& p, const Changes&) {
    segments.push_back(outlineOf(p.world()).size());
    return true;
  }));
  EXPECT_EQ(segments, (std::vector<std::size_t>{6, 7}));  // the end of the trace commits
  ASSERT_EQ(player.scene().polygons.size(), 2U);
  EXPECT_EQ(player.scene().polygons[0].block, 2U);
  EXPECT_EQ(player.scene().polygons[1].cell, (Cell{5, 5}));
  EXPECT_TRUE(player.isAlive("a"));
}

TEST(Dump, IsSortedByNumbersAndMarksMissingGhosts) {
  const Outline outline{{{-65'536, 0}, {0, 0}, 1, Point{-65'536, 65'536}, Point{0, 65'536}},
                        {{-9, 0}, {0, 0}, 10, {}, Point{1, -2}},
                        {{0, 0}, {2, 2}, 9, Point{7, 7}, {}}};
  EXPECT_EQ(dump(outline),
            "segment -65536 0 0 0 -65536 65536 0 65536 1\n"
            "segment -9 0 0 0 - - 1 -2 10\n"
            "segment 0 0 2 2 7 7 - - 9\n");

  const Trace trace = mustParse("lgs-trace 1\nadd a -1 0 1  0 0 1 0 1 1 0 1\n");
  Player player(trace.preserve);
  ASSERT_TRUE(play(trace, player));
  EXPECT_EQ(dump(outlineOf(player.world())),
            "segment -65536 0 0 0 -65536 65536 0 65536 1\n"
            "segment -65536 65536 -65536 0 0 65536 0 0 1\n"
            "segment 0 0 0 65536 -65536 0 -65536 65536 1\n"
            "segment 0 65536 -65536 65536 0 0 -65536 0 1\n");
}

}  // namespace
}  // namespace lgs::oracle
