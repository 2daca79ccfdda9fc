// Outlines as people draw them: they touch or cross themselves, go there and back, or repeat a vertex. And the shapes
// that are left out, with the reason in words.
#include "addons/tiled/src/collision_object.h"
#include "maps.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lgs::tiled {
namespace {

std::string polygon(const std::string& points) { return "<object id='1'><polygon points='" + points + "'/></object>"; }

/// The notes of an object that is alone in its tile, as "kind: text" with the number of the NoteKind.
std::vector<std::string> kindsAndTexts(const ImportedMap& map) {
  std::vector<std::string> result;
  for (const Note& note : map.report.tiles.at(0).notes) {
    result.push_back(std::to_string(static_cast<int>(note.kind)) + ": " + note.text);
  }
  return result;
}

TEST(TiledOutlines, ThatTouchThemselvesInAVertexFallApart) {
  struct Case {
    const char* points;
    Rings rings;
  };
  const Ring lower = px({{0, 0}, {32, 0}, {16, 16}}), upper = px({{0, 32}, {16, 16}, {32, 32}});
  const std::vector<Case> cases = {
      {"0,32 32,32 16,16 32,0 0,0 16,16", {lower, upper}},              // an hourglass, drawn along its outline
      {"0,32 16,16 0,0 32,0 16,16 32,32", {lower, upper}},              // clockwise
      {"16,16 0,32 32,32 16,16 32,0 0,0", {lower, upper}},              // begins in the waist
      {"0,32 32,32 16,16 16,16 32,0 0,0 16,16", {lower, upper}},        // names the waist twice in a row
      {"0,32 32,32 16,16 20,16 16,16 32,0 0,0 16,16", {lower, upper}},  // with a spike there
  };
  for (const Case& c : cases) {
    const auto map = importTile(polygon(c.points));
    Rings rings = ringsIn(map, {0, -1});
    std::sort(rings.begin(), rings.end());
    EXPECT_EQ(rings, c.rings) << c.points;
    EXPECT_TRUE(kindsAndTexts(map).empty()) << c.points;
  }
}

/// What a ring, "x,y x,y …", goes around an odd number of times, in square pixels: the sum of thin stripes.
double oddArea(const std::string& points) {
  std::vector<DoublePoint> ring;
  std::istringstream words(points);
  for (DoublePoint p; words >> p.x && words.ignore() && words >> p.y;) ring.push_back(p);
  constexpr int kStripes = 4'096;
  double area = 0;
  for (int k = 0; k < kStripes; ++k) {
    const double y = 32 * (k + 0.5) / kStripes;
    std::vector<double> crossings;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const DoublePoint a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      area += (crossings[i + 1] - crossings[i]) * 32 / kStripes;
    }
  }
  return area;
}

TEST(TiledOutlines, ThatCrossOrTouchThemselvesAreFilledAsTiledFillsThem) {
  for (const char* points : {
           "0,32 32,32 32,8 20,8 0,12 20,4 32,0",             // an edge through another
           "4,4 28,4 28,28 16,4 4,28",                        // a vertex on an edge, from inside
           "0,32 32,32 32,0 16,32 0,0",                       // a vertex on the lower edge
           "0,8 0,0 32,0 32,32 16,32 16,0 8,0 8,8",           // an edge along another, the same way
           "0,0 32,32 32,0 0,16",                             // a bow tie
           "0,0 32,32 32,0 0,32",                             // a bow tie with equal halves: its area is 0
           "16,16 32,16 32,32 16,16 16,0 0,16 0,0",           // such a bow tie at the corner of a triangle
           "0,32 32,32 16,12 0,0 32,0 16,12",                 // an hourglass, half of it turned over
           "16,16 8,8 24,8 16,16 4,0 28,0",                   // a triangle in a triangle, with a common tip
           "16,16 24,8 8,8 16,16 4,0 28,0",                   // the same, as a hole
           "16,16 0,0 20,0 16,16 12,0 32,0",                  // two triangles that overlap, with a common tip
           "16,16 0,0 20,0 16,16 12,0 32,0 16,16 14,0 18,0",  // three
       }) {
    const auto map = importTile(polygon(points));
    EXPECT_NEAR(areaInCells(map) * 1024, oddArea(points), 0.1) << points;
    EXPECT_TRUE(kindsAndTexts(map).empty()) << points;
  }
}

TEST(TiledOutlines, ThatAreTangledAreLeftOut) {
  const auto star = [](int vertices) {  // each edge crosses nearly all others
    std::string points;
    for (int k = 0; k < vertices; ++k) {
      const double angle = 3.14159265358979 * k * (vertices - 1) / vertices;
      points += std::to_string(16 + 14 * std::cos(angle)) + "," + std::to_string(16 + 14 * std::sin(angle)) + " ";
    }
    return polygon(points);
  };
  for (const auto& map : bothWays(star(21))) {
    EXPECT_FALSE(map.placements.empty());
    EXPECT_TRUE(noteTexts(map).empty());
  }
  const auto many = importFiles({{"maps/test.tmx", mapXml(objectLayer(star(45)))}});
  ASSERT_TRUE(many);  // 945 crossings
  EXPECT_THAT(noteTexts(*many), ElementsAre("a cell holds as many polygons or vertices as it can"));
  for (const int vertices : {49, 1'023}) {
    for (const auto& map : bothWays(star(vertices))) {
      EXPECT_TRUE(map.placements.empty());
      EXPECT_THAT(noteTexts(map), ElementsAre("its outline crosses itself more than 1024 times"));
    }
  }
}

TEST(TiledOutlines, WithoutAreaAreLeftOut) {
  for (const char* points : {"4,4 28,4 4,4", "4,4 4,4 4,4 4,4", "4,4 16,16 28,28", "4,4 28,4 28,20 28,4"}) {
    const auto map = importTile(polygon(points));
    EXPECT_TRUE(map.placements.empty()) << points;
    EXPECT_EQ(kindsAndTexts(map).at(0), "0: it has no area once it is on the grid") << points;
  }
}

TEST(TiledOutlines, OfWhatHasNone) {
  CollisionObject object;
  object.kind = CollisionObject::Kind::unsupported;
  object.size = {32, 32};
  const auto same = [](DoublePoint p) { return p; };
  EXPECT_TRUE(outlines(object, same).empty());
  object.kind = CollisionObject::Kind::rectangle;
  EXPECT_EQ(outlines(object, same).at(0).size(), 4U);
}

TEST(TiledOutlines, WhatIsLeftOutAndWhy) {
  const auto reason = [](const std::string& object) {
    const auto map = importTile(object);
    EXPECT_TRUE(map.placements.empty()) << object;
    const std::vector<std::string> notes = kindsAndTexts(map);
    EXPECT_EQ(notes.size(), 1U) << object;
    return notes.at(0);
  };
  const auto vertices = [](int count) {  // a comb that fills the tile
    std::string points = "0,32 32,32";
    for (int k = 0; k < count - 2; ++k) points += " " + std::to_string(30 - k / 64.0) + (k % 2 == 0 ? ",8" : ",0");
    return polygon(points);
  };
  EXPECT_EQ(importTile(vertices(1024)).shapes.at(0).size(), 1024U);
  EXPECT_EQ(reason(vertices(1025)), "0: the polygon has more than 1024 vertices");
  EXPECT_EQ(reason(polygon("0,0 9,9")), "0: the polygon has fewer than 3 vertices");
  EXPECT_EQ(reason("<object id='1'><polyline points='0,0 9,9 9,0'/></object>"),
            "0: an open polyline has no area: close it, or --polyline-thickness PIXELS makes it thick");
  EXPECT_EQ(reason("<object id='1'><point/></object>"), "0: a point has no area");
  EXPECT_EQ(reason("<object id='1' width='9' height='9'><text/></object>"), "0: a text is no shape");
  EXPECT_EQ(reason("<object id='1' template='a.tx'/>"),
            "0: its template maps/a.tx: cannot be read: there is no such file");
  EXPECT_EQ(reason("<object id='1' gid='4'/>"), "0: it is a tile object: draw a shape instead");
  const std::string flat = "0: it has no area: its width or height is 0";
  EXPECT_EQ(reason("<object id='1' width='9'/>"), flat);
  EXPECT_EQ(reason("<object id='1' height='9'/>"), flat);
  EXPECT_EQ(reason("<object id='1' width='9' height='-9'><ellipse/></object>"), flat);
  const std::string far = "0: it reaches more than 64 cells out of its cell";
  EXPECT_EQ(reason("<object id='1' x='2040' width='8.125' height='9'/>"), far);
  EXPECT_EQ(reason("<object id='1' y='2070' width='9' height='10.125'/>"), far);  // from the lower edge, y = 32
  EXPECT_EQ(importTile("<object id='1' x='2040' width='8' height='9'/>").placements.size(), 1U);
  EXPECT_EQ(importTile("<object id='1' y='2070' width='9' height='10'/>").placements.size(), 1U);
}

}  // namespace
}  // namespace lgs::tiled
