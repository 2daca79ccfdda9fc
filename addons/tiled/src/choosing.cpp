// What Options choose, and how a command says it; and which layers and values could be chosen.
#include "evidence.h"

#include <algorithm>

namespace lgs::tiled {

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string result;
  for (std::size_t k = 0; k < std::min(kMost, names.size()); ++k) result += (k == 0 ? "" : ", ") + names[k];
  if (names.size() > kMost) result += " and " + std::to_string(names.size() - kMost) + " more";
  return result;
}

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
  if (options.polylineThickness > 0) {
    std::string number = std::to_string(options.polylineThickness);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.pop_back();
    add("--polyline-thickness", {number});
  }
  return result;
}

const LayerFacts* onlyLayer(const Facts& facts) {
  Layers all, called;
  for (const LayerFacts& layer : facts.layers) {
    if (layer.kind == LayerKind::objects) {
      const bool areBoxes = layer.objects > layer.figures && !areThings(layer);
      if (layer.saying.says == Says::nothing && areBoxes) return nullptr;
    } else if (layer.tiles > 0 && !layer.isForOther) {
      if (layer.isDrawn) return nullptr;
      all.push_back(&layer);
      if (isMainName(layer.name)) called.push_back(&layer);
    }
  }
  const Layers& some = all.size() > 1 ? called : all;
  const LayerFacts* const only = some.size() == 1 ? some.front() : nullptr;
  return only && only->bare > 0 && 2 * only->tiles <= only->cells ? only : nullptr;
}

std::vector<std::string> valuesGoneThrough(const Layers& layers) {
  std::map<std::string, Saying> values;
  for (const LayerFacts* layer : layers) values.insert(layer->values.begin(), layer->values.end());
  const bool isWalled =
      std::any_of(values.begin(), values.end(), [](const auto& value) { return value.second.isWall(); });
  std::vector<std::string> result;
  for (const auto& [name, said] : values) {
    const bool isFloor = isWalled && said.isFloor();
    if ((isGoneThrough(name) || isFloor) && result.size() < kMostRules) result.push_back(name);
  }
  return result.size() == values.size() ? std::vector<std::string>{} : result;
}

Options wholeLayer(const LayerFacts& layer, const Options& options) {
  Options result = options;
  result.layers = {layer.name};
  result.solidWithoutShapes = true;
  return result;
}

bool leaveChoice(const Options& options) {
  return !options.solidWithoutShapes && options.solidIf.empty() && !options.objects && options.tiles.empty();
}

}  // namespace lgs::tiled
