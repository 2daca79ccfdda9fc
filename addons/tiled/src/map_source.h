// A map that was read, with its tilesets and templates. It can be imported several times.
#pragma once

#include "layers.h"
#include "tileset.h"
#include "world_maps.h"

#include <memory>

namespace lgs::tiled {

struct MapSource {
  /// Reads the tilesets. The first problem goes into `error`, which is that of the file, as it is for all that follows.
  MapSource(std::unique_ptr<const XmlFile> map, MapPlace where, const Options& options, const FileReader& reader,
            std::optional<ImportError>& error);

  std::unique_ptr<const XmlFile> file;
  MapPlace place;
  WorldMap entry = {};  ///< of a world, which names it
  const FileReader& reader;
  Templates templates;
  Tilesets tilesets;
  std::map<Template*, Tileset> tilesetsOfTemplates;  ///< those that were needed
};

}  // namespace lgs::tiled
