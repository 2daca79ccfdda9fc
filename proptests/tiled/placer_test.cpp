// Cells as they fill up: which entries are equal, and what is given up if too much meets in one cell.
#include "lib/tiled/src/placer.h"
#include "maps.h"

#include <lgs/world.h>

namespace lgs::tiled {
namespace {

TEST(TiledPlacer, EntriesAreToldApartByEveryField) {
  // All combinations of three values, once upwards and once downwards.
  std::vector<Placer::Entry> entries;
  for (std::uint32_t code = 0; code < 243; ++code) {
    entries.push_back({code % 3, static_cast<Block>(code / 3 % 3), code / 9 % 3, code / 27 % 3, code / 81});
  }
  for (const bool down : {false, true}) {
    Placer placer;
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
  Placer placer;
  EXPECT_EQ(placer.shape({{0, 0}, {9, 0}, {9, 9}}), 0U);
  EXPECT_EQ(placer.shape({{9, 0}, {9, 9}, {0, 0}}), 0U);
  EXPECT_EQ(placer.shape({{0, 0}, {9, 0}, {9, 8}}), 1U);
}

/// As importTile(), but without a World, which is slow if hundreds of polygons share a cell.
ImportedMap importAlone(const std::string& objects, const Options& options) {
  auto map = importFiles({{"maps/test.tmx", mapXml(tilesetXml({objects}) + csvLayer(1, 1, "1"))}}, options);
  if (!map) {
    ADD_FAILURE() << message(map.error());
    return {};
  }
  return std::move(*map);
}

/// Objects of one tile: `lying` level bars on the left, the highest first; `standing` upright bars on the right; then
/// the whole square. The lines along the level bars cut the rest of the square into stripes. So each upright bar has to
/// be taken out of each stripe.
std::string barsAndSquare(int lying, int standing) {
  std::string objects;
  const auto add = [&](double x, double y, double width, double height) {
    objects += "<object id='1' x='" + std::to_string(x) + "' y='" + std::to_string(y) + "' width='" +
               std::to_string(width) + "' height='" + std::to_string(height) + "'/>";
  };
  for (int k = 0; k < lying; ++k) add(2, 2 + k, 8, 0.5);
  for (int k = 0; k < standing; ++k) add(11 + k * 0.5, 1.5, 0.25, 29);
  return objects + "<object id='7' width='32' height='32'/>";
}

TEST(TiledPlacer, SomeHundredCutsThenTheRestIsGivenUp) {
  Options options;
  options.tolerance = 0;
  const auto few = importAlone(barsAndSquare(8, 8), options);
  EXPECT_DOUBLE_EQ(areaInCells(few), 1.0);
  EXPECT_EQ(noteKinds(few), (std::vector<NoteKind>{NoteKind::trimmed}));
  const auto many = importAlone(barsAndSquare(11, 14), options);
  EXPECT_LT(areaInCells(many), 1.0);
  ASSERT_EQ(noteKinds(many), (std::vector<NoteKind>{NoteKind::leftOut, NoteKind::trimmed}));
  const Note& note = many.report.tiles[0].notes[0];
  EXPECT_EQ(note.text, "overlaps what is there already in so intricate a way that a part was given up");
  EXPECT_EQ(note.object, 7U);
  EXPECT_EQ(note.places, 1U);
  EXPECT_EQ(note.cell, (Cell{0, -1}));
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
  Options options;
  options.tolerance = 0;
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
