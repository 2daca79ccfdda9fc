// Imported map → trace → the same world: random maps of shapes that touch, overlap, and reach out of their tiles, and the
// project's own map.
#include "maps.h"
#include "oracle/check/random.h"
#include "oracle/cli/imported.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <gtest/gtest.h>

namespace lgs::tiled {
namespace {

void comesBack(const ImportedMap& map) {
  const World world = worldOf(map);
  const oracle::Trace written = oracle::traceOf(map);
  const oracle::ParsedTrace read = oracle::parseTrace(oracle::printTrace(written));
  ASSERT_FALSE(read.error) << read.error->text;
  ASSERT_EQ(read.trace, written);
  oracle::Player player(read.trace.preserve);
  const auto played = oracle::play(read.trace, player);
  ASSERT_TRUE(played) << played.error().text;
  ASSERT_EQ(oracle::dump(oracle::outlineOf(player.world())), oracle::dump(oracle::outlineOf(world)));
}

TEST(TiledRoundTrip, RandomMaps) {
  const std::vector<std::string> objects{
      "<object id='1' x='0' y='0' width='32' height='32'/>",
      "<object id='1' x='0' y='16' width='32' height='16'/>",
      "<object id='1' x='0' y='32'><polygon points='0,0 32,0 32,-32'/></object>",
      "<object id='1' x='0.3' y='31.8'><polygon points='0,0 32,0 32,-16'/></object>",
      "<object id='1' x='-10' y='-6' width='30' height='50'/>",
      "<object id='1' x='4' y='4' width='24' height='24'><ellipse/></object>",
      "<object id='1' x='16' y='0' width='20' height='20' rotation='30'/>",
      "<object id='1' x='0' y='0' width='10' height='10'/><object id='2' x='10' y='5' width='22' height='9'/>"};
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    oracle::Random random(seed);
    std::string csv;
    for (int k = 0; k < 6 * 5; ++k) {
      const std::uint32_t tile = random.below(static_cast<std::uint32_t>(objects.size()) + 1);
      const std::uint32_t flips = tile == 0 ? 0 : random.below(8U) << 29;
      csv += (k == 0 ? "" : ",") + std::to_string(tile | flips);
    }
    const std::string map = mapXml(tilesetXml(objects) + csvLayer(6, 5, csv), "width='6' height='5'");
    Options options;
    options.outside = random.chance(70) ? Outside::carry : Outside::clip;
    const ImportedMap imported = mustImportFiles({{"maps/test.tmx", map}}, options);
    ASSERT_GT(imported.report.polygons, 0U);
    ASSERT_NO_FATAL_FAILURE(comesBack(imported));
  }
}

TEST(TiledRoundTrip, TheProjectsOwnMap) {
  const auto map = importMap(LGS_SOURCE_DIR "/oracle/maps/landscape.tmx");
  ASSERT_TRUE(map) << message(map.error());
  comesBack(*map);
}

}  // namespace
}  // namespace lgs::tiled
