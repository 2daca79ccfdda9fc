#include "evidence.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs::tiled {
namespace {

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

std::string kindOf(const LayerFacts& layer) { return layer.kind == LayerKind::tiles ? "tile layer" : "object layer"; }

template <class Fits>
Layers layersOf(const Facts& facts, const Fits& fits) {
  Layers layers;
  for (const LayerFacts& layer : facts.layers)
    if (fits(layer)) layers.push_back(&layer);
  return layers;
}

std::vector<std::string> namesOf(const Layers& layers) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(layers.size(), kMostLayers); ++k) names.push_back(layers[k]->name);
  return names;
}

/// The object layers that say that they are solid.
Layers sayingObjects(const Facts& facts) {
  return layersOf(facts, [](const LayerFacts& layer) {
    return layer.kind == LayerKind::objects && layer.saying.says != Says::nothing;
  });
}

/// Finds the choices of a map.
class Chooser {
 public:
  Chooser(const Facts& facts, const Options& options) : facts_(facts), options_(options), squares_(options) {
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.kind != LayerKind::tiles) continue;
      isWalled_ |= layer.saying.isWall() && !isFull(layer) && layer.tiles > 0;
      if (layer.saying.isFloor()) floors_ += layer.share();
    }
    leaveOut();
  }

  std::vector<Choice> run() {
    const bool isDecided = !facts_.isLdtk || addIntGrids();
    if (isDecided) addSolid();
    if (isDecided) addGround();
    addOnlyLayer();
    if (isDecided && !namesOfSaying(facts_).empty())
      add(Evidence::onlyLayer, options_, "object layers whose tiles have shapes: " + listed(namesOfSaying(facts_)));
    addOffers();
    return std::move(result_);
  }

 private:
  void add(Evidence evidence, Options options, std::string text) {
    result_.push_back({evidence, std::move(options), std::move(text)});
  }

  /// No choice takes what is deadly or passable; nor pictures: backgrounds and what is above the player, whose tiles
  /// only look the same as those of another layer, and a floor that fills the map, if a layer says collision.
  void leaveOut() {
    for (const auto& [what, passable] : facts_.passable) {
      if (!passable.areSquares) options_.leaveOut.push_back(what);
      if (!passable.isLayer) squares_.leaveOut.push_back(what);
    }
    const bool isSaid = !facts_.isLdtk && !saying(LayerKind::tiles, Says::collision).empty();
    Layers pictures;
    bool areAll = true;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.uses.isPassable || layer.shaped + layer.ruled == 0) continue;
      const bool isPicture = layer.uses.isOnlySeen || (isSaid && layer.saying.isFloor() && isFull(layer));
      isPicture ? pictures.push_back(&layer) : void(areAll = false);
    }
    if (!areAll) pictures_ = namesOf(pictures);
    options_.leaveOut.insert(options_.leaveOut.end(), pictures_.begin(), pictures_.end());
  }

  /// IntGrid layers are all taken, but for those with another use, and floors beside walls. If some are called
  /// collision, the others are for something else. Values that one goes through are left out, and so is a floor beside
  /// walls. Returns whether there is something to be chosen.
  bool addIntGrids() {
    const Layers all = layersOf(facts_, [](const LayerFacts& layer) {
      return layer.kind == LayerKind::tiles && !layer.isDrawn && layer.tiles > 0;
    });
    if (all.empty()) return true;
    Layers called, some;
    for (const LayerFacts* layer : all) {
      if (layer->saying.word.starts_with("coll")) called.push_back(layer);  // "Solid" may be one of several materials
      if (!layer->uses.isOther || layer->uses.isForeground) some.push_back(layer);
    }
    if (std::any_of(all.begin(), all.end(), [](const LayerFacts* layer) { return layer->saying.isWall(); }))
      std::erase_if(some, [](const LayerFacts* layer) { return layer->saying.isFloor(); });
    if (!called.empty() || some.empty()) some = called.empty() ? all : called;
    const LayerFacts& largest = **std::max_element(some.begin(), some.end(), [](const auto* a, const auto* b) {
      return a->tiles * a->side * a->side < b->tiles * b->side * b->side;
    });
    const auto tail = std::stable_partition(some.begin(), some.end(), [&](auto* a) { return a->side == largest.side; });
    const Layers apart(tail, some.end());
    some.erase(tail, some.end());
    const bool isPart = some.size() < all.size();
    Options options = options_;
    if (isPart) {
      options.layers = namesOf(some);
      options.objects = namesOf(saying(LayerKind::objects, Says::collision));
      if (options.objects->empty()) options.objects.reset();
    }
    std::string text = called.empty() || !isPart ? "IntGrid layers: " + listed(namesOf(some)) : reasons(some);
    if (!options.objects) join(text, reasons(sayingObjects(facts_)));
    if (!apart.empty()) text += ", without those whose cells are of another size: " + listed(namesOf(apart));
    const auto [through, others, floors] = valuesOf(some);
    const bool isDecided = floors.empty();
    const Evidence evidence = isDecided ? Evidence::solid : Evidence::offered;
    const auto without = [&](const std::vector<std::string>& values) {
      Options rest = options;
      rest.leaveOut.insert(rest.leaveOut.end(), values.begin(), values.end());
      add(evidence, std::move(rest), text + (values.empty() ? "" : ", without " + listed(values)));
    };
    if (!isDecided) without(floors);
    without(through);
    if (isDecided && !others.empty() && others != through) without(others);
    if (!isPart) options.objects.emplace();  // all values, as whoever chooses gets them
    if (!through.empty()) without({});
    if (isPart && called.empty()) {
      options = options_;
      options.objects.emplace();
      add(Evidence::offered, std::move(options), "IntGrid layers: " + listed(namesOf(all)));
    }
    return isDecided;
  }

  /// Whether a layer says so, and holds what could be solid.
  bool isSaying(const LayerFacts& layer, LayerKind kind, Says says) const {
    if (layer.kind != kind || layer.saying.says != says || layer.uses.isPassable || isMixed(layer)) return false;
    if (kind == LayerKind::objects) return isDrawnByHand(layer);
    return layer.tiles > 0 && !isFull(layer) && !isWalkedOn(layer);
  }

  Layers saying(LayerKind kind, Says says) const {
    return layersOf(facts_, [&](const LayerFacts& layer) { return isSaying(layer, kind, says); });
  }

  /// In LDtk each kind of entity is a layer of its own.
  bool isMixed(const LayerFacts& layer) const { return !facts_.isLdtk && layer.isMixed(); }

  /// Floors beside walls are what one walks on, seen from above, if they fill together a quarter of the map.
  bool isWalkedOn(const LayerFacts& layer) const { return layer.saying.isFloor() && isWalled_ && floors_ > 0.25; }

  /// All that says collision, each tile by its own shape or as a square; then each kind of it by itself.
  void addSolid() {
    const auto isCollision = [&](const LayerFacts& layer) {
      return !facts_.isLdtk && isSaying(layer, LayerKind::tiles, Says::collision);
    };
    const Layers tiles = layersOf(facts_, isCollision),
                 shaped = layersOf(facts_, [&](const LayerFacts&layer) {
                   return layer.shaped > 0 && !layer.uses.isPassable && !has(pictures_, layer.name) && !facts_.isLdtk;
                 });
    std::uint64_t uses = 0;
    bool isOneLayer = true;
    for (const LayerFacts* layer : shaped) {
      uses += layer->shaped;
      isOneLayer &= isCollision(*layer);
    }
    const std::string ofShapes = "the shapes of " + counted(uses, "tile") + " in " + listed(namesOf(shaped));
    auto [rules, ofRules] = rulesOf(Says::collision, !shaped.empty());
    Options options = options_;
    std::string text = shaped.empty() ? "" : ofShapes;
    join(text, ofRules);
    options.solidIf = rules;
    if (!tiles.empty() && rules.empty() && isOneLayer) {
      text = reasons(tiles);
      options = wholeLayers(tiles);
    } else {
      for (const std::string& name : namesOf(tiles)) options.solidIf.push_back(kLayerProperty + ("=" + name));
      for (const auto& [what, passable] : facts_.passable)
        if (passable.areSquares && !tiles.empty()) options.leaveOut.push_back(what);
      join(text, reasons(tiles));
    }
    addObjects(Says::collision, !shaped.empty() || !rules.empty(), options, text);
    if (text.empty()) return;
    add(Evidence::solid, options, text);
    Options alone = options_;
    alone.objects.emplace();
    if (!shaped.empty()) add(Evidence::solid, std::move(alone), ofShapes + ", and no more");
    if (!tiles.empty()) add(Evidence::solid, wholeLayers(tiles), reasons(tiles));
    addRules(Evidence::solid, std::move(rules), std::move(ofRules));
  }

  /// Layers that say ground. Those that are drawn come first: they were drawn for it; tiles need not be meant so.
  void addGround() {
    const Layers tiles = saying(LayerKind::tiles, Says::ground), objects = saying(LayerKind::objects, Says::ground);
    Options drawn = options_, options = wholeLayers(tiles);
    std::string ofObjects, text = reasons(tiles);
    addObjects(Says::ground, tiles.empty(), drawn, ofObjects);
    const bool areClasses = drawn.objects && drawn.objects->size() > objects.size();
    const bool areGround = areClasses || std::any_of(objects.begin(), objects.end(),
                                                     [](const LayerFacts* layer) { return !layer->saying.isPart(); });
    if (!ofObjects.empty() && (areGround || tiles.empty())) add(Evidence::ground, drawn, ofObjects);
    if (!ofObjects.empty() && !areGround) {
      options.objects = drawn.objects;
      text += "; " + ofObjects;
    }
    if (!tiles.empty()) add(Evidence::ground, std::move(options), std::move(text));
    auto [rules, ofRules] = rulesOf(Says::ground, false);
    addRules(Evidence::ground, std::move(rules), std::move(ofRules));
  }

  void addRules(Evidence evidence, std::vector<std::string> rules, std::string text) {
    Options options = options_;
    options.solidIf = std::move(rules);
    if (!options.solidIf.empty()) add(evidence, std::move(options), std::move(text));
  }

  /// Object layers that say so, and with those that say collision walls and grounds that were drawn; and objects by
  /// their class or name. `areAll`: layers need not be named that are taken without a word.
  void addObjects(Says says, bool areAll, Options& options, std::string& text) const {
    Layers objects = saying(LayerKind::objects, says);
    const std::vector<std::string> classes = classesThatSay(says);
    if (says == Says::collision && !(text.empty() && objects.empty() && classes.empty()))
      for (const LayerFacts* layer : saying(LayerKind::objects, Says::ground))
        if (!layer->saying.isPart()) objects.push_back(layer);
    std::vector<std::string> names = namesOf(objects);
    join(text, reasons(objects));
    if (!classes.empty()) join(text, "objects that are called " + listed(classes));
    names.insert(names.end(), classes.begin(), classes.end());
    if (names.empty()) return;
    const bool isDefault = options.layers.empty() && leaveChoice(options_) && names == namesOfSaying(facts_);
    if (!isDefault && !(areAll && classes.empty() && says == Says::collision && options.layers.empty()))
      options.objects = std::move(names);
  }

  /// Classes and names of objects in layers that say nothing, or that hold things of all kinds.
  std::vector<std::string> classesThatSay(Says says) const {
    std::vector<std::string> classes;
    for (const LayerFacts& layer : facts_.layers) {
      if (layer.saying.says != Says::nothing && !isMixed(layer)) continue;
      for (const auto& [name, said] : layer.classes) {
        if (says == Says::ground && said.isPart()) continue;  // "Platform" may be a thing that moves
        if (said.says == says && !has(classes, name) && classes.size() < kMostRules) classes.push_back(name);
      }
    }
    return classes;
  }

  /// Properties of tiles, layers and objects that say so, and classes of tiles; and these in words. Beside shapes only
  /// those count that a layer has, or a tile with shapes: those of other tiles say something else.
  std::pair<std::vector<std::string>, std::string> rulesOf(Says says, bool besideShapes) const {
    std::vector<std::pair<std::uint64_t, std::string>> found;
    const bool isWalled = std::any_of(facts_.rules.begin(), facts_.rules.end(),
                                      [](const auto& rule) { return rule.second.saying.isWall(); });
    for (const auto& [rule, known] : facts_.rules) {
      const std::uint64_t uses = known.uses + known.objects;
      if (known.saying.says != says || uses == 0 || (besideShapes && !known.isOfShaped)) continue;
      if (isWalled && known.saying.isFloor()) continue;  // what one walks on between the walls
      found.push_back({uses, rule});
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    if (found.size() > kMostRules) found.resize(kMostRules);
    std::vector<std::string> rules, names;
    for (auto& [uses, rule] : found) {
      const RuleFacts& known = facts_.rules.at(rule);
      std::string counts = known.uses == 0 ? "" : counted(known.uses, "tile");
      if (known.objects > 0) join(counts, counted(known.objects, "object"), ", ");
      names.push_back(rule + " (" + counts + ")");
      rules.push_back(std::move(rule));
    }
    return {std::move(rules), names.empty() ? "" : "what has a property: " + listed(names)};
  }

  void addOnlyLayer() {
    const LayerFacts* const only = onlyLayer(facts_);
    if (!only) return;
    add(Evidence::onlyLayer, wholeLayers({only}),
        "tile layer " + only->name + ", " + percent(only->share()) + " of the map: it is the only one that could be");
  }

  /// What nothing speaks for. The likeliest come first: objects that are no things, and first those that are no pictures;
  /// tile layers that do not fill the map and are no background, of these what is called "tiles" or the like, and then
  /// the largest.
  void addOffers() {
    Layers layers = layersOf(facts_, [&](const LayerFacts& layer) {
      const bool says = layer.saying.says != Says::nothing;
      if (layer.kind == LayerKind::objects) return layer.objects > 0 && !(says && isDrawnByHand(layer));
      return layer.bare > 0 && (!says || isFull(layer) || isWalkedOn(layer));
    });
    const auto key = [](const LayerFacts* layer) {
      if (layer->kind == LayerKind::tiles)
        return std::tuple(1, isFull(*layer), isTiny(*layer), layer->uses.isOther, !layer->uses.isMain, -layer->share());
      const bool areOthers = layer->saying.says == Says::nothing && areThings(*layer);
      return std::tuple(areOthers ? 2 : 0, layer->figures > 0, false, false, false, 0.0);
    };
    std::stable_sort(layers.begin(), layers.end(), [&](auto* a, auto* b) { return key(a) < key(b); });
    if (layers.size() > kMostLayers) layers.resize(kMostLayers);  // no more are tried
    constexpr std::size_t kMostTogether = 4;                      // of more some are decoration
    Layers plain;  // nobody can tell which of them is the ground, or whether all are
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(plain), [&](const LayerFacts* layer) {
      return layer->kind == LayerKind::tiles && layer->saying.says == Says::nothing && !isFull(*layer) &&
             !isTiny(*layer) && !layer->uses.isOther && !layer->uses.isMain;
    });
    for (const LayerFacts* layer : layers) {
      const bool ofTiles = layer->kind == LayerKind::tiles;
      if (plain.size() > 1 && plain.size() <= kMostTogether && layer == plain.front())
        add(Evidence::offered, wholeLayers(plain),
            "tile layers " + listed(namesOf(plain)) + ": nothing says what they are");
      Options options = ofTiles ? wholeLayers({layer}) : options_;
      if (!ofTiles) options.objects = {layer->name};
      if (layer->bareFigures > 0 && layer->saying.says != Says::nothing) options.solidIf = {ruleOf(*layer)};
      add(Evidence::offered, std::move(options),
          concat(kindOf(*layer), " ", layer->name, ", ",
                 ofTiles ? percent(layer->share()) + " of the map" : counted(layer->objects, "object"),
                 ": nothing says what it is"));
    }
  }

  Options wholeLayers(const Layers& layers) const {
    Options options = squares_;
    options.layers = namesOf(layers);
    options.solidWithoutShapes = true;
    return options;
  }

  static std::string reasons(const Layers& layers) {
    std::vector<std::string> all;
    for (const LayerFacts* layer : layers) all.push_back(kindOf(*layer) + " " + layer->name + ": " + layer->why);
    return listed(all);
  }

  const Facts& facts_;
  Options options_;                    // those of the user, without what is not solid
  Options squares_;                    // the same for whole layers that are named
  std::vector<std::string> pictures_;  // tile layers whose shapes and properties do not count
  bool isWalled_ = false;              // there are tile layers of walls
  double floors_ = 0;                  // how much of the map tile layers of floors fill together
  std::vector<Choice> result_;
};

}  // namespace

std::vector<std::string> namesOfSaying(const Facts& facts) { return namesOf(sayingObjects(facts)); }

std::vector<Choice> choices(const Facts& facts, const Options& options) { return Chooser(facts, options).run(); }

}  // namespace lgs::tiled
