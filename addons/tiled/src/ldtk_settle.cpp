// What of an LDtk project depends on the layers that are wanted.
#include "layers.h"
#include "ldtk.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lgs::tiled {

namespace {

/// One cell is one tile, so the tile layers that are wanted must have one grid. Returns the side of its cells.
double gridOf(const XmlFile& file, const std::vector<Layer>& layers) {
  const auto isWanted = [](const Layer& layer) { return layer.wanted && layer.kind == LayerKind::tiles; };
  const auto side = [](const Layer& layer) { return std::string(layer.node.attribute(kLdtkGridAttribute).value()); };
  const auto first = std::find_if(layers.begin(), layers.end(), isWanted);
  const auto other = std::find_if(first, layers.end(),
                                  [&](const Layer& layer) { return isWanted(layer) && side(layer) != side(*first); });
  if (other != layers.end()) {
    file.fail(other->node,
              "has a grid of " + side(*other) + " px, and " + first->path + " one of " + side(*first) +
                  " px. One cell of the grid becomes one cell of the world, so choose layers that have one grid",
              "layers");
  }
  const pugi::xml_node node = first == layers.end() ? file.root() : first->node;
  return static_cast<double>(file.integer(node, kLdtkGridAttribute, std::nullopt, 1, kMaxCellPixels));
}

/// The worlds of all layers that are wanted; or, if tile layers were chosen and some are wanted, of these alone.
std::set<std::string> wantedWorlds(const std::vector<Layer>& layers, const Options& options) {
  std::set<std::string> all, ofTiles;
  for (const Layer& layer : layers) {
    if (!layer.wanted) continue;
    const std::string world = layer.path.substr(0, layer.path.find('/'));
    all.insert(world);
    if (layer.kind == LayerKind::tiles) ofTiles.insert(world);
  }
  return options.layers.empty() || ofTiles.empty() ? all : ofTiles;
}

/// Several worlds of a project would lie over each other: the one that was chosen is listed alone. Returns it.
pugi::xml_node chooseWorld(const XmlFile& file, const Options& options) {
  pugi::xml_node root = file.root();
  root.remove_attribute(kWorldAttribute);
  LayerNames names(options);
  const std::set<std::string> worlds = wantedWorlds(listLayers(file, options, {}, names), options);
  if (worlds.size() > 1) {
    file.fail(root,
              "has several worlds, which lie over each other: choose one of " + listed({worlds.begin(), worlds.end()}),
              "layers");
  }
  if (worlds.size() != 1) return root;
  setAttribute(root, kWorldAttribute, *worlds.begin());
  return root.find_child_by_attribute("group", "name", worlds.begin()->c_str());
}

}  // namespace

void settleLdtk(const XmlFile& file, Options& options, std::vector<std::string>& notes) {
  constexpr double kMostTiles = 1 << 28;
  pugi::xml_node root = file.root();
  const pugi::xml_node world = root.attribute(kLdtkWidthAttribute) ? root : chooseWorld(file, options);
  if (file.failed()) return;
  LayerNames names(options);
  const std::vector<Layer> layers = listLayers(file, options, {}, names);
  const double grid = gridOf(file, layers);
  if (world.attribute(kLdtkDepthsAttribute)) {
    notes.push_back("levels at different depths are imported over each other: choose some by --layer");
  }
  setNumbers(root, {{"tilewidth", grid}, {"tileheight", grid}});
  for (const auto& [pixels, tiles] : {std::pair(kLdtkWidthAttribute, "width"), {kLdtkHeightAttribute, "height"}}) {
    const double side = std::ceil(file.real(world, pixels) / grid);
    if (!(side <= kMostTiles)) return file.fail(root, "its levels are too far apart");
    setNumbers(root, {{tiles, side}});
  }
  if (options.blockFrom == BlockFrom::layer) return;
  options.blockFrom = BlockFrom::tileClass;
  for (const auto set : root.children("tileset")) {
    if (set.attribute(kLdtkDrawnAttribute)) continue;
    for (const auto tile : set.children("tile")) {
      options.blocks.emplace(tile.attribute("class").value(), tile.attribute("id").as_uint());
    }
  }
}

}  // namespace lgs::tiled
