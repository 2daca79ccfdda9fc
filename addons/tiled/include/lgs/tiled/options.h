// What to import of a map, and how.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lgs::tiled {

/// Where a polygon's block comes from.
enum class BlockFrom : std::uint8_t {
  one,        ///< every polygon gets block 1; but in an LDtk project a cell gets its value, and each kind of entity a
              ///< block of its own, as with tileClass, whose names are those of values and entities
  tileClass,  ///< the class of the collision object ("type" before Tiled 1.9); if it has none, that of its tile or, in
              ///< an object layer, of its layer
  name,       ///< the name of the collision object; if it has none, as tileClass
  layer,      ///< the path of the layer, "Group/Layer", without that of its map in a world or of its level
};

/// What a tile is by the code of a game, which its maps do not say.
struct TileShape {
  std::vector<DoublePoint> outline;  ///< in tiles, from the tile's lower left corner, y up; empty: it is not solid
  bool oneWay = false;               ///< the outline is an open polyline, for Options::polylineThickness
};

/// Shapes by the name of the tileset ("" for any) and the number of the tile in it, from 0.
using TileTable = std::map<std::string, std::map<std::uint32_t, TileShape>>;

/// What to import, and how. The defaults suit most maps.
///
/// Without solidWithoutShapes, solidIf, objects and tiles the map itself decides what is solid: docs/maps.md, "What is
/// taken without options". `layers` narrows where that is looked for, and the next best choice is tried as well, so that
/// takes twice as long. With any of the four nothing is chosen: they hold, and so do the shapes of tiles.
struct Options {
  double tolerance = 1.0;           ///< pixels, finite, 0 or more; at most a quarter of a tile is used
  bool solidWithoutShapes = false;  ///< a tile without any collision object is a full square (true) or empty (false)

  /// Properties, "NAME" or "NAME=VALUE". A tile without any collision object is a full square if it or its layer has
  /// one of them. "NAME" alone takes any value but "false" and "0". A tile has its class as a property "class", and a
  /// layer its path as "layer", also for its tile objects. Unless `objects` names some, objects that have such a property
  /// are taken from any object layer. The report names properties and values that nothing has.
  std::vector<std::string> solidIf = {};

  TileTable tiles = {};  ///< shapes of tiles by their numbers; they replace those in the tileset

  /// What is not solid: classes of tiles and values of IntGrid layers, classes and names of shapes and objects, names
  /// of layers, and properties of all of these, as "NAME=VALUE".
  std::vector<std::string> leaveOut = {};

  BlockFrom blockFrom = BlockFrom::one;  ///< where blocks come from

  /// The block for each class, object's name or layer; unused with BlockFrom::one. "" stands for no class. Other names
  /// get the least unused numbers from 1 up, as the import meets them: they may change with an edit of the map, and the
  /// report warns of them. A game gives a class that it knows a number here, or requests it: ImportedMap::block("ice").
  std::map<std::string, Block> blocks = {};

  /// Tile layers to import: names or paths ("Group/Layer") of layers or groups, and of maps of a world or levels, with
  /// which paths may begin. Empty means all tile layers. A name that fits none is an error.
  std::vector<std::string> layers = {};

  /// Object layers to import: names or paths of layers or groups, or classes or names of objects in any layer; an empty
  /// list takes none. A name that fits none is an error. Without a list, all are taken whose name, class or property
  /// says that they are solid, if `layers` has none or has their group.
  std::optional<std::vector<std::string>> objects = {};

  bool visibleOnly = false;  ///< hidden layers and objects, and what is in hidden groups, are left out

  /// Pixels, finite, 0 or more. If more, each segment of an open polyline becomes a polygon: what lies up to so many
  /// pixels below it, or right of it if it is steeper than 45°.
  double polylineThickness = 0;

  /// The folder in which, or below which, the files lie that the map names: docs/maps.md, "Untrusted maps". Empty: the
  /// map's folder; or, if importMap() reads from the disk, the project's: projectFolder().
  std::string filesIn = {};

  /// The map is trusted: the files that it names may lie anywhere that the reader reads, and have any name.
  bool filesAnywhere = false;

  /// A map of a world that cannot be read is an error. Otherwise the report names it, and the others are imported.
  bool allMaps = false;

  /// Limits. A map that goes beyond one of them is an error.
  std::size_t maxTiles = std::size_t{1} << 24;       ///< of the imported layers together, with the empty ones
  std::size_t maxPlacements = std::size_t{1} << 24;  ///< polygons before overlaps are taken away
  std::size_t maxBytes = std::size_t{1} << 27;       ///< of all files together; one that is read again counts again

  /// Each byte that is read adds to these: docs/maps.md, "What a map may cost".
  std::size_t maxObjectCells = std::size_t{1} << 20;  ///< cells of the bounding boxes of all shapes together
  std::size_t maxWork = std::size_t{1} << 28;         ///< steps: of outlines that meet, shape by shape, cell by cell
};

}  // namespace lgs::tiled
