// The engine of examples/engines/naive.py is right. With each of some bugs planted in it, what is found is right and
// small. report_test.cpp has a bug of each kind that a report counts.
#include "oracle/tests/engines/workbench.h"

namespace lgs::test {
namespace {

class PlantedBugs : public Workbench {
 protected:
  /// The finding must have all these parts in its text.
  void expectFound(const std::string& piece, const std::string& instead, const std::vector<std::string>& parts,
                   std::size_t most = 4) const {
    const Outcome outcome = check(naiveWith(piece, instead), "--edits 4000 --shrink 60");
    EXPECT_EQ(outcome.status, 1) << outcome.text;
    for (const std::string& part : parts)
      EXPECT_NE(outcome.text.find(part), std::string::npos) << part << "\n" << outcome.text;
    EXPECT_LE(editsOfMismatch(), most) << outcome.text;
  }
};

TEST_F(PlantedBugs, NoneInTheEngineAsItIs) {
  const Outcome outcome =
      sh("lgs check --engine '" LGS_PYTHON " " LGS_SOURCE_DIR "/examples/engines/naive.py' --edits 2000");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("no mismatch\nedits      2000, "), std::string::npos) << outcome.text;
}

TEST_F(PlantedBugs, EverythingIsPreservedOrNothing) {
  expectFound("frozenset((b, edges[e[::-1]])) in preserve}", "preserve}", {"preserve ", "should have been cancelled"},
              2);
}

TEST_F(PlantedBugs, TheLastSuccessorIsTakenForTheFirst) {
  expectFound("return min((t for", "return max((t for", {"wrong ghost"});
}

TEST_F(PlantedBugs, CornersThatTouchDoNotHoldTogether) {
  expectFound("not points.isdisjoint(f[0])", "len(points & f[0]) > 1",
              {"a view is not that of the world", "extra island: "}, 2);
}

TEST_F(PlantedBugs, AnIslandHasTheAreaOfItsLastPolygon) {
  expectFound("area += other[1]", "pass", {"missing island: westernmost vertex", "extra island: "}, 2);
}

TEST_F(PlantedBugs, AGoodEditIsRefused) {
  expectFound("elif word == \"commit\":",
              "elif word == \"commit\":\n            if len(polygons) == 2: print(\"refused p2 why?\")",
              {"refused, but is good: 'p2': why?"}, 2);
}

// The case before has left something, so the case alone is right, and can not be shrunk.
TEST_F(PlantedBugs, AResetDoesNotForgetEverything) {
  const Outcome outcome = check(naiveWith("elif word == \"reset\":\n            polygons, preserve = {}, set()",
                                          "elif word == \"reset\":\n            polygons = {}"),
                                "--edits 4000 --shrink 60");
  EXPECT_EQ(outcome.status, 1) << outcome.text;
  EXPECT_NE(outcome.text.find("but not again"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("keeps something when it is reset"), std::string::npos) << outcome.text;
}

}  // namespace
}  // namespace lgs::test
