// `lgs ride` as a user meets it.
#include "proptests/support/command.h"

#include <cstdio>

namespace {

using lgs::test::Outcome;

Outcome ride(const std::string& arguments) {
  return lgs::test::outcomeOf("'" LGS_COMMAND "' ride " + arguments + " 2>&1");
}

const std::string kTrace = "'" LGS_SOURCE_DIR "/docs/ride.trace' ";

TEST(RideCommand, TheTerrainDoesNotKickAndPolygonsDo) {
  const Outcome outcome = ride(kTrace + "--coast --speed 2 --size 0.6");
  EXPECT_EQ(outcome.status, 0);
  const auto kicksOf = [&](const std::string& way) {
    const std::size_t at = outcome.text.find("\n" + way + "  ");
    if (at == std::string::npos) return -1;
    double length = 0;
    int kicks = -1;
    (void)std::sscanf(outcome.text.c_str() + at + 1 + way.size(), "%lf %d", &length, &kicks);  // NOLINT
    return kicks;
  };
  EXPECT_EQ(kicksOf("terrain"), 0) << outcome.text;
  EXPECT_EQ(kicksOf("terrain, merged"), 0);
  EXPECT_EQ(kicksOf("CGAL chains"), 0);
  EXPECT_GT(kicksOf("edges without ghosts"), 5);
  EXPECT_GT(kicksOf("polygons"), 5);
}

TEST(RideCommand, DrawsAPicture) {
  const Outcome outcome = ride(kTrace + "--rider box --upright --steps 200 --svg -");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.text.rfind("<svg", 0), 0U);
  EXPECT_NE(outcome.text.find("</svg>"), std::string::npos);
}

TEST(RideCommand, SaysWhatIsWrong) {
  EXPECT_EQ(ride("missing.trace").status, 2);
  EXPECT_EQ(ride(kTrace + "--rider bus").status, 2);
  EXPECT_EQ(ride(kTrace + "--size 0").status, 2);
  const Outcome empty = ride("/dev/null");
  EXPECT_EQ(empty.status, 2);
  EXPECT_EQ(ride("--help").status, 0);
}

}  // namespace
