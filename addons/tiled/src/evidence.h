// What speaks for each layer, class and property of a map, and what follows from it: which of them are taken by
// themselves, and what is offered. It knows facts alone, and no files.
#pragma once

#include "census.h"

namespace lgs::tiled {

/// Whether a layer fills so much of its rectangle that its tiles are not solid. One that says collision may be crowded,
/// but not full: then its tiles mean free as well.
inline bool isFull(const LayerFacts& layer) {
  return layer.share() >= (layer.saying.says == Says::collision ? 0.99 : 0.8);
}

/// The groups of evidence, the strongest first. Those of one group are taken together, and those of two never are.
enum class Evidence : std::uint8_t {
  solid,      ///< shapes of tiles; layers, classes and properties that say collision
  ground,     ///< those that say ground or wall
  onlyLayer,  ///< the only tile layer that could be it, and it is half empty
  offered,    ///< nothing but tiles, or objects with an area; it is offered and not taken
};

/// A choice that could be made.
struct Choice {
  Evidence evidence{};
  Options options;   ///< those of the user, with the choice
  std::string text;  ///< what it takes, and what speaks for it
};

/// Of one choice. Each name is looked for in each layer. More layers than that are said to be missed.
inline constexpr std::size_t kMostRules = 16, kMostLayers = 64;

/// "object layer Walls, of which 2 open polylines are left out"
std::string linesLeftOut(const std::string& layer, std::uint64_t lines);

/// Of open polylines, if it is offered, pixels.
inline constexpr double kLineThickness = 4;

using Layers = std::vector<const LayerFacts*>;

/// Whether an object layer has more than figures, which are things with pictures.
inline bool isDrawnByHand(const LayerFacts& layer) { return layer.objects > layer.figures || layer.lines > 0; }

/// The rule by which all tiles of a layer, or its tile objects, are full squares.
inline std::string ruleOf(const LayerFacts& layer) { return kLayerProperty + ("=" + layer.name); }

/// Whether the objects of a layer are things with names, rather than the boxes of a ground.
inline bool areNamed(const LayerFacts& layer) { return 2 * layer.named > layer.objects; }
inline bool areThings(const LayerFacts& layer) { return layer.uses.isOther || areNamed(layer); }

/// The only tile layer that could be solid, in a map that says nothing, or the only one of several that is called
/// "level" or the like, or a foreground beside nothing but backgrounds; or null. docs/maps.md has the rest.
const LayerFacts* onlyLayer(const Facts& facts);

/// Whether a layer has so little in it that it is hardly the ground.
inline bool isTiny(const LayerFacts& layer) { return layer.share() < 0.03; }

/// Values of IntGrid layers that are not solid, if there are others.
struct GridValues {
  std::vector<std::string> through;  ///< they have another use, such as water, or are a floor beside walls
  std::vector<std::string> others;   ///< all but the walls, or but those whose name says ground, if there are such
  std::vector<std::string> floors;   ///< a floor that fills most, without walls: bodies may stand on it, or walk on it
};
GridValues valuesOf(const Layers& layers);

/// All choices, the strongest first.
std::vector<Choice> choices(const Facts& facts, const Options& options);

/// The object layers that say that they are solid: they are taken if options name none.
std::vector<std::string> namesOfSaying(const Facts& facts);

/// Whether a choice may be made without a wish of the user's.
inline bool isTakenByItself(const Choice& choice) { return choice.evidence <= Evidence::onlyLayer; }

/// What else says that it is solid, and is not in a choice, or only in part, by what the import of the choice took.
struct Missed {
  std::string text;    ///< "tile layer Blocks, of which 211 of 349 tiles are taken"; empty for all others together
  Options options;     ///< that would take it
  std::string offer;   ///< what these take
  bool isDue = true;   ///< without it the map is taken in part; otherwise it may be weaker evidence for the same thing
  bool isSaid = true;  ///< something speaks for it; otherwise it is only there
};
std::vector<Missed> missed(const Facts& facts, const Choice& taken, const Options& options, const Report& report);

/// Those of the options that choose what is solid, as arguments of `lgs import`.
std::vector<std::string> choosingArguments(const Options& options);

/// Whether the options leave the choice to the map.
bool leaveChoice(const Options& options);

}  // namespace lgs::tiled
