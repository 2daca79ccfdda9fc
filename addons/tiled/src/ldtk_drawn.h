// Layers of an LDtk project whose tiles are only drawn: tile layers and auto-layers. They become tile layers whose
// tiles have no shapes.
#pragma once

#include "json_elements.h"

#include <map>
#include <set>

namespace lgs::tiled {

inline constexpr std::uint64_t kLdtkSetSize = 1 << 20;  ///< how many tile numbers each tileset of the document has
inline constexpr std::uint64_t kMaxLdtkSets = 0x7F;  ///< of IntGrid layers, and as many of drawn ones; above them are
                                                     ///< the flags of tile numbers

class DrawnLayers {
 public:
  DrawnLayers(const JsonReading& reading, const JsonPlace& root);

  /// Gives a layer of the document the tiles of a layer of the project.
  void read(const JsonPlace& layer, pugi::xml_node to);

  /// Adds the tilesets of all that was read. `names` are taken: those of the values of IntGrid layers.
  void writeTilesets(pugi::xml_node map, const std::map<std::string, std::uint64_t>& names) const;

 private:
  struct Set {
    std::uint64_t firstGid = 0;
    std::string layer;
    double grid = 0;
    double tileset = 0;             // the number of its definition
    std::set<std::uint64_t> tiles;  // that are used
  };

  Set* setOf(const JsonPlace& layer);
  void writeTiles(pugi::xml_node to, const Set& set) const;

  const JsonReading& reading_;
  std::map<double, JsonPlace> tilesets_;           // by the number of their definition
  std::map<std::pair<double, double>, Set> sets_;  // by the numbers of layer and tileset
};

}  // namespace lgs::tiled
