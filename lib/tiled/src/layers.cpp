#include "layers.h"

#include "encoding.h"

#include <algorithm>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr int kMaxDepth = 64;               // of groups in groups
constexpr std::int64_t kMaxSide = 1 << 28;  // of a layer, and of a chunk's place; far below kMaxCell

/// Goes through the tree of groups.
class Lister {
 public:
  Lister(const XmlFile& file, const std::vector<std::string>& names)
      : file_(file), names_(names), found_(names.size(), false) {}

  struct Parent {
    std::string path;
    bool wanted;
    DoublePoint offset;
    bool parallax;
    int depth;
  };

  void list(pugi::xml_node node, const Parent& parent) {
    for (const auto child : node.children()) {
      const std::string_view kind = child.name();
      const bool group = kind == "group";
      if (!group && kind != "layer" && kind != "objectgroup" && kind != "imagelayer") continue;
      const std::string name = child.attribute("name").value();
      Parent self{parent.path.empty() ? name : parent.path + "/" + name,
                  false,
                  {parent.offset.x + file_.real(child, "offsetx"), parent.offset.y + file_.real(child, "offsety")},
                  parent.parallax || scrollsApart(child),
                  parent.depth + 1};
      const bool asked = fits(name, self.path, group || kind == "layer");
      self.wanted = parent.wanted || asked;
      if (!group) {
        add(child, kind, self);
      } else if (self.depth > kMaxDepth) {
        file_.fail(child, "groups are nested too deeply");
      } else {
        list(child, self);
      }
    }
  }

  std::vector<Layer> finish() {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!found_[i]) file_.fail(file_.root(), "has no tile layer or group '" + names_[i] + "'");
    }
    return std::move(layers_);
  }

 private:
  static bool scrollsApart(pugi::xml_node node) {
    return node.attribute("parallaxx").as_double(1) != 1 || node.attribute("parallaxy").as_double(1) != 1;
  }

  bool fits(const std::string& name, const std::string& path, bool choosable) {
    bool any = false;
    for (std::size_t i = 0; i < names_.size() && choosable; ++i) {
      if (names_[i] != name && names_[i] != path) continue;
      found_[i] = any = true;
    }
    return any;
  }

  void add(pugi::xml_node node, std::string_view kind, const Parent& self) {
    Layer layer{node, self.path, kind == "layer" && self.wanted, self.offset, {}};
    if (kind == "objectgroup") {
      layer.remark = "an object layer: only tile layers are imported";
    } else if (kind == "imagelayer") {
      layer.remark = "an image";
    } else if (!self.wanted) {
      layer.remark = "not chosen";
    } else if (self.parallax) {
      layer.remark = "scrolls at its own speed (parallax); imported where it stands in the editor";
    }
    layers_.push_back(std::move(layer));
  }

  const XmlFile& file_;
  const std::vector<std::string>& names_;
  std::vector<bool> found_;
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

std::vector<Layer> listLayers(const XmlFile& file, const std::vector<std::string>& wanted) {
  Lister lister(file, wanted);
  lister.list(file.root(), {"", wanted.empty(), {}, false, 0});
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
