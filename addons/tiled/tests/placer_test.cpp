// Cells as they fill up: which entries are equal, and what is given up if too much meets in one cell.
#include "addons/tiled/src/placer.h"
#include "lattice.h"
#include "maps.h"

#include <lgs/world.h>

namespace lgs::tiled {
namespace {

/// Places rings in a cell, with the blocks 1, 2, …
ImportedMap placed(const std::vector<Polygon>& rings) {
  Budget budget{Options{}};
  Placer placer(budget);
  for (Block block = 1; const Polygon& ring : rings) {
    placer.place({3, -8}, placer.entry({{}, block++, placer.shape(ring), kNoTile}));
  }
  ImportedMap map;
  map.report.layers.emplace_back();
  placer.finish(map);
  return map;
}

TEST(TiledPlacer, EntriesAreToldApartByEveryField) {
  // All combinations of three values, once upwards and once downwards.
  std::vector<Placer::Entry> entries;
  for (std::uint32_t code = 0; code < 243; ++code) {
    entries.push_back({{}, static_cast<Block>(code / 3 % 3), code % 3, code / 9 % 3, code / 27 % 3, code / 81});
  }
  for (const bool down : {false, true}) {
    Budget budget{Options{}};
    Placer placer(budget);
    for (const bool again : {false, true}) {
      for (std::uint32_t k = 0; k < entries.size(); ++k) {
        const std::size_t at = down != again ? entries.size() - 1 - k : k;
        const Placer::EntryId first = static_cast<std::uint32_t>(down ? entries.size() - 1 - at : at);
        EXPECT_EQ(placer.entry(entries[at]), first) << at;
      }
    }
  }
}

TEST(TiledPlacer, TheSameRingIsOneShapeWhereverItBegins) {
  Budget budget{Options{}};
  Placer placer(budget);
  EXPECT_EQ(placer.shape({{0, 0}, {9, 0}, {9, 9}}), 0U);
  EXPECT_EQ(placer.shape({{9, 0}, {9, 9}, {0, 0}}), 0U);
  EXPECT_EQ(placer.shape({{0, 0}, {9, 0}, {9, 8}}), 1U);
}

TEST(TiledPlacer, CellsComeRowByRow) {
  Budget budget{Options{}};
  Placer placer(budget);
  std::map<std::pair<std::int32_t, std::int32_t>, Block> expected;  // by row, then column
  const std::uint32_t shape = placer.shape({{0, 0}, {9, 0}, {9, 9}});
  for (const std::int32_t j : {-40, kMaxCell, -1, 17, 0, -16, -kMaxCell, 16}) {
    for (const std::int32_t i : {3, -kMaxCell, 16, -17, 15, kMaxCell, -16, 0, 2}) {
      const auto block = expected[{j, i}] = static_cast<Block>(expected.size());
      placer.place({i, j}, placer.entry({{}, block, shape, kNoTile}));
    }
  }
  ImportedMap map;
  map.report.layers.emplace_back();
  placer.finish(map);
  ASSERT_EQ(map.placements.size(), expected.size());
  EXPECT_EQ(map.report.cells, expected.size());
  for (auto at = map.placements.begin(); const auto& [place, block] : expected) {
    EXPECT_EQ(at->cell, (Cell{place.second, place.first}));
    EXPECT_EQ(at++->block, block);
  }
}

/// As importTile(), but without a World, which is slow if hundreds of polygons share a cell.
ImportedMap importAlone(const std::string& objects, const Options& options) {
  return test::must(importFiles({{"maps/test.tmx", mapXml(tilesetXml({objects}) + csvLayer(1, 1, "1"))}}, options));
}

TEST(TiledPlacer, WhatIsLeftIsFilledHoweverMuchIsThere) {
  std::string objects;
  const auto add = [&](double x, double y, double width, double height) {
    objects += "<object id='1' x='" + std::to_string(x) + "' y='" + std::to_string(y) + "' width='" +
               std::to_string(width) + "' height='" + std::to_string(height) + "'/>";
  };
  for (int k = 0; k < 11; ++k) add(2, 2 + k, 8, 0.5);
  for (int k = 0; k < 14; ++k) add(11 + k * 0.5, 1.5, 0.25, 29);
  const auto map = importTile(objects + "<object id='7' width='32' height='32'/>", {.tolerance = 0});
  EXPECT_EQ(areaInCells(map), 1);
  EXPECT_THAT(noteKinds(map), ElementsAre(NoteKind::trimmed));
}

/// The area of the polygons with a block, in square units.
double areaOfBlock(const ImportedMap& map, Block block) {
  double area = 0;
  for (const MapPolygon& p : map.placements) {
    if (p.block == block) area += tiled::areaOf(realRing(ringOf(map.shapes[p.shape])));
  }
  return area;
}

TEST(TiledPlacer, WhatComesLaterLosesTheCommonPart) {
  constexpr double kRounding = 8.0 * kUnitsPerCell;  // an edge can move by less than a unit along its length
  const std::vector<Polygon> rings = simpleRings(5, 3, kUnitsPerCell / 2);
  std::size_t cut = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = i % 64; j < rings.size(); j += 64) {  // a 64th of all pairs
      SCOPED_TRACE(text(rings[j]) + " on " + text(rings[i]));
      const ImportedMap map = placed({rings[i], rings[j]});
      worldOf(map);
      const double common = commonArea(rings[i], rings[j]);
      ASSERT_NEAR(areaOfBlock(map, 1), tiled::areaOf(realRing(rings[i])), kRounding) << "the first one stays";
      ASSERT_NEAR(areaOfBlock(map, 2), tiled::areaOf(realRing(rings[j])) - common, kRounding);
      ASSERT_EQ(map.report.layers[0].notes.empty(), common < 1) << "it says so";
      cut += common >= 1;
    }
  }
  EXPECT_GT(cut, 100U);
}

/// A comb of `teeth` needles up to the other side of the cell.
Polygon combOf(std::int64_t teeth, bool lying) {
  Polygon ring{{0, 0}, {65'536, 0}};
  for (std::int64_t k = teeth; k > 0; --k) {
    ring.push_back({k * 65'536 / (teeth + 1), 65'536});
    ring.push_back({k * 65'536 / (teeth + 1) - 10, 40});
  }
  for (Point& p : ring) {
    if (lying) p = {65'536 - p.y, p.x};
  }
  return ring;
}

TEST(TiledPlacer, WhatCrossesTooOftenIsLeftOut) {
  const auto noteOf = [](std::int64_t teeth) {
    const ImportedMap map = placed({combOf(teeth, false), combOf(teeth, true)});
    EXPECT_GE(map.report.layers[0].notes.size(), 1U);
    return map.report.layers[0].notes.back().text + (map.placements.size() > 1 ? ", taken" : ", left out");
  };
  EXPECT_EQ(noteOf(12), "lies on what is there already: the common part was taken away, taken");
  EXPECT_EQ(noteOf(40), "crosses what is there already more than 1024 times, left out");
}

TEST(TiledPlacer, SliversAreDropped) {
  const auto left = [](std::int64_t width) {  // of a square that is wider than the one before it
    const std::int64_t end = 9'000 + width;
    const Polygon first{{0, 0}, {9'000, 0}, {9'000, 65'536}, {0, 65'536}};
    return placed({first, {{0, 0}, {end, 0}, {end, 65'536}, {0, 65'536}}}).placements.size() - 1;
  };
  EXPECT_EQ(left(0), 0U);
  EXPECT_EQ(left(4), 0U);
  EXPECT_EQ(left(5), 1U);
}

/// Bars beside each other, as tiles of several layers bring them: each is compared with all that are there, once.
TEST(TiledPlacer, WhatMeetsInACellIsTakenFromTheBudget) {
  constexpr std::size_t kSteps = 3 * 1'000 + (1 + 2) * (100 + 8 * 8);  // three bars of four corners
  for (const std::size_t less : {std::size_t{0}, std::size_t{1}}) {
    Budget budget({.maxWork = kSteps - less});
    Placer placer(budget);
    for (const Cell cell : {Cell{0, 0}, Cell{1, 0}}) {  // what happened in one cell is known in the next
      for (std::int64_t x = 0; x < 3'000; x += 1'000) {
        placer.place(cell,
                     placer.entry({{}, 1, placer.shape({{x, 0}, {x + 900, 0}, {x + 900, 900}, {x, 900}}), kNoTile}));
      }
    }
    ImportedMap map;
    map.report.layers.emplace_back();
    placer.finish(map);
    EXPECT_EQ(budget.isOutOfWork(), less == 1);
    EXPECT_EQ(map.placements.size(), less == 0 ? 6U : 2U) << "what there are no steps for is not done";
  }
}

/// A polygon of 1024 vertices below a line: teeth of 1/16 pixel.
std::string combObject(int id, int y) {
  std::string points = "0,0";
  for (int k = 1; k < 512; ++k) {
    points += " " + std::to_string(k / 16.0) + ",-3 " + std::to_string((k + 0.5) / 16.0) + ",-1";
  }
  return "<object id='" + std::to_string(id) + "' y='" + std::to_string(y) + "'><polygon points='" + points +
         " 32,0'/></object>";
}

TEST(TiledPlacer, VerticesTooManyForACell) {
  const Options options{.tolerance = 0};
  std::string objects;
  for (int k = 1; k <= 4; ++k) objects += combObject(k, 4 * k);
  const std::string corner = "<object id='9'><polygon points='0,32 1,32 0,31'/></object>";
  const auto full = importAlone(objects, options);
  EXPECT_EQ(full.placements.size(), 4U);
  EXPECT_TRUE(noteKinds(full).empty());
  const auto overfull = importAlone(objects + corner, options);
  EXPECT_EQ(ringsIn(overfull, {0, -1}), ringsIn(full, {0, -1}));
  ASSERT_EQ(noteKinds(overfull), (std::vector<NoteKind>{NoteKind::leftOut}));
  EXPECT_EQ(overfull.report.tiles[0].notes[0].object, 9U);
  EXPECT_EQ(overfull.report.tiles[0].notes[0].text, "the cell holds as many polygons or vertices as it can");
}

}  // namespace
}  // namespace lgs::tiled
