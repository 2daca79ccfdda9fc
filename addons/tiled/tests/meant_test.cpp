// How often the importer takes what the author of a map meant: at the first try, and after the first command that it
// offers.
#include "meant_maps.h"

namespace lgs::tiled::meant {
namespace {

std::string textOf(const MeantMap& map) {
  return "<map orientation='orthogonal' width='8' height='4' tilewidth='16' tileheight='16'>\n" + map.content +
         "</map>\n";
}

/// The cells that are solid, as a picture.
std::string pictureOf(const ImportedMap& map) {
  std::string picture = "......../......../......../........";
  for (const MapPolygon& p : map.placements) {
    const int row = -1 - p.cell.j;
    if (p.cell.i >= 0 && p.cell.i < 8 && row >= 0 && row < 4)
      picture[static_cast<std::size_t>(9 * row + p.cell.i)] = '#';
  }
  return picture;
}

std::string meantPicture(const MeantMap& map) {
  std::string picture = map.solid;
  std::replace_if(
      picture.begin(), picture.end(), [](char c) { return c != '.' && c != '/'; }, '#');
  return picture;
}

ImportedMap importMeant(const MeantMap& map, const Options& options = {}) {
  return mustImportFiles({{"maps/test.tmx", textOf(map)}}, options);
}

/// Counts those that are right at the first try, and after the first command. Each offer must keep its promise, and
/// what is taken in part must say so.
TEST(TiledMeant, MapsAreTakenAsTheyAreMeant) {
  std::size_t first = 0, afterCommand = 0;
  const std::vector<MeantMap> all = meantMaps();
  for (const MeantMap& meant : all) {
    SCOPED_TRACE(meant.name);
    const ImportedMap map = importMeant(meant);
    const std::string solid = meantPicture(meant), got = pictureOf(map);
    for (const Suggestion& offer : map.report.suggestions) {
      EXPECT_EQ(importMeant(meant, offer.options).placements.size(), offer.polygons) << offer.text;
      EXPECT_GT(offer.polygons, 0U) << offer.text;
    }
    const auto isWithin = [&](std::size_t k) { return got[k] != '#' || solid[k] == '#'; };
    bool isPart = got != solid && !map.placements.empty();
    for (std::size_t k = 0; k < solid.size(); ++k) isPart = isPart && isWithin(k);
    EXPECT_TRUE(!isPart || !map.report.partial.empty()) << "in part, and without a word: " << got << "\n"
                                                        << toText(map.report);
    first += got == solid;
    if (got == solid) {
      ++afterCommand;
      continue;
    }
    const std::vector<Suggestion>& offers = map.report.suggestions;
    const bool isRight = !offers.empty() && pictureOf(importMeant(meant, offers.front().options)) == solid;
    afterCommand += isRight;
    EXPECT_TRUE(isRight) << "got " << got << "\n" << toText(map.report);
  }
  EXPECT_GE(all.size(), 110U);
  EXPECT_GE(10 * first, 8 * all.size()) << first << " of " << all.size() << " at the first try";
  EXPECT_LE(all.size() - first, 11U) << "of those that were right once, one is no more";
  EXPECT_GE(100 * afterCommand, 97 * all.size()) << afterCommand << " of " << all.size() << " after the first command";
  RecordProperty("first", static_cast<int>(first));
}

}  // namespace
}  // namespace lgs::tiled::meant
