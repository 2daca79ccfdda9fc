// The import of one map, by itself or as a part of a world.
#pragma once

#include "asked_names.h"
#include "budget.h"

namespace lgs::tiled {

/// What the maps of a world share.
struct ImportJob {
  Options options;
  Budget& budget;
  const FileReader& reader;
  const FolderLister& lister;
  LayerNames names = LayerNames(options);
  AskedNames asked = AskedNames(options);
  std::size_t tilesLeft = options.maxTiles;            ///< how many may still be read
  std::size_t placementsLeft = options.maxPlacements;  ///< likewise
};

/// Imports the map that a file holds. `error` is that of the file. It is the caller who checks that all names that were
/// asked for are there.
tl::expected<ImportedMap, ImportError> importOne(const XmlFile& file, ImportJob& job, const MapPlace& place,
                                                 std::optional<ImportError>& error);

/// Imports the maps that a world of Tiled's lists, and puts them together.
tl::expected<ImportedMap, ImportError> importWorld(const XmlFile& file, ImportJob& job,
                                                   std::optional<ImportError>& error);

}  // namespace lgs::tiled
