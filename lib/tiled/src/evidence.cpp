#include "evidence.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::size_t kMostRules = 16;  // of one choice

using Layers = std::vector<const LayerFacts*>;

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

std::string kindOf(const LayerFacts& layer) { return layer.kind == LayerKind::tiles ? "tile layer" : "object layer"; }

bool isUnderfoot(std::string_view word) { return word == "ground" || word == "floor" || word == "terrain"; }

/// Whether an object that says so is ground: a platform or a block may be a thing that moves.
bool isDrawnGround(std::string_view word) { return word == "wall" || isUnderfoot(word); }

/// Finds the choices of a map.
class Chooser {
 public:
  Chooser(const Facts& facts, const Options& options) : facts_(facts), options_(options) {}

  std::vector<Choice> run() {
    if (facts_.isLdtk) addIntGrids();
    if (hasShapes() && areShapesEnough()) addShapes();
    addNamed(Says::collision);
    addRules(Says::collision);
    addNamed(Says::ground);
    addRules(Says::ground);
    if (hasShapes() && !areShapesEnough()) addShapes();
    addObjectLayers(false);
    addTileLayers();
    addObjectLayers(true);
    return std::move(result_);
  }

 private:
  bool hasShapes() const {
    return std::any_of(facts_.layers.begin(), facts_.layers.end(), [](const LayerFacts& l) { return l.shaped > 0; });
  }

  /// Whether shapes of tiles are how this map says what is solid. They are not if the layers that say it have more tiles
  /// without shapes than there are with shapes anywhere.
  bool areShapesEnough() const {
    std::uint64_t bare = 0, shaped = 0;
    for (const LayerFacts& layer : facts_.layers) {
      shaped += layer.shaped;
      if (layer.saying.says != Says::nothing && !isFull(layer)) bare += layer.bare;
    }
    return shaped >= bare;
  }

  void add(Evidence evidence, Options options, std::string text) {
    result_.push_back({evidence, std::move(options), std::move(text)});
  }

  void addShapes() {
    std::uint64_t uses = 0;
    std::vector<std::string> names;
    for (const LayerFacts& layer : facts_.layers) {
      uses += layer.shaped;
      if (layer.shaped > 0) names.push_back(layer.name);
    }
    add(Evidence::shapes, options_, "the shapes of " + counted(uses, "tile") + " in " + listed(names));
  }

  /// IntGrid layers are all taken. But if some are called collision, the others are for something else.
  void addIntGrids() {
    Layers some;
    bool areAll = true;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.kind != LayerKind::tiles || layer.isDrawn || layer.tiles == 0) continue;
      const bool says = layer.saying.word.starts_with("coll");  // "Solid" may be one of several materials
      if (says) some.push_back(&layer);
      areAll = areAll && says;
    }
    if (some.empty() || areAll) return;
    Options options = options_;
    options.layers = namesOf(some);
    options.objects = namesOf(saying(LayerKind::objects, Says::collision));
    if (options.objects->empty()) options.objects.reset();
    add(Evidence::shapes, std::move(options), reasons(some));
  }

  /// Layers of a kind that say so, and hold what could be solid.
  Layers saying(LayerKind kind, Says says) const {
    Layers layers;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.kind != kind || layer.saying.says != says) continue;
      const bool isThere = kind == LayerKind::objects ? layer.objects + layer.lines > 0 : layer.tiles > 0;
      const bool isThing = facts_.isLdtk && kind == LayerKind::objects && !isDrawnGround(layer.saying.word);
      if (isThing && says == Says::ground) continue;
      if (isThere && !(kind == LayerKind::tiles && (isFull(layer) || isWalkedOn(layer)))) layers.push_back(&layer);
    }
    return layers;
  }

  /// A floor beside walls is what one walks on, seen from above, unless it is smaller than they are.
  bool isWalkedOn(const LayerFacts& floor) const {
    if (!isUnderfoot(floor.saying.word)) return false;
    std::uint64_t walls = 0;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.kind == LayerKind::tiles && layer.saying.word == "wall" && !isFull(layer)) walls += layer.tiles;
    }
    return walls > 0 && floor.tiles > walls;
  }

  void addNamed(Says says) {
    const Evidence evidence = says == Says::collision ? Evidence::collision : Evidence::ground;
    const Layers tiles = saying(LayerKind::tiles, says), objects = saying(LayerKind::objects, says);
    std::vector<std::string> objectNames = namesOf(objects);
    std::string text = reasons(objects);
    addClasses(says, objectNames, text);
    if (says == Says::ground && std::any_of(objects.begin(), objects.end(), [](const LayerFacts* layer) {
          return isDrawnGround(layer->saying.word);
        })) {
      addObjects(evidence, objectNames, text);  // they were drawn for it; the tiles need not be meant so
      objectNames.clear();
      text.clear();
    }
    if (tiles.empty()) {
      if (!objectNames.empty()) addObjects(evidence, objectNames, text);
    } else {
      Options options = options_;
      options.layers = namesOf(tiles);
      options.solidWithoutShapes = true;
      if (!objectNames.empty()) options.objects = objectNames;
      add(evidence, std::move(options), reasons(tiles) + (text.empty() ? "" : "; " + text));
    }
    addRules(says, true);
  }

  /// Those that are taken by themselves need not be named.
  void addObjects(Evidence evidence, const std::vector<std::string>& names, const std::string& text) {
    std::vector<std::string> all;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.kind == LayerKind::objects && layer.saying.says != Says::nothing) all.push_back(layer.name);
    }
    Options options = options_;
    if (names != all || !leaveChoice(options_)) options.objects = names;
    add(evidence, std::move(options), text);
  }

  /// Classes and names of objects in layers that say nothing.
  void addClasses(Says says, std::vector<std::string>& names, std::string& text) const {
    std::vector<std::string> classes;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.saying.says != Says::nothing) continue;
      for (const auto& [name, said] : layer.classes) {
        if (says == Says::ground && !isDrawnGround(said.word)) continue;  // "Platform" may be a thing that moves
        const bool isNew = std::find(classes.begin(), classes.end(), name) == classes.end();
        if (said.says == says && isNew && classes.size() < kMostRules) classes.push_back(name);
      }
    }
    if (classes.empty()) return;
    names.insert(names.end(), classes.begin(), classes.end());
    text += (text.empty() ? "" : "; ") + std::string("objects that are called ") + listed(classes);
  }

  /// Properties of tiles that say so, all together, or classes of tiles.
  void addRules(Says says, bool ofClass = false) {
    std::vector<std::pair<std::uint64_t, std::string>> rules;
    for (const auto& [rule, known] : facts_.rules) {
      if (known.says == says && rule.starts_with("class=") == ofClass) rules.push_back({known.uses, rule});
    }
    std::stable_sort(rules.begin(), rules.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    if (rules.size() > kMostRules) rules.resize(kMostRules);
    if (rules.empty()) return;
    Options options = options_;
    std::vector<std::string> names;
    for (const auto& [uses, rule] : rules) {
      options.solidIf.push_back(rule);
      names.push_back(rule + " (" + counted(uses, "tile") + ")");
    }
    const bool isSaid = std::any_of(facts_.layers.begin(), facts_.layers.end(), [](const LayerFacts& layer) {
      return layer.kind == LayerKind::objects && layer.saying.says != Says::nothing;
    });
    if (isSaid) options.objects = std::vector<std::string>{};
    const Evidence evidence = says == Says::ground ? Evidence::ground
                              : ofClass            ? Evidence::collision
                                                   : Evidence::properties;
    add(evidence, std::move(options), "tiles by a property: " + listed(names));
  }

  void addObjectLayers(bool ofThings) {
    for (const LayerFacts& layer : facts_.layers) {
      const bool areThings = layer.isForOther || 2 * layer.named > layer.objects;
      const bool isCovered = layer.saying.says != Says::nothing;
      if (layer.kind != LayerKind::objects || layer.objects == 0 || isCovered || areThings != ofThings) continue;
      Options options = options_;
      options.objects = {layer.name};
      add(Evidence::objectLayer, std::move(options),
          "object layer " + layer.name + ", " + counted(layer.objects, "object") + ": nothing says what it is");
    }
  }

  /// The likeliest first: what is no background, and does not fill the map, and of these the largest.
  void addTileLayers() {
    Layers layers;
    for (const LayerFacts& layer : facts_.layers) {
      const bool isCovered = layer.saying.says != Says::nothing && !isFull(layer) && !isWalkedOn(layer);
      if (layer.kind == LayerKind::tiles && layer.bare > 0 && !isCovered) layers.push_back(&layer);
    }
    const auto key = [](const LayerFacts* layer) {
      return std::tuple(layer->isForOther, isFull(*layer), -layer->share());
    };
    std::stable_sort(layers.begin(), layers.end(), [&](auto* a, auto* b) { return key(a) < key(b); });
    for (const LayerFacts* layer : layers) {
      add(Evidence::tileLayer, wholeLayer(*layer, options_),
          "tile layer " + layer->name + ", " + percent(layer->share()) + " of the map: nothing says what it is");
    }
  }

  static std::vector<std::string> namesOf(const Layers& layers) {
    std::vector<std::string> names;
    for (const LayerFacts* layer : layers) names.push_back(layer->name);
    return names;
  }

  static std::string reasons(const Layers& layers) {
    std::vector<std::string> all;
    for (const LayerFacts* layer : layers) all.push_back(kindOf(*layer) + " " + layer->name + ": " + layer->why);
    return listed(all);
  }

  const Facts& facts_;
  const Options& options_;
  std::vector<Choice> result_;
};

}  // namespace

std::vector<Choice> choices(const Facts& facts, const Options& options) { return Chooser(facts, options).run(); }

}  // namespace lgs::tiled
