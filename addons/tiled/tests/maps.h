// Small Tiled maps for the tests, and what holds for each imported map: World accepts every polygon.
#pragma once

#include "as_json.h"
#include "oracle/reference/validity.h"
#include "proptests/support/must.h"

#include <lgs/tiled/import.h>
#include <lgs/world.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace lgs::tiled {

using testing::ElementsAre, testing::HasSubstr, testing::IsEmpty, testing::Not;

using Files = std::map<std::string, std::string>;
using Cells = std::vector<Cell>;
using Ring = std::vector<LocalPoint>;
using Rings = std::vector<Ring>;

/// A tile with these objects, for a tileset.
inline std::string tileXml(std::size_t id, const std::string& objects, const std::string& attributes = "") {
  return fmt::format("<tile id='{}' {}><objectgroup>{}</objectgroup></tile>", id, attributes, objects);
}

/// Tiles of 32×32 pixels; `content` is everything inside <tileset>.
inline std::string tilesOf32(const std::string& content, const std::string& attributes = "firstgid='1'") {
  return "<tileset " + attributes + " tilewidth='32' tileheight='32'>" + content + "</tileset>";
}

/// Tiles 1, 2, … of 32×32 pixels, each with the given objects.
inline std::string tilesetXml(const std::vector<std::string>& objects, const std::string& attributes = "") {
  std::string xml = "<tileset firstgid='1' name='set' tilewidth='32' tileheight='32' " + attributes + ">\n";
  for (std::size_t i = 0; i < objects.size(); ++i) xml += tileXml(i, objects[i]) + "\n";
  return xml + "</tileset>\n";
}

/// A map of 32×32 pixel tiles; `content` is everything inside <map>.
inline std::string mapXml(const std::string& content, const std::string& attributes = "width='4' height='3'") {
  return "<?xml version='1.0'?>\n<map orientation='orthogonal' tilewidth='32' tileheight='32' " + attributes + ">\n" +
         content + "</map>\n";
}

inline std::string csvLayer(int width, int height, const std::string& csv, const std::string& attributes = "") {
  return fmt::format("<layer name='Ground' width='{}' height='{}' {}><data encoding='csv'>{}</data></layer>\n", width,
                     height, attributes, csv);
}

inline std::string objectLayer(const std::string& objects, const std::string& attributes = "name='Walls'") {
  return "<objectgroup " + attributes + ">" + objects + "</objectgroup>\n";
}

inline std::string property(const std::string& name, const std::string& value) {
  return "<properties><property name='" + name + "' value='" + value + "'/></properties>";
}

/// Reads these files, which must outlive it.
inline FileReader readerOf(const Files& files) {
  return [&files](const std::string& path) -> tl::expected<std::string, std::string> {
    const auto file = files.find(path);
    if (file == files.end()) return tl::unexpected<std::string>("there is no such file");
    return file->second;
  };
}

/// Imports "maps/test.tmx" with files that may lie anywhere, as in many projects of Tiled's.
inline tl::expected<ImportedMap, ImportError> importFiles(const Files& files, Options options = {}) {
  options.filesAnywhere = true;
  return importMap("maps/test.tmx", options, readerOf(files));
}

/// Places everything in a world; that is what the importer promises to be possible. World decides what overlaps by the
/// code that the importer uses, so the reference is asked, too.
inline World worldOf(const ImportedMap& map) {
  World world;
  for (auto p = map.placements.begin(); p != map.placements.end(); ++p) {
    const auto added = world.add(p->cell, map.shapes[p->shape], p->block);
    EXPECT_TRUE(added) << message(added.error());
    for (auto q = map.placements.begin(); q != p; ++q) {
      EXPECT_FALSE(q->cell == p->cell && oracle::overlap(map.shapes[q->shape], map.shapes[p->shape]));
    }
  }
  world.commit();
  EXPECT_EQ(map.report.polygons, map.placements.size());
  EXPECT_EQ(map.report.shapes, map.shapes.size());
  return world;
}

/// Expects the same of the map in JSON, if it can be said in JSON: of all files, and of the map's alone.
inline void mustBeAlikeInJson(const Files& files, const Options& options, const ImportedMap& map) {
  for (const bool all : {true, false}) {
    if (!all && files.size() == 1) break;
    const auto json = asJson(files, [&](const std::string& name) { return all || name == "maps/test.tmx"; });
    if (json) expectAlike(map, test::must(importFiles(*json, options)));
  }
}

/// Imports what is no map of Tiled's by itself: a world, or a project of LDtk.
inline ImportedMap mustImportWorld(const Files& files, const Options& options = {}) {
  ImportedMap map = test::must(importFiles(files, options));
  worldOf(map);
  return map;
}

/// Imports a map, and then the same map in JSON.
inline ImportedMap mustImportFiles(const Files& files, const Options& options = {}) {
  ImportedMap map = mustImportWorld(files, options);
  mustBeAlikeInJson(files, options, map);
  return map;
}

inline ImportedMap mustImport(const std::string& content, const Options& options = {}) {
  return mustImportFiles({{"maps/test.tmx", mapXml(content)}}, options);
}

/// The message of a map that is refused.
inline std::string refusalOf(const tl::expected<ImportedMap, ImportError>& map) {
  return map ? "accepted" : message(map.error());
}

inline std::string refusalOf(const std::string& xml, const Options& options = {}) {
  return refusalOf(importFiles({{"maps/test.tmx", xml}}, options));
}

/// One tile with these objects, alone in the map's upper left corner: cell (0, -1).
inline ImportedMap importTile(const std::string& objects, const Options& options = {}) {
  return mustImport(tilesetXml({objects}) + csvLayer(1, 1, "1"), options);
}

/// What an object becomes: as the shape of a tile in cell (0, -1), and as an object in the same place.
inline std::array<ImportedMap, 2> bothWays(const std::string& object, const Options& options = {}) {
  return {importTile(object, options), mustImport(objectLayer(object), options)};
}

inline const Ring kSquare(kUnitSquare.begin(), kUnitSquare.end());

/// The polygons of a cell, in order.
inline Rings ringsIn(const ImportedMap& map, Cell cell) {
  Rings rings;
  for (const MapPolygon& p : map.placements) {
    if (p.cell == cell) rings.push_back(map.shapes[p.shape]);
  }
  return rings;
}

inline Cells cellsOf(const ImportedMap& map) {
  Cells cells;
  for (const MapPolygon& p : map.placements) cells.push_back(p.cell);
  return cells;
}

inline std::vector<Block> blocksOf(const ImportedMap& map) {
  std::vector<Block> blocks;
  for (const MapPolygon& p : map.placements) blocks.push_back(p.block);
  return blocks;
}

/// A ring in pixels of a 32×32 tile, y up. Begin with its least vertex, as the importer's rings do.
inline Ring px(const std::vector<std::pair<double, double>>& points) {
  Ring ring;
  for (const auto& [x, y] : points) {
    ring.push_back({static_cast<std::int32_t>(x * 2048), static_cast<std::int32_t>(y * 2048)});
  }
  return ring;
}

/// A rectangle in pixels, as px() has it.
inline Ring pxBox(double left, double low, double right, double high) {
  return px({{left, low}, {right, low}, {right, high}, {left, high}});
}

inline double areaInCells(const ImportedMap& map) {
  double sum = 0;
  for (const MapPolygon& p : map.placements) {
    const Ring& ring = map.shapes[p.shape];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const LocalPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      sum += static_cast<double>(std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x) / 2;
    }
  }
  return sum / kUnitsPerCell / kUnitsPerCell;
}

inline std::vector<NoteKind> noteKinds(const ImportedMap& map) {
  std::vector<NoteKind> kinds;
  for (const TileReport& tile : map.report.tiles) {
    for (const Note& note : tile.notes) kinds.push_back(note.kind);
  }
  return kinds;
}

/// All notes, be they of tiles or of layers.
inline std::vector<Note> notesOf(const ImportedMap& map) {
  std::vector<Note> notes;
  for (const TileReport& tile : map.report.tiles) notes.insert(notes.end(), tile.notes.begin(), tile.notes.end());
  for (const LayerReport& layer : map.report.layers) notes.insert(notes.end(), layer.notes.begin(), layer.notes.end());
  return notes;
}

inline std::vector<std::string> noteTexts(const ImportedMap& map) {
  std::vector<std::string> texts;
  for (const Note& note : notesOf(map)) texts.push_back(note.text);
  return texts;
}

/// "Path: note" of each layer; layers that are passed over are in brackets.
inline std::vector<std::string> remarks(const ImportedMap& map) {
  std::vector<std::string> result;
  for (const LayerReport& layer : map.report.layers) {
    const std::string text = layer.path + (layer.note.empty() ? "" : ": " + layer.note);
    result.push_back(layer.imported ? text : "[" + text + "]");
  }
  return result;
}

inline const std::string kFullTile = "<object id='1' x='0' y='0' width='32' height='32'/>";

}  // namespace lgs::tiled
