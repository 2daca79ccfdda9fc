#include "ldtk_drawn.h"

#include "layers.h"
#include "ldtk.h"

#include <cmath>
#include <tuple>

namespace lgs::tiled {

DrawnLayers::DrawnLayers(const JsonReading& reading, const JsonPlace& root) : reading_(reading) {
  for (const JsonPlace& tileset : reading.objects(root["defs"]["tilesets"])) {
    tilesets_.emplace(reading.number(tileset["uid"], 0), tileset);
  }
}

DrawnLayers::Set* DrawnLayers::setOf(const JsonPlace& layer) {
  const double tileset = reading_.number(layer["__tilesetDefUid"], 0);
  const auto [at, isNew] = sets_.try_emplace({reading_.number(layer["layerDefUid"], 0), tileset});
  if (isNew) {
    at->second = {(kMaxLdtkSets + sets_.size()) * kLdtkSetSize,
                  layer.text("__identifier"),
                  reading_.number(layer["__gridSize"], 0),
                  tileset,
                  {}};
  }
  if (sets_.size() <= kMaxLdtkSets) return &at->second;
  sets_.erase(at);
  return nullptr;
}

/// A layer that cannot be solid says why, for whoever asks.
void DrawnLayers::read(const JsonPlace& layer, pugi::xml_node to) {
  const double side = reading_.number(layer["__gridSize"], 0);
  setAttribute(to, kDrawnAttribute, "1");
  setAttribute(to, kLdtkGridAttribute, numberText(side));
  Set* const set = setOf(layer);
  if (!set) return setAttribute(to, kLdtkNotSolidAttribute, "is one layer of tiles too many to be solid");
  const auto tileset = tilesets_.find(set->tileset);
  const double tileSide = tileset == tilesets_.end() ? side : reading_.number(tileset->second["tileGridSize"], side);
  if (tileSide != side) {
    setAttribute(to, kLdtkNotSolidAttribute,
                 "has tiles of " + numberText(tileSide) + " px on a grid of " + numberText(side) +
                     " px. Only tiles as large as the grid can be solid");
  }
  setAttribute(to, "width", "0");  // each tile is a chunk, as several may lie in one cell
  setAttribute(to, "height", "0");
  const pugi::xml_node data = addElement(to, "data", layer);
  setAttribute(data, "encoding", "csv");
  std::set<std::tuple<double, double, double>> known;
  std::uint64_t astray = 0;
  for (const char* list : {"gridTiles", "autoLayerTiles"}) {
    for (const JsonPlace& tile : reading_.objects(layer[list])) {
      const std::vector<JsonPlace> px = reading_.elements(tile["px"]);
      const double id = reading_.number(tile["t"]);
      if (px.size() != 2 || !(id >= 0 && id < kLdtkSetSize && id == std::floor(id))) {
        return reading_.fail(
            tile, "should have two numbers 'px', and a tile 't' from 0 to " + std::to_string(kLdtkSetSize - 1));
      }
      const double column = reading_.number(px[0]) / side, row = reading_.number(px[1]) / side;
      if (column != std::floor(column) || row != std::floor(row)) {
        ++astray;
      } else if (known.insert({column, row, id}).second) {
        const auto number = static_cast<std::uint64_t>(id);
        set->tiles.insert(number);
        const pugi::xml_node chunk = addElement(data, "chunk", tile);
        setAttribute(chunk, "x", numberText(column));
        setAttribute(chunk, "y", numberText(row));
        setAttribute(chunk, "width", "1");
        setAttribute(chunk, "height", "1");
        chunk.text() = std::to_string(set->firstGid + number).c_str();
      }
    }
  }
  if (astray > 0) setAttribute(to, kRemarkAttribute, std::to_string(astray) + " tiles beside the grid are left out");
}

void DrawnLayers::writeTilesets(pugi::xml_node map, const std::map<std::string, std::uint64_t>& names) const {
  for (const auto& [key, set] : sets_) {
    pugi::xml_node node = map.append_child("tileset");
    const std::string side = numberText(set.grid);
    std::string name = set.layer;
    while (names.contains(name)) name.insert(0, set.layer + ".");
    setAttribute(node, kLdtkDrawnAttribute, name);
    setAttribute(node, "name", set.layer);
    setAttribute(node, "firstgid", std::to_string(set.firstGid));
    setAttribute(node, "tilewidth", side);
    setAttribute(node, "tileheight", side);
    writeTiles(node, set);
  }
}

/// The class of all tiles is their layer. A tile has its tags as properties.
void DrawnLayers::writeTiles(pugi::xml_node to, const Set& set) const {
  std::map<std::uint64_t, pugi::xml_node> tiles;
  for (const std::uint64_t id : set.tiles) {
    pugi::xml_node tile = tiles[id] = to.append_child("tile");
    setAttribute(tile, "id", std::to_string(id));
    setAttribute(tile, "class", to.attribute(kLdtkDrawnAttribute).value());
  }
  const auto tileset = tilesets_.find(set.tileset);
  if (tileset == tilesets_.end()) return;
  for (const JsonPlace& tag : reading_.objects(tileset->second["enumTags"])) {
    for (const JsonPlace& id : reading_.elements(tag["tileIds"])) {
      const double number = reading_.number(id);
      const auto tile =
          tiles.find(number >= 0 && number < kLdtkSetSize ? static_cast<std::uint64_t>(number) : kLdtkSetSize);
      if (tile != tiles.end()) addProperty(tile->second, tag.text("enumValueId"), true);
    }
  }
}

}  // namespace lgs::tiled
