#include "census.h"

#include "ldtk.h"
#include "object_outline.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::size_t kMostValue = 32;  // bytes of a value that can be a word
constexpr std::size_t kMostKnown = 64;  // rules that are counted; so a map of n bytes takes work in proportion to n

/// Columns and rows of tiles that are not empty.
struct TileBox {
  std::int64_t left = 0, right = 0, top = 0, bottom = 0;
  bool isEmpty = true;

  void add(std::int64_t column, std::int64_t row) {
    left = isEmpty ? column : std::min(left, column);
    right = isEmpty ? column : std::max(right, column);
    top = isEmpty ? row : std::min(top, row);
    bottom = isEmpty ? row : std::max(bottom, row);
    isEmpty = false;
  }

  std::uint64_t cells() const {
    return isEmpty ? 0 : static_cast<std::uint64_t>((right - left + 1) * (bottom - top + 1));
  }
};

/// The rule that takes tiles with a property; empty if it says nothing.
std::pair<std::string, Saying> ruleOf(const std::string& name, const std::string& value) {
  if (name.find('=') != std::string::npos || !saysYes(value)) return {};
  if (const Saying said = sayingOfProperty(name); said.says != Says::nothing) return {name, said};
  const Saying said = value.size() > kMostValue ? Saying{} : saying(value);
  return {said.says == Says::nothing ? "" : name + "=" + value, said};
}

class Census {
 public:
  Census(const Options& options, std::size_t& tilesLeft) : options_(options), tilesLeft_(tilesLeft) {
    options_.solidWithoutShapes = true;  // so that layers which are only drawn are tile layers
    options_.objects = std::nullopt;
  }

  void take(const MapSource& map) {
    LayerNames names(options_);
    facts_.isLdtk = map.file->root().attribute(kLdtkAttribute);
    box_ = {};
    boxed_.clear();
    for (const Layer& layer : listLayers(*map.file, options_, map.place, names)) {
      if (map.file->failed()) return;
      if (layer.hidden) facts_.hidden.push_back(layer.path);
      if (layer.kind == LayerKind::tiles && layer.wanted) takeTiles(map, layer);
      if (layer.kind == LayerKind::objects && layer.isInReach) takeObjects(map, layer);
    }
    for (const std::size_t at : boxed_) facts_.layers[at].cells += box_.cells();
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
    facts.isForOther = isForOtherUse(layer.node.attribute("name").value());
    facts.isOnlySeen = isOnlySeen(layer.node.attribute("name").value());
    facts.isDrawn = layer.node.attribute(kDrawnAttribute);
    return at->second;
  }

  void takeTiles(const MapSource& map, const Layer& layer) {
    if (layer.node.attribute(kLdtkNotSolidAttribute)) return;
    const std::size_t at = factsOf(layer);
    std::unordered_map<std::uint32_t, std::uint64_t> uses;
    readTiles(*map.file, layer, tilesLeft_, [&](std::int64_t column, std::int64_t row, std::uint32_t gid) {
      ++uses[tileNumber(gid)];
      box_.add(column, row);
    });
    const auto side = [&](const char* name) { return layer.node.attribute(name).as_ullong(); };
    if (layer.node.child("data").child("chunk")) {
      boxed_.push_back(at);
    } else {
      facts_.layers[at].cells += side("width") * side("height");
    }
    for (const auto& [number, count] : uses) takeTile(map, facts_.layers[at], number, count);
  }

  void takeTile(const MapSource& map, LayerFacts& facts, std::uint32_t number, std::uint64_t uses) {
    facts.tiles += uses;
    const Tileset* const tileset = map.tilesets.of(number);
    if (!tileset) return;
    const auto found = tileset->tiles.find(number - tileset->firstGid);
    if (found == tileset->tiles.end()) {
      facts.bare += uses;
      return;
    }
    const Tile& tile = found->second;
    if (isLeftOut(tile, options_)) return;
    const auto hasArea = [&](const CollisionObject& object) {
      const auto kind = asAsked(object, options_).kind;
      return kind != CollisionObject::Kind::unsupported && kind != CollisionObject::Kind::tile;
    };
    const bool isShaped = std::any_of(tile.objects.begin(), tile.objects.end(), hasArea);
    if (isShaped) facts.shaped += uses;
    if (facts_.isLdtk && isShaped && tile.className.size() <= kMostValue) {
      facts.values[tile.className] = saying(tile.className);
    }
    if (tile.isSettled) return;
    const bool isBare = tile.objects.empty();
    if (isBare) facts.bare += uses;
    for (RuleFacts* const known : rulesOf(tile)) {
      known->isOfShaped = known->isOfShaped || isShaped;
      if (!isBare) continue;
      known->uses += uses;
      known->layers[facts.name] += uses;
    }
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

  /// A tile may be in all layers, so its properties are looked at once.
  const std::vector<RuleFacts*>& rulesOf(const Tile& tile) {
    const auto [at, isNew] = rulesOf_.try_emplace(&tile);
    if (!isNew) return at->second;
    for (const auto& [name, value] : tile.properties) {
      if (RuleFacts* const known = ruleFacts(name, value)) at->second.push_back(known);
    }
    return at->second;
  }

  void takeObjects(const MapSource& map, const Layer& layer) {
    LayerFacts& facts = facts_.layers[factsOf(layer)];
    for (const auto node : layer.node.children("object")) {
      const auto polyline = node.child("polyline");
      const bool isLine = polyline && map.file->points(polyline, "points").size() > 0 && !isClosed(*map.file, polyline);
      facts.lines += isLine;
      if (isLine || node.child("point") || node.child("text")) continue;
      ++facts.objects;
      facts.figures += static_cast<bool>(node.attribute("gid"));
      bool isNamed = false, isSilent = true;
      for (const std::string& name : {classOf(node), std::string(node.attribute("name").value())}) {
        const Saying said = saying(name);
        isNamed = isNamed || !name.empty();
        isSilent = isSilent && said.says == Says::nothing;
        if (said.says != Says::nothing) facts.classes[name] = said;
      }
      facts.named += isNamed;
      facts.silent += isNamed && isSilent;
      if (isNamed || facts_.isLdtk || node.attribute("gid")) continue;  // what has a name is judged by that
      for (const auto& [name, value] : propertiesOf(node)) {
        if (RuleFacts* const known = ruleFacts(name, value)) ++known->objects;
      }
    }
  }

  static bool isClosed(const XmlFile& file, pugi::xml_node polyline) {
    const std::vector<DoublePoint> points = file.points(polyline, "points");
    return points.size() > 3 && points.front().x == points.back().x && points.front().y == points.back().y;
  }

  Options options_;
  std::size_t& tilesLeft_;
  Facts facts_;
  std::map<std::pair<LayerKind, std::string>, std::size_t> known_;
  std::unordered_map<const Tile*, std::vector<RuleFacts*>> rulesOf_;  // into facts_, whose map keeps them in place
  TileBox box_;                                                       // of all tile layers of one map
  std::vector<std::size_t> boxed_;  // layers of one map that have no rectangle of their own
};

}  // namespace

Facts census(const std::vector<std::unique_ptr<MapSource>>& maps, const Options& options, std::size_t& tilesLeft) {
  Census result(options, tilesLeft);
  for (const auto& map : maps) result.take(*map);
  return result.finish();
}

}  // namespace lgs::tiled
