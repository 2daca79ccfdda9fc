// One pass of an import: of a map by itself, or of the maps of a world.
#pragma once

#include "asked_names.h"
#include "budget.h"
#include "map_source.h"

namespace lgs::tiled {

/// What the maps of a pass share.
struct ImportJob {
  Options options;
  Budget& budget;
  LayerNames names = LayerNames(options);
  AskedNames asked = AskedNames(options);
  std::size_t tilesLeft = options.maxTiles;            ///< how many may still be read
  std::size_t placementsLeft = options.maxPlacements;  ///< likewise
};

/// Imports a map. `error` is that of its file. It is the caller who checks that all names that were asked for are
/// there.
tl::expected<ImportedMap, ImportError> importOne(MapSource& source, ImportJob& job, std::optional<ImportError>& error);

/// Imports the maps of a world, whose file is `file`, and puts them together.
tl::expected<ImportedMap, ImportError> importWorld(const XmlFile& file,
                                                   const std::vector<std::unique_ptr<MapSource>>& maps, ImportJob& job,
                                                   std::optional<ImportError>& error);

}  // namespace lgs::tiled
