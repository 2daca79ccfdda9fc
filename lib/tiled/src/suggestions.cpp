#include "suggestions.h"

#include <algorithm>
#include <set>
#include <utility>

namespace lgs::tiled {
namespace {

std::string counted(std::uint64_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// "A, B, C and 4 more"
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string result;
  for (std::size_t k = 0; k < std::min(kMost, names.size()); ++k) result += (k == 0 ? "" : ", ") + names[k];
  if (names.size() > kMost) result += " and " + std::to_string(names.size() - kMost) + " more";
  return result;
}

/// The property of a layer that looks like collision; empty if there is none.
std::string collisionProperty(pugi::xml_node node) {
  for (const auto& [name, value] : propertiesOf(node))
    if (looksLikeCollision(name) && saysYes(value)) return name;
  return {};
}

bool looksSolid(pugi::xml_node object) { return !whySolid(object).empty() || !collisionProperty(object).empty(); }

Suggestion objectLayers(const std::vector<const Layer*>& layers) {
  Suggestion result;
  std::vector<std::string> names;
  std::uint64_t objects = 0;
  for (const Layer* layer : layers) {
    names.push_back(layer->path);
    result.arguments.insert(result.arguments.end(), {"--objects", layer->path});
    for (const auto object : layer->node.children("object")) objects += !object.empty();
  }
  result.text = counted(layers.size(), "object layer") + " with " + counted(objects, "object") +
                (layers.size() == 1 ? " was" : " were") + " passed over: " + listed(names);
  return result;
}

bool canHaveArea(pugi::xml_node object) { return !object.child("point") && !object.child("text"); }

/// Object layers with objects that look solid; if there are none, all that have objects with an area.
void addObjectLayers(const std::vector<Layer>& layers, std::vector<Suggestion>& result) {
  std::vector<const Layer*> some, likely;
  for (const Layer& layer : layers) {
    const auto objects = layer.node.children("object");
    if (layer.kind != LayerKind::objects || layer.wanted || layer.hidden) continue;
    if (std::none_of(objects.begin(), objects.end(), canHaveArea)) continue;
    some.push_back(&layer);
    const bool isLikely = looksSolid(layer.node) || std::any_of(objects.begin(), objects.end(), looksSolid);
    if (isLikely) likely.push_back(&layer);
  }
  if (!some.empty()) result.push_back(objectLayers(likely.empty() ? some : likely));
}

/// What can be taken by asking for less.
void addHiddenLayers(const std::vector<Layer>& layers, std::vector<Suggestion>& result) {
  std::vector<std::string> names;
  for (const Layer& layer : layers) {
    if (layer.hidden) names.push_back(layer.path);
  }
  if (names.empty()) return;
  result.push_back({counted(names.size(), "layer") + (names.size() == 1 ? " is" : " are") +
                        " hidden, and --visible leaves " + (names.size() == 1 ? "it" : "them") +
                        " out: " + listed(names),
                    {}});
}

/// Whether a full square would help: the tile has no shapes, not even such as were left out.
bool canBeSquare(const TileReport& tile) { return !tile.hasShapes && !tile.isSolid; }

/// The layers with tiles of which that is so.
std::set<std::size_t> layersWithSquares(const Report& report) {
  std::set<std::size_t> result;
  for (const TileReport& tile : report.tiles) {
    if (canBeSquare(tile)) result.insert(tile.layers.begin(), tile.layers.end());
  }
  return result;
}

/// Tiles without shapes, if nothing says which of them are solid. The layers that were not read stay out.
void addFullSquares(const std::vector<Layer>& layers, const Report& report, std::vector<Suggestion>& result) {
  const auto tiles = std::count_if(report.tiles.begin(), report.tiles.end(), canBeSquare);
  if (tiles == 0) return;
  const std::set<std::size_t> squares = layersWithSquares(report);
  Suggestion some;
  std::vector<std::string> names;
  bool isChosen = false;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (layers[k].kind != LayerKind::tiles) continue;
    isChosen = isChosen || !layers[k].wanted;
    if (!squares.contains(k)) continue;
    names.push_back(layers[k].path);
    some.arguments.insert(some.arguments.end(), {"--layer", layers[k].path});
  }
  if (!isChosen) some.arguments.clear();
  some.arguments.push_back("--solid");
  some.text = counted(static_cast<std::uint64_t>(tiles), "tile") + " without collision shapes, in " +
              (isChosen ? listed(names) : "all tile layers");
  result.push_back(std::move(some));
}

/// Layers of LDtk whose tiles are only drawn.
void addDrawnLayers(const std::vector<Layer>& layers, std::vector<Suggestion>& result) {
  Suggestion drawn;
  std::vector<std::string> names;
  for (const Layer& layer : layers) {
    if (layer.kind != LayerKind::image || !layer.node.attribute(kRemarkAttribute)) continue;
    names.push_back(layer.path);
    drawn.arguments.insert(drawn.arguments.end(), {"--layer", layer.path});
  }
  if (names.empty()) return;
  drawn.arguments.push_back("--solid");
  drawn.text = counted(names.size(), "layer") + " of tiles that are only drawn: " + listed(names);
  result.push_back(std::move(drawn));
}

}  // namespace

void Suggestions::see(std::uint32_t tile, const Properties& properties) {
  for (const auto& [name, value] : properties) {
    if (looksLikeCollision(name) && saysYes(value)) tiles_[name].push_back(tile);
  }
}

std::vector<Suggestion> Suggestions::make(const std::vector<Layer>& layers, const Report& report) const {
  std::vector<Suggestion> result;
  for (const auto& [name, tiles] : tiles_) {
    std::uint64_t uses = 0;
    for (const std::uint32_t tile : tiles) uses += report.tiles[tile].uses;
    result.push_back(
        {counted(tiles.size(), "tile") + " (" + counted(uses, "use") + ") with the property '" + name + "'",
         {"--solid-if", name}});
  }
  const std::set<std::size_t> squares = layersWithSquares(report);
  std::set<std::string> properties;  // of layers
  Suggestion named;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (layers[k].kind != LayerKind::tiles || !squares.contains(k)) continue;
    if (const auto name = collisionProperty(layers[k].node); !name.empty()) properties.insert(name);
    if (solidWord(layers[k].node.attribute("name").value()).empty()) continue;
    names.push_back(layers[k].path);
    named.arguments.insert(named.arguments.end(), {"--layer", layers[k].path});
  }
  for (const std::string& name : properties) {
    result.push_back({"tile layers with the property '" + name + "'", {"--solid-if", name}});
  }
  addHiddenLayers(layers, result);
  addObjectLayers(layers, result);
  if (!names.empty()) {
    named.arguments.push_back("--solid");
    named.text = counted(names.size(), "tile layer") + " with a name that says so: " + listed(names);
    result.push_back(std::move(named));
  }
  addDrawnLayers(layers, result);
  if (result.empty()) addFullSquares(layers, report, result);
  return result;
}

}  // namespace lgs::tiled
