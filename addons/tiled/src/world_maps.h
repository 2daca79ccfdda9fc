// The maps of a world of Tiled's: those that it lists, and the files that fit its patterns.
#pragma once

#include "xml.h"

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

}  // namespace lgs::tiled
