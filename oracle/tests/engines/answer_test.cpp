// The answers of engines as text.
#include "oracle/engine/answer.h"
#include "oracle/trace/coordinate.h"

#include <gtest/gtest.h>

namespace lgs::oracle {
namespace {

TEST(Answers, AreReadLineByLine) {
  AnswerReader reader(Capabilities::all());
  EXPECT_EQ(reader.take("refused p1 it is bad").value(), false);
  EXPECT_EQ(reader.take("segment 0 -65536 65536 -65536 - - 1 2 4294967295").value(), false);
  EXPECT_EQ(reader.take("segment 1 2 3 4 5 6 - - 0").value(), false);
  EXPECT_EQ(reader.take("end").value(), true);
  ASSERT_EQ(reader.refused.size(), 1U);
  EXPECT_EQ(reader.refused[0].name, "p1");
  EXPECT_EQ(reader.refused[0].reason, "it is bad");
  const Outline expected{{{0, -65'536}, {65'536, -65'536}, 4'294'967'295, {}, Point{1, 2}},
                         {{1, 2}, {3, 4}, 0, Point{5, 6}, {}}};
  EXPECT_EQ(reader.outline, expected);
}

TEST(Answers, IslandsAreReadIfTheyArePromised) {
  Capabilities can = Capabilities::all();
  EXPECT_FALSE(AnswerReader(can).take("island 0 0 8"));
  can.islands = true;
  AnswerReader reader(can);
  EXPECT_EQ(reader.take("island -5 65536 8589934592").value(), false);
  EXPECT_EQ(reader.islands, (NamedIslands{{{-5, 65'536}, 8'589'934'592}}));
  for (const std::string line : {"island", "island 0 0", "island 0 0 8 ", "island 0 0 8 8", "island 0 x 8",
                                 "island 0 0 99999999999999999999", "refused p1 too late"})
    EXPECT_FALSE(reader.take(line)) << line;
}

TEST(Answers, ChangesAreReadIfTheyArePromised) {
  Capabilities can = Capabilities::all();
  EXPECT_FALSE(AnswerReader(can).take("- 7"));
  EXPECT_FALSE(AnswerReader(can).take("time 5"));
  can.delta = can.time = true;
  AnswerReader reader(can);
  for (const std::string line : {"- 7", "+ a,b segment 1 2 3 4 5 6 - - 9", "~ 8 segment 1 2 3 4 - - - - 0", "time 12"})
    EXPECT_EQ(reader.take(line).value(), false) << line;
  ASSERT_EQ(reader.changes.size(), 3U);
  EXPECT_EQ(reader.changes[0].id, "7");
  EXPECT_EQ(reader.changes[1].sign, '+');
  EXPECT_EQ(reader.changes[1].id, "a,b");
  EXPECT_EQ(reader.changes[1].segment, (OutlineSegment{{1, 2}, {3, 4}, 9, Point{5, 6}, {}}));
  EXPECT_EQ(reader.changes[2].sign, '~');
  EXPECT_EQ(reader.time, std::chrono::nanoseconds(12));
  for (const std::string line : {"-", "- ", "- 7 8", "+ 7", "+ segment 1 2 3 4 5 6 - - 9", "+ 7 1 2 3 4 5 6 - - 9",
                                 "~ 8 segment 1 2 3 4 - - - -", "* 7", "segment 1 2 3 4 - - - - 0",
                                 "refused p1 too late", "time 13", "+ 7 segment 99999999999999 2 3 4 - - - - 9"})
    EXPECT_FALSE(reader.take(line)) << line;
  EXPECT_FALSE(AnswerReader(can).take("time -1"));
  EXPECT_FALSE(AnswerReader(can).take("time 1.5"));
}

// What it does not declare means nothing, so it is no change that it should have told, and none that it should not have.
TEST(Answers, WhatIsNotDeclaredIsForgotten) {
  Capabilities can;
  can.delta = true;
  AnswerReader reader(can);
  ASSERT_TRUE(reader.take("+ a segment 1 2 3 4 5 6 7 8 9"));
  EXPECT_EQ(reader.changes[0].segment, (OutlineSegment{{1, 2}, {3, 4}, 0, {}, {}}));
}

TEST(Answers, AreShortenedToBePrinted) {
  EXPECT_EQ(shortened("a\x1b[31m\nb\x7f"), "a?[31m?b?");
  EXPECT_EQ(shortened(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(shortened(std::string(1'000'000, 'x')), std::string(80, 'x') + "…");
  EXPECT_EQ(shortened(std::string(79, 'x') + "…"), std::string(79, 'x') + "…") << "no half of a character";
  EXPECT_EQ(parseHello("lgs-engine 1 " + std::string(1'000, 'x'))->name, shortened(std::string(1'000, 'x')));
  EXPECT_LE(parseHello("lgs-engine 1 x " + std::string(1'000, 'y')).error().size(), 400U);
}

TEST(Answers, WrongLinesAreTold) {
  for (const std::string line :
       {"", " ", "End", "end ", "segment", "segment 0 0 1 1 - - - -", "segment 0 0 1 1 - - - - 1 ",
        "segment 0 0 1 1 - - - - x", "segment 0 0 1 1 - - - - -1", "segment  0 0 1 1 - - - - 1",
        "segment 0 0 1 1 - 1 - - 1", "segment 0 0 1.5 1 - - - - 1", "segment 0 0 99999999999999999 1 - - - - 1",
        "segment 0 0 99999999999999 1 - - - - 1", "segment 0 0 1 1 - - - - 1\r", "refused", "refused p1", "refused p1 ",
        "commit"}) {
    AnswerReader reader(Capabilities::all());
    EXPECT_FALSE(reader.take(line)) << line;
  }
  AnswerReader late(Capabilities::all());
  EXPECT_TRUE(late.take("segment 0 0 1 1 - - - - 1"));
  EXPECT_FALSE(late.take("refused p1 too late"));
  AnswerReader without(Capabilities{});
  EXPECT_TRUE(without.take("segment 0 0 1 1 - - - - -")) << "without blocks any word is good";
  EXPECT_FALSE(without.take("segment 0 0 1 1 - - - -")) << "but there is one";
  EXPECT_FALSE(without.take("segment 0 0 1 1 - - - - "));
  EXPECT_FALSE(without.take("segment 0 0 1 1 - - - - 1 2"));
  const std::string far = "segment 0 0 1 1 99999999999999 0 - - 1";
  EXPECT_TRUE(without.take(far)) << "ghosts are not compared";
  EXPECT_FALSE(AnswerReader(Capabilities::all()).take(far));
}

TEST(Answers, AnEngineGreets) {
  EXPECT_EQ(parseHello("lgs-engine 1 mine ghosts lattice=8").value().name, "mine");
  EXPECT_EQ(parseHello("lgs-engine 1 mine ghosts lattice=8").value().can.lattice, 8);
  EXPECT_TRUE(parseHello("lgs-engine 1 mine"));
  for (const std::string line :
       {"", "lgs-engine", "lgs-engine 1", "lgs-engine 2 mine", "lgs-engine 1 mine flies", "hello"})
    EXPECT_FALSE(parseHello(line)) << line;
}

TEST(Answers, DecimalsAreExact) {
  const auto text = [](std::int32_t units) {
    std::string decimal;
    printDecimal(units, decimal);
    return decimal;
  };
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(32'768), "0.5");
  EXPECT_EQ(text(65'536), "1");
  EXPECT_EQ(text(21'845), "0.3333282470703125");
  EXPECT_EQ(text(-1), "-0.0000152587890625");
  EXPECT_EQ(text(-65'536 * 3 - 16'384), "-3.25");
  for (std::int32_t units = -70'000; units < 140'000; units += 7)
    EXPECT_EQ(parseCoordinate(text(units)).value(), units);
}

}  // namespace
}  // namespace lgs::oracle
