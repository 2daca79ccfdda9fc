// What Options choose, and how a command says it; and which layers and values could be chosen.
#include "evidence.h"

#include <fast_float/fast_float.h>
#include <algorithm>
#include <utility>

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

Options chosen(Options options, const Suggestion& suggestion) {
  options.layers = options.solidIf = options.leaveOut = {};
  options.objects.reset();
  options.solidWithoutShapes = options.visibleOnly = false;
  options.tiles = {};
  options.polylineThickness = 0;
  std::string option;
  for (const std::string& word : suggestion.arguments) {  // an option, or the value of the one before it
    const std::string before = std::exchange(option, {});
    if (before == "--layer") {
      options.layers.push_back(word);
    } else if (before == "--solid-if") {
      options.solidIf.push_back(word);
    } else if (before == "--not") {
      options.leaveOut.push_back(word);
    } else if (before == "--objects") {
      options.objects->push_back(word);
    } else if (before == "--polyline-thickness") {
      fast_float::from_chars(word.data(), word.data() + word.size(), options.polylineThickness);
    } else if (word == "--solid") {
      options.solidWithoutShapes = true;
    } else if (word == "--visible") {
      options.visibleOnly = true;
    } else {
      if ((word == "--objects" || word == "--no-objects") && !options.objects) options.objects.emplace();
      if (word != "--no-objects") option = word;
    }
  }
  return options;
}

const LayerFacts* onlyLayer(const Facts& facts) {
  Layers all, called;
  std::uint64_t passedOver = 0;  // tiles of the largest layer that its name rules out, and that is no picture
  for (const LayerFacts& layer : facts.layers) {
    if (layer.kind == LayerKind::objects) {
      const bool areBoxes = layer.objects > layer.figures && !areThings(layer);
      if (layer.saying.says == Says::nothing && areBoxes) return nullptr;
    } else if (layer.tiles > 0 && layer.isForOther) {
      if (!isFull(layer)) passedOver = std::max(passedOver, layer.tiles);
    } else if (layer.tiles > 0) {
      if (layer.isDrawn) return nullptr;
      all.push_back(&layer);
      if (isMainName(layer.name)) called.push_back(&layer);
    }
  }
  const Layers& some = all.size() > 1 ? called : all;
  const LayerFacts* const only = some.size() == 1 ? some.front() : nullptr;
  const bool isIt = only && only->bare > 0 && 2 * only->tiles <= only->cells && only->tiles >= passedOver;
  return isIt && !isTiny(*only) ? only : nullptr;
}

namespace {

/// The values of some IntGrid layers that a test fits, with what they say and how many cells have them.
template <class Fits>
std::vector<std::string> valuesThat(const Layers& layers, const Fits& fits) {
  std::map<std::string, std::uint64_t> values;
  for (const LayerFacts* layer : layers) {
    for (const auto& [name, uses] : layer->values) values[name] += uses;
  }
  const bool isWalled =
      std::any_of(values.begin(), values.end(), [](const auto& value) { return saying(value.first).isWall(); });
  std::vector<std::string> result;
  for (const auto& [name, uses] : values)
    if (fits(name, uses, isWalled) && result.size() < kMostRules) result.push_back(name);
  return result.size() == values.size() ? std::vector<std::string>{} : result;
}

}  // namespace

std::vector<std::string> valuesGoneThrough(const Layers& layers) {
  return valuesThat(layers, [](const std::string& name, std::uint64_t, bool isWalled) {
    return isGoneThrough(name) || (isWalled && saying(name).isFloor());
  });
}

std::vector<std::string> floorsWithoutWalls(const Layers& layers) {
  std::uint64_t cells = 0;
  for (const LayerFacts* layer : layers) cells += layer->cells;
  return valuesThat(layers, [&](const std::string& name, std::uint64_t uses, bool isWalled) {
    return !isWalled && saying(name).isFloor() && 2 * uses > cells;
  });
}

bool leaveChoice(const Options& options) {
  return !options.solidWithoutShapes && options.solidIf.empty() && !options.objects && options.tiles.empty();
}

}  // namespace lgs::tiled
