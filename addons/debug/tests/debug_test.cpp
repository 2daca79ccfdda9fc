// What LocalGridSeg::debug writes: a trace that makes the same world, and a picture with all that it should show.
#include "oracle/trace/player.h"
#include "oracle/trace/trace.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lgs/debug.h>
#include <pugixml.hpp>

#include <iterator>

namespace lgs::test {
namespace {

using testing::HasSubstr;

LGS_LAW(Debug, ATraceMakesTheSameWorld, 300, (const GoodTrace& trace)) {
  oracle::Player player(trace.preserve), again(trace.preserve);
  playAll(trace, player);
  const std::string text = writeTrace(player.world());
  const oracle::ParsedTrace parsed = oracle::parseTrace(text);
  ASSERT_FALSE(parsed.error) << message(*parsed.error, "written") << "\n" << text;
  playAll(parsed.trace, again);
  EXPECT_TRUE(samePolygons(player.world(), again.world())) << text;
  EXPECT_EQ(writeTrace(again.world()), text);
}

TEST(Debug, ATraceHasThePreserveLinesOfItsBlocks) {
  World world([](Block a, Block b) { return a + b == 5; });
  ASSERT_TRUE(world.add({0, 1}, {{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell / 2}}, 2));
  ASSERT_TRUE(world.add({-1, 0}, {{0, 0}, {1, 0}, {kUnitsPerCell * 3 / 4, 2}}, 3));
  ASSERT_TRUE(world.add({-2, 0}, {{0, 0}, {1, 0}, {1, 1}}, 4));
  EXPECT_EQ(writeTrace(world),
            "lgs-trace 1\n"
            "preserve 2 3\n"
            "add p1 -2 0 4  0 0 1/65536 0 1/65536 1/65536\n"
            "add p2 -1 0 3  0 0 1/65536 0 3/4 1/32768\n"
            "add p3 0 1 2  0 0 1 0 1 1/2\n");
}

LGS_LAW(Debug, APictureShowsEveryPolygonAndSegment, 100, (const GoodTrace& trace)) {
  oracle::Player player(trace.preserve);
  playAll(trace, player);
  pugi::xml_document picture;
  ASSERT_TRUE(picture.load_string(writeSvg(player.world()).c_str()));
  const auto count = [](pugi::xml_node node, const char* name) {
    const auto found = node.children(name);
    return static_cast<std::uint64_t>(std::distance(found.begin(), found.end()));
  };
  const pugi::xml_node svg = picture.child("svg");
  EXPECT_EQ(count(svg, "polygon"), player.world().stats().polygons);
  EXPECT_EQ(count(svg.child("g"), "path"), player.world().stats().segments);
}

TEST(Debug, APictureHasItsOriginAtTheUpperLeft) {
  World world;
  ASSERT_TRUE(world.add({-3, 7}, kUnitSquare, 0));
  world.commit();
  const std::string svg = writeSvg(world);
  EXPECT_THAT(svg, HasSubstr("viewBox=\"-8 -8 80 80\""));
  EXPECT_THAT(svg, HasSubstr("points=\"0.000,64.000 64.000,64.000 64.000,0.000 0.000,0.000 \""));
  EXPECT_THAT(svg, HasSubstr("M32.000,64.000 32.000,69.333\"")) << "a normal that points down\n" << svg;
}

TEST(Debug, APictureShowsTheSegmentsOfWhatWasRemovedSinceTheCommit) {
  World world;
  ASSERT_TRUE(world.add({1'000, 1'000}, kUnitSquare, 0));
  world.commit();
  ASSERT_TRUE(world.clear(Cell{1'000, 1'000}));
  EXPECT_THAT(writeSvg(world), HasSubstr("M32.000,64.000 32.000,69.333\"")) << "on the page";
  ASSERT_TRUE(world.add({1'001, 1'002}, kUnitSquare, 0));
  EXPECT_THAT(writeSvg(world), HasSubstr("viewBox=\"-8 -8 144 208\""));
}

TEST(Debug, WhatIsLaidOverHasItsScale) {
  const auto with = [](double cellsPerUnit) {
    return writeSvg(World(), {.over = "<g/>", .cellsPerUnit = cellsPerUnit});
  };
  EXPECT_THAT(with(1), HasSubstr("matrix(64.000000000,0,0,-64.000000000,"));
  EXPECT_THAT(with(1e-6), HasSubstr("matrix(0.000064000,0,0,-0.000064000,"));
  EXPECT_THAT(with(1e6), HasSubstr("matrix(64000000.000000000,0,0,-64000000.000000000,"));
  for (const double none : {0.0, -1.0, 1e-7, 2e6}) EXPECT_THAT(with(none), testing::Not(HasSubstr("matrix(")));
}

}  // namespace
}  // namespace lgs::test
