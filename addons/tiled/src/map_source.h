// The maps of an import with what they name. Each file is read once, so that they can be imported several times.
#pragma once

#include "budget.h"
#include "layers.h"
#include "tileset.h"
#include "xml.h"

#include <memory>

namespace lgs::tiled {

/// A map of a world.
struct WorldMap {
  pugi::xml_node node;  ///< what names it: a <map> or <pattern>
  std::string name;     ///< its file, as the world names it
  DoublePoint at;       ///< of its upper left corner, pixels, y down
};

/// Listed maps come first. Then come the patterns in their order, each with the files of the world's folder that fit it
/// and are no maps yet, sorted by name. What is worth a note goes into `notes`. The first problem goes into the file.
std::vector<WorldMap> mapsOf(const XmlFile& file, const FolderLister& lister, std::vector<std::string>& notes);

/// A map that was read, with its tilesets and templates.
struct MapSource {
  /// Reads the tilesets. The first problem goes into the file, as it does in all that follows.
  MapSource(std::unique_ptr<const XmlFile> map, MapPlace where, const Options& options);

  std::unique_ptr<const XmlFile> file;
  MapPlace place;
  WorldMap entry = {};  ///< of a world, which names it
  Templates templates;
  Tilesets tilesets;
  std::map<Template*, Tileset> tilesetsOfTemplates;  ///< those that were needed
};

/// A map by itself, or those of a world.
using Maps = std::vector<std::unique_ptr<MapSource>>;

/// How many tiles may still be read, and how many polygons placed.
struct Limits {
  explicit Limits(const Options& options) : tiles(options.maxTiles), placements(options.maxPlacements) {}
  std::size_t tiles, placements;
};

/// Imports maps, and puts them together. `file` is the world or the map.
tl::expected<ImportedMap, ImportError> importMaps(const XmlFile& file, const Maps& maps, const Options& options,
                                                  Budget& budget, Limits& left);

}  // namespace lgs::tiled
