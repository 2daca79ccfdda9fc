// An imported map becomes a trace, and the trace becomes the same world again. This holds for the project's own map and
// for random maps, with shapes that touch, overlap, and reach out of their tiles.
#include "cli/imported.h"
#include "maps.h"
#include "oracle/generate/random.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/model.h"
#include "oracle/trace/player.h"
#include "proptests/first_failure.h"

#include <gtest/gtest.h>

namespace lgs::tiled {
namespace {

/// The world that the add edits of a trace make.
World worldOf(const oracle::Trace& trace) {
  World world;
  for (const oracle::Edit& edit : trace.edits) {
    if (edit.kind != oracle::Edit::Kind::add) continue;
    const auto& [cell, block, vertices] = edit.polygon;
    EXPECT_TRUE(world.add(cell, std::span<const LocalPoint>(vertices), block));
  }
  world.commit();
  return world;
}

/// Expects that a trace is still the same, and makes this world, after it was written and read.
void comesBack(const oracle::Trace& written, const World& world) {
  const oracle::ParsedTrace read = oracle::parseTrace(oracle::printTrace(written));
  ASSERT_FALSE(read.error) << read.error->text;
  ASSERT_TRUE(read.trace == written) << "another trace is read than was written:\n" << oracle::printTrace(read.trace);
  oracle::Player player(read.trace.preserve);
  const auto played = oracle::play(read.trace, player);
  ASSERT_TRUE(played) << played.error().text;
  ASSERT_EQ(oracle::dump(oracle::outlineOf(player.world())), oracle::dump(oracle::outlineOf(world)));
}

ImportedMap randomMap(std::uint64_t seed) {
  static const std::vector<std::string> kObjects{
      "<object id='1' x='0' y='0' width='32' height='32'/>",
      "<object id='1' x='0' y='16' width='32' height='16'/>",
      "<object id='1' x='0' y='32'><polygon points='0,0 32,0 32,-32'/></object>",
      "<object id='1' x='0.3' y='31.8'><polygon points='0,0 32,0 32,-16'/></object>",
      "<object id='1' x='-10' y='-6' width='30' height='50'/>",
      "<object id='1' x='4' y='4' width='24' height='24'><ellipse/></object>",
      "<object id='1' x='16' y='0' width='20' height='20' rotation='30'/>",
      "<object id='1' x='0' y='0' width='10' height='10'/><object id='2' x='10' y='5' width='22' height='9'/>"};
  oracle::Random random(seed);
  std::string csv;
  for (int k = 0; k < 6 * 5; ++k) {
    const std::uint32_t tile = random.below(static_cast<std::uint32_t>(kObjects.size()) + 1);
    const std::uint32_t flips = tile == 0 ? 0 : random.below(8U) << 29;
    csv += (k == 0 ? "" : ",") + std::to_string(tile | flips);
  }
  const std::string map = mapXml(tilesetXml(kObjects) + csvLayer(6, 5, csv), "width='6' height='5'");
  Options options;
  options.outside = random.chance(70) ? Outside::carry : Outside::clip;
  return mustImportFiles({{"maps/test.tmx", map}}, options);
}

TEST(TiledRoundTrip, RandomMaps) {
  const auto failure =
      test::firstFailure({.name = "tiled-round-trip",
                          .count = 60,
                          .trace = [](std::uint64_t seed) { return cli::traceOf(randomMap(seed)); },
                          .complaint =
                              [](const oracle::Trace& trace, std::uint64_t seed) {
                                return test::failedExpectation([&] {
                                  const ImportedMap map = randomMap(seed);
                                  ASSERT_GT(map.report.polygons, 0U);
                                  // A trace that was shrunk is of no map any more. Its own world has to come back.
                                  comesBack(trace, trace == cli::traceOf(map) ? worldOf(map) : worldOf(trace));
                                });
                              },
                          .mayBe =
                              [](const oracle::Trace& trace) {
                                return oracle::withoutRefused(trace).edits.size() == trace.edits.size();
                              }});
  if (failure) FAIL() << failure->text << "\nagain      " << test::again("lgs_tests");
}

TEST(TiledRoundTrip, TheProjectsOwnMap) {
  const auto map = importMap(LGS_SOURCE_DIR "/examples/maps/landscape.tmx");
  ASSERT_TRUE(map) << message(map.error());
  comesBack(cli::traceOf(*map), worldOf(*map));
}

}  // namespace
}  // namespace lgs::tiled
