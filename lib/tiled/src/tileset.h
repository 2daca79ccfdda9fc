// Tilesets and the collision shapes of their tiles, just as the files have them.
#pragma once

#include "xml.h"

#include <unordered_map>

namespace lgs::tiled {

/// A shape from the Tile Collision Editor, in pixels from the upper left corner of the tile's image, y down.
struct CollisionObject {
  enum class Kind : std::uint8_t { rectangle, polygon, ellipse, capsule, unsupported };
  std::uint32_t id = 0;
  Kind kind = Kind::rectangle;
  std::string unsupported;  ///< the reason, for Kind::unsupported
  std::string className;
  DoublePoint at;
  DoublePoint size;
  double rotation = 0;              ///< degrees, clockwise, around `at`
  std::vector<DoublePoint> points;  ///< of a polygon, relative to `at`
};

struct Tile {
  std::string className;
  DoublePoint size;  ///< of its image, pixels; 0: that of the tileset's tiles
  std::vector<CollisionObject> objects;
};

struct Tileset {
  std::string name;
  std::uint32_t firstGid = 1;
  std::uint32_t tileCount = 0;  ///< 0: unknown, any id may occur
  DoublePoint tileSize;
  DoublePoint offset;                             ///< by which tiles are drawn aside, pixels, y down
  bool fitToGrid = false;                         ///< images are scaled to the size of the map's tiles
  std::unordered_map<std::uint32_t, Tile> tiles;  ///< by id; only those that the file has a <tile> for
};

/// Reads a <tileset> of a map, from another file if it names one. `error` is that of the import; it keeps a problem.
Tileset readTileset(const XmlFile& map, pugi::xml_node node, const FileReader& reader,
                    std::optional<ImportError>& error);

}  // namespace lgs::tiled
