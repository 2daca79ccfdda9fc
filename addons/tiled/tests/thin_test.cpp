// Snapping never presses a shape together: what is thinner than the tolerance stays as drawn.
#include "maps.h"
#include "proptests/support/law.h"

#include <ostream>

namespace lgs::tiled {
namespace {

const std::string kTakenBack =
    "stays as drawn: snapping by up to 1 px would press sides of it together. A smaller --tolerance may snap the rest";

std::string outline(const std::string& points) { return "<object id='1'><polygon points='" + points + "'/></object>"; }

TEST(TiledThinShapes, AWallOfAPixelStaysAsDrawn) {
  for (const auto& map : bothWays("<object id='1' x='0' y='0' width='1' height='32'/>")) {
    EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 0, 1, 32)}));
    EXPECT_THAT(noteTexts(map), ElementsAre(kTakenBack));
    EXPECT_THAT(toText(map.report), HasSubstr("Worth a look:\n"));
  }
  for (const auto& map : bothWays("<object id='1' x='4' y='0.25' width='27.5' height='0.5'/>")) {
    EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(4, 31.25, 31.5, 31.75)}))
        << "no vertex of it moves, not even at its end";
  }
}

TEST(TiledThinShapes, SoDoesASlantedOne) {
  for (const auto& map : bothWays(outline("0,0 1,0 32,31 32,32 31,32 0,1"))) {
    EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{px({{0, 31}, {31, 0}, {32, 0}, {32, 1}, {1, 32}, {0, 32}})}));
    EXPECT_THAT(noteTexts(map), ElementsAre(kTakenBack));
  }
  for (const auto& map : bothWays(outline("0,0 0.75,0 0.5,32"))) {
    EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{px({{0, 32}, {0.5, 0}, {0.75, 32}})})) << "a wedge";
  }
  for (const auto& map : bothWays(outline("0,10 0,11 32,21 32,20"))) {
    EXPECT_TRUE(noteTexts(map).empty()) << "it does not fall together";
  }
}

TEST(TiledThinShapes, AThinPartOfAThickShapeStays) {
  for (const auto& map : bothWays(outline("0,0 1,0 1,24 32,24 32,32 0,32"))) {
    EXPECT_EQ(areaInCells(map) * 1024, 24 + 8 * 32) << "an arm";
    EXPECT_THAT(noteTexts(map), ElementsAre(kTakenBack));
  }
  for (const auto& map : bothWays(outline("0,0 32,0 32,31.5 20,31.5 20,32 0,32 0,31.5 0,31"))) {
    EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{kSquare})) << "nothing that it has is thin";
  }
}

TEST(TiledThinShapes, WhatIsApartStaysApart) {
  const auto waist = bothWays(outline("-8,0 8,0 0.5,16 8,32 -8,32 -0.5,16"));
  const auto slit = bothWays(outline("-16,0 -0.5,0 -0.5,20 0.5,20 0.5,0 16,0 16,32 -16,32"));
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_NEAR(areaInCells(waist[k]) * 1024, 2 * (16 + 1) * 16 / 2, 1e-3);
    EXPECT_EQ(waist[k].placements.size(), 2U) << "one polygon in each cell: it does not touch itself";
    EXPECT_EQ(areaInCells(slit[k]) * 1024, 32 * 32 - 20);
    for (const auto* map : {&waist[k], &slit[k]}) EXPECT_THAT(toText(map->report), HasSubstr("--tolerance"));
  }
}

TEST(TiledThinShapes, NeighboursMayBecomeOneVertex) {
  for (const char* points : {"0,0 31.5,0 32,0.5 32,32 0,32", "0,0 16,0 16.25,0.5 16.5,0 32,0 32,32 0,32",
                             "0.5,0.25 0,0.5 0,0 0,-0.25 32,0 32,31.5 31.5,32.5 31.5,32 0,32"}) {
    for (const auto& map : bothWays(outline(points))) {
      EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{kSquare})) << points;
    }
  }
}

TEST(TiledThinShapes, ASmallerToleranceSnapsTheRest) {
  for (const auto& map :
       bothWays("<object id='1' x='0.25' y='0.25' width='0.75' height='31.5'/>", {.tolerance = 0.5})) {
    EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 0, 1, 32)}));
    EXPECT_THAT(noteTexts(map), ElementsAre("6 coordinates put on the grid, by up to 0.25 px"));
  }
}

TEST(TiledThinShapes, WhatHasNoAreaAsDrawnIsLeftOut) {
  for (const auto& map : bothWays(outline("0,0 0.5,0 0.25,0"))) {
    EXPECT_TRUE(map.placements.empty());
    EXPECT_EQ(noteTexts(map).front(), "it has no area once it is on the grid");
    EXPECT_THAT(toText(map.report), Not(HasSubstr("--tolerance")));
  }
}

// --- Any bar ---------------------------------------------------------------------------------------------------------

/// A bar in quarters of a pixel, near the corner of four tiles, turned by some degrees.
struct Bar {
  int x = 0, y = 0, length = 1, thickness = 1, rotation = 0;
};

std::string objectOf(const Bar& bar) {
  const auto quarters = [](int n) { return std::to_string(n / 4.0); };
  return "<object id='1' x='" + quarters(bar.x) + "' y='" + quarters(bar.y) + "' width='" + quarters(bar.length) +
         "' height='" + quarters(bar.thickness) + "' rotation='" + std::to_string(bar.rotation) + "'/>";
}

void showValue(const Bar& bar, std::ostream& out) { out << objectOf(bar); }

rc::Gen<Bar> anyBar() {
  const auto turn = rc::gen::weightedOneOf<int>(
      {{2, rc::gen::element(0, 90, 180, 270)}, {1, rc::gen::element(45, 135)}, {1, rc::gen::inRange(0, 360)}});
  const auto drawn = rc::gen::tuple(rc::gen::inRange(-8, 9), rc::gen::inRange(-8, 9), rc::gen::inRange(4, 300),
                                    rc::gen::inRange(1, 12), turn);
  return rc::gen::map(drawn, [](std::tuple<int, int, int, int, int> d) {
    return Bar{std::get<0>(d), std::get<1>(d), std::get<2>(d), std::get<3>(d), std::get<4>(d)};
  });
}

TEST(TiledThinShapes, NoBarIsLostOrFallsApart) {
  const auto law = [](const Bar& bar, int tolerance) {
    for (const auto& map : bothWays(objectOf(bar), {.tolerance = tolerance / 4.0})) {
      EXPECT_GT(areaInCells(map), 0);
      EXPECT_EQ(worldOf(map).loops().size(), 1U);
    }
  };
  test::forAll(300, law, rc::gen::resize(rc::kNominalSize, anyBar()), rc::gen::inRange(0, 17));
}

}  // namespace
}  // namespace lgs::tiled
