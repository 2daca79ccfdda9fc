// What says that it is solid and is not in a choice.
#include "evidence.h"

#include <algorithm>
#include <utility>

namespace lgs::tiled {
namespace {

/// How many tiles of a layer a choice takes.
std::uint64_t taken(const LayerFacts& layer, const Facts& facts, const Options& options) {
  const std::vector<std::string>& layers = options.layers;
  if (!layers.empty() && std::find(layers.begin(), layers.end(), layer.name) == layers.end()) return 0;
  if (options.solidWithoutShapes) return layer.tiles;
  std::uint64_t tiles = layer.shaped;
  for (const std::string& rule : options.solidIf) {
    const auto known = facts.rules.find(rule);
    if (known == facts.rules.end()) continue;
    const auto uses = known->second.layers.find(layer.name);
    if (uses != known->second.layers.end()) tiles += uses->second;
  }
  return std::min(tiles, layer.tiles);
}

bool isTaken(const LayerFacts& objects, const Options& options, bool isLdtk) {
  if (!options.objects) return options.layers.empty();  // then those that say something are
  const auto isNamed = [&](const std::string& name) {
    return std::find(options.objects->begin(), options.objects->end(), name) != options.objects->end();
  };
  const bool isByClass =
      !isLdtk && objects.isMixed() &&
      std::any_of(objects.classes.begin(), objects.classes.end(), [&](const auto& one) { return isNamed(one.first); });
  return isByClass || isNamed(objects.name);
}

/// Whether a layer that says so must be in a choice, or is only weaker evidence beside it. Tiles that are called ground
/// are what one sees of a collision layer; objects that are called so are drawn for the game, as those of that layer.
bool isDue(const LayerFacts& layer, const Choice& choice, bool isLdtk) {
  if (layer.isDrawn || (layer.kind == LayerKind::objects && !isDrawnByHand(layer))) return false;
  if (layer.saying.says == Says::collision) return true;
  if (isLdtk && layer.kind == LayerKind::objects) return false;
  const bool isWeaker = choice.evidence == Evidence::shapes || choice.evidence == Evidence::properties ||
                        (choice.evidence == Evidence::collision && layer.kind == LayerKind::objects);
  if (layer.saying.says != Says::ground || !isWeaker) return false;
  return layer.kind == LayerKind::objects || !layer.saying.isFloor();
}

Missed missedTiles(const LayerFacts& layer, std::uint64_t tiles, const Choice& choice, const Options& options) {
  const std::string text = "tile layer " + layer.name + ", of which " + std::to_string(tiles) + " of " +
                           counted(layer.tiles, "tile") + " are taken";
  if (tiles > 0 || choice.options.layers.empty()) {
    return {text, wholeLayer(layer, options), "all of tile layer " + layer.name + ", and no other"};
  }
  Options more = choice.options;
  more.layers.push_back(layer.name);
  return {text, std::move(more), "the same with tile layer " + layer.name};
}

Missed missedObjects(const LayerFacts& layer, const Choice& choice) {
  Options more = choice.options;
  if (!more.objects) more.objects.emplace();
  more.objects->push_back(layer.name);
  return {"object layer " + layer.name + ", of which nothing is taken", std::move(more),
          "the same with object layer " + layer.name};
}

/// Open polylines have no area. Those that are one-way can be made thick.
Missed missedLines(const LayerFacts& layer, const Choice& choice, const Options& options) {
  constexpr double kThickness = 4;  // pixels
  Options thick = choice.evidence == Evidence::shapes ? options : choice.options;
  thick.polylineThickness = kThickness;
  return {"object layer " + layer.name + ", of which " + counted(layer.lines, "open polyline") +
              (layer.lines == 1 ? " is" : " are") + " left out",
          std::move(thick), "the same with the polylines that are one-way"};
}

}  // namespace

std::vector<Missed> missed(const Facts& facts, const Choice& choice, const Options& options) {
  std::vector<Missed> result;
  for (const LayerFacts& layer : facts.layers) {
    if (result.size() == kMaxSuggestions) break;  // as many commands follow
    if (!isDue(layer, choice, facts.isLdtk)) continue;
    if (layer.kind == LayerKind::tiles) {
      const std::uint64_t tiles = taken(layer, facts, choice.options);
      if (4 * tiles < 3 * layer.tiles && !isFull(layer)) result.push_back(missedTiles(layer, tiles, choice, options));
    } else if (!isTaken(layer, choice.options, facts.isLdtk)) {
      if (layer.objects > 0) result.push_back(missedObjects(layer, choice));
    } else if (options.polylineThickness == 0 && layer.lines > 0) {
      result.push_back(missedLines(layer, choice, options));
    }
  }
  return result;
}

std::vector<Missed> silentBeside(const Facts& facts, const Choice& choice) {
  std::vector<Missed> result;
  for (const LayerFacts& layer : facts.layers) {
    const bool areBoxes = layer.kind == LayerKind::objects && layer.objects > layer.figures && !areThings(layer);
    if (!areBoxes || facts.isLdtk || layer.saying.says != Says::nothing || !layer.classes.empty()) continue;
    if (choice.options.objects && isTaken(layer, choice.options, false)) continue;
    if (result.size() == kMaxSuggestions) break;
    result.push_back(missedObjects(layer, choice));
  }
  return result;
}

}  // namespace lgs::tiled
