#include "tileset.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::int64_t kMaxPixels = 1 << 20;   // of a tile
constexpr std::int64_t kMaxGid = 0x0FFF'FFFF;  // above are the flags for flipping
constexpr std::int64_t kMaxId = 0xFFFF'FFFF;

using Kind = CollisionObject::Kind;

/// Reads the kind of an object, and for Kind::unsupported the reason.
void readKind(const XmlFile& file, pugi::xml_node node, CollisionObject& object) {
  const auto leaveOut = [&](const char* reason) {
    object.kind = Kind::unsupported;
    object.unsupported = reason;
  };
  if (node.attribute("template")) return leaveOut("it comes from an object template: detach it in Tiled");
  if (node.attribute("gid")) return leaveOut("it is a tile object: draw a shape instead");
  if (node.child("point")) return leaveOut("a point has no area");
  if (node.child("polyline")) return leaveOut("a polyline has no area: draw a polygon instead");
  if (node.child("text")) return leaveOut("a text is no shape");
  if (const auto polygon = node.child("polygon")) {
    object.kind = Kind::polygon;
    object.points = file.points(polygon, "points");
    if (object.points.size() < 3) return leaveOut("the polygon has fewer than 3 vertices");
    if (object.points.size() > kMaxObjectVertices) return leaveOut("the polygon has more than 1024 vertices");
    return;
  }
  object.kind = node.child("ellipse") ? Kind::ellipse : node.child("capsule") ? Kind::capsule : Kind::rectangle;
  if (object.size.x <= 0 || object.size.y <= 0) leaveOut("it has no area: its width or height is 0");
}

CollisionObject readObject(const XmlFile& file, pugi::xml_node node, DoublePoint groupOffset) {
  CollisionObject object;
  object.id = static_cast<std::uint32_t>(file.integer(node, "id", 0, 0, kMaxId));
  object.className = classOf(node);
  object.at = {file.real(node, "x") + groupOffset.x, file.real(node, "y") + groupOffset.y};
  object.size = {file.real(node, "width"), file.real(node, "height")};
  object.rotation = file.real(node, "rotation");
  readKind(file, node, object);
  return object;
}

Tile readTile(const XmlFile& file, pugi::xml_node node) {
  Tile tile;
  tile.className = classOf(node);
  const auto image = node.child("image");
  const auto side = [&](const char* attribute) {
    const std::int64_t ofImage = file.integer(image, attribute, 0, 0, kMaxPixels);
    return static_cast<double>(file.integer(node, attribute, ofImage, 0, kMaxPixels));
  };
  tile.size = {side("width"), side("height")};
  for (const auto group : node.children("objectgroup")) {
    const DoublePoint offset{file.real(group, "offsetx"), file.real(group, "offsety")};
    for (const auto object : group.children("object")) tile.objects.push_back(readObject(file, object, offset));
  }
  return tile;
}

/// Reads what is in a <tileset> element, be it in the map or in a file of its own.
void readContent(const XmlFile& file, pugi::xml_node node, Tileset& tileset) {
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
  for (const auto tile : node.children("tile")) {
    const auto id = static_cast<std::uint32_t>(file.integer(tile, "id", std::nullopt, 0, kMaxGid));
    tileset.tiles.emplace(id, readTile(file, tile));
    if (file.failed()) return;
  }
}

}  // namespace

Tileset readTileset(const XmlFile& map, pugi::xml_node node, const FileReader& reader,
                    std::optional<ImportError>& error) {
  Tileset tileset;
  tileset.firstGid = static_cast<std::uint32_t>(map.integer(node, "firstgid", std::nullopt, 1, kMaxGid));
  std::string source = node.attribute("source").value();
  if (source.empty()) {
    readContent(map, node, tileset);
    return tileset;
  }
  if (source.ends_with(".tsj") || source.ends_with(".json")) {
    map.fail(node, "the tileset is in JSON: export it as TSX (XML) in Tiled");
    return tileset;
  }
  std::replace(source.begin(), source.end(), '\\', '/');
  const auto path = (std::filesystem::path(map.name()).parent_path() / source).lexically_normal();
  const XmlFile file(path.generic_string(), reader, "tileset", error);
  if (error && error->line == 0) {  // no line: the file could not be read, and the map is to blame for naming it
    std::string what = "the tileset's file " + error->file + " " + error->what;
    error.reset();
    map.fail(node, std::move(what));
  }
  if (!file.failed()) readContent(file, file.root(), tileset);
  return tileset;
}

}  // namespace lgs::tiled
