// The layers of a map: which of them are wanted, how they are shifted, and which tiles they hold.
#pragma once

#include "words.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::tiled {

struct Layer {
  pugi::xml_node node;
  std::string path;       ///< "Group/Layer", after the name of its map in a world or of its level
  std::string pathInMap;  ///< without that name
  LayerKind kind{};
  bool wanted = false;
  bool isInReach = true;  ///< of an object layer: Options::layers do not rule it out
  DoublePoint offset;     ///< pixels, y down; the sum of its own and those of its groups
  bool isPicked = false;  ///< of an object layer: only objects for which isPicked() holds
  std::string remark;     ///< for the report: why it is taken or passed over, or what is special about it
  bool areObjectsAsked = false, isHidden = false, scrollsApart = false;  ///< it, or a group around it
  int depth = 0;                                                         ///< of groups around it
};

/// The property of a layer that is its path in its map. By it a rule can take all tiles of a layer.
inline constexpr const char* kLayerProperty = "layer";

/// The properties of a layer, with kLayerProperty.
Properties propertiesOf(const Layer& layer);

/// Whether Options::objects has the class or name of an object; or if there are none, whether Options::solidIf has one of
/// its properties.
bool isPicked(const Called& object, const Options& options);

/// Where a map stands among others.
struct MapPlace {
  std::string name = {};      ///< of its file, without the extension; empty for a map by itself
  DoublePoint offset = {};    ///< of its upper left corner, pixels, y down
  std::string file = {};      ///< as the world names it
  pugi::xml_node entry = {};  ///< what names it: a <map> or <pattern>
};

/// The names of layers of one kind that the options ask for, and which of them were found.
class AskedLayers {
 public:
  explicit AskedLayers(const std::vector<std::string>& names) : asked_(names.begin(), names.end()) {}

  /// Whether this is a layer or group that was asked for, by its name or path.
  bool fit(const Layer& layer);

  /// The class or the name of an object: perhaps one was asked for.
  void seeName(const std::string& name) { found_.insert(name); }

  /// If a name fits no layer, the file keeps an error, which tells of one of another kind that has the name.
  void checkAll(const XmlFile& file, const char* kind, const std::vector<LayerReport>& layers) const;

 private:
  std::set<std::string> asked_, found_;
  std::set<std::string> known_;  // the names of all layers and groups that were looked at, if any is asked for
};

struct LayerNames {
  explicit LayerNames(const Options& options)
      : tiles(options.layers), objects(options.objects.value_or(std::vector<std::string>{})) {}
  AskedLayers tiles, objects;
};

/// All layers of a map in the map's order, with those that are passed over.
std::vector<Layer> listLayers(const XmlFile& file, const Options& options, const MapPlace& place, LayerNames& names);

/// Receives the tiles that are not empty, row by row. The number still holds the flags for flipping.
using TileSink = std::function<void(std::int64_t column, std::int64_t row, std::uint32_t gid)>;

/// Reads the tiles of a layer. So many may still be read as the budget says; it goes down by all, empty ones too.
void readTiles(const XmlFile& file, const Layer& layer, std::size_t& budget, const TileSink& sink);

using Gids = std::vector<std::uint32_t>;

tl::expected<Gids, std::string> decodeCsv(std::string_view text, std::size_t count);

/// `compression` is "", "zlib", "gzip" or "zstd". Takes memory in proportion to `count` and to the text, whatever the
/// text announces.
tl::expected<Gids, std::string> decodeBase64(std::string_view text, std::string_view compression, std::size_t count);

}  // namespace lgs::tiled
