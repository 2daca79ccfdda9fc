// Maps of Tiled and LDtk. JavaScript has the files, and gives them when they are asked for.
#include "bridge.h"

#include <lgs/tiled/import.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace lgs::web {

/// Functions that JavaScript has. They write bytes into the input buffer, and return their number, or -1 if there is no
/// such file.
__attribute__((import_module("lgs"), import_name("readFile"))) std::int32_t readFileInJavaScript(const char* path,
                                                                                                 std::size_t length);
__attribute__((import_module("lgs"), import_name("listFolder"))) std::int32_t listFolderInJavaScript(
    const char* path, std::size_t length);

namespace {

using Json = nlohmann::json;

std::string inputText(std::size_t bytes) {
  const auto in = input<std::byte>(bytes);
  return {reinterpret_cast<const char*>(in.data()), in.size()};
}

tl::expected<std::string, std::string> readFile(const std::string& path) {
  const std::int32_t bytes = readFileInJavaScript(path.data(), path.size());
  if (bytes < 0) return tl::unexpected<std::string>("there is no such file among those that were given");
  return inputText(static_cast<std::size_t>(bytes));
}

tl::expected<std::vector<std::string>, std::string> listFolder(const std::string& path) {
  const std::int32_t bytes = listFolderInJavaScript(path.data(), path.size());
  std::vector<std::string> names(1);
  for (const char c : inputText(static_cast<std::size_t>(std::max(bytes, 0)))) {
    if (c == '\n')
      names.emplace_back();
    else
      names.back() += c;
  }
  return names;
}

/// JavaScript has checked what is in the options, but for the table of tiles.
tiled::Options optionsOf(const Json& json) {
  tiled::Options options;
  options.tolerance = json.value("tolerance", options.tolerance);
  options.solidWithoutShapes = json.value("solid", false);
  options.solidIf = json.value("solidIf", options.solidIf);
  const std::string from = json.value("block", "one");
  options.blockFrom = from == "class"   ? tiled::BlockFrom::tileClass
                      : from == "name"  ? tiled::BlockFrom::name
                      : from == "layer" ? tiled::BlockFrom::layer
                                        : tiled::BlockFrom::one;
  options.blocks = json.value("numbers", options.blocks);
  options.layers = json.value("layers", options.layers);
  if (json.contains("objects")) options.objects = json["objects"].get<std::vector<std::string>>();
  options.leaveOut = json.value("not", options.leaveOut);
  options.allMaps = json.value("allMaps", false);
  options.visibleOnly = json.value("visible", false);
  options.polylineThickness = json.value("polylineThickness", 0.0);
  options.filesAnywhere = true;  // JavaScript was given the files: there are no others
  return options;
}

void putText(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  answerBytes().assign(bytes.begin(), bytes.end());
}

}  // namespace

/// The input has the path, and then the options as JSON. Returns the number of bytes in the answer: a JSON object, with
/// `error` and `line` if the map is refused; otherwise with the report, the names of blocks and tiles, and how long the
/// other answer is. That has numbers: for each shape the number of its vertices and these in cells, and then for each
/// placement i, j, shape, block, tile (-1: none), object, layer.
LGS_EXPORT("importMap") std::size_t importMap(std::size_t pathBytes, std::size_t optionBytes) {
  const std::string arguments = inputText(pathBytes + optionBytes);
  const Json asked = Json::parse(arguments.substr(pathBytes), nullptr, false);
  const auto told = [](const Json& json) {
    putText(json.dump(-1, ' ', false, Json::error_handler_t::replace));
    return answerBytes().size();
  };
  tiled::Options options = optionsOf(asked);
  if (asked.contains("tiles")) {
    auto table = tiled::parseTileTable(asked["tiles"].get<std::string>());
    if (!table) return told({{"error", "options.tiles:" + table.error()}, {"line", 0}});
    options.tiles = std::move(*table);
  }
  const auto map = tiled::importMap(arguments.substr(0, pathBytes), options, readFile, listFolder);
  if (!map) return told({{"error", tiled::message(map.error())}, {"line", map.error().line}});

  auto& numbers = answer();
  numbers.clear();
  for (const auto& shape : map->shapes) {
    numbers.push_back(static_cast<double>(shape.size()));
    for (const LocalPoint v : shape) numbers.insert(numbers.end(), {cellsOf(v.x), cellsOf(v.y)});
  }
  for (const tiled::MapPolygon& p : map->placements)
    numbers.insert(numbers.end(),
                   {static_cast<double>(p.cell.i), static_cast<double>(p.cell.j), static_cast<double>(p.shape),
                    static_cast<double>(p.block), p.tile == tiled::kNoTile ? -1.0 : static_cast<double>(p.tile),
                    static_cast<double>(p.object), static_cast<double>(p.layer)});
  Json tiles = Json::array(), layers = Json::array(), suggestions = Json::array();
  for (const auto& tile : map->report.tiles)
    tiles.push_back({{"tileset", tile.tileset}, {"id", tile.id}, {"class", tile.className}});
  for (const auto& layer : map->report.layers) layers.push_back(layer.path);
  for (const auto& suggestion : map->report.suggestions)
    suggestions.push_back(std::to_string(suggestion.polygons) + " polygons: " + suggestion.text);
  return told({{"shapes", map->shapes.size()},
               {"placements", map->placements.size()},
               {"numbers", numbers.size()},
               {"blocks", map->blocks},
               {"tiles", std::move(tiles)},
               {"layers", std::move(layers)},
               {"partial", map->report.partial},
               {"suggestions", std::move(suggestions)},
               {"report", tiled::toText(map->report)}});
}

}  // namespace lgs::web
