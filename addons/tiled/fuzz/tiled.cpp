// Maps. An input is a file of Tiled's or LDtk's; what follows a form feed in it is the file that any name in it means:
// a tileset, a template, a map of a world, or a level. Whatever is accepted keeps the importer's promise: sorted,
// counted, and placed by World without a refusal.
#include "cli/import/imported.h"
#include "fuzz/target.h"
#include "oracle/reference/validity.h"

#include <fmt/format.h>
#include <lgs/tiled/import.h>
#include <lgs/world.h>
#include <array>

namespace lgs::fuzz {
namespace tiled_target {
namespace {

using tiled::ImportedMap;
using tiled::MapPolygon;

constexpr std::array<std::string_view, 63> kWords{
    // Files of Tiled, as XML.
    "<map orientation='orthogonal' width='2' height='2' tilewidth='32' tileheight='32'>", "</map>",
    "<tileset firstgid='1' tilewidth='32' tileheight='32'>", "<tileset firstgid='1' source='a.tsx'/>", "</tileset>",
    "<tile id='0'>", "<tile id='1' type='water'>", "</tile>", "<objectgroup>", "<objectgroup name='wall'>",
    "<object id='3' gid='1' x='8' y='40' width='48' height='48'/>", "</objectgroup>",
    "<object id='1' x='0' y='0' width='32' height='32'/>", "<object id='2' x='1' y='2'>", "</object>",
    "<polygon points='0,0 32,0 32,32'/>", "<ellipse/>", "<capsule/>", "<polyline points='0,0 1,1'/>",
    " class='one-way'", " visible='0'", " rotation='45'", " offsetx='16'", "<layer name='a' width='2' height='2'>",
    "</layer>", "<group name='g' offsety='-7'>", "</group>", "<data encoding='csv'>1,2,0,1</data>",
    "<data encoding='base64' compression='zlib'>", "<data encoding='base64'>AQAAAAAAAAA=</data>",
    "<chunk x='-16' y='0' width='2' height='2'>", "<tile gid='2147483649'/>", " infinite='1'",
    // Numbers.
    "2147483649", "-1", "1e300", "nan",
    // Files of Tiled, as JSON.
    R"({"type":"map", "tilewidth":32, "tileheight":32, "width":2, "height":2, "layers":[)",
    R"("tilesets":[{"firstgid":1, "source":"a.tsj"}], )",
    R"({"type":"tileset", "tilewidth":32, "tileheight":32, "tiles":[)", R"({"id":0, "objectgroup":{"objects":[)",
    R"({"type":"tilelayer", "name":"a", "width":2, "height":2, "data":[1,2,0,1]},)",
    R"("encoding":"base64", "compression":"zlib", )",
    R"("chunks":[{"x":-16, "y":0, "width":2, "height":2, "data":[1,1,0,2]}], )",
    R"({"type":"objectgroup", "name":"wall", "objects":[)",
    R"({"id":1, "x":8, "y":4, "width":48, "height":40, "rotation":30, "ellipse":true},)",
    R"("polygon":[{"x":0, "y":0}, {"x":40, "y":0}, {"x":0, "y":32}], )", R"({"type":"group", "offsetx":7, "layers":[)",
    R"("properties":[{"name":"solid", "value":true}], )",
    R"({"type":"world", "maps":[{"fileName":"a.tmx", "x":0, "y":0},{"fileName":"b.tmx", "x":64, "y":-8},)",
    R"x({"type":"world", "patterns":[{"regexp":"(\\d+)_(.)", "multiplierX":64, "offsetY":-8},)x",
    // Projects of LDtk.
    R"({"__header__":{"app":"LDtk"}, "worldLayout":"Free", "levels":[)",
    R"({"identifier":"A", "worldX":8, "worldY":0, "pxWid":64, "pxHei":64, "layerInstances":[)",
    R"({"__type":"IntGrid", "__identifier":"a", "layerDefUid":1, "intGridCsv":[1,2],)",
    R"("__gridSize":32, "__cWid":2, "__cHei":1},)",
    R"({"__type":"Tiles", "__identifier":"a", "layerDefUid":2, "__gridSize":32, "gridTiles":[{"px":[32,0], "t":1},)",
    R"({"__type":"Entities", "__identifier":"wall", "entityInstances":[)",
    R"({"__identifier":"E", "px":[40,8], "__pivot":[0.5,1], "width":40, "height":24},)",
    R"("layerInstances":null, "externalRelPath":"a.ldtkl")",
    // Ends, and what parts files.
    "]}", "},", "null", "\f"};

constexpr std::size_t kMaxPlacements = 512;

// The three ways between them take every option.
std::array<tiled::Options, 3> allOptions() {
  std::array<tiled::Options, 3> all;
  for (tiled::Options& options : all) {
    options.maxTiles = 4'096;
    options.maxPlacements = kMaxPlacements;
  }
  all[1].blockFrom = tiled::BlockFrom::tileClass;
  all[1].tolerance = 0;
  all[1].visibleOnly = true;
  all[1].polylineThickness = 3;
  all[2].solidWithoutShapes = true;
  all[2].blockFrom = tiled::BlockFrom::layer;
  all[2].blocks["a"] = 7;
  return all;
}

auto importText(std::string_view text, const tiled::Options& options) {
  const std::size_t cut = std::min(text.find('\f'), text.size());
  const std::string tmx(text.substr(0, cut));
  const std::string tsx(text.substr(std::min(cut + 1, text.size())));
  const auto read = [&](const std::string& path) -> tl::expected<std::string, std::string> {
    return path == "map.tmx" ? tmx : tsx;
  };
  const auto list = [](const std::string&) -> tl::expected<std::vector<std::string>, std::string> {
    return std::vector<std::string>{"1_2.tmx", "3_a.tmx"};
  };
  return tiled::importMap("map.tmx", options, read, list);
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
    const MapPolygon& p = map.placements[k];
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

constexpr Target kTarget{"tiled", "maps of Tiled and LDtk", check, traceOf, nullptr, kWords, whyEmpty};

}  // namespace
}  // namespace tiled_target

const Target kTiled = tiled_target::kTarget;

}  // namespace lgs::fuzz
