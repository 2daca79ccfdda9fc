// Engines that tell what changed: a copy follows them, ids are used rightly, and nothing is told that did not change.
#include "oracle/engine/delta.h"
#include "oracle/tests/engines/workbench.h"

namespace lgs::oracle {
namespace {

OutlineSegment segment(std::int64_t x) { return {{x, 0}, {x + 1, 0}, 1, {}, {}}; }

TEST(Delta, KeepsACopy) {
  Delta delta;
  delta.take({{'+', "a", segment(5)}, {'+', "b", segment(3)}});
  EXPECT_EQ(delta.outline(), (Outline{segment(3), segment(5)}));
  delta.take({{'-', "a"}, {'~', "b", segment(4)}, {'+', "c", segment(1)}});
  EXPECT_EQ(delta.outline(), (Outline{segment(1), segment(4)}));
  delta.take({{'+', "a", segment(5)}});  // an id is free again in the commit after
  EXPECT_EQ(delta.wrongId(), "");
  EXPECT_TRUE(delta.unchanged().empty() && delta.remade().empty());
  delta.clear();
  EXPECT_TRUE(delta.outline().empty());
}

TEST(Delta, SaysWhichIdIsWrong) {
  const auto wrong = [](const SegmentChanges& changes) {
    Delta delta;
    delta.take({{'+', "a", segment(5)}, {'+', "b", segment(6)}});
    delta.take(changes);
    return delta.wrongId();
  };
  EXPECT_EQ(wrong({{'+', "a", segment(7)}}), "'+ a': this id is taken");
  EXPECT_EQ(wrong({{'-', "c"}}), "'- c': there is no such id");
  EXPECT_EQ(wrong({{'~', "c", segment(7)}}), "'~ c': there is no such id");
  const std::string twice = "': a line before this one has the same id";
  EXPECT_EQ(wrong({{'-', "a"}, {'-', "a"}}), "'- a" + twice);
  EXPECT_EQ(wrong({{'-', "a"}, {'+', "a", segment(7)}}), "'+ a" + twice);
  EXPECT_EQ(wrong({{'~', "a", segment(7)}, {'~', "a", segment(8)}}), "'~ a" + twice);
  EXPECT_EQ(wrong({{'-', "d"}, {'-', "c"}}), "'- d': there is no such id") << "the first";
  EXPECT_LE(wrong({{'-', std::string(1'000'000, 'd')}}).size(), 200U);
}

TEST(Delta, KnowsWhatDidNotChange) {
  Delta delta;
  delta.take({{'+', "a", segment(5)}, {'+', "b", segment(6)}});
  delta.take({{'~', "a", segment(5)}});
  EXPECT_EQ(delta.unchanged(), (Outline{segment(5)}));
  delta.take({{'+', "c", segment(6)}, {'-', "b"}});
  EXPECT_EQ(delta.remade(), (Outline{segment(6)})) << "in whatever order";
  EXPECT_TRUE(delta.unchanged().empty());
  delta.take({});
  EXPECT_TRUE(delta.remade().empty());
}

}  // namespace
}  // namespace lgs::oracle

namespace lgs::test {
namespace {

class Incremental : public Workbench {
 protected:
  void expectFound(const std::string& piece, const std::string& instead, const std::string& part, std::size_t most,
                   const std::string& told = "") const {
    const Outcome outcome = check(exampleWith("incremental.py", {{piece, instead}}), "--edits 2000 --shrink 60");
    EXPECT_EQ(outcome.status, 1) << outcome.text;
    EXPECT_NE(outcome.text.find(part), std::string::npos) << part << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(told), std::string::npos) << outcome.text;
    EXPECT_LE(editsOfMismatch(), most) << outcome.text;
  }
};

TEST_F(Incremental, AGoodOneIsFine) {
  const Outcome outcome = check(exampleWith("incremental.py", {}), "--edits 2000");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("segments, ghosts, blocks and lists of changes are compared"), std::string::npos);
}

// The copy is compared: a change that is not told is an outline that differs.
TEST_F(Incremental, ForgetsToTell) {
  expectFound("for x in range(-1, 3) for y in range(-1, 3)}", "for x in range(0, 2) for y in range(0, 2)}",
              "wrong ghost", 2, "\nin this commit the engine reported ");
}

TEST_F(Incremental, UsesAnIdTwice) {
  expectFound("changes = list(update(cells, edited, told))", "changes = 2 * list(update(cells, edited, told))",
              "': a line before this one has the same id", 1, "\nin this commit the engine reported 8 changes:\n  + ");
}

TEST_F(Incremental, RemovesWhatIsNotThere) {
  expectFound("told[at, way] = new", "old = old if told.setdefault((at, way), new) else new", "there is no such id", 3);
}

TEST_F(Incremental, TellsOfWhatDidNotChange) {
  expectFound("if new == old:", "if new == old and not (new and edited):",
              "the change list reports what did not change:\nchanged, but is as it was: (", 2);
}

TEST_F(Incremental, RemovesAndAddsWhatIsAsItWas) {
  expectFound("            if new == old:\n                continue\n            told[at, way] = new",
              "            if new == old and not new:\n                continue\n"
              "            told[at, way] = new\n            if old == new:\n"
              "                told[at, way] = new + ' '\n                yield f\"- {name}\"\n"
              "                name, old = f\"{name},{len(told)},{id(edited)}\", None",
              "removed and added, but is as it was: (", 2);
}

}  // namespace
}  // namespace lgs::test
