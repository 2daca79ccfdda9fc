// The maps of an import with what they name. Each file is read once, so that they can be imported several times.
#pragma once

#include "budget.h"
#include "layers.h"
#include "tileset.h"
#include "xml.h"

#include <memory>

namespace lgs::tiled {

/// The maps of a world: those that are listed; then the patterns in their order, each with the files of the folder that
/// fit it and are no maps yet, by name. What is worth a note goes into `notes`, the first problem into the file.
std::vector<MapPlace> mapsOf(const XmlFile& file, const FolderLister& lister, std::vector<std::string>& notes);

/// A map that was read, with its tilesets and templates.
struct MapSource {
  /// Reads the tilesets. The first problem goes into the file, as it does in all that follows.
  MapSource(std::unique_ptr<const XmlFile> map, MapPlace where, const Options& options);

  std::unique_ptr<const XmlFile> file;
  MapPlace place;
  Templates templates;
  std::vector<Tileset> tilesets;                     ///< by firstGid
  std::map<Template*, Tileset> tilesetsOfTemplates;  ///< those that were needed
};

/// A map by itself, or those of a world.
using Maps = std::vector<std::unique_ptr<MapSource>>;

/// Imports maps, and puts them together. `file` is the world or the map.
tl::expected<ImportedMap, ImportError> importMaps(const XmlFile& file, const Maps& maps, const Options& options,
                                                  Budget& budget);

}  // namespace lgs::tiled
