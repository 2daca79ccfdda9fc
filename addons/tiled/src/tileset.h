// Tilesets and the collision shapes of their tiles, just as the files have them.
#pragma once

#include "collision_object.h"
#include "words.h"

#include <unordered_map>

namespace lgs::tiled {

struct Tile : Called {
  DoublePoint size;                      ///< of its image, pixels
  std::vector<CollisionObject> objects;  ///< from the Tile Collision Editor
  bool isSettled = false;                ///< Options::tiles says what it is: no rule makes it a full square
};

struct Tileset {
  std::string name;
  std::uint32_t firstGid = 1;
  std::uint32_t tileCount = 0;                    ///< 0: unknown, any id may occur
  Tile plain;                                     ///< what a tile is for which the file has no <tile>
  DoublePoint offset;                             ///< by which tiles are drawn aside, pixels, y down
  bool fitToGrid = false;                         ///< images are scaled to the size of the map's tiles
  std::string alignment;                          ///< which point of a tile object is its place; empty: the default
  std::string missing;                            ///< why its file is not there; then no tile has shapes or properties
  std::unordered_map<std::uint32_t, Tile> tiles;  ///< by id; only those that the file has a <tile> for

  const Tile& tile(std::uint32_t id) const;
};

/// Gives a tile without shapes one that fills its image, if it is to be a full square. `layer` are the properties of its
/// layer. Returns whether it is.
bool squareAsAsked(Tile& tile, const Properties& layer, const Options& options);

/// Reads a <tileset> of a map or template, from another file if it names one.
Tileset readTileset(const XmlFile& map, pugi::xml_node node, Templates& templates, const TileTable& table);

/// Those of a map, by firstGid.
std::vector<Tileset> readTilesets(const XmlFile& map, Templates& templates, const TileTable& table);

/// The one that has a tile, by its number without flags; null if none has.
const Tileset* tilesetOf(const std::vector<Tileset>& tilesets, std::uint32_t number);

}  // namespace lgs::tiled
