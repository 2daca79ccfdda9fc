#include "evidence.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs::tiled {
namespace {

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

std::string kindOf(const LayerFacts& layer) { return layer.kind == LayerKind::tiles ? "tile layer" : "object layer"; }

/// Whether an object that says so is ground: a platform or a block may be a thing that moves.
bool isDrawnGround(const Saying& said) { return said.isWall() || said.isFloor(); }

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
    addOnlyLayer();
    addObjectLayers(false);
    addTileLayers();
    addObjectLayers(true);
    return std::move(result_);
  }

 private:
  bool hasShapes() const {
    return std::any_of(facts_.layers.begin(), facts_.layers.end(), [](const LayerFacts& l) { return l.shaped > 0; });
  }

  /// Whether shapes of tiles are how this map says what is solid. They are not if the layers that say it have more
  /// tiles without shapes than there are with shapes anywhere.
  bool areShapesEnough() const {
    std::uint64_t bare = 0, shaped = 0;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.isDrawn) continue;
      shaped += layer.shaped;
      if (layer.saying.says != Says::nothing && !isFull(layer)) bare += layer.bare;
    }
    return shaped >= bare;
  }

  void add(Evidence evidence, Options options, std::string text) {
    result_.push_back({evidence, std::move(options), std::move(text)});
  }

  /// Where a property of shaped tiles says that they are solid, tiles that have it and no shape are taken, too.
  void addShapes() {
    std::uint64_t uses = 0;
    std::vector<std::string> names;
    const Layers layers = withoutPictures([](const LayerFacts& layer) { return layer.shaped > 0; });
    for (const LayerFacts* layer : layers) {
      uses += layer->shaped;
      names.push_back(layer->name);
    }
    Options options = narrowedTo(layers, [](const LayerFacts& layer) { return layer.shaped > 0; });
    for (const auto& [rule, known] : facts_.rules) {
      const bool isTaken = known.isOfShaped && known.uses > 0 && known.saying.says == Says::collision;
      if (isTaken && options.solidIf.size() < kMostRules) options.solidIf.push_back(rule);
    }
    add(Evidence::shapes, std::move(options), "the shapes of " + counted(uses, "tile") + " in " + listed(names));
  }

  /// The tile layers that have something; of these no background and nothing above the player, unless all are so: they
  /// use the same tiles only to look the same. Nor a floor that fills the map, if another layer says collision.
  template <class Has>
  Layers withoutPictures(const Has& hasIt) const {
    Layers all, some;
    const bool isSaid = !saying(LayerKind::tiles, Says::collision).empty() && !facts_.isLdtk;
    for (const LayerFacts& layer : facts_.layers) {
      if (!hasIt(layer)) continue;
      all.push_back(&layer);
      const bool isFilled = isSaid && layer.saying.isFloor() && isFull(layer);
      if (!layer.isOnlySeen && !isFilled) some.push_back(&layer);
    }
    return some.empty() ? all : some;
  }

  /// The options, with these layers if others have the same thing.
  template <class Has>
  Options narrowedTo(const Layers& layers, const Has& hasIt) const {
    Options options = options_;
    const auto all = std::count_if(facts_.layers.begin(), facts_.layers.end(), hasIt);
    if (static_cast<std::size_t>(all) == layers.size()) return options;
    options.layers = namesOf(layers);
    options.objects = namesOfSaying();
    return options;
  }

  /// IntGrid layers are all taken. But if some are called collision, the others are for something else. Values that one
  /// goes through are left out, and so is a floor beside walls.
  void addIntGrids() {
    Layers some, all;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.kind != LayerKind::tiles || layer.isDrawn || layer.tiles == 0) continue;
      all.push_back(&layer);
      if (layer.saying.word.starts_with("coll")) some.push_back(&layer);  // "Solid" may be one of several materials
    }
    if (some.empty()) some = all;
    const std::vector<std::string> through = valuesGoneThrough(some);
    if (some.size() == all.size() && through.empty()) return;
    Options options = options_;
    if (some.size() < all.size()) {
      options.layers = namesOf(some);
      options.objects = namesOf(saying(LayerKind::objects, Says::collision));
      if (options.objects->empty()) options.objects.reset();
    }
    options.leaveOut.insert(options.leaveOut.end(), through.begin(), through.end());
    std::string text = some.size() < all.size() ? reasons(some) : "IntGrid layers: " + listed(namesOf(some));
    if (!through.empty()) text += ", without " + listed(through);
    add(Evidence::shapes, std::move(options), std::move(text));
  }

  /// Layers of a kind that say so, and hold what could be solid.
  Layers saying(LayerKind kind, Says says) const {
    Layers layers;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.kind != kind || layer.saying.says != says || isMixed(layer)) continue;
      const bool isThere = kind == LayerKind::objects ? isDrawnByHand(layer) : layer.tiles > 0;
      const bool isThing = facts_.isLdtk && kind == LayerKind::objects && !isDrawnGround(layer.saying);
      if (isThing && says == Says::ground) continue;
      if (isThere && !(kind == LayerKind::tiles && (isFull(layer) || isWalkedOn(layer)))) layers.push_back(&layer);
    }
    return layers;
  }

  /// In LDtk each kind of entity is a layer of its own.
  bool isMixed(const LayerFacts& layer) const { return !facts_.isLdtk && layer.isMixed(); }

  /// A floor beside walls is what one walks on, seen from above, unless it is smaller than they are.
  bool isWalkedOn(const LayerFacts& floor) const {
    if (!floor.saying.isFloor()) return false;
    std::uint64_t walls = 0;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.kind == LayerKind::tiles && layer.saying.isWall() && !isFull(layer)) walls += layer.tiles;
    }
    return walls > 0 && floor.tiles > walls;
  }

  void addNamed(Says says) {
    const Evidence evidence = says == Says::collision ? Evidence::collision : Evidence::ground;
    const Layers tiles = saying(LayerKind::tiles, says);
    Layers objects = saying(LayerKind::objects, says);
    if (says == Says::collision && !(tiles.empty() && objects.empty())) addDrawnGround(objects);
    std::vector<std::string> objectNames = namesOf(objects);
    std::string text = reasons(objects);
    addClasses(says, objectNames, text);
    const bool areCalled = objectNames.size() > objects.size();
    if (says == Says::ground && (areCalled || std::any_of(objects.begin(), objects.end(), [](const LayerFacts* layer) {
                                   return isDrawnGround(layer->saying);
                                 }))) {
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

  /// Walls and grounds that were drawn are there for collision as well.
  void addDrawnGround(Layers& objects) const {
    for (const LayerFacts* layer : saying(LayerKind::objects, Says::ground)) {
      if (isDrawnGround(layer->saying)) objects.push_back(layer);
    }
  }

  /// Those that are taken by themselves need not be named.
  void addObjects(Evidence evidence, const std::vector<std::string>& names, const std::string& text) {
    Options options = options_;
    if (names != namesOfSaying() || !leaveChoice(options_)) options.objects = names;
    add(evidence, std::move(options), text);
  }

  /// The object layers that are taken without options.
  std::vector<std::string> namesOfSaying() const {
    std::vector<std::string> names;
    for (const LayerFacts& layer : facts_.layers) {
      if (names.size() == kMostLayers) break;
      if (layer.kind == LayerKind::objects && layer.saying.says != Says::nothing) names.push_back(layer.name);
    }
    return names;
  }

  /// Classes and names of objects in layers that say nothing, or that hold things of all kinds.
  void addClasses(Says says, std::vector<std::string>& names, std::string& text) const {
    std::vector<std::string> classes;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.saying.says != Says::nothing && !isMixed(layer)) continue;
      for (const auto& [name, said] : layer.classes) {
        if (says == Says::ground && !isDrawnGround(said)) continue;  // "Platform" may be a thing that moves
        const bool isNew = std::find(classes.begin(), classes.end(), name) == classes.end();
        if (said.says == says && isNew && classes.size() < kMostRules) classes.push_back(name);
      }
    }
    if (classes.empty()) return;
    names.insert(names.end(), classes.begin(), classes.end());
    text += (text.empty() ? "" : "; ") + std::string("objects that are called ") + listed(classes);
  }

  /// Properties of tiles and objects that say so, all together, or classes of tiles.
  void addRules(Says says, bool ofClass = false) {
    std::vector<std::pair<std::uint64_t, std::string>> rules;
    bool areObjects = false;
    const bool isWalled = std::any_of(facts_.rules.begin(), facts_.rules.end(),
                                      [](const auto& rule) { return rule.second.saying.isWall(); });
    for (const auto& [rule, known] : facts_.rules) {
      const std::uint64_t uses = known.uses + known.objects;
      if (known.saying.says != says || uses == 0 || rule.starts_with("class=") != ofClass) continue;
      if (isWalled && known.saying.isFloor()) continue;  // what one walks on between the walls
      rules.push_back({uses, rule});
      areObjects = areObjects || known.objects > 0;
    }
    std::stable_sort(rules.begin(), rules.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    if (rules.size() > kMostRules) rules.resize(kMostRules);
    if (rules.empty()) return;
    const auto hasRule = [&](const LayerFacts& layer) {
      return std::any_of(rules.begin(), rules.end(), [&](const auto& rule) {
        return layer.kind == LayerKind::tiles && facts_.rules.at(rule.second).layers.contains(layer.name);
      });
    };
    Options options = areObjects ? options_ : narrowedTo(withoutPictures(hasRule), hasRule);
    std::vector<std::string> names;
    for (const auto& [uses, rule] : rules) {
      options.solidIf.push_back(rule);
      const RuleFacts& known = facts_.rules.at(rule);
      const std::string tiles = known.uses == 0 ? "" : counted(known.uses, "tile");
      const std::string both = tiles.empty() || known.objects == 0 ? "" : ", ";
      names.push_back(rule + " (" + tiles + both + (known.objects == 0 ? "" : counted(known.objects, "object")) + ")");
    }
    if (!areObjects && !namesOfSaying().empty()) options.objects = std::vector<std::string>{};
    const Evidence evidence = says == Says::ground ? Evidence::ground
                              : ofClass            ? Evidence::collision
                                                   : Evidence::properties;
    add(evidence, std::move(options),
        std::string(areObjects ? "what has a property: " : "tiles by a property: ") + listed(names));
  }

  void addOnlyLayer() {
    const LayerFacts* const only = onlyLayer(facts_);
    if (!only) return;
    Options options = wholeLayer(*only, options_);
    if (!namesOfSaying().empty()) options.objects = std::vector<std::string>{};
    add(Evidence::onlyLayer, std::move(options),
        "tile layer " + only->name + ", " + percent(only->share()) + " of the map: it is the only one that could be");
  }

  void addObjectLayers(bool ofThings) {
    for (const LayerFacts& layer : facts_.layers) {
      const bool isCovered = layer.saying.says != Says::nothing && isDrawnByHand(layer);
      if (layer.kind != LayerKind::objects || layer.objects == 0 || isCovered || areThings(layer) != ofThings) continue;
      Options options = options_;
      options.objects = {layer.name};
      add(Evidence::objectLayer, std::move(options),
          "object layer " + layer.name + ", " + counted(layer.objects, "object") + ": nothing says what it is");
    }
  }

  /// The likeliest first: what is no background, and does not fill the map; of these what is called "tiles" or the
  /// like, and then the largest.
  void addTileLayers() {
    Layers layers;
    for (const LayerFacts& layer : facts_.layers) {
      const bool isCovered = layer.saying.says != Says::nothing && !isFull(layer) && !isWalkedOn(layer);
      if (layer.kind == LayerKind::tiles && layer.bare > 0 && !isCovered) layers.push_back(&layer);
    }
    const auto key = [](const LayerFacts* layer) {
      return std::tuple(layer->isForOther, isFull(*layer), !isMainName(layer->name), -layer->share());
    };
    std::stable_sort(layers.begin(), layers.end(), [&](auto* a, auto* b) { return key(a) < key(b); });
    for (const LayerFacts* layer : layers) {
      add(Evidence::tileLayer, wholeLayer(*layer, options_),
          "tile layer " + layer->name + ", " + percent(layer->share()) + " of the map: nothing says what it is");
    }
  }

  static std::vector<std::string> namesOf(const Layers& layers) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::min(layers.size(), kMostLayers); ++k) names.push_back(layers[k]->name);
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
