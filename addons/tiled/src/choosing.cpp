// What Options choose, and how a command says it; and which layers and values could be chosen.
#include "evidence.h"

#include <algorithm>
#include <utility>

namespace lgs::tiled {
namespace {

/// Whether a layer that says so must be in a choice, or is only weaker evidence beside it. Tiles that are called ground
/// are what one sees of a collision layer, or of objects; objects that are called so are drawn for the game, as those of
/// that layer.
bool isDue(const LayerFacts& layer, const Choice& choice, bool areTilesTaken, bool isLdtk) {
  const bool areFigures = layer.kind == LayerKind::objects && !isDrawnByHand(layer);  // "obstacles" with pictures
  if (layer.isDrawn || layer.uses.isPassable || layer.saying.says == Says::nothing || areFigures) return false;
  if (layer.saying.says == Says::collision) return true;
  if (layer.kind == LayerKind::objects) return !isLdtk && choice.evidence == Evidence::solid;
  return choice.evidence == Evidence::solid && choice.options.layers.empty() && areTilesTaken &&
         !layer.saying.isFloor();
}

/// Beside layers that were taken as a whole another one may be meant as well, unless its name says what it is. Water
/// often stops bodies that walk.
bool isPlainLayer(const LayerFacts& layer) {
  return layer.kind == LayerKind::tiles && layer.bare > 0 && !layer.uses.isOnlySeen && !layer.isDrawn &&
         (!layer.uses.isOther || layer.uses.isFluid);
}

}  // namespace

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
    } else if (layer.uses.isOther) {
      if (!isFull(layer) && !layer.uses.isPassable) passedOver = std::max(passedOver, layer.tiles);
      if (layer.uses.isForeground) fore.push_back(&layer);
    } else if (!isTiny(layer)) {
      if (layer.isDrawn) return nullptr;
      all.push_back(&layer);
      if (layer.uses.isMain) called.push_back(&layer);
    }
  }
  const Layers& some = all.empty() ? fore : all.size() > 1 ? called : all;
  const LayerFacts* const only = some.size() == 1 ? some.front() : nullptr;
  const bool isRivalled = only && !only->uses.isOther && !only->uses.isMain && only->tiles < passedOver;
  const bool isIt = only && only->bare > 0 && 2 * only->tiles <= only->cells && !isRivalled;
  return isIt && !isTiny(*only) ? only : nullptr;
}

GridValues valuesOf(const Layers& layers) {
  std::map<std::string, std::uint64_t> values;
  std::uint64_t cells = 0;
  bool isWalled = false, isSaid = false;
  for (const LayerFacts* layer : layers) {
    cells += layer->cells;
    for (const auto& [name, uses] : layer->values) {
      values[name] += uses;
      isWalled = isWalled || saying(name).isWall();
      isSaid = isSaid || saying(name).says != Says::nothing;
    }
  }
  GridValues result;
  for (const auto& [name, uses] : values) {
    const Saying said = saying(name);
    const bool isOther = isWalled ? !said.isWall() : said.says == Says::nothing;
    if (usesOf(name).isOther || (isWalled && said.isFloor())) result.through.push_back(name);
    if (isSaid && isOther) result.others.push_back(name);
    if (!isWalled && said.isFloor() && 2 * uses > cells) result.floors.push_back(name);
  }
  for (std::vector<std::string>* const list : {&result.through, &result.others, &result.floors}) {
    if (list->size() == values.size()) list->clear();
    if (list->size() > kMostRules) list->resize(kMostRules);
  }
  return result;
}

bool leaveChoice(const Options& options) {
  return !options.solidWithoutShapes && options.solidIf.empty() && !options.objects && options.tiles.empty();
}

std::string linesLeftOut(const std::string& layer, std::uint64_t lines) {
  return concat("object layer ", layer, ", of which ", counted(lines, "open polyline"), lines == 1 ? " is" : " are",
                " left out");
}

std::vector<Missed> missed(const Facts& facts, const Choice& choice, const Options& options, const Report& report) {
  std::vector<Missed> result;
  Options all = choice.options;                                      // with all that is due
  std::map<std::pair<LayerKind, std::string>, std::uint64_t> taken;  // tiles or objects of layers
  bool areTilesTaken = false;
  for (const LayerReport& layer : report.layers) {
    taken[{layer.kind, layer.name}] += layer.solid;
    areTilesTaken |= layer.kind == LayerKind::tiles && layer.solid > 0;
  }
  const bool areDrawn = choice.evidence == Evidence::ground && choice.options.layers.empty();
  for (const LayerFacts& layer : facts.layers) {
    const bool says = layer.saying.says != Says::nothing, isOfObjects = layer.kind == LayerKind::objects;
    const bool areOthers = areDrawn ? layer.uses.isPassable || areNamed(layer) : layer.uses.isOther || areNamed(layer);
    const bool areBoxes = isOfObjects && layer.objects > layer.figures && !areOthers && !facts.isLdtk;
    const bool isPlain = !choice.options.layers.empty() && isPlainLayer(layer);
    const bool isWater = isOfObjects && facts.isLdtk && layer.uses.isFluid && !layer.uses.isPassable;
    const std::uint64_t count = taken[{layer.kind, layer.name}];
    const bool isBegun = isOfObjects && count > 0;  // some are taken, by their class or property
    if (!says && !isPlain && !isWater && !isBegun && !(areBoxes && layer.classes.empty())) continue;
    const bool due = isDue(layer, choice, areTilesTaken, facts.isLdtk);
    const auto add = [&](std::string text, std::string offer, bool isPart, const auto& take) {
      if (result.size() == kMaxSuggestions) return;  // as many commands follow
      result.push_back({std::move(text), choice.options, std::move(offer), isPart, says || isWater || isBegun});
      take(result.back().options);
      if (isPart) take(all);
    };
    const bool isForSeeing = isFull(layer) || layer.isDrawn || layer.uses.isPassable || !layer.values.empty();
    if (!isOfObjects && !isForSeeing && count + layer.passable < layer.tiles)
      add(concat("tile layer ", layer.name, ", of which ", count, " of ", counted(layer.tiles, "tile"), " are taken"),
          "the same with all of tile layer " + layer.name, due && 4 * count < 3 * layer.tiles, [&](Options& more) {
            std::erase(more.leaveOut, layer.name);
            more.layers.empty() ? more.solidIf.push_back(ruleOf(layer)) : more.layers.push_back(layer.name);
          });
    if (!isOfObjects || (facts.isLdtk && !due && !isWater)) continue;
    const auto takeObjects = [&](Options& more) {
      if (!more.objects) more.objects = more.layers.empty() ? namesOfSaying(facts) : std::vector<std::string>{};
      if (!has(*more.objects, layer.name)) more.objects->push_back(layer.name);
      if (says && layer.bareFigures > 0 && !more.solidWithoutShapes) more.solidIf.push_back(ruleOf(layer));
    };
    if (count + layer.passable < layer.objects)
      add(concat("object layer ", layer.name, ", of which ",
                 count == 0 ? "nothing is" : concat(count, " of ", counted(layer.objects, "object"), " are"), " taken"),
          "the same with object layer " + layer.name, due && count == 0, takeObjects);
    if (says && options.polylineThickness == 0 && layer.lines > 0)
      add(linesLeftOut(layer.name, layer.lines), "the same with its polylines made thick", due || isBegun,
          [&](Options& more) {
            if (more.objects || !more.layers.empty()) takeObjects(more);
            more.polylineThickness = kLineThickness;
          });
  }
  const auto rest = std::stable_partition(result.begin(), result.end(), [](const Missed& one) { return one.isDue; });
  if (rest - result.begin() > 1) result.insert(result.begin(), {"", std::move(all), "the same with all of these"});
  return result;
}

}  // namespace lgs::tiled
