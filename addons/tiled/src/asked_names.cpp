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
  if (values.empty()) return {};
  std::vector<std::string> list;
  const std::string* const similar = similarOne(value, values);
  if (similar) list.push_back(inQuotes(*similar));
  for (const std::string& other : values)
    if (&other != similar) list.push_back(inQuotes(other));
  return (values.size() == 1 ? "; there is " : "; there are ") + listed(list, 6);
}

AskedNames::AskedNames(const Options& options) : blockFrom_(options.blockFrom) {
  const auto addRule = [&](const std::string& rule) {
    const std::string name = propertyIn(rule);
    properties_.asked.insert(name);
    if (name != rule) values_[name].asked.insert(rule.substr(name.size() + 1));
  };
  const auto add = [](Names& names, const std::string& name) {
    if (!name.empty()) names.asked.insert(name);  // "" stands for no class, and for any tileset
  };
  for (const std::string& rule : options.solidIf) addRule(rule);
  for (const std::string& name : options.leaveOut)
    name.find('=') == std::string::npos ? void(leftOut_.asked.insert(name)) : addRule(name);
  for (const auto& [name, block] : options.blocks) add(blocks_, name);
  for (const auto& [name, shapes] : options.tiles) add(tilesets_, name);
}

void AskedNames::see(const Tileset& tileset) {
  tilesets_.see(tileset.name);
  for (const auto& [id, tile] : tileset.tiles) {
    seeProperties(tile.properties);
    seeClass(tile.className);
    for (const CollisionObject& object : tile.objects) see(object);
  }
}

void AskedNames::see(const Layer& layer) {
  if (blockFrom_ == BlockFrom::layer) blocks_.see(layer.pathInMap);
  leftOut_.see(layer.pathInMap);
  leftOut_.see(layer.node.attribute("name").value());
  if (layer.kind == LayerKind::tiles) seeProperties(propertiesOf(layer));
  if (layer.kind != LayerKind::objects) return;
  seeClass(classOf(layer.node));
  for (const auto node : layer.node.children("object")) {
    if (!properties_.asked.empty()) seeProperties(propertiesOf(node));
    seeClass(classOf(node));
    seeObjectName(node.attribute("name").value());
  }
}

void AskedNames::see(const CollisionObject& object) {
  seeClass(object.className);
  seeObjectName(object.name);
  seeProperties(object.properties);
}

void AskedNames::seeProperties(const Properties& properties) {
  if (properties_.asked.empty()) return;
  for (const auto& [name, value] : properties) {
    properties_.see(name);
    if (const auto asked = values_.find(name); asked != values_.end()) asked->second.see(value);
  }
}

void AskedNames::seeClass(const std::string& className) {
  leftOut_.see(className);
  if (blockFrom_ != BlockFrom::layer && !className.empty()) blocks_.see(className);
}

void AskedNames::seeObjectName(const std::string& name) {
  leftOut_.see(name);
  if (blockFrom_ == BlockFrom::name && !name.empty()) blocks_.see(name);
}

std::vector<std::string> AskedNames::notes() const {
  std::vector<std::string> result;
  const auto tell = [&](const Names& names, const std::string& before, const std::string& after, const auto& others) {
    for (const std::string& name : names.asked) {
      if (!names.seen.contains(name)) result.push_back(before + "'" + name + "'" + after + others(name, names.seen));
    }
  };
  tell(properties_, "no tile, tile layer or object has a property ", "", thereIs);
  for (const auto& [name, values] : values_) {
    if (properties_.seen.contains(name))
      tell(values, "no tile, tile layer or object has ", " as its property '" + name + "'", thereAre);
  }
  tell(leftOut_, "no tile, object or layer has the class or name ", ", which was to be left out", thereIs);
  tell(tilesets_, "the map has no tileset ", ", which the table of tiles names", thereAre);
  if (blockFrom_ == BlockFrom::one && !blocks_.asked.empty())
    result.push_back("numbers of names are not used, as all polygons get block 1: choose whose names (--block)");
  const char* const noBlock = blockFrom_ == BlockFrom::layer  ? "no layer has this path"
                              : blockFrom_ == BlockFrom::name ? "no tile, object or object layer has this class or name"
                                                              : "no tile, object or object layer has this class";
  if (blockFrom_ != BlockFrom::one) tell(blocks_, "the number of ", std::string(" is not used: ") + noBlock, thereIs);
  return result;
}

std::string AskedNames::notThere() const {
  std::vector<std::string> names;
  const auto add = [&](const Names& of, const std::string& before) {
    for (const std::string& name : of.asked)
      if (!of.seen.contains(name)) names.push_back(before + name);
  };
  add(properties_, "");
  for (const auto& [name, values] : values_)
    if (properties_.seen.contains(name)) add(values, name + "=");
  add(leftOut_, "");
  add(tilesets_, "");
  return names.empty() ? "" : "nothing has what was asked for: " + listed(names);
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

void BlockNumbers::report(ImportedMap& map) const {
  map.blocks = numbers_;
  const auto add = [](std::string& names, const std::string& name) {
    join(names, name.empty() ? "(no class)" : name, ", ");
  };
  if (std::string names; !asTheyCame_.empty()) {
    for (const std::string& name : asTheyCame_) add(names, name);
    map.report.notes.push_back("blocks are numbered in the order of their first use: " + names +
                               ". An edit of the map may change the numbers. Choose them, or look them up by name");
  }
  std::map<Block, std::uint64_t> polygons;
  for (const MapPolygon& placement : map.placements) ++polygons[placement.block];
  std::map<Block, std::string> names;
  for (const auto& [name, number] : numbers_) add(names[number], name);
  for (const auto& [block, count] : polygons) map.report.blocks.push_back({names[block], block, count});
}

}  // namespace lgs::tiled
