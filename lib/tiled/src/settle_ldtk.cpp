#include "layers.h"
#include "ldtk.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lgs::tiled {
namespace {

/// One cell is one tile, so the tile layers that are wanted must have one grid. Returns the side of its cells.
double gridOf(const XmlFile& file, const std::vector<Layer>& layers) {
  constexpr std::int64_t kMaxPixels = 1 << 16;
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
  return static_cast<double>(file.integer(node, kLdtkGridAttribute, std::nullopt, 1, kMaxPixels));
}

/// Several worlds of a project would lie over each other.
void allowOneWorld(const XmlFile& file, const std::vector<Layer>& layers) {
  std::set<std::string> worlds;
  for (const Layer& layer : layers) {
    if (layer.wanted) worlds.insert(layer.path.substr(0, layer.path.find('/')));
  }
  if (worlds.size() < 2) return;
  std::string names;
  for (const std::string& world : worlds) names += (names.empty() ? "" : ", ") + world;
  file.fail(file.root(), "has several worlds, which lie over each other: choose one of " + names, "layers");
}

}  // namespace

void settleLdtk(const XmlFile& file, Options& options, std::vector<std::string>& notes) {
  constexpr double kMaxSide = 1 << 28;  // tiles
  pugi::xml_node root = file.root();
  LayerNames names(options);
  const std::vector<Layer> layers = listLayers(file, options, {}, names);
  const double grid = gridOf(file, layers);
  if (root.attribute(kLdtkWorldsAttribute)) allowOneWorld(file, layers);
  if (root.attribute(kLdtkDepthsAttribute)) {
    notes.push_back("levels at different depths are imported over each other: choose some by --layer");
  }
  setAttribute(root, "tilewidth", numberText(grid));
  setAttribute(root, "tileheight", numberText(grid));
  for (const auto& [pixels, tiles] : {std::pair(kLdtkWidthAttribute, "width"), {kLdtkHeightAttribute, "height"}}) {
    const double side = std::ceil(file.real(root, pixels) / grid);
    if (!(side <= kMaxSide)) return file.fail(root, "its levels are too far apart");
    setAttribute(root, tiles, numberText(side));
  }
  if (options.blockFrom == BlockFrom::layer) return;
  options.blockFrom = BlockFrom::tileClass;
  for (const auto set : root.children("tileset")) {
    for (const auto tile : set.children("tile")) {
      options.blocks.emplace(tile.attribute("class").value(), tile.attribute("id").as_uint());
    }
  }
}

}  // namespace lgs::tiled
