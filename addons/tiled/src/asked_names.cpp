#include "asked_names.h"

#include <algorithm>

namespace lgs::tiled {
namespace {

/// One that is similar, or null. A name that differs by upper and lower case alone comes first.
const std::string* similarOne(const std::string& name, const std::set<std::string>& names) {
  const std::string* best = nullptr;
  for (const std::string& other : names) {
    const bool isSame = lower(other) == lower(name);
    if (isSame || (!best && areSimilar(other, name))) best = &other;
    if (isSame) break;
  }
  return best;
}

/// "; there is 'collides'", or nothing.
std::string thereIs(const std::string& name, const std::set<std::string>& names) {
  const std::string* const similar = similarOne(name, names);
  return similar ? "; there is '" + *similar + "'" : "";
}

}  // namespace

std::string thereAre(const std::string& value, const std::set<std::string>& values) {
  constexpr std::size_t kMost = 6;
  if (values.empty()) return {};
  std::vector<std::string> list;
  const std::string* const similar = similarOne(value, values);
  if (similar) list.push_back(*similar);
  for (const std::string& other : values) {
    if (list.size() < kMost && &other != similar) list.push_back(other);
  }
  std::string text = values.size() == 1 ? "; there is" : "; there are";
  for (const std::string& other : list) text += (&other == &list.front() ? " " : ", ") + inQuotes(other);
  return values.size() > kMost ? text + " and " + std::to_string(values.size() - kMost) + " more" : text;
}

AskedNames::AskedNames(const Options& options) : blockFrom_(options.blockFrom) {
  const auto addRule = [&](const std::string& rule) {
    rules_.insert(rule);
    if (const std::string name = propertyIn(rule); name != rule) values_[name];
  };
  for (const std::string& rule : options.solidIf) addRule(rule);
  for (const std::string& name : options.leaveOut)
    name.find('=') == std::string::npos ? void(leftOut_.insert(name)) : addRule(name);
  for (const auto& [name, block] : options.blocks) {
    if (!name.empty()) askedBlocks_.insert(name);  // "" stands for no class
  }
  for (const auto& [name, shapes] : options.tiles) {
    if (!name.empty()) tables_.insert(name);  // "" stands for any tileset
  }
}

void AskedNames::see(const Tileset& tileset) {
  if (!tables_.empty()) tilesets_.insert(tileset.name);
  for (const auto& [id, tile] : tileset.tiles) {
    seeProperties(tile.properties);
    seeClass(tile.className);
    for (const CollisionObject& object : tile.objects) see(object);
  }
}

void AskedNames::see(const Layer& layer) {
  if (blockFrom_ == BlockFrom::layer) blocks_.insert(layer.pathInMap);
  if (!leftOut_.empty()) classes_.insert({layer.pathInMap, layer.node.attribute("name").value()});
  if (layer.kind == LayerKind::tiles) seeProperties(propertiesOf(layer));
  if (layer.kind != LayerKind::objects) return;
  seeClass(classOf(layer.node));
  for (const auto node : layer.node.children("object")) {
    if (!rules_.empty()) seeProperties(propertiesOf(node));
    seeClass(classOf(node));
    seeObjectName(node.attribute("name").value());
  }
}

void AskedNames::see(const CollisionObject& object) {
  seeClass(object.className);
  seeObjectName(object.name);
  if (!rules_.empty()) seeProperties(object.properties);
}

void AskedNames::seeProperties(const Properties& properties) {
  for (const auto& [name, value] : properties) {
    properties_.insert(name);
    if (const auto asked = values_.find(name); asked != values_.end()) asked->second.insert(value);
  }
}

void AskedNames::seeClass(const std::string& className) {
  if (!leftOut_.empty()) classes_.insert(className);
  if (blockFrom_ != BlockFrom::layer && !className.empty()) blocks_.insert(className);
}

void AskedNames::seeObjectName(const std::string& name) {
  if (!leftOut_.empty()) classes_.insert(name);
  if (blockFrom_ == BlockFrom::name && !name.empty()) blocks_.insert(name);
}

/// What is to be said of a rule that takes nothing; empty if a value is there, or the rule takes any.
std::string AskedNames::noProperty(const std::string& rule) const {
  const std::string name = propertyIn(rule);
  if (!properties_.contains(name)) {
    return "no tile, tile layer or object has a property '" + name + "'" + thereIs(name, properties_);
  }
  if (name == rule) return {};
  const std::string value = rule.substr(name.size() + 1);
  const Names& values = values_.at(name);
  if (values.contains(value)) return {};
  return "no tile, tile layer or object has '" + value + "' as its property '" + name + "'" + thereAre(value, values);
}

std::string AskedNames::notUsed(const std::string& name) const {
  const char* const why = blockFrom_ == BlockFrom::layer  ? "no layer has this path"
                          : blockFrom_ == BlockFrom::name ? "no tile, object or object layer has this class or name"
                                                          : "no tile, object or object layer has this class";
  return "the number of '" + name + "' is not used: " + why + thereIs(name, blocks_);
}

std::vector<std::string> AskedNames::notes() const {
  std::vector<std::string> result;
  for (const std::string& rule : rules_) {
    const std::string text = noProperty(rule);
    if (!text.empty() && std::find(result.begin(), result.end(), text) == result.end()) result.push_back(text);
  }
  for (const std::string& name : leftOut_) {
    if (!classes_.contains(name)) {
      result.push_back("no tile, object or layer has the class or name '" + name + "', which was to be left out" +
                       thereIs(name, classes_));
    }
  }
  for (const std::string& name : tables_) {
    if (!tilesets_.contains(name)) {
      result.push_back("the map has no tileset '" + name + "', which the table of tiles names" +
                       thereAre(name, tilesets_));
    }
  }
  if (blockFrom_ == BlockFrom::one) {
    if (!askedBlocks_.empty()) {
      result.push_back("numbers of names are not used, as all polygons get block 1: choose whose names (--block)");
    }
    return result;
  }
  for (const std::string& name : askedBlocks_) {
    if (!blocks_.contains(name)) result.push_back(notUsed(name));
  }
  return result;
}

bool areSimilar(std::string_view a, std::string_view b) {
  const std::string x = lower(a), y = lower(b);
  const std::size_t most = std::min(x.size(), y.size());
  std::size_t begin = 0, end = 0;  // how many letters are alike
  while (begin < most && x[begin] == y[begin]) ++begin;
  while (end < most - begin && x[x.size() - 1 - end] == y[y.size() - 1 - end]) ++end;
  const std::string_view restOfX = std::string_view(x).substr(begin, x.size() - begin - end);
  const std::string_view restOfY = std::string_view(y).substr(begin, y.size() - begin - end);
  if (restOfX.empty() && restOfY.empty()) return true;
  if (begin + end == 0) return false;  // "x" and "y" are not similar
  const bool isSwapped =
      restOfX.size() == 2 && restOfY.size() == 2 && restOfX[0] == restOfY[1] && restOfX[1] == restOfY[0];
  return isSwapped || std::max(restOfX.size(), restOfY.size()) == 1;
}

}  // namespace lgs::tiled
