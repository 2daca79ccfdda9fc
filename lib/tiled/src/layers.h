// The layers of a map: which of them are wanted, how they are shifted, and which tiles they hold.
#pragma once

#include "xml.h"

#include <functional>

namespace lgs::tiled {

struct Layer {
  pugi::xml_node node;
  std::string path;  ///< "Group/Layer"
  LayerKind kind{};
  bool wanted = false;
  DoublePoint offset;  ///< pixels, y down; the sum of its own and those of its groups
  std::string remark;  ///< for the report: why it is taken or passed over, or what is special about it
};

/// All layers of a map in the map's order, with those that are passed over. If a name in the options fits no layer, the
/// file keeps an error.
std::vector<Layer> listLayers(const XmlFile& file, const Options& options);

/// Receives the tiles that are not empty, row by row. The number still holds the flags for flipping.
using TileSink = std::function<void(std::int64_t column, std::int64_t row, std::uint32_t gid)>;

/// Reads the tiles of a layer. `budget` says how many tiles may still be read; it goes down by the layer's, empty ones
/// too.
void readTiles(const XmlFile& file, const Layer& layer, std::size_t& budget, const TileSink& sink);

}  // namespace lgs::tiled
