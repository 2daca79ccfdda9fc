// The layers of a map: which are wanted, how they are shifted, and their tiles in order.
#pragma once

#include "xml.h"

#include <functional>

namespace lgs::tiled {

/// A tile layer in its place in the tree of groups.
struct Layer {
  pugi::xml_node node;
  std::string path;  ///< "Group/Layer"
  bool wanted = false;
  DoublePoint offset;  ///< pixels, y down, with those of the groups
  std::string remark;  ///< what is special about it, for the report
};

/// All layers of a map, those passed over included, in the map's order. Keeps an error if a name of `wanted` fits none.
std::vector<Layer> listLayers(const XmlFile& file, const std::vector<std::string>& wanted);

/// Receives the tiles that are not empty, by rows; the number still holds the flags for flipping.
using TileSink = std::function<void(std::int64_t column, std::int64_t row, std::uint32_t gid)>;

/// Reads a layer's data. `budget` is the number of tiles that may still be read, and is counted down.
void readTiles(const XmlFile& file, const Layer& layer, std::size_t& budget, const TileSink& sink);

}  // namespace lgs::tiled
