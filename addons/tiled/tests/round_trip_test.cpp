// An imported map becomes a trace, and the trace becomes the same world again. This holds for the project's own map and
// for random maps, with shapes that touch, overlap, and reach out of their tiles.
#include "cli/import/imported.h"
#include "maps.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"
#include "proptests/support/law.h"
#include "proptests/support/must.h"

#include <algorithm>
#include <ostream>

namespace lgs::tiled {
namespace {

/// A trace, written and read again, gives this world.
void comesBack(const oracle::Trace& written, const World& world) {
  const oracle::ParsedTrace read = oracle::parseTrace(oracle::printTrace(written));
  ASSERT_FALSE(read.error) << read.error->text;
  ASSERT_TRUE(read.trace == written) << "another trace is read than was written:\n" << oracle::printTrace(read.trace);
  oracle::Player player(read.trace.preserve);
  const auto played = oracle::play(read.trace, player);
  ASSERT_TRUE(played) << played.error().text;
  ASSERT_EQ(oracle::dump(oracle::outlineOf(player.world())), oracle::dump(oracle::outlineOf(world)));
}

constexpr std::size_t kWidth = 6, kHeight = 5;

/// Tiles of shapes that touch, overlap, and reach out of their tiles.
struct AnyMap {
  std::vector<std::uint32_t> tiles;  ///< by rows; with the flips in their upper bits; 0 is none
};

std::string xmlOf(const AnyMap& map) {
  static const std::vector<std::string> kObjects{
      "<object id='1' x='0' y='0' width='32' height='32'/>",
      "<object id='1' x='0' y='16' width='32' height='16'/>",
      "<object id='1' x='0' y='32'><polygon points='0,0 32,0 32,-32'/></object>",
      "<object id='1' x='0.3' y='31.8'><polygon points='0,0 32,0 32,-16'/></object>",
      "<object id='1' x='-10' y='-6' width='30' height='50'/>",
      "<object id='1' x='4' y='4' width='24' height='24'><ellipse/></object>",
      "<object id='1' x='16' y='0' width='20' height='20' rotation='30'/>",
      "<object id='1' x='0' y='0' width='10' height='10'/><object id='2' x='10' y='5' width='22' height='9'/>"};
  std::string csv;
  for (const std::uint32_t tile : map.tiles) csv += (csv.empty() ? "" : ",") + std::to_string(tile);
  return mapXml(tilesetXml(kObjects) + csvLayer(kWidth, kHeight, csv), "width='6' height='5'");
}

void showValue(const AnyMap& map, std::ostream& out) { out << xmlOf(map); }

rc::Gen<AnyMap> anyMap() {
  const auto tile = rc::gen::map(rc::gen::pair(rc::gen::inRange(0U, 9U), rc::gen::inRange(0U, 8U)),
                                 [](std::pair<std::uint32_t, std::uint32_t> drawn) {
                                   return drawn.first == 0 ? 0 : drawn.first | drawn.second << 29;
                                 });
  const auto tiles = rc::gen::container<std::vector<std::uint32_t>>(kWidth * kHeight, tile);
  return rc::gen::resize(rc::kNominalSize, rc::gen::map(tiles, [](const auto& drawn) { return AnyMap{drawn}; }));
}

TEST(TiledRoundTrip, RandomMaps) {
  const auto law = [](const AnyMap& any) {
    const ImportedMap map = mustImportFiles({{"maps/test.tmx", xmlOf(any)}});
    const bool isEmpty = std::ranges::all_of(any.tiles, [](std::uint32_t tile) { return tile == 0; });
    ASSERT_EQ(map.report.polygons == 0, isEmpty);
    comesBack(cli::traceOf(map), worldOf(map));
  };
  test::forAll(60, law, anyMap());
}

TEST(TiledRoundTrip, TheProjectsOwnMap) {
  const auto map = test::must(importMap(LGS_SOURCE_DIR "/examples/maps/landscape.tmx"));
  comesBack(cli::traceOf(map), worldOf(map));
}

}  // namespace
}  // namespace lgs::tiled
