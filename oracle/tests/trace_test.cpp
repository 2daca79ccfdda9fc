// The trace and dump formats: what is read, what is refused and how, what is written.
#include "oracle/trace/trace.h"
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
  ASSERT_EQ(trace.edits.size(), 5U);
  EXPECT_EQ(trace.edits[0], Edit::add("a", {{-3, 4}, 4'294'967'295, {{0, 0}, {65'536, 0}, {32'768, 32'768}}}));
  EXPECT_EQ(trace.edits[0].line, 7U);
  EXPECT_EQ(trace.edits[1].name, "b#2");
  EXPECT_EQ(trace.edits[2], Edit::commit());
  EXPECT_EQ(trace.edits[3], Edit::remove("a"));
  EXPECT_EQ(trace.edits[4].line, 11U);
}

TEST(Trace, RoundTrips) {
  const Trace trace = mustParse(
      "lgs-trace 1\npreserve 9 3\nadd a 1073741824 -1073741824 0 0 0 1/3 0 1 1\nadd b 0 0 4 -5 12 0.1 0.2\n"
      "commit\ncommit\nremove a\n");
  const std::string text = printTrace(trace);
  EXPECT_EQ(mustParse(text), trace) << text;
  EXPECT_EQ(printTrace(mustParse(text)), text);
}

// The ways of edits (way.h): the plain ones are not written.
TEST(Trace, SaysHowEditsAreMade) {
  const std::string square = "0 0 1 0 1 1 0 1";
  const std::string text = "lgs-trace 3\nadd by 0 0 1  " + square + " by fill 3 undone\nadd b 1 0 1  " + square +
                           " by fill too\ncommit by 2\nremove by by 7 marked\nremove b by removeMany too\n";
  const Trace trace = mustParse(text);
  ASSERT_EQ(trace.edits.size(), 5U);
  EXPECT_EQ(trace.edits[0].name, "by");
  EXPECT_EQ(trace.edits[0].way, (Way{Door::fill, Detour::undone, false, 3}));
  EXPECT_EQ(trace.edits[1].way, (Way{Door::fill, Detour::none, true, 0}));
  EXPECT_EQ(trace.edits[2].way, (Way{Door::commit, Detour::none, false, 2}));
  EXPECT_EQ(trace.edits[3].way, (Way{Door::remove, Detour::marked, false, 7}));
  EXPECT_EQ(printTrace(trace), text);
  const auto old = "lgs-trace 2\nadd a1xyz 0 0 1  " + square + "\nremove a1xyz\n";
  for (const Edit& edit : mustParse(old).edits) EXPECT_EQ(edit.way, Edit::plainWay(edit.kind));
}

TEST(Rows, AreWhatOneCallMakes) {
  const std::string square = "0 0 1 0 1 1 0 1";
  const Trace trace = mustParse(
      "lgs-trace 3\nadd a 0 0 1 " + square + " by fill\nadd b 1 0 1 " + square + " by fill too\nadd c 3 0 1 " + square +
      " by fill\nadd d 5 0 1 " + square + " by fill too\nremove a by setBlock\nadd a 0 0 2 " + square +
      " by setBlock too\nadd e 7 0 1 " + square + " by many\nadd f 1 0 1 " + square + " by many too\n");
  Player player({});
  Rows rows(trace);
  std::string told;
  while (const auto row = rows.next(player.calls())) {
    const bool isDone = player.apply(*row).has_value();
    told += inWords(*row) + (isDone ? "\n" : row->isTrial ? ", as a trial\n" : ", refused\n");
  }
  EXPECT_EQ(told,
            "fill of 'a' to 'b'\nfill of 'c'\nfill of 'd'\nsetBlock of 'a' to 'a'\n"  // c and d are no rectangle
            "many of 'e' to 'f', as a trial\nmany of 'e'\nmany of 'f', refused\n");   // f overlaps b
  EXPECT_EQ(player.standing()["a"].block, 2U);
}

const std::string kHeadLine = "lgs-trace 1\n";
const std::string kSquareLine = "add p 0 0 1  0 0 1 0 1 1 0 1\n";

TEST(Trace, BadWordsSayFileLineAndReason) {
  expectFaults({
      {"", "bad.trace:1: the trace ends before its first line, 'lgs-trace 1'"},
      {"# nothing\n\n", "bad.trace:2: the trace ends before its first line"},
      {"add p 0 0 1 0 0 1 0 1 1\n", "bad.trace:1: not a trace: the first line must be 'lgs-trace 1', not 'add'"},
      {"lgs-trace\n", "bad.trace:1: the first line must be 'lgs-trace 1'"},
      {"lgs-trace 4\n",
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
      {"lgs-trace 3\nremove p by magic\n", "bad.trace:2: by 'magic': there is no such door or detour"},
      {"lgs-trace 3\ncommit by 4294967296\n", "bad.trace:2: the number of a call '4294967296' is out of range"},
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
