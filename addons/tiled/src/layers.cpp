#include "layers.h"

#include "asked_names.h"
#include "collision_object.h"
#include "words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr int kMaxDepth = 64;               // of groups in groups
constexpr std::int64_t kMaxSide = 1 << 28;  // of a layer, and of a chunk's place; far below kMaxCell

constexpr const char* kOnlyDrawn = "tiles that are only drawn";
constexpr std::array kAskedAs{"a tile layer: --layer ", "an object layer: --objects ",
                              "a layer of tiles that are only drawn: --solid --layer "};  // by LayerKind

/// Goes through the tree of groups.
class Lister {
 public:
  Lister(const XmlFile& file, const Options& options, LayerNames& names)
      : file_(file), options_(options), names_(names) {}

  /// `wanted` of the parent is that of its tile layers.
  void list(pugi::xml_node node, const Layer& parent) {
    const auto world = node.attribute(kWorldAttribute);
    for (const auto child : node.children()) {
      if (world && std::string_view(world.value()) != child.attribute("name").value()) continue;
      const std::string_view kind = child.name();
      const bool isDrawn = kind == "layer" && child.attribute(kDrawnAttribute) && !drawnCounts_;
      const bool group = kind == "group", tiles = kind == "layer" && !isDrawn, objects = kind == "objectgroup";
      if (!group && !tiles && !objects && !isDrawn && kind != "imagelayer") continue;
      Layer self = parent;
      self.node = child;
      self.scrollsApart = parent.scrollsApart || scrollsApart(child);
      self.isHidden = parent.isHidden || !child.attribute("visible").as_bool(true);
      ++self.depth;
      extend(self.path, child);
      if (!child.attribute(kPlaceAttribute).as_bool()) extend(self.pathInMap, child);
      if (self.path.size() > kMaxPathLength) {  // each layer has a copy
        return file_.fail(child, "has a path of names that is longer than 4096 bytes");
      }
      self.offset.x += file_.real(child, "offsetx");
      self.offset.y += file_.real(child, "offsety");
      if (group || tiles) self.wanted = names_.tiles.fit(self) || self.wanted;
      if (group || objects) self.areObjectsAsked = names_.objects.fit(self) || self.areObjectsAsked;
      if (!group) {
        add(tiles ? LayerKind::tiles : objects ? LayerKind::objects : LayerKind::image, self);
      } else if (self.depth > kMaxDepth) {
        file_.fail(child, "groups are nested too deeply");
      } else {
        list(child, self);
      }
    }
  }

  std::vector<Layer> finish() { return std::move(layers_); }

 private:
  static void extend(std::string& path, pugi::xml_node node) {
    path += concat(path.empty() ? "" : "/", node.attribute("name").value());
  }

  bool scrollsApart(pugi::xml_node node) const {
    const auto isOther = [&](const char* factor) { return node.attribute(factor) && file_.real(node, factor) != 1; };
    return isOther("parallaxx") || isOther("parallaxy");
  }

  void add(LayerKind kind, Layer layer) {
    layer.kind = kind;
    if (kind == LayerKind::objects) {
      chooseObjects(layer);
    } else if (kind == LayerKind::image) {
      layer.wanted = false;
      layer.remark = layer.node.attribute(kDrawnAttribute) ? kOnlyDrawn : "an image";
    } else {
      layer.remark = layer.wanted ? layer.node.attribute(kRemarkAttribute).value() : "not chosen";
    }
    if (isLeftOut({layer.pathInMap, layer.node.attribute("name").value(), propertiesOf(layer.node)}, options_)) {
      layer.wanted = layer.isInReach = false;
      layer.remark = "left out (--not)";
    }
    layer.isInReach = layer.isInReach && !(layer.isHidden && options_.visibleOnly);
    if (layer.wanted && layer.isHidden && options_.visibleOnly) {
      layer.wanted = false;
      layer.remark = "hidden";
    } else if (layer.isHidden && kind != LayerKind::image) {
      join(layer.remark, layer.wanted ? "hidden (--visible leaves it out)" : "hidden");
    }
    if (layer.wanted && layer.scrollsApart)
      join(layer.remark, "scrolls at its own speed (parallax); imported where it stands in the editor");
    layers_.push_back(std::move(layer));
  }

  void chooseObjects(Layer& layer) const {
    layer.isInReach = std::exchange(layer.wanted, false);
    layer.remark = "not chosen";
    if (!options_.objects && !layer.isInReach) return;
    layer.wanted = options_.objects ? layer.areObjectsAsked : sayingOf(layer.node, &layer.remark).says != Says::nothing;
    if (!layer.wanted) pickObjects(layer);
    if (options_.objects && layer.wanted) layer.remark = layer.isPicked ? "chosen, of a class or name" : "chosen";
    if (options_.objects) return;
    if (layer.isPicked) layer.remark = "objects with the property that was asked for";
    if (!layer.wanted) layer.remark = "neither its name, its class nor a property says that it is solid";
  }

  void pickObjects(Layer& layer) const {
    if (!options_.objects && options_.solidIf.empty()) return;
    for (const auto node : layer.node.children("object")) {
      const Called object = calledOf(node);
      if (!isPicked(object, options_)) continue;
      layer.wanted = layer.isPicked = true;
      names_.objects.seeName(object.className);
      names_.objects.seeName(object.name);
    }
  }

  const XmlFile& file_;
  const Options& options_;
  const bool drawnCounts_ = options_.solidWithoutShapes || !options_.solidIf.empty();  // what LDtk only draws
  LayerNames& names_;
  std::vector<Layer> layers_;
};

/// The paths and the name of a layer or group.
std::vector<std::string> callsOf(const Layer& layer) {
  return {layer.path, layer.pathInMap, layer.node.attribute("name").value()};
}

tl::expected<Gids, std::string> decode(const XmlFile& file, pugi::xml_node data, pugi::xml_node tiles,
                                       std::size_t count) {
  const std::string_view encoding = data.attribute("encoding").value();
  if (encoding == "csv") return decodeCsv(tiles.text().get(), count);
  const std::string_view compression = data.attribute("compression").value();
  if (encoding == "base64" && !isOneOf(compression, {"", "zlib", "gzip", "zstd"}))
    return tl::unexpected(concat("has the unknown compression", file.quoted(" ", compression),
                                 ": save the map with zlib, gzip, zstd or none"));
  if (encoding == "base64") return decodeBase64(tiles.text().get(), compression, count);
  if (!encoding.empty()) {
    return tl::unexpected(
        concat("has the unknown encoding", file.quoted(" ", encoding), ": save the map with csv or base64"));
  }
  Gids gids;
  for (const auto tile : tiles.children("tile")) {
    gids.push_back(static_cast<std::uint32_t>(file.integer(tile, "gid", 0, 0, 0xFFFF'FFFF)));
  }
  if (gids.size() == count) return gids;
  return tl::unexpected(concat("holds ", gids.size(), " <tile> elements where its size asks for ", count));
}

/// Reads a rectangle of tiles: a whole layer, or a chunk of an infinite one.
void readRect(const XmlFile& file, pugi::xml_node data, pugi::xml_node rect, std::size_t& budget,
              const TileSink& sink) {
  const bool isChunk = rect.parent() == data;
  const auto side = [&](const char* name) { return file.integer(rect, name, std::nullopt, 0, kMaxSide); };
  const auto place = [&](const char* name) {
    return isChunk ? file.integer(rect, name, std::nullopt, -kMaxSide, kMaxSide) : 0;
  };
  const std::int64_t column = place("x"), row = place("y"), width = side("width"), height = side("height");
  if (file.failed()) return;
  const auto count = static_cast<std::uint64_t>(width * height);
  if (count > budget) return file.fail(isChunk ? rect : data, "the map has more tiles than the limit", "maxTiles");
  budget -= static_cast<std::size_t>(count);
  if (count == 0) return;
  const auto gids = decode(file, data, isChunk ? rect : data, static_cast<std::size_t>(count));
  if (!gids) return file.fail(isChunk ? rect : data, gids.error());
  for (std::size_t i = 0; i < gids->size() && !file.failed(); ++i) {
    const auto at = static_cast<std::int64_t>(i);
    if ((*gids)[i] != 0) sink(column + at % width, row + at / width, (*gids)[i]);
  }
}

}  // namespace

Properties propertiesOf(const Layer& layer) {
  Properties result = propertiesOf(layer.node);
  result[kLayerProperty] = layer.pathInMap;
  return result;
}

bool isPicked(const Called& object, const Options& options) {
  if (!options.objects) return firstFit(options.solidIf, object.properties) != nullptr;
  return std::any_of(options.objects->begin(), options.objects->end(), [&](const std::string& name) {
    return !name.empty() && (name == object.className || name == object.name);
  });
}

bool AskedLayers::fit(const Layer& layer) {
  if (asked_.empty()) return false;
  known_.insert(layer.pathInMap.empty() ? layer.path : layer.pathInMap);
  bool fits = false;
  for (const std::string& name : callsOf(layer)) {
    if (name.empty() || !asked_.contains(name)) continue;
    found_.insert(name);
    fits = true;
  }
  return fits;
}

void AskedLayers::checkAll(const XmlFile& file, const char* kind, const std::vector<LayerReport>& layers) const {
  for (const std::string& name : asked_) {
    if (found_.contains(name)) continue;
    for (const LayerReport& other : layers) {
      const bool isIt = isOneOf(name, {other.path, other.name}) || other.path.ends_with("/" + name);
      if (isIt && (other.kind != LayerKind::image || other.note == kOnlyDrawn))
        file.fail({}, concat("'", name, "' is ", kAskedAs[static_cast<std::size_t>(other.kind)], shellWord(name)));
    }
    file.fail(file.root(), concat("has no ", kind, " layer or group '", name, "'", thereAre(name, known_)));
  }
}

std::vector<Layer> listLayers(const XmlFile& file, const Options& options, const MapPlace& place, LayerNames& names) {
  Lister lister(file, options, names);
  Layer root;
  root.path = root.pathInMap = place.name;
  root.offset = place.offset;
  root.wanted = options.layers.empty();
  if (!place.name.empty()) {
    root.wanted = names.tiles.fit(root) || root.wanted;
    root.areObjectsAsked = names.objects.fit(root);
    root.pathInMap.clear();
  }
  lister.list(file.root(), root);
  return lister.finish();
}

void readTiles(const XmlFile& file, const Layer& layer, std::size_t& budget, const TileSink& sink) {
  const auto data = layer.node.child("data");
  if (!data) return file.fail(layer.node, "has no <data>");
  const bool isWhole = !file.root().attribute("infinite").as_bool() && !data.child("chunk");
  if (isWhole) return readRect(file, data, layer.node, budget, sink);
  for (const auto chunk : data.children("chunk")) readRect(file, data, chunk, budget, sink);
}

}  // namespace lgs::tiled
