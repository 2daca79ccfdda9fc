// Tiled maps. An input is a TMX file; what follows a form feed in it is the TSX file that any tileset's source names.
// Whatever is accepted keeps the importer's promise: sorted, counted, and placed by World without a refusal.
#include "cli/imported.h"
#include "fuzz/target.h"
#include "oracle/reference/validity.h"

#include <fmt/format.h>
#include <lgs/tiled/import.h>
#include <lgs/world.h>
#include <array>

namespace lgs::fuzz {
namespace {

using tiled::ImportedMap;
using tiled::Placement;

constexpr std::array<std::string_view, 36> kWords{
    "<map orientation='orthogonal' width='2' height='2' tilewidth='32' tileheight='32'>",
    "</map>",
    "<tileset firstgid='1' tilewidth='32' tileheight='32'>",
    "<tileset firstgid='1' source='a.tsx'/>",
    "</tileset>",
    "<tile id='0'>",
    "<tile id='1' type='water'>",
    "</tile>",
    "<objectgroup>",
    "<objectgroup name='wall'>",
    "<object id='3' gid='1' x='8' y='40' width='48' height='48'/>",
    "</objectgroup>",
    "<object id='1' x='0' y='0' width='32' height='32'/>",
    "<object id='2' x='1' y='2'>",
    "</object>",
    "<polygon points='0,0 32,0 32,32'/>",
    "<ellipse/>",
    "<capsule/>",
    "<polyline points='0,0 1,1'/>",
    " rotation='45'",
    " offsetx='16'",
    "<layer name='a' width='2' height='2'>",
    "</layer>",
    "<group name='g' offsety='-7'>",
    "</group>",
    "<data encoding='csv'>1,2,0,1</data>",
    "<data encoding='base64' compression='zlib'>",
    "<data encoding='base64'>AQAAAAAAAAA=</data>",
    "<chunk x='-16' y='0' width='2' height='2'>",
    "<tile gid='2147483649'/>",
    " infinite='1'",
    "2147483649",
    "-1",
    "1e300",
    "nan",
    "\f"};

constexpr std::size_t kMaxPlacements = 512;

// The three ways between them take every option.
std::array<tiled::Options, 3> allOptions() {
  std::array<tiled::Options, 3> all;
  for (tiled::Options& options : all) {
    options.maxTiles = 4'096;
    options.maxPlacements = kMaxPlacements;
  }
  all[1].outside = tiled::Outside::clip;
  all[1].blockFrom = tiled::BlockFrom::tileClass;
  all[1].tolerance = 0;
  all[2].solidWithoutShapes = true;
  all[2].blockFrom = tiled::BlockFrom::layer;
  all[2].blocks["a"] = 7;
  return all;
}

auto importText(std::string_view text, const tiled::Options& options) {
  const std::size_t cut = std::min(text.find('\f'), text.size());
  const std::string tmx(text.substr(0, cut));
  const std::string tsx(text.substr(std::min(cut + 1, text.size())));
  return tiled::importMap("map.tmx", options, [&](const std::string& path) -> tl::expected<std::string, std::string> {
    return path == "map.tmx" ? tmx : tsx;
  });
}

std::optional<Finding> checkMap(const ImportedMap& map, oracle::CheckStats& stats) {
  const auto bad = [](std::string text) { return Finding{std::move(text) + "\n"}; };
  if (map.report.polygons != map.placements.size() || map.report.shapes != map.shapes.size() ||
      map.placements.size() > kMaxPlacements || tiled::toText(map.report).empty()) {
    return bad("the report does not count what came out");
  }
  for (std::size_t k = 0; k < map.shapes.size(); ++k) {
    if (const auto fault = oracle::faultOf(map.shapes[k])) return bad(fmt::format("shape {} is {}", k, name(*fault)));
  }
  World world;
  for (std::size_t k = 0; k < map.placements.size(); ++k) {
    const Placement& p = map.placements[k];
    const auto key = [](Cell cell) { return std::pair(cell.j, cell.i); };
    if (k > 0 && key(p.cell) < key(map.placements[k - 1].cell)) return bad("the placements are not sorted by cell");
    const bool isTileKnown = p.tile == tiled::kNoTile || p.tile < map.report.tiles.size();
    if (!isTileKnown || p.layer >= map.report.layers.size()) return bad("a tile or layer unknown");
    const auto added = world.add(p.cell, map.shapes[p.shape], p.block);
    ++stats.edits;
    if (!added) return bad("the world refuses a placement: " + message(added.error()));
  }
  return std::nullopt;
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) {
  for (const tiled::Options& options : allOptions()) {
    const auto map = importText(textOf(input), options);
    if (!map) {
      if (map.error().what.empty() || message(map.error()).empty()) return Finding{"an error without words\n"};
    } else if (auto finding = checkMap(*map, stats)) {
      return finding;
    }
  }
  return std::nullopt;
}

oracle::Trace traceOf(Bytes input) {
  const auto map = importText(textOf(input), allOptions()[0]);
  return map ? cli::traceOf(*map) : oracle::Trace();
}

std::string whyEmpty(Bytes input) {
  const auto map = importText(textOf(input), allOptions()[0]);
  return map ? "the map has no solid tiles" : message(map.error());
}

}  // namespace

const Target kTiled{"tiled", "Tiled maps, TMX and TSX", check, traceOf, nullptr, {}, kWords, whyEmpty};

}  // namespace lgs::fuzz
