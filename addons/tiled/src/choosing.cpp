// What Options choose, and how a command says it; and which layers and values could be chosen.
#include "evidence.h"

#include <algorithm>
#include <utility>

namespace lgs::tiled {

std::vector<std::string> choosingArguments(const Options& options) {
  std::vector<std::string> result;
  const auto add = [&](const char* option, const std::vector<std::string>& values) {
    for (const std::string& value : values) result.insert(result.end(), {option, value});
  };
  add("--layer", options.layers);
  if (options.solidWithoutShapes) result.emplace_back("--solid");
  add("--solid-if", options.solidIf);
  if (options.objects) add("--objects", *options.objects);
  if (options.objects && options.objects->empty()) result.emplace_back("--no-objects");
  add("--not", options.leaveOut);
  if (options.visibleOnly) result.emplace_back("--visible");
  if (options.polylineThickness > 0) add("--polyline-thickness", {numberText(options.polylineThickness)});
  return result;
}

const LayerFacts* onlyLayer(const Facts& facts) {
  Layers all, called, fore;
  std::uint64_t passedOver = 0;  // tiles of the largest layer that its name rules out, and that is no picture
  for (const LayerFacts& layer : facts.layers) {
    if (layer.kind == LayerKind::objects) {
      const bool areBoxes = layer.objects > layer.figures && !areThings(layer);
      if (layer.saying.says == Says::nothing && areBoxes) return nullptr;
    } else if (layer.isForOther) {
      if (!isFull(layer) && !layer.isPassable) passedOver = std::max(passedOver, layer.tiles);
      if (isForeground(layer.name)) fore.push_back(&layer);
    } else if (!isTiny(layer)) {
      if (layer.isDrawn) return nullptr;
      all.push_back(&layer);
      if (isMainName(layer.name)) called.push_back(&layer);
    }
  }
  const Layers& some = all.empty() ? fore : all.size() > 1 ? called : all;
  const LayerFacts* const only = some.size() == 1 ? some.front() : nullptr;
  const bool isRivalled = only && !only->isForOther && only->tiles < passedOver;
  const bool isIt = only && only->bare > 0 && 2 * only->tiles <= only->cells && !isRivalled;
  return isIt && !isTiny(*only) ? only : nullptr;
}

GridValues valuesOf(const Layers& layers) {
  std::map<std::string, std::uint64_t> values;
  std::uint64_t cells = 0;
  bool isWalled = false;
  for (const LayerFacts* layer : layers) {
    cells += layer->cells;
    for (const auto& [name, uses] : layer->values) {
      values[name] += uses;
      isWalled = isWalled || saying(name).isWall();
    }
  }
  GridValues result;
  for (const auto& [name, uses] : values) {
    const bool isFloor = saying(name).isFloor();
    if (isGoneThrough(name) || (isWalled && isFloor)) result.through.push_back(name);
    if (isWalled && !saying(name).isWall()) result.noWalls.push_back(name);
    if (!isWalled && isFloor && 2 * uses > cells) result.floors.push_back(name);
  }
  for (std::vector<std::string>* const list : {&result.through, &result.noWalls, &result.floors}) {
    if (list->size() == values.size()) list->clear();
    if (list->size() > kMostRules) list->resize(kMostRules);
  }
  return result;
}

bool leaveChoice(const Options& options) {
  return !options.solidWithoutShapes && options.solidIf.empty() && !options.objects && options.tiles.empty();
}

namespace {

/// How many tiles of a layer a choice takes.
std::uint64_t taken(const LayerFacts& layer, const Facts& facts, const Options& options) {
  const bool isChosen = options.layers.empty() || has(options.layers, layer.name);
  if (!isChosen || has(options.leaveOut, layer.name)) return 0;
  if (options.solidWithoutShapes) return layer.tiles;
  std::uint64_t tiles = layer.shaped;
  for (const std::string& rule : options.solidIf) {
    if (rule == kLayerProperty + ("=" + layer.name)) return layer.tiles;
    const auto known = facts.rules.find(rule);
    if (known == facts.rules.end()) continue;
    const auto uses = known->second.layers.find(layer.name);
    if (uses != known->second.layers.end()) tiles += uses->second;
  }
  return std::min(tiles, layer.tiles);
}

bool isTaken(const LayerFacts& objects, const Options& options, bool isLdtk) {
  if (!options.objects) return options.layers.empty() && objects.saying.says != Says::nothing;
  const bool isByClass = !isLdtk && objects.isMixed() &&
                         std::any_of(objects.classes.begin(), objects.classes.end(),
                                     [&](const auto& one) { return has(*options.objects, one.first); });
  return isByClass || has(*options.objects, objects.name);
}

/// Whether a layer that says so must be in a choice, or is only weaker evidence beside it. Tiles that are called ground
/// are what one sees of a collision layer; objects that are called so are drawn for the game, as those of that layer.
bool isDue(const LayerFacts& layer, const Choice& choice, bool isLdtk) {
  if (layer.isDrawn || layer.isPassable) return false;
  if (layer.saying.says == Says::collision) return true;
  if (layer.kind == LayerKind::objects) return !isLdtk && choice.evidence == Evidence::solid;
  return choice.evidence == Evidence::solid && choice.options.layers.empty() && !layer.saying.isFloor();
}

Missed missedTiles(const LayerFacts& layer, std::uint64_t tiles, const Choice& choice) {
  Options more = choice.options;
  std::erase(more.leaveOut, layer.name);
  more.layers.empty() ? more.solidIf.push_back(kLayerProperty + ("=" + layer.name)) : more.layers.push_back(layer.name);
  return {concat("tile layer ", layer.name, ", of which ", tiles, " of ", counted(layer.tiles, "tile"), " are taken"),
          std::move(more), "the same with all of tile layer " + layer.name};
}

Missed missedObjects(const LayerFacts& layer, const Facts& facts, const Choice& choice) {
  Options more = choice.options;
  if (!more.objects) more.objects = more.layers.empty() ? namesOfSaying(facts) : std::vector<std::string>{};
  more.objects->push_back(layer.name);
  return {"object layer " + layer.name + ", of which nothing is taken", std::move(more),
          "the same with object layer " + layer.name};
}

/// Beside layers that were taken as a whole another one may be meant as well, unless its name says what it is. Water
/// often stops bodies that walk.
bool isPlainLayer(const LayerFacts& layer) {
  return layer.kind == LayerKind::tiles && layer.bare > 0 && !layer.isOnlySeen && !layer.isDrawn &&
         (!layer.isForOther || isGoneThrough(layer.name));
}

/// Open polylines have no area, but can be made thick.
Missed missedLines(const LayerFacts& layer, const Choice& choice, const Options& options) {
  Options thick = choosingArguments(choice.options) == choosingArguments(options) ? options : choice.options;
  thick.polylineThickness = kLineThickness;
  return {linesLeftOut(layer.name, layer.lines), std::move(thick), "the same with its polylines made thick"};
}

}  // namespace

std::string linesLeftOut(const std::string& layer, std::uint64_t lines) {
  return concat("object layer ", layer, ", of which ", counted(lines, "open polyline"), lines == 1 ? " is" : " are",
                " left out");
}

std::vector<Missed> missed(const Facts& facts, const Choice& choice, const Options& options) {
  std::vector<Missed> result;
  for (const LayerFacts& layer : facts.layers) {
    const bool says = layer.saying.says != Says::nothing, isOfObjects = layer.kind == LayerKind::objects;
    const bool areBoxes = isOfObjects && layer.objects > layer.figures && !areThings(layer) && !facts.isLdtk;
    const bool isPlain = !choice.options.layers.empty() && isPlainLayer(layer);
    const bool isWater = isOfObjects && facts.isLdtk && isGoneThrough(layer.name) && !layer.isPassable;
    if (!says && !isPlain && !isWater && !(areBoxes && layer.classes.empty())) continue;
    if (says && isOfObjects && !isDrawnByHand(layer)) continue;
    const bool due = says && isDue(layer, choice, facts.isLdtk);
    const auto add = [&](Missed one, bool isPart = true) {
      one.isDue = due && isPart;
      if (result.size() < kMaxSuggestions) result.push_back(std::move(one));  // as many commands follow
    };
    if (!isOfObjects) {
      const std::uint64_t tiles = taken(layer, facts, choice.options);
      const bool isWhole = tiles == layer.tiles || isFull(layer) || layer.isDrawn || layer.isPassable;
      if (!isWhole) add(missedTiles(layer, tiles, choice), 4 * tiles < 3 * layer.tiles);
      continue;
    }
    if (facts.isLdtk && !due && !isWater) continue;
    if (!isTaken(layer, choice.options, facts.isLdtk) && layer.objects > 0) add(missedObjects(layer, facts, choice));
    if (says && options.polylineThickness == 0 && layer.lines > 0) add(missedLines(layer, choice, options));
  }
  std::stable_partition(result.begin(), result.end(), [](const Missed& one) { return one.isDue; });
  return result;
}

}  // namespace lgs::tiled
