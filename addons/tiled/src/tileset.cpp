#include "tileset.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::int64_t kMaxPixels = 1 << 20;     // of a tile
constexpr std::int64_t kMaxGid = 0x0FFF'FFFF;    // above are the flags for flipping
constexpr std::string_view kInsideTiled = ":/";  // begins the names of files that Tiled has in itself, without shapes

Tile readTile(const XmlFile& file, pugi::xml_node node, Templates& templates) {
  Tile tile;
  static_cast<Called&>(tile) = {classOf(node), "", propertiesOf(node)};
  if (!tile.className.empty()) tile.properties.emplace("class", tile.className);
  const auto image = node.child("image");
  const auto side = [&](const char* attribute) {
    const std::int64_t ofImage = file.integer(image, attribute, 0, 0, kMaxPixels);
    return static_cast<double>(file.integer(node, attribute, ofImage, 0, kMaxPixels));
  };
  tile.size = {side("width"), side("height")};
  for (const auto group : node.children("objectgroup")) {
    const DoublePoint offset{file.real(group, "offsetx"), file.real(group, "offsety")};
    for (const auto object : group.children("object"))
      tile.objects.push_back(readObject(file, object, offset, templates));
  }
  return tile;
}

/// Reads what is in a <tileset> element, be it in the map or in a file of its own.
void readContent(const XmlFile& file, pugi::xml_node node, Templates& templates, Tileset& tileset) {
  tileset.name = node.attribute("name").value();
  if (tileset.name.empty()) tileset.name = std::filesystem::path(file.name()).stem().string();
  tileset.plain.size = {static_cast<double>(file.integer(node, "tilewidth", std::nullopt, 1, kMaxPixels)),
                        static_cast<double>(file.integer(node, "tileheight", std::nullopt, 1, kMaxPixels))};
  if (node.child("image")) {
    tileset.tileCount = static_cast<std::uint32_t>(file.integer(node, "tilecount", 0, 0, kMaxGid));
  }
  const auto offset = node.child("tileoffset");
  tileset.offset = {file.real(offset, "x"), file.real(offset, "y")};
  tileset.fitToGrid = std::string_view(node.attribute("tilerendersize").value()) == "grid";
  tileset.alignment = node.attribute("objectalignment").value();
  for (const auto tile : node.children("tile")) {
    const auto id = static_cast<std::uint32_t>(file.integer(tile, "id", std::nullopt, 0, kMaxGid));
    Tile& read = tileset.tiles.emplace(id, readTile(file, tile, templates)).first->second;
    if (read.size.x == 0 || read.size.y == 0) read.size = tileset.plain.size;
    if (file.failed()) return;
  }
}

constexpr std::int64_t kMaxTiles = 1 << 16;  // of a table

/// "3", "60-63" or "0,39,60-63"; none if it is something else.
std::vector<std::uint32_t> idsIn(std::string_view text) {
  std::vector<std::uint32_t> ids;
  for (const std::string_view part : split(text, ",")) {
    const auto ends = split(part, "-");
    const auto from = parseInteger(ends.front()), to = parseInteger(ends.back());
    if (ends.size() > 2 || !from || !to || *from < 0 || *to > kMaxGid || *to < *from || *to - *from >= kMaxTiles)
      return {};
    for (std::int64_t id = *from; id <= *to; ++id) ids.push_back(static_cast<std::uint32_t>(id));
  }
  return ids;
}

/// A decimal, or a fraction of two.
std::optional<double> numberIn(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, "/");
  const auto over = parseReal(parts.front()), under = parts.size() == 1 ? std::optional(1.0) : parseReal(parts.back());
  constexpr double kMost = 1e6;
  if (parts.size() > 2 || !over || !under || *under <= 0 || std::abs(*over) > kMost || *under > kMost) return {};
  return *over / *under;
}

tl::expected<TileShape, std::string> shapeIn(std::string_view text) {
  constexpr std::string_view kOneWay = "oneway ";
  TileShape shape;
  if (text == "none") return shape;
  if (text == "full") text = "0 0 1 0 1 1 0 1";
  shape.oneWay = text.starts_with(kOneWay);
  std::vector<double> numbers;
  for (const std::string_view part : split(text.substr(shape.oneWay ? kOneWay.size() : 0), " \t,")) {
    if (part.empty()) continue;
    const auto number = numberIn(part);
    if (!number)
      return tl::unexpected<std::string>(
          "should say full, none, oneway with x y of two points or more, or x y of three or more");
    numbers.push_back(*number);
  }
  const std::size_t least = shape.oneWay ? 2 : 3;
  if (numbers.size() % 2 != 0 || numbers.size() / 2 < least || numbers.size() / 2 > kMaxObjectVertices)
    return tl::unexpected(concat("should have x y of ", least, " points or more"));
  for (std::size_t k = 0; k < numbers.size(); k += 2) shape.outline.push_back({numbers[k], numbers[k + 1]});
  return shape;
}

/// Gives each tile that a table names the shape that the table says, instead of its own ones.
void reshape(Tileset& tileset, const TileTable& table) {
  for (const std::string& name : {std::string(), tileset.name}) {
    const auto rows = table.find(name);
    if (rows == table.end()) continue;
    for (const auto& [id, shape] : rows->second) {
      Tile& tile = tileset.tiles.try_emplace(id, tileset.plain).first->second;
      tile.objects.clear();
      tile.isSettled = true;
      if (shape.outline.empty()) continue;
      CollisionObject& object = tile.objects.emplace_back();
      object.kind = shape.oneWay ? CollisionObject::Kind::polyline : CollisionObject::Kind::polygon;
      if (shape.oneWay && tile.className.empty()) object.className = "one-way";
      for (const DoublePoint p : shape.outline) object.points.push_back({p.x * tile.size.x, (1 - p.y) * tile.size.y});
    }
  }
}

}  // namespace

Tileset readTileset(const XmlFile& map, pugi::xml_node node, Templates& templates, const TileTable& table) {
  Tileset tileset;
  tileset.firstGid = static_cast<std::uint32_t>(map.integer(node, "firstgid", std::nullopt, 1, kMaxGid));
  const std::string source = node.attribute("source").value();
  if (source.empty()) {
    readContent(map, node, templates, tileset);
  } else if (!map.failed() && !source.starts_with(kInsideTiled)) {
    const XmlFile file(map, source, "tileset", map.error());
    if (std::string what = file.takeReason("tileset"); !what.empty()) {
      const bool isOfMap = std::string_view(map.root().name()) == "map";
      if (!isOfMap || !(file.isMissing() || file.isRefused())) map.fail(node, std::move(what));
      tileset.name = std::filesystem::path(source).stem().string();
      tileset.missing = std::move(what);
      const auto side = [&](const char* attribute) { return map.integer(map.root(), attribute, 0, 0, kMaxPixels); };
      tileset.plain.size = {static_cast<double>(side("tilewidth")), static_cast<double>(side("tileheight"))};
    } else if (!file.failed()) {
      readContent(file, file.root(), templates, tileset);
    }
  }
  reshape(tileset, table);
  return tileset;
}

const Tile& Tileset::tile(std::uint32_t id) const {
  const auto found = tiles.find(id);
  return found == tiles.end() ? plain : found->second;
}

bool squareAsAsked(Tile& tile, const Properties& layer, const Options& options) {
  if (tile.isSettled || isLeftOut(tile, options) || !tile.objects.empty()) return false;
  if (!options.solidWithoutShapes && !firstFit(options.solidIf, tile.properties) && !firstFit(options.solidIf, layer))
    return false;
  tile.objects.emplace_back().size = tile.size;
  return true;
}

std::vector<Tileset> readTilesets(const XmlFile& map, Templates& templates, const TileTable& table) {
  std::vector<Tileset> tilesets;
  std::map<std::uint32_t, std::string> names;  // by firstGid; as the map has them
  for (const auto node : map.root().children("tileset")) {
    tilesets.push_back(readTileset(map, node, templates, table));
    if (map.failed()) break;
    const auto [same, isNew] = names.try_emplace(tilesets.back().firstGid,
                                                 node.attribute(node.attribute("source") ? "source" : "name").value());
    if (!isNew) map.fail(node, "has the same firstgid as the tileset" + map.quoted(" ", same->second));
  }
  std::sort(tilesets.begin(), tilesets.end(), [](const auto& a, const auto& b) { return a.firstGid < b.firstGid; });
  return tilesets;
}

const Tileset* tilesetOf(const std::vector<Tileset>& tilesets, std::uint32_t number) {
  const auto next = std::upper_bound(tilesets.begin(), tilesets.end(), number,
                                     [](std::uint32_t n, const Tileset& t) { return n < t.firstGid; });
  if (next == tilesets.begin()) return nullptr;
  const Tileset& tileset = *(next - 1);
  return tileset.tileCount == 0 || number - tileset.firstGid < tileset.tileCount ? &tileset : nullptr;
}

tl::expected<TileTable, std::string> parseTileTable(std::string_view text) {
  TileTable table;
  std::string tileset;  // "" for any
  std::int64_t tiles = 0, number = 0;
  bool hasHead = false;
  constexpr const char* kNoHead = "should begin with \"lgs-tiles 1\"";
  for (std::string_view line : split(text, "\n")) {
    ++number;
    const auto bad = [&](const auto&... what) { return tl::unexpected(concat(number, ": ", what...)); };
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    if (!hasHead && line != "lgs-tiles 1") return bad(kNoHead);
    if (!std::exchange(hasHead, true)) continue;
    const std::string_view first = line.substr(0, line.find_first_of(" \t")), rest = trimmed(line.substr(first.size()));
    if (first == "tileset") {
      tileset = rest;
      continue;
    }
    const std::vector<std::uint32_t> ids = idsIn(first);
    if (ids.empty())
      return bad("should begin with the numbers of tiles, such as 3 or 0,5,60-63, or with \"tileset NAME\"");
    const auto shape = shapeIn(rest);
    if (!shape) return bad(shape.error());
    for (const std::uint32_t id : ids)
      if (!table[tileset].emplace(id, *shape).second) return bad("tile ", id, " has a row already");
    tiles += static_cast<std::int64_t>(ids.size());
    if (tiles > kMaxTiles) return bad("has more than ", kMaxTiles, " tiles");
  }
  if (!hasHead) return tl::unexpected(std::string("1: ") + kNoHead);
  return table;
}

}  // namespace lgs::tiled
