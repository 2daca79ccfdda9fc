// The objects of object layers: which outlines they have on the map.
#include "parts.h"

#include <utility>

namespace lgs::tiled {
namespace {

using Kind = CollisionObject::Kind;

/// Which point of a tile object is its place: the part of its width and height that lies left of it and below it.
DoublePoint anchor(const std::string& alignment) {
  if (alignment.empty() || alignment == "unspecified") return {0, 0};
  const auto has = [&](const char* word) { return alignment.find(word) != std::string::npos; };
  return {has("left") ? 0 : has("right") ? 1 : 0.5, has("bottom") ? 0 : has("top") ? 1 : 0.5};
}

/// The tileset of a tile object; null if it has none. A problem is kept by the template.
const Tileset* tilesetOf(const CollisionObject& object, MapSource& source, const Options& options) {
  Template* const origin = object.gidFrom;
  if (!origin) return source.tilesets.of(tileNumber(object.gid));
  const auto node = origin->file.root().child("tileset");
  const auto [at, isNew] = source.tilesetsOfTemplates.try_emplace(origin);
  if (isNew && node) {
    at->second = readTileset(origin->file, node, source.templates);
    reshape(at->second, options.tiles);
  }
  return node ? &at->second : nullptr;
}

/// Gives the shapes of a tile object.
void readTileObject(CollisionObject object, MapSource& source, const Options& options, Budget& budget,
                    const ShapeSink& sink) {
  const auto leftOut = [&](std::string reason) {
    leaveOut(object, std::move(reason));
    sink(object, {});
  };
  const std::uint32_t number = tileNumber(object.gid);
  const Tileset* const tileset = tilesetOf(object, source, options);
  if (object.gidFrom && object.gidFrom->error) return leftOut("its template " + message(*object.gidFrom->error));
  if (!tileset || number < tileset->firstGid) return leftOut("its tile belongs to no tileset");
  if (!budget.tile(*tileset, number - tileset->firstGid)) return;
  Tile tile = tileAt(*tileset, number - tileset->firstGid);
  if (isLeftOut(tile, options)) tile.objects.clear();
  squareAsAsked(tile, {}, options);
  if (tile.objects.empty()) return leftOut("its tile has no collision shapes");
  const DoublePoint size{object.size.x > 0 ? object.size.x : tile.size.x,
                         object.size.y > 0 ? object.size.y : tile.size.y};
  ImageFrame frame{tile.size, flipsOf(object.gid), {1, 1}, {}};
  frame.scaleTo(size);
  frame.shift = {tileset->offset.x * frame.scale.x, tileset->offset.y * frame.scale.y};
  const DoublePoint part = anchor(tileset->alignment);
  for (CollisionObject& drawn : tile.objects) {
    drawn.hidden |= object.hidden;
    CollisionObject shape = asAsked(drawn, options);
    if (!budget.shape(shape.points.size())) return;
    std::vector<Outline> all = outlines(shape);
    for (Outline& outline : all) {
      for (DoublePoint& p : outline) {
        const DoublePoint inBox = frame.toCell(p);
        const DoublePoint q = turned({inBox.x - part.x * size.x, part.y * size.y - inBox.y}, object.rotation);
        p = {object.at.x + q.x, -(object.at.y + q.y)};
      }
    }
    shape.id = object.id;
    for (const std::string& name : {object.className, tile.className})
      if (shape.className.empty()) shape.className = name;
    if (shape.kind == Kind::tile) leaveOut(shape, "a shape of its tile is a tile object");
    sink(shape, all);
  }
}

}  // namespace

void readObjects(MapSource& source, const Layer& layer, const Options& options, Budget& budget, const ShapeSink& sink) {
  for (const auto node : layer.node.children("object")) {
    CollisionObject object = readObject(*source.file, node, layer.offset, source.templates);
    if (source.file->failed()) return;
    if (layer.isPicked && !isPicked(options, object.className, object.name, object.properties)) continue;
    object = asAsked(std::move(object), options);
    if (object.kind == Kind::tile) {
      readTileObject(std::move(object), source, options, budget, sink);
      continue;
    }
    std::vector<Outline> all = outlines(object);
    for (Outline& outline : all)
      for (DoublePoint& p : outline) p.y = -p.y;
    sink(object, all);
  }
}

}  // namespace lgs::tiled
