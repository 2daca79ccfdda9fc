// LDtk projects. They become the document that a Tiled map of the same content would be: each level is a group of
// layers with an offset, an IntGrid layer is a tile layer whose tiles are full squares, and the entities of one kind in
// a layer are an object layer.
#pragma once

#include "json.h"

#include <map>
#include <set>

namespace lgs::tiled {

/// Attributes of the document that no map of Tiled's has.
inline constexpr const char* kLdtkAttribute = "ldtk:version";     ///< of the root; its version of LDtk
inline constexpr const char* kLdtkGridAttribute = "__gridSize";   ///< of the root and of layers: a cell's side, pixels
inline constexpr const char* kLdtkWidthAttribute = "ldtk:width";  ///< of a world: from the first level to the last one.
                                                                  ///< The root is the world if there is one
inline constexpr const char* kLdtkHeightAttribute = "ldtk:height";
inline constexpr const char* kLdtkWorldsAttribute = "ldtk:worlds";       ///< of the root: there are several
inline constexpr const char* kLdtkDepthsAttribute = "ldtk:depths";       ///< of a world: levels have several depths
inline constexpr const char* kLdtkDrawnAttribute = "ldtk:drawn";         ///< of tilesets whose tiles are only drawn
inline constexpr const char* kLdtkNotSolidAttribute = "ldtk:not-solid";  ///< of such layers: why they cannot be solid

/// A tileset of square tiles.
pugi::xml_node addTileset(pugi::xml_node map, const std::string& name, std::uint64_t firstGid, double side);

bool isLdtkProject(const JsonPlace& root);

void readLdtk(const JsonPlace& root, pugi::xml_document& document);

/// An IntGrid layer whose cells have no size is an error.
void checkGrids(const XmlFile& file, pugi::xml_node parent);

/// Decides what depends on the layers that are wanted: which world stays, whether tiles that are only drawn are read,
/// and how large a cell is. Gives each value of an IntGrid layer its block, unless the options give it another one.
/// What is worth a note goes into `notes`.
void settleLdtk(const XmlFile& file, Options& options, std::vector<std::string>& notes);

inline constexpr std::uint64_t kLdtkSetSize = 1 << 20;  ///< how many tile numbers each tileset of the document has
inline constexpr std::uint64_t kMaxLdtkSets = 0x7F;  ///< of IntGrid layers, and as many of drawn ones; above them are
                                                     ///< the flags of tile numbers

/// What a project says of its layers, entities or tilesets, for all levels.
class Definitions {
 public:
  Definitions(const JsonPlace& root, const char* kind) : none_(root["defs"][kind][""]) {
    for (const JsonPlace& one : root["defs"][kind].objects()) byNumber_.emplace(one["uid"].number(0), one);
  }

  /// The one with a number, which a layer or entity names; null if there is none.
  const JsonPlace& operator[](double number) const {
    const auto found = byNumber_.find(number);
    return found == byNumber_.end() ? none_ : found->second;
  }

 private:
  std::map<double, JsonPlace> byNumber_;
  JsonPlace none_;
};

class DrawnLayers {
 public:
  explicit DrawnLayers(const JsonPlace& root) : tilesets_(root, "tilesets") {}

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

  Definitions tilesets_;
  std::map<std::pair<double, double>, Set> sets_;  // by the numbers of layer and tileset
};

}  // namespace lgs::tiled
