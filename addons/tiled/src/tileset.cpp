#include "tileset.h"

#include "tile_table.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::int64_t kMaxPixels = 1 << 20;     // of a tile
constexpr std::int64_t kMaxGid = 0x0FFF'FFFF;    // above are the flags for flipping
constexpr std::string_view kInsideTiled = ":/";  // begins the names of files that Tiled has in itself, without shapes

Tile readTile(const XmlFile& file, pugi::xml_node node, Templates& templates) {
  Tile tile;
  tile.className = classOf(node);
  tile.properties = propertiesOf(node);
  if (!tile.className.empty()) tile.properties.emplace("class", tile.className);
  const bool isOneWay = saysOneWay(node);
  const auto image = node.child("image");
  const auto side = [&](const char* attribute) {
    const std::int64_t ofImage = file.integer(image, attribute, 0, 0, kMaxPixels);
    return static_cast<double>(file.integer(node, attribute, ofImage, 0, kMaxPixels));
  };
  tile.size = {side("width"), side("height")};
  for (const auto group : node.children("objectgroup")) {
    const DoublePoint offset{file.real(group, "offsetx"), file.real(group, "offsety")};
    for (const auto object : group.children("object")) {
      tile.objects.push_back(readObject(file, object, offset, templates));
      tile.objects.back().oneWay |= isOneWay;
    }
  }
  return tile;
}

/// Reads what is in a <tileset> element, be it in the map or in a file of its own.
void readContent(const XmlFile& file, pugi::xml_node node, Templates& templates, Tileset& tileset) {
  tileset.name = node.attribute("name").value();
  if (tileset.name.empty()) tileset.name = std::filesystem::path(file.name()).stem().string();
  tileset.tileSize = {static_cast<double>(file.integer(node, "tilewidth", std::nullopt, 1, kMaxPixels)),
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
    tileset.tiles.emplace(id, readTile(file, tile, templates));
    if (file.failed()) return;
  }
}

}  // namespace

Tileset readTileset(const XmlFile& map, pugi::xml_node node, const FileReader& reader, Templates& templates,
                    std::optional<ImportError>& error) {
  Tileset tileset;
  tileset.firstGid = static_cast<std::uint32_t>(map.integer(node, "firstgid", std::nullopt, 1, kMaxGid));
  const std::string source = node.attribute("source").value();
  if (source.empty()) {
    readContent(map, node, templates, tileset);
    return tileset;
  }
  if (map.failed() || source.starts_with(kInsideTiled)) return tileset;
  const XmlFile file(map, source, reader, "tileset", error);
  if (error && !file.wasRead()) {  // the map is to blame for naming it
    std::string what = "the tileset's file " + error->file + " " + error->what;
    error.reset();
    const bool isOfMap = std::string_view(map.root().name()) == "map";
    if (!file.isMissing() || !isOfMap) map.fail(node, std::move(what));
    tileset.name = std::filesystem::path(source).stem().string();
    tileset.missing = std::move(what);
    for (auto [side, attribute] : {std::pair(&tileset.tileSize.x, "tilewidth"), {&tileset.tileSize.y, "tileheight"}})
      *side = static_cast<double>(map.integer(map.root(), attribute, 0, 0, kMaxPixels));
    return tileset;
  }
  if (!file.failed()) readContent(file, file.root(), templates, tileset);
  return tileset;
}

Tile tileAt(const Tileset& tileset, std::uint32_t id) {
  const auto found = tileset.tiles.find(id);
  Tile tile = found == tileset.tiles.end() ? Tile{} : found->second;
  if (tile.size.x == 0 || tile.size.y == 0) tile.size = tileset.tileSize;
  return tile;
}

bool isSolidAsAsked(const Tile& tile, const Properties& layer, const Options& options) {
  return !tile.isSettled && !isLeftOut(tile, options) && tile.objects.empty() &&
         (options.solidWithoutShapes || firstFit(options.solidIf, tile.properties) != nullptr ||
          firstFit(options.solidIf, layer) != nullptr);
}

CollisionObject fullSquare(const Tile& tile) {
  CollisionObject square;
  square.size = tile.size;
  return square;
}

void Tilesets::read(const XmlFile& map, const FileReader& reader, Templates& templates,
                    std::optional<ImportError>& error) {
  std::map<std::uint32_t, std::string> names;  // by firstGid
  for (const auto node : map.root().children("tileset")) {
    tilesets_.push_back(readTileset(map, node, reader, templates, error));
    if (map.failed()) return;
    const Tileset& last = tilesets_.back();
    const auto [same, isNew] = names.try_emplace(last.firstGid, last.name);
    if (!isNew) return map.fail(node, "has the same firstgid as the tileset '" + same->second + "'");
  }
  std::sort(tilesets_.begin(), tilesets_.end(),
            [](const Tileset& a, const Tileset& b) { return a.firstGid < b.firstGid; });
}

void settle(Tileset& tileset, const Options& options) { reshape(tileset, options.tiles); }

bool isLeftOut(const Tile& tile, const Options& options) {
  return isLeftOut(options, tile.className, "", tile.properties);
}

void Tilesets::settle(const Options& options) {
  for (Tileset& tileset : tilesets_) tiled::settle(tileset, options);
}

const Tileset* Tilesets::of(std::uint32_t number) const {
  const auto next = std::upper_bound(tilesets_.begin(), tilesets_.end(), number,
                                     [](std::uint32_t n, const Tileset& t) { return n < t.firstGid; });
  if (next == tilesets_.begin()) return nullptr;
  const Tileset& tileset = *(next - 1);
  return tileset.tileCount == 0 || number - tileset.firstGid < tileset.tileCount ? &tileset : nullptr;
}

}  // namespace lgs::tiled
