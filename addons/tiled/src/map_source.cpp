#include "map_source.h"

#include "ldtk.h"

#include <utility>

namespace lgs::tiled {

MapSource::MapSource(std::unique_ptr<const XmlFile> map, MapPlace where, const Options& options,
                     const FileReader& ofFiles, std::optional<ImportError>& error)
    : file(std::move(map)), place(std::move(where)), reader(ofFiles), templates(ofFiles) {
  const auto root = file->root();
  const std::string_view orientation = root.attribute("orientation").value();
  if (!orientation.empty() && orientation != "orthogonal") {
    file->fail(root,
               "has the orientation" + file->quoted(" ", orientation) + ": only orthogonal maps have square cells");
    return;
  }
  if (root.attribute(kLdtkAttribute)) checkGrids(*file, root);
  if (!file->failed()) tilesets.read(*file, reader, templates, error);
  tilesets.settle(options);
}

}  // namespace lgs::tiled
