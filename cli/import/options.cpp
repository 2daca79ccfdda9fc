#include "cli/import/options.h"

#include "cli/command.h"
#include "lib/text/words.h"
#include "oracle/trace/file.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cstdio>

namespace lgs::cli {
namespace {

constexpr const char* kGroup = "Options of the import";

// Reads "water=7". Returns what is wrong with it, or nothing.
std::string readBlock(const std::string& text, std::map<std::string, Block>& blocks) {
  const std::size_t equals = text.rfind('=');
  Block block = 0;
  const char* const begin = text.data() + (equals == std::string::npos ? text.size() : equals + 1);
  const char* const end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(begin, end, block);
  if (begin == end || stop != end || status != std::errc()) return "'" + text + "' is not NAME=NUMBER";
  blocks[text.substr(0, equals)] = block;
  return {};
}

void addBlockOptions(CLI::App& command, tiled::Options& options) {
  command
      .add_option_function<std::string>(
          "--block",
          [&options](const std::string& from) {
            options.blockFrom = from == "class"   ? tiled::BlockFrom::tileClass
                                : from == "name"  ? tiled::BlockFrom::name
                                : from == "layer" ? tiled::BlockFrom::layer
                                                  : tiled::BlockFrom::one;
          },
          "Which block a shape gets: one gives block 1 to all (the default;\n"
          "in an LDtk project a cell of an IntGrid layer gets its value),\n"
          "class and layer give one block to each class of tiles and objects,\n"
          "or layer; name is class, but the names of objects come first")
      ->check(CLI::IsMember({"one", "class", "name", "layer"}))
      ->option_text("one|class|name|layer");
  command
      .add_option_function<std::vector<std::string>>(
          "--number",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              if (const std::string fault = readBlock(text, options.blocks); !fault.empty()) {
                throw CLI::ValidationError("--number", fault);
              }
            }
          },
          "The block of a class, name or layer; the others get numbers in the\n"
          "order in which they occur. May be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME=NUMBER");
}

void addShapeOptions(CLI::App& command, tiled::Options& options) {
  addReal(
      command, "--tolerance", [&options](double pixels) { options.tolerance = pixels; }, {0, 1e6},
      "A vertex that misses the tile's rim or corner by up to this\nmany pixels is put on it; default 1")
      ->option_text("PX");
  command.add_flag("--solid", options.solidWithoutShapes,
                   "Import a tile without collision shapes as a full square;\notherwise it is empty");
  command
      .add_option("--solid-if", options.solidIf,
                  "The same for tiles with this property, or in layers with it;\n"
                  "and objects with it. NAME alone takes any value but false and 0.\nMay be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME[=VALUE]");
  addReal(
      command, "--polyline-thickness", [&options](double pixels) { options.polylineThickness = pixels; }, {0, 1e6},
      "Make thin polygons of open polylines: what lies up to so many\n"
      "pixels below them is solid, or right of them where they are steep")
      ->option_text("PIXELS");
}

void addLayerOptions(CLI::App& command, tiled::Options& options) {
  command
      .add_option("--layer", options.layers,
                  "Import only this tile layer or group, or this map of a world,\nor level of LDtk. May be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME");
  CLI::Option* const objects =
      command
          .add_option_function<std::vector<std::string>>(
              "--objects", [&options](const std::vector<std::string>& names) { options.objects = names; },
              "Import this object layer or kind of entity, all of a group, or\n"
              "all objects of this class or name. May be repeated")
          ->allow_extra_args(false)
          ->option_text("NAME");
  command
      .add_flag_callback(
          "--no-objects", [&options] { options.objects = std::vector<std::string>{}; }, "Import no object layer")
      ->excludes(objects);
  command
      .add_option(
          "--not", options.leaveOut,
          "Leave out tiles and objects of this class, or cells of LDtk\nwith a value of this name. May be repeated")
      ->allow_extra_args(false)
      ->option_text("CLASS");
  command.add_flag("--visible", options.visibleOnly,
                   "Leave out hidden layers and objects; otherwise they count like\nthose that are visible");
}

/// A table may be named once for all tilesets, or one for each.
void readTiles(const std::string& path, tiled::TileTable& tiles) {
  const auto text = oracle::readFile(path);
  if (!text) throw CLI::ValidationError("--tiles", message(text.error(), path));
  auto table = tiled::parseTileTable(*text);
  if (!table) throw CLI::ValidationError("--tiles", path + ":" + table.error());
  for (auto& [tileset, shapes] : *table) tiles[tileset].merge(shapes);
}

void addTileOptions(CLI::App& command, tiled::Options& options) {
  command
      .add_option_function<std::vector<std::string>>(
          "--tiles",
          [&options](const std::vector<std::string>& paths) {
            for (const std::string& path : paths) readTiles(path, options.tiles);
          },
          "A table of what tiles are by their numbers, if the game's own code\n"
          "says it: full, none, a polygon or one-way (docs/maps.md). May be\nrepeated")
      ->allow_extra_args(false)
      ->option_text("FILE");
}

void addFileOptions(CLI::App& command, tiled::Options& options) {
  command.add_flag("--all-maps", options.allMaps,
                   "A map of a world that cannot be read is an error; otherwise the\nothers are imported");
  command
      .add_option("--files-in", options.filesIn,
                  "Files that the map names must lie in this folder or below it;\notherwise in the folder of its "
                  "project (docs/maps.md)")
      ->option_text("FOLDER");
  command.add_flag("--files-anywhere", options.filesAnywhere,
                   "They may lie anywhere, and have any names. For maps that you\ntrust");
}

}  // namespace

void addImportOptions(CLI::App& command, tiled::Options& options) {
  const std::vector<CLI::Option*> before = command.get_options();
  addLayerOptions(command, options);
  addShapeOptions(command, options);
  addTileOptions(command, options);
  addBlockOptions(command, options);
  addFileOptions(command, options);
  for (CLI::Option* option : command.get_options()) {
    if (std::find(before.begin(), before.end(), option) == before.end()) option->group(kGroup);
  }
}

std::string importArguments(const CLI::App& command, std::span<const std::string_view> without) {
  std::string words;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group() != kGroup || option->count() == 0) continue;
    if (std::find(without.begin(), without.end(), option->get_name()) != without.end()) continue;
    if (option->get_expected_max() == 0) words += " " + option->get_name();
    for (const std::string& value : option->get_expected_max() == 0 ? std::vector<std::string>{} : option->results()) {
      words += " " + option->get_name() + " " + text::shellWord(value);
    }
  }
  return words;
}

std::string argumentsOf(const tiled::Suggestion& suggestion) {
  std::string text;
  for (const std::string& argument : suggestion.arguments)
    text += (text.empty() ? "" : " ") + text::shellWord(argument);
  return text;
}

std::string summaryOf(const std::string& report) {
  std::size_t end = report.find('\n') + 1;
  while (report.compare(end, 5, "  or:") == 0) end = report.find('\n', end) + 1;
  return report.substr(0, end);
}

}  // namespace lgs::cli
