// What of an LDtk project depends on the layers that are wanted.
#include "layers.h"
#include "ldtk.h"

#include <cmath>
#include <set>

namespace lgs::tiled {

namespace {

/// One cell is one tile, so the tile layers that are wanted must have one grid. Returns the side of its cells.
double gridOf(const XmlFile& file, const std::vector<Layer>& layers) {
  const Layer* first = nullptr;
  const auto side = [](const Layer& layer) { return std::string(layer.node.attribute(kLdtkGridAttribute).value()); };
  for (const Layer& layer : layers) {
    if (!layer.wanted || layer.kind != LayerKind::tiles) continue;
    if (!first) first = &layer;
    if (side(layer) != side(*first))
      file.fail(layer.node,
                "has a grid of " + side(layer) + " px, and " + first->path + " one of " + side(*first) +
                    " px. One cell of the grid becomes one cell of the world, so choose layers that have one grid",
                "layers");
  }
  const pugi::xml_node node = first ? first->node : file.root();
  return static_cast<double>(file.integer(node, kLdtkGridAttribute, std::nullopt, 1, kMaxCellPixels));
}

/// Several worlds of a project would lie over each other: the one with all layers that are wanted is listed alone; or,
/// if tile layers were chosen and some are wanted, with all of these. Returns it.
pugi::xml_node chooseWorld(const XmlFile& file, const Options& options) {
  pugi::xml_node root = file.root();
  root.remove_attribute(kWorldAttribute);
  LayerNames names(options);
  std::set<std::string> all, ofTiles;
  for (const Layer& layer : listLayers(file, options, {}, names)) {
    if (!layer.wanted) continue;
    all.insert(layer.path.substr(0, layer.path.find('/')));
    if (layer.kind == LayerKind::tiles) ofTiles.insert(layer.path.substr(0, layer.path.find('/')));
  }
  const std::set<std::string>& worlds = options.layers.empty() || ofTiles.empty() ? all : ofTiles;
  if (worlds.size() > 1)
    file.fail(root,
              "has several worlds, which lie over each other: choose one of " + listed({worlds.begin(), worlds.end()}),
              "layers");
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
    if (set.attribute(kDrawnAttribute)) continue;
    for (const auto tile : set.children("tile")) {
      options.blocks.emplace(tile.attribute("class").value(), tile.attribute("id").as_uint());
    }
  }
}

}  // namespace lgs::tiled
