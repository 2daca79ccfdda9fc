#include "map_objects.h"

#include "object_outline.h"

#include <utility>

namespace lgs::tiled {
namespace {

using Kind = CollisionObject::Kind;

MapShape leftOut(CollisionObject object, std::string reason) {
  object.kind = Kind::unsupported;
  object.unsupported = std::move(reason);
  return {std::move(object), {}};
}

/// Which point of a tile object is its place: the part of its width and height that lies left of it and below it.
DoublePoint anchor(const std::string& alignment) {
  if (alignment.empty() || alignment == "unspecified") return {0, 0};
  const auto has = [&](const char* word) { return alignment.find(word) != std::string::npos; };
  return {has("left") ? 0 : has("right") ? 1 : 0.5, has("bottom") ? 0 : has("top") ? 1 : 0.5};
}

}  // namespace

std::vector<MapShape> MapObjects::read(const Layer& layer) {
  std::vector<MapShape> shapes;
  const bool isOneWay = saysOneWay(layer.node);
  for (const auto node : layer.node.children("object")) {
    if (layer.isByProperty && !firstFit(options_.solidIf, propertiesOf(node))) continue;
    CollisionObject object = readObject(map_, node, layer.offset, source_.templates);
    if (map_.failed()) return {};
    if (!layer.classes.empty() && !layer.classes.contains(object.className) && !layer.classes.contains(object.name)) {
      continue;
    }
    object.oneWay |= isOneWay;
    object = asAsked(std::move(object), options_);
    if (object.kind == Kind::tile) {
      readTileObject(object, shapes);
      continue;
    }
    MapShape& shape = shapes.emplace_back(MapShape{std::move(object), {}});
    shape.outline = outline(shape.object);
    for (DoublePoint& p : shape.outline) p.y = -p.y;
  }
  const std::string ofLayer = classOf(layer.node);
  for (MapShape& shape : shapes) {
    if (shape.object.className.empty()) shape.object.className = ofLayer;
  }
  return shapes;
}

/// The tileset of a tile object; null if it has none. A problem is kept by the template.
const Tileset* MapObjects::tilesetOf(const CollisionObject& object) {
  Template* const origin = object.gidFrom;
  if (!origin) return source_.tilesets.of(tileNumber(object.gid));
  const auto node = origin->file.root().child("tileset");
  const auto [at, isNew] = source_.tilesetsOfTemplates.try_emplace(origin);
  if (isNew && node) {
    at->second = readTileset(origin->file, node, source_.reader, source_.templates, origin->error);
    settle(at->second, options_);
  }
  return node ? &at->second : nullptr;
}

void MapObjects::readTileObject(const CollisionObject& object, std::vector<MapShape>& shapes) {
  const std::uint32_t number = tileNumber(object.gid);
  const Tileset* const tileset = tilesetOf(object);
  if (object.gidFrom && object.gidFrom->error) {
    return shapes.push_back(leftOut(object, "its template " + message(*object.gidFrom->error)));
  }
  if (!tileset || number < tileset->firstGid) {
    return shapes.push_back(leftOut(object, "its tile belongs to no tileset"));
  }
  if (!budget_.tile(*tileset, number - tileset->firstGid)) return;
  Tile tile = tileAt(*tileset, number - tileset->firstGid);
  if (isLeftOut(tile, options_)) tile.objects.clear();
  if (isSolidAsAsked(tile, {}, options_)) tile.objects.push_back(fullSquare(tile));
  if (tile.objects.empty()) return shapes.push_back(leftOut(object, "its tile has no collision shapes"));
  const DoublePoint size{object.size.x > 0 ? object.size.x : tile.size.x,
                         object.size.y > 0 ? object.size.y : tile.size.y};
  ImageFrame frame{tile.size, flipsOf(object.gid), {1, 1}, {}};
  frame.scaleTo(size);
  frame.shift = {tileset->offset.x * frame.scale.x, tileset->offset.y * frame.scale.y};
  const DoublePoint part = anchor(tileset->alignment);
  for (CollisionObject& drawn : tile.objects) {
    drawn.hidden |= object.hidden;
    drawn.oneWay |= object.oneWay;
    drawn = asAsked(std::move(drawn), options_);
    if (!budget_.shape(drawn.points.size())) return;
    MapShape shape{drawn, outline(drawn)};
    shape.object.id = object.id;
    for (const std::string& name : {object.className, tile.className}) {
      if (shape.object.className.empty()) shape.object.className = name;
    }
    if (drawn.kind == Kind::tile) shape = leftOut(shape.object, "a shape of its tile is a tile object");
    for (DoublePoint& p : shape.outline) {
      const DoublePoint inBox = frame.toCell(p);
      const DoublePoint q = turned({inBox.x - part.x * size.x, part.y * size.y - inBox.y}, object.rotation);
      p = {object.at.x + q.x, -(object.at.y + q.y)};
    }
    shapes.push_back(std::move(shape));
  }
}

}  // namespace lgs::tiled
