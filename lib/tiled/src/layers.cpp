#include "layers.h"

#include "encoding.h"
#include "properties.h"

#include <algorithm>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr int kMaxDepth = 64;               // of groups in groups
constexpr std::int64_t kMaxSide = 1 << 28;  // of a layer, and of a chunk's place; far below kMaxCell

/// Names that were asked for, and which of them fit a layer.
class Names {
 public:
  explicit Names(const std::vector<std::string>& names) : names_(names), found_(names.size(), false) {}

  bool fit(const std::string& name, const std::string& path) {
    bool any = false;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] != name && names_[i] != path) continue;
      found_[i] = any = true;
    }
    return any;
  }

  void checkAll(const XmlFile& file, const std::string& kind) const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!found_[i]) file.fail(file.root(), "has no " + kind + " layer or group '" + names_[i] + "'");
    }
  }

 private:
  const std::vector<std::string>& names_;
  std::vector<bool> found_;
};

/// Goes through the tree of groups.
class Lister {
 public:
  Lister(const XmlFile& file, const Options& options)
      : file_(file),
        objectsAreNamed_(options.objects.has_value()),
        objectNames_(options.objects.value_or(std::vector<std::string>{})),
        tiles_(options.layers),
        objects_(objectNames_) {}

  struct Parent {
    std::string path;
    bool wanted;         // its tile layers
    bool objectsWanted;  // its object layers, by name
    DoublePoint offset;
    bool parallax;
    int depth;
  };

  void list(pugi::xml_node node, const Parent& parent) {
    for (const auto child : node.children()) {
      const std::string_view kind = child.name();
      const bool group = kind == "group", tiles = kind == "layer", objects = kind == "objectgroup";
      if (!group && !tiles && !objects && kind != "imagelayer") continue;
      const std::string name = child.attribute("name").value();
      Parent self{parent.path.empty() ? name : parent.path + "/" + name,
                  parent.wanted,
                  parent.objectsWanted,
                  {parent.offset.x + file_.real(child, "offsetx"), parent.offset.y + file_.real(child, "offsety")},
                  parent.parallax || scrollsApart(child),
                  parent.depth + 1};
      if (group || tiles) self.wanted = tiles_.fit(name, self.path) || self.wanted;
      if (group || objects) self.objectsWanted = objects_.fit(name, self.path) || self.objectsWanted;
      if (!group) {
        add(child, tiles ? LayerKind::tiles : objects ? LayerKind::objects : LayerKind::image, self);
      } else if (self.depth > kMaxDepth) {
        file_.fail(child, "groups are nested too deeply");
      } else {
        list(child, self);
      }
    }
  }

  std::vector<Layer> finish() {
    tiles_.checkAll(file_, "tile");
    objects_.checkAll(file_, "object");
    return std::move(layers_);
  }

 private:
  static bool scrollsApart(pugi::xml_node node) {
    return node.attribute("parallaxx").as_double(1) != 1 || node.attribute("parallaxy").as_double(1) != 1;
  }

  void add(pugi::xml_node node, LayerKind kind, const Parent& self) {
    Layer layer{node, self.path, kind, kind == LayerKind::tiles && self.wanted, self.offset, {}};
    if (kind == LayerKind::objects) {
      chooseObjects(layer, self);
    } else if (kind == LayerKind::image) {
      layer.remark = "an image";
    } else if (!self.wanted) {
      layer.remark = "not chosen";
    }
    if (layer.wanted && self.parallax) {
      layer.remark += std::string(layer.remark.empty() ? "" : "; ") +
                      "scrolls at its own speed (parallax); imported where it stands in the editor";
    }
    layers_.push_back(std::move(layer));
  }

  void chooseObjects(Layer& layer, const Parent& self) const {
    if (objectsAreNamed_) {
      layer.wanted = self.objectsWanted;
      layer.remark = layer.wanted ? "chosen" : "not chosen";
    } else if (!self.wanted) {
      layer.remark = "not chosen";
    } else {
      layer.remark = whySolid(layer.node);
      layer.wanted = !layer.remark.empty();
      if (!layer.wanted) layer.remark = "neither its name, its class nor a property says that it is solid";
    }
  }

  const XmlFile& file_;
  bool objectsAreNamed_;
  std::vector<std::string> objectNames_;
  Names tiles_;
  Names objects_;
  std::vector<Layer> layers_;
};

/// A rectangle of tiles: a whole layer, or a chunk of an infinite one.
struct TileRect {
  pugi::xml_node node;
  std::int64_t column = 0, row = 0, width = 0, height = 0;
};

tl::expected<Gids, std::string> decode(const XmlFile& file, pugi::xml_node data, const TileRect& rect) {
  const auto count = static_cast<std::size_t>(rect.width * rect.height);
  const std::string_view encoding = data.attribute("encoding").value();
  if (encoding == "csv") return decodeCsv(rect.node.text().get(), count);
  if (encoding == "base64") {
    return decodeBase64(rect.node.text().get(), data.attribute("compression").value(), count);
  }
  if (!encoding.empty()) {
    return tl::unexpected("has the unknown encoding '" + std::string(encoding) + "': save the map with csv or base64");
  }
  Gids gids;
  for (const auto tile : rect.node.children("tile")) {
    gids.push_back(static_cast<std::uint32_t>(file.integer(tile, "gid", 0, 0, 0xFFFF'FFFF)));
  }
  if (gids.size() == count) return gids;
  return tl::unexpected("holds " + std::to_string(gids.size()) + " <tile> elements where its size asks for " +
                        std::to_string(count));
}

void readRect(const XmlFile& file, pugi::xml_node data, const TileRect& rect, std::size_t& budget,
              const TileSink& sink) {
  if (file.failed()) return;
  const auto count = static_cast<std::uint64_t>(rect.width * rect.height);
  if (count > budget) return file.fail(rect.node, "the map has more tiles than the limit (Options::maxTiles)");
  budget -= static_cast<std::size_t>(count);
  if (count == 0) return;
  const auto gids = decode(file, data, rect);
  if (!gids) return file.fail(rect.node, gids.error());
  for (std::size_t i = 0; i < gids->size() && !file.failed(); ++i) {
    const auto at = static_cast<std::int64_t>(i);
    if ((*gids)[i] != 0) sink(rect.column + at % rect.width, rect.row + at / rect.width, (*gids)[i]);
  }
}

}  // namespace

std::vector<Layer> listLayers(const XmlFile& file, const Options& options) {
  Lister lister(file, options);
  lister.list(file.root(), {"", options.layers.empty(), false, {}, false, 0});
  return lister.finish();
}

void readTiles(const XmlFile& file, const Layer& layer, std::size_t& budget, const TileSink& sink) {
  const auto data = layer.node.child("data");
  if (!data) return file.fail(layer.node, "has no <data>");
  const auto side = [&](pugi::xml_node node, const char* attribute) {
    return file.integer(node, attribute, std::nullopt, 0, kMaxSide);
  };
  if (!file.root().attribute("infinite").as_bool() && !data.child("chunk")) {
    return readRect(file, data, {data, 0, 0, side(layer.node, "width"), side(layer.node, "height")}, budget, sink);
  }
  for (const auto chunk : data.children("chunk")) {
    const auto place = [&](const char* attribute) {
      return file.integer(chunk, attribute, std::nullopt, -kMaxSide, kMaxSide);
    };
    readRect(file, data, {chunk, place("x"), place("y"), side(chunk, "width"), side(chunk, "height")}, budget, sink);
  }
}

}  // namespace lgs::tiled
