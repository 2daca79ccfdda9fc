#include "census.h"

#include "collision_object.h"
#include "ldtk.h"

#include <array>
#include <set>
#include <unordered_map>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::size_t kMostValue = 32;  // bytes of a value that can be a word
constexpr std::size_t kMostKnown = 64;  // rules that are counted; so a map of n bytes takes work in proportion to n

/// The rule that takes tiles with a property; empty if it says nothing.
std::pair<std::string, Saying> ruleOf(const std::string& name, const std::string& value) {
  if (name.find('=') != std::string::npos) return {};
  if (!saysYes(value))
    return usesOf(name).isPassage ? std::pair(name + "=" + value, Saying{Says::collision})
                                  : std::pair<std::string, Saying>();
  if (const Saying said = sayingOfProperty(name); said.says != Says::nothing) return {name, said};
  const Saying said = value.size() > kMostValue ? Saying{} : saying(value);
  return {said.says == Says::nothing ? "" : name + "=" + value, said};
}

class Census {
 public:
  explicit Census(const Options& options) : options_(options) {
    options_.solidWithoutShapes = true;  // so that layers which are only drawn are tile layers
    options_.objects = std::nullopt;
  }

  void take(const MapSource& map) {
    LayerNames names(options_);
    facts_.isLdtk = map.file->root().attribute(kLdtkAttribute);
    box_.reset();
    boxed_.clear();
    for (const Layer& layer : listLayers(*map.file, options_, map.place, names)) {
      if (map.file->failed()) return;
      if (layer.kind == LayerKind::tiles && layer.wanted) takeTiles(map, layer);
      if (layer.kind == LayerKind::objects && layer.isInReach) takeObjects(map, layer);
    }
    if (!box_) return;
    const std::int64_t columns = box_->max.x - box_->min.x + 1, rows = box_->max.y - box_->min.y + 1;
    for (const std::size_t at : boxed_) facts_.layers[at].cells += static_cast<std::uint64_t>(columns * rows);
  }

  Facts finish() { return std::move(facts_); }

 private:
  std::size_t factsOf(const Layer& layer) {
    const auto [at, isNew] = known_.try_emplace({layer.kind, layer.pathInMap}, facts_.layers.size());
    if (!isNew) return at->second;
    LayerFacts& facts = facts_.layers.emplace_back();
    facts.name = layer.pathInMap;
    facts.kind = layer.kind;
    facts.saying = sayingOf(layer.node, &facts.why);
    facts.uses = usesOf(layer.node.attribute("name").value());
    facts.uses.isPassable |= !noOf(propertiesOf(layer.node)).empty();
    facts.isDrawn = layer.node.attribute(kDrawnAttribute);
    facts.side = layer.node.attribute(kLdtkGridAttribute).as_ullong();
    return at->second;
  }

  void takeTiles(const MapSource& map, const Layer& layer) {
    const std::size_t at = factsOf(layer);
    std::unordered_map<std::uint32_t, std::uint64_t> uses;
    readTiles(*map.file, layer, tilesLeft_, [&](std::int64_t column, std::int64_t row, std::uint32_t gid) {
      ++uses[tileNumber(gid)];
      const Point tile{column, row};
      box_ = box_ ? boundingBox(std::array{box_->min, box_->max, tile}) : Box{tile, tile};
    });
    const auto side = [&](const char* name) { return layer.node.attribute(name).as_ullong(); };
    if (layer.node.child("data").child("chunk")) {
      boxed_.push_back(at);
    } else {
      facts_.layers[at].cells += side("width") * side("height");
    }
    LayerFacts& facts = facts_.layers[at];
    std::vector<RuleFacts*> rules;  // of the layer, for all of its tiles
    for (const auto& [name, value] : propertiesOf(layer.node)) {
      if (RuleFacts* const rule = ruleFacts(name, value)) rules.push_back(rule);
    }
    for (RuleFacts* const rule : rules) rule->isOfShaped = true;
    for (const auto& [number, count] : uses) takeTile(map, facts, rules, number, count);
    if (facts.uses.isPassable && facts.shaped + facts.ruled > 0) pass(facts.name, facts.shaped + facts.ruled, true);
  }

  /// The first property that says that something is not solid.
  static std::string noOf(const Properties& properties) {
    for (const auto& [name, value] : properties) {
      if (std::string no = noIn(name, value); !no.empty()) return no;
    }
    return {};
  }

  /// The class, name or property by which something is deadly or passable; or "".
  static std::string passableOf(const Called& called) {
    for (const std::string& one : {called.className, called.name})
      if (usesOf(one).isPassable) return one;
    return noOf(called.properties);
  }

  void pass(const std::string& what, std::uint64_t uses, bool isLayer = false, bool areSquares = false) {
    if (facts_.passable.size() == kMostKnown && !facts_.passable.contains(what)) return;
    const auto [at, isNew] = facts_.passable.try_emplace(what, PassableFacts{0, isLayer, areSquares});
    at->second.uses += uses;
    at->second.areSquares = at->second.areSquares && areSquares;
  }

  /// What holds for a tile in all layers, so that it is looked at once.
  struct KnownTile {
    bool isShaped = false, isBare = true;
    std::string passable;                // by what the tile is so
    std::set<std::string> shapes;        // by what some of its shapes are
    std::vector<RuleFacts*> rules = {};  // into facts_, whose map keeps them in place
  };

  const KnownTile& known(const Tile& tile) {
    const auto [at, isNew] = tiles_.try_emplace(&tile);
    KnownTile& result = at->second;
    if (!isNew) return result;
    result.isBare = tile.objects.empty();
    result.passable = passableOf(tile);
    for (const CollisionObject& drawn : tile.objects) {
      const auto kind = asAsked(drawn, options_).kind;
      if (kind == CollisionObject::Kind::unsupported || kind == CollisionObject::Kind::tile) continue;
      std::string why = passableOf(drawn);
      result.isShaped = result.isShaped || why.empty();
      if (!why.empty() && result.shapes.size() < kMostKnown) result.shapes.insert(std::move(why));
    }
    for (const auto& [name, value] : tile.properties) {
      RuleFacts* const rule = ruleFacts(name, value);
      if (!rule) continue;
      result.rules.push_back(rule);
      rule->isOfShaped = rule->isOfShaped || result.isShaped;
    }
    return result;
  }

  void takeTile(const MapSource& map, LayerFacts& facts, const std::vector<RuleFacts*>& ofLayer, std::uint32_t number,
                std::uint64_t uses) {
    facts.tiles += uses;
    const Tileset* const tileset = tilesetOf(map.tilesets, number);
    if (!tileset) return;
    const Tile& tile = tileset->tile(number - tileset->firstGid);
    if (isLeftOut(tile, options_)) return;
    const KnownTile& all = known(tile);
    if (facts_.isLdtk && !all.isBare) {
      if (tile.className.size() <= kMostValue) facts.values[tile.className] += uses;
    } else if (!all.passable.empty()) {
      facts.passable += uses;
      return pass(all.passable, uses, false, all.isBare);
    }
    if (!facts.uses.isPassable)
      for (const std::string& why : all.shapes) pass(why, uses);
    if (all.isShaped) facts.shaped += uses;
    if (tile.isSettled || !all.isBare) return;
    facts.bare += uses;
    std::set<RuleFacts*> rules(ofLayer.begin(), ofLayer.end());
    rules.insert(all.rules.begin(), all.rules.end());
    if (facts.isDrawn) rules.erase(ruleFacts("class", tile.className));  // which is the name of the layer
    if (!rules.empty()) facts.ruled += uses;
    for (RuleFacts* const rule : rules) rule->uses += uses;
  }

  /// The rule that takes what has a property; null if the property says nothing.
  RuleFacts* ruleFacts(const std::string& name, const std::string& value) {
    const auto [rule, said] = ruleOf(name, value);
    if (rule.empty()) return nullptr;
    const auto found = facts_.rules.find(rule);
    if (found != facts_.rules.end()) return &found->second;
    if (facts_.rules.size() == kMostKnown) return nullptr;
    RuleFacts& known = facts_.rules[rule];
    known.saying = said;
    return &known;
  }

  void takeObjects(const MapSource& map, const Layer& layer) {
    LayerFacts& facts = facts_.layers[factsOf(layer)];
    const bool isSaid = facts.saying.says != Says::nothing;
    for (const auto node : layer.node.children("object")) {
      const std::vector<DoublePoint> points = map.file->points(node.child("polyline"), "points");
      const bool isLine = !points.empty() && isOpen(points);
      facts.lines += isLine;
      if (isLine || node.child("point") || node.child("text")) continue;
      ++facts.objects;
      if (const auto gid = node.attribute("gid")) {
        const std::uint32_t number = tileNumber(gid.as_uint());
        const Tileset* const tileset = tilesetOf(map.tilesets, number);
        ++facts.figures;
        facts.bareFigures += tileset && tileset->tile(number - tileset->firstGid).objects.empty();
      }
      bool isNamed = false, isSilent = true;
      const Called called = calledOf(node);
      if (const std::string why = passableOf(called); isSaid && !why.empty()) {
        pass(why, 1);
        ++facts.passable;
      }
      for (const std::string& name : {called.className, called.name}) {
        const Saying said = saying(name);
        isNamed = isNamed || !name.empty();
        isSilent = isSilent && said.says == Says::nothing;
        if (said.says != Says::nothing) facts.classes[name] = said;
      }
      facts.named += isNamed;
      facts.silent += isNamed && isSilent;
      if (isNamed || facts_.isLdtk || node.attribute("gid")) continue;  // what has a name is judged by that
      for (const auto& [name, value] : called.properties) {
        if (RuleFacts* const known = ruleFacts(name, value)) ++known->objects;
      }
    }
  }

  Options options_;
  std::size_t tilesLeft_ = options_.maxTiles;
  Facts facts_;
  std::map<std::pair<LayerKind, std::string>, std::size_t> known_;
  std::unordered_map<const Tile*, KnownTile> tiles_;
  std::optional<Box> box_;          // of all tiles of one map, in columns and rows
  std::vector<std::size_t> boxed_;  // layers of one map that have no rectangle of their own
};

}  // namespace

Facts census(const Maps& maps, const Options& options) {
  Census result(options);
  for (const auto& map : maps) result.take(*map);
  return result.finish();
}

}  // namespace lgs::tiled
