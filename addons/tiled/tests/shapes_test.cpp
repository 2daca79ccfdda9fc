// Hand-drawn shapes on their way to the lattice: they are snapped, cut, carried, freed of overlaps, or left out.
#include "maps.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace lgs::tiled {
namespace {

/// A map of tiles of 128×128 pixels. Tile 1 is a full square, tile 2 a slope that misses its three corners a little.
std::string slopeMap() {
  return "<map tilewidth='128' tileheight='128' width='4' height='2'><tileset firstgid='1' tilewidth='128' "
         "tileheight='128'>"
         "<tile id='0'><objectgroup><object id='1' width='128' height='128'/></objectgroup></tile>"
         "<tile id='1'><objectgroup><object id='3' x='0.4' y='127.2'>"
         "<polygon points='0,0 127.98,-127.35 127.3,0.38'/></object></objectgroup></tile></tileset>" +
         csvLayer(4, 2, "0,0,2,1,1,1,1,1") + "</map>";
}

TEST(TiledSnapping, SlopesJoinTheFlatGroundWithoutAStep) {
  const auto map = mustImportFiles({{"maps/test.tmx", slopeMap()}});
  const auto loops = worldOf(map).loops(Collinear::merge);
  ASSERT_EQ(loops.size(), 1U);
  constexpr std::int64_t k = kUnitsPerCell;
  EXPECT_EQ(loops[0].vertices,
            (std::vector<Point>{{0, -2 * k}, {4 * k, -2 * k}, {4 * k, 0}, {3 * k, 0}, {2 * k, -k}, {0, -k}}));
  ASSERT_EQ(map.report.tiles[0].notes.size(), 1U);
  EXPECT_EQ(map.report.tiles[0].notes[0].kind, NoteKind::snapped);
  EXPECT_NEAR(map.report.tiles[0].notes[0].pixels, 0.8, 1e-9);
  EXPECT_THAT(toText(map.report), HasSubstr("6 coordinates put on the grid, by up to 0.8 px"));

  const Options strict{.tolerance = 0.5};  // the foot of the slope is 0.8 px too high and stays there
  const auto steps = mustImportFiles({{"maps/test.tmx", slopeMap()}}, strict);
  EXPECT_GT(worldOf(steps).loops(Collinear::merge).at(0).vertices.size(), 6U);
  EXPECT_THAT(noteKinds(steps), ElementsAre(NoteKind::snapped, NoteKind::nearMiss));
}

TEST(TiledSnapping, AVertexNearACornerIsNotedUpToA32thOfATile) {
  const auto imported = [](const std::string& miss) {
    const Options options{.tolerance = 0.75};  // pixels, of 32
    return importTile("<object id='1'><polygon points='0,32 32,32 32," + miss + "'/></object>", options);
  };
  const auto kindsOf = [&](const std::string& miss) { return noteKinds(imported(miss)); };
  EXPECT_EQ(imported("0.83").report.tiles.at(0).notes.at(0).text,
            "a vertex misses a corner by 0.83 px: a tolerance of 0.9 px would join it");
  EXPECT_THAT(kindsOf("0.74"), ElementsAre(NoteKind::snapped));
  EXPECT_THAT(kindsOf("0.76"), ElementsAre(NoteKind::nearMiss));
  EXPECT_THAT(kindsOf("1"), ElementsAre(NoteKind::nearMiss));
  EXPECT_EQ(kindsOf("1.02"), std::vector<NoteKind>());
}

TEST(TiledSnapping, OnlyWithinTheTolerance) {
  const std::string objects = "<object id='1' x='2.5' y='-1' width='29' height='20'/>";
  EXPECT_EQ(ringsIn(importTile(objects), {0, -1}), (Rings{pxBox(2.5, 13, 32, 32)}));
  Options options{.tolerance = 3};
  EXPECT_EQ(ringsIn(importTile(objects, options), {0, -1}), (Rings{pxBox(0, 13, 32, 32)}));
  options.tolerance = 1000;  // a quarter of the tile is used
  const auto map = importTile("<object id='1' x='9' y='7' width='15' height='17.5'/>", options);
  EXPECT_EQ(map.report.tolerance, 8);
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(9, 0, 32, 32)}));
}

TEST(TiledReach, IsCarried) {
  const std::string objects = "<object id='1' x='16' y='16' width='32' height='32'/>";
  const auto carried = importTile(objects);
  EXPECT_EQ(cellsOf(carried), (Cells{{0, -2}, {1, -2}, {0, -1}, {1, -1}}));
  EXPECT_DOUBLE_EQ(areaInCells(carried), 1.0);
  EXPECT_EQ(worldOf(carried).loops(Collinear::merge).at(0).vertices.size(), 4U);
  EXPECT_THAT(noteKinds(carried), ElementsAre(NoteKind::carried));
  EXPECT_EQ(carried.report.tiles[0].notes[0].pixels, 16);
}

TEST(TiledReach, AConcavePolygonFallsIntoPieces) {
  // A U on its side: its back lies left of the cell, its two arms inside.
  const auto map =
      importTile("<object id='1'><polygon points='-8,4 24,4 24,8 -4,8 -4,24 16,24 16,28 -8,28'/></object>");
  EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{pxBox(0, 4, 16, 8), pxBox(0, 24, 24, 28)}));
  EXPECT_EQ(ringsIn(map, {-1, -1}).size(), 1U);
  // An arm whose side lies on the grid is cut there, too.
  const auto touching =
      importTile("<object id='1'><polygon points='-8,4 24,4 24,8 0,8 0,24 16,24 16,28 -8,28'/></object>");
  EXPECT_EQ(ringsIn(touching, {0, -1}).size(), 2U);
  EXPECT_DOUBLE_EQ(areaInCells(touching) * 1024, 24 * 4 + 16 * 4 + 8 * 24);
}

TEST(TiledReach, TooFarIsLeftOut) {
  const auto map = importTile("<object id='1' x='0' y='0' width='2200' height='32'/>");
  EXPECT_TRUE(map.placements.empty());
  EXPECT_THAT(map.report.tiles[0].notes.at(0).text, HasSubstr("more than 64 cells"));
}

TEST(TiledOutlines, WindingAndExtraVerticesDoNotMatter) {
  const Ring triangle = px({{0, 0}, {32, 0}, {32, 32}});
  for (const char* points : {"0,32 32,32 32,0", "32,0 32,32 0,32", "0,32 16,32 16,32 32,32 32,0 16,16",
                             "0,32 32,32 32,0 0,32", "0,32 32,32 32,0 32,-9 32,0"}) {
    const auto map = importTile(std::string("<object id='1'><polygon points='") + points + "'/></object>");
    EXPECT_EQ(ringsIn(map, {0, -1}), (Rings{triangle})) << points;
  }
  // Two triangles that meet in a vertex are two polygons.
  const auto pair = importTile("<object id='1'><polygon points='0,0 16,16 32,0 32,32 16,16 0,32'/></object>");
  EXPECT_EQ(pair.placements.size(), 2U);
}

TEST(TiledOverlaps, WhatComesLaterYields) {
  // An L of two overlapping rectangles: the second loses what the first covers.
  const auto corner =
      importTile("<object id='1' x='0' y='16' width='32' height='16'/><object id='2' width='16' height='32'/>");
  EXPECT_EQ(ringsIn(corner, {0, -1}), (Rings{pxBox(0, 0, 32, 16), pxBox(0, 16, 16, 32)}));
  EXPECT_THAT(noteKinds(corner), ElementsAre(NoteKind::trimmed));
  // The same tile on two layers, and a carried part under solid ground: nothing is placed twice.
  const auto twice = mustImport(tilesetXml({kFullTile}) + csvLayer(1, 1, "1") + csvLayer(1, 1, "1"));
  EXPECT_EQ(ringsIn(twice, {0, -1}), (Rings{kSquare}));
  EXPECT_EQ(twice.report.tiles[0].notes.at(0).places, 1U);
  const auto rooted = mustImport(tilesetXml({"<object id='5' x='8' y='0' width='16' height='40'/>", kFullTile}) +
                                 csvLayer(2, 2, "1,1,2,0"));
  EXPECT_EQ(ringsIn(rooted, {0, -2}), (Rings{kSquare}));
  EXPECT_EQ(ringsIn(rooted, {1, -2}), (Rings{pxBox(8, 24, 24, 32)}));
}

// --- Any shapes: what was drawn is solid, everything else is not -----------------------------------------------------

using Outline = std::vector<DoublePoint>;

/// A star around a point. It is simple and may be very pointed.
Outline randomStar(std::mt19937& random) {
  const auto real = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 4096) / 4095;
  };
  const DoublePoint centre{real(-10, 42), real(-10, 42)};
  const unsigned corners = 3 + random() % 8;
  const double start = real(0, 6);
  Outline star;
  for (unsigned i = 0; i < corners; ++i) {
    const double radius = real(2, 40), angle = start + 6.283185307 * (i + real(0, 0.4)) / corners;
    star.push_back({std::round((centre.x + radius * std::cos(angle)) * 8) / 8,
                    std::round((centre.y + radius * std::sin(angle)) * 8) / 8});
  }
  return star;
}

/// 1 inside, 0 outside, -1 too near the outline to tell.
int insideOf(const Outline& ring, DoublePoint p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const DoublePoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const double t = length2 == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0);
    if (std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy) < 0.01) return -1;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * dx / dy) inside = !inside;
  }
  return inside ? 1 : 0;
}

TEST(TiledProperty, CoverageIsTheUnionOfTheObjects) {
  std::mt19937 random(20);
  for (int round = 0; round < 200; ++round) {
    std::vector<Outline> stars;
    std::string objects;
    for (unsigned i = 0; i <= random() % 4; ++i) {
      stars.push_back(randomStar(random));
      objects += "<object id='" + std::to_string(i + 1) + "'><polygon points='";
      for (DoublePoint p : stars.back()) objects += std::to_string(p.x) + "," + std::to_string(p.y) + " ";
      objects += "'/></object>";
    }
    const auto map = importTile(objects, {.tolerance = 0});
    const auto kinds = noteKinds(map);
    ASSERT_EQ(std::count(kinds.begin(), kinds.end(), NoteKind::leftOut), 0) << objects;
    for (int probe = 0; probe < 200; ++probe) {
      const DoublePoint p{static_cast<double>(random() % 8192) / 64 - 48,
                          static_cast<double>(random() % 8192) / 64 - 48};
      int drawn = 0, solid = 0;
      for (const Outline& star : stars) {
        const int in = insideOf(star, p);
        drawn = drawn < 0 || in < 0 ? -1 : drawn | in;
      }
      for (const MapPolygon& placed : map.placements) {
        Outline ring;
        for (LocalPoint v : map.shapes[placed.shape]) {
          const Point w = toWorld(placed.cell, v);
          ring.push_back({static_cast<double>(w.x) / 2048, -static_cast<double>(w.y) / 2048});
        }
        solid |= insideOf(ring, p) == 1;
        if (insideOf(ring, p) < 0) drawn = -1;
      }
      ASSERT_TRUE(drawn < 0 || drawn == solid) << "round " << round << " at " << p.x << ", " << p.y << "\n" << objects;
    }
  }
}

}  // namespace
}  // namespace lgs::tiled
