// Tilesets and the collision shapes of their tiles, as the files say; nothing is interpreted here.
#pragma once

#include "xml.h"

#include <unordered_map>

namespace lgs::tiled {

/// A shape from the Tile Collision Editor: pixels from the upper left corner of the tile's image, y down.
struct CollisionObject {
  enum class Kind : std::uint8_t { rectangle, polygon, ellipse, capsule, unsupported };
  std::uint32_t id = 0;
  Kind kind = Kind::rectangle;
  std::string unsupported;  ///< why it cannot be used, if it cannot
  std::string className;
  DoublePoint at;
  DoublePoint size;
  double rotation = 0;              ///< degrees, clockwise, around `at`
  std::vector<DoublePoint> points;  ///< of a polygon, from `at`
};

struct Tile {
  std::string className;
  DoublePoint size;  ///< of its image in pixels; 0: the tileset's
  std::vector<CollisionObject> objects;
};

struct Tileset {
  std::string name;
  std::uint32_t firstGid = 1;
  std::uint32_t tileCount = 0;  ///< 0: any id may occur (a collection of images, or not said)
  DoublePoint tileSize;
  DoublePoint offset;                             ///< of the drawing, pixels, y down
  bool fitToGrid = false;                         ///< images are scaled to the size of the map's tiles
  std::unordered_map<std::uint32_t, Tile> tiles;  ///< those with anything special
};

/// Reads a <tileset> of a map, from its file if it names one. Problems are kept in the import's error.
Tileset readTileset(const XmlFile& map, pugi::xml_node node, const FileReader& reader,
                    std::optional<ImportError>& error);

}  // namespace lgs::tiled
