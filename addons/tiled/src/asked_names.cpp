#include "asked_names.h"

#include <algorithm>

namespace lgs::tiled {
std::string thereAre(const std::string& name, const std::set<std::string>& names) {
  if (names.empty()) return {};
  std::vector<std::string> list(names.begin(), names.end());
  const auto rank = [&](const std::string& other) {
    return lower(other) == lower(name) ? 0 : areSimilar(other, name) ? 1 : 2;
  };
  std::stable_sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  for (std::string& other : list) other = inQuotes(other);
  return (list.size() == 1 ? "; there is " : "; there are ") + listed(list, 6);
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
    see(static_cast<const Called&>(tile));
    for (const Called& object : tile.objects) see(object);
  }
}

void AskedNames::see(const Layer& layer) {
  if (blockFrom_ == BlockFrom::layer) blocks_.see(layer.pathInMap);
  leftOut_.see(layer.pathInMap);
  leftOut_.see(layer.node.attribute("name").value());
  if (layer.kind == LayerKind::tiles) see(Called{"", "", propertiesOf(layer)});
  if (layer.kind == LayerKind::objects) see(Called{classOf(layer.node), "", {{kLayerProperty, layer.pathInMap}}});
  for (const auto node : layer.node.children("object")) see(calledOf(node));
}

void AskedNames::see(const Called& called) {
  for (const auto& [property, value] : called.properties) {
    properties_.see(property);
    if (const auto asked = values_.find(property); asked != values_.end()) asked->second.see(value);
  }
  for (const std::string* one : {&called.className, &called.name}) {
    if (one->empty()) continue;
    leftOut_.see(*one);
    if (blockFrom_ == BlockFrom::name || (blockFrom_ != BlockFrom::layer && one == &called.className))
      blocks_.see(*one);
  }
}

void AskedNames::report(Report& report) const {
  std::vector<std::string> missing;
  const auto tell = [&](const Names& names, const std::string& before, const std::string& rule = {}) {
    for (const std::string& name : names.asked) {
      if (names.seen.contains(name)) continue;
      report.notes.push_back(before + " '" + name + "'" + thereAre(name, names.seen));
      if (&names != &blocks_) missing.push_back(rule + name);
    }
  };
  const std::string noProperty = "no tile, tile layer or object has a property";
  tell(properties_, noProperty);
  for (const auto& [name, values] : values_)
    if (properties_.seen.contains(name)) tell(values, noProperty + " '" + name + "' with the value", name + "=");
  tell(leftOut_, "no tile, object or layer has the class or name");
  tell(tilesets_, "the map has no tileset");
  if (blockFrom_ == BlockFrom::layer) tell(blocks_, "no layer has the path");
  if (blockFrom_ == BlockFrom::name) tell(blocks_, "no tile, object or object layer has the class or name");
  if (blockFrom_ == BlockFrom::tileClass) tell(blocks_, "no tile, object or object layer has the class");
  if (blockFrom_ == BlockFrom::one && !blocks_.asked.empty())
    report.notes.push_back("numbers of names are not used, as all polygons get block 1: choose whose names (--block)");
  if (!missing.empty()) join(report.partial, "nothing has what was asked for: " + listed(missing));
}

bool areSimilar(std::string_view a, std::string_view b) {
  const std::string x = lower(a), y = lower(b);
  const auto [x1, y1] = std::mismatch(x.begin(), x.end(), y.begin(), y.end());
  const auto [x2, y2] = std::mismatch(x.rbegin(), std::reverse_iterator(x1), y.rbegin(), std::reverse_iterator(y1));
  const std::string restOfX(x1, x2.base()), restOfY(y1, y2.base());
  if (x == y) return true;
  if (restOfX == x && restOfY == y) return false;  // "x" and "y" are not similar
  const bool isSwapped = restOfX.size() == 2 && restOfX == std::string(restOfY.rbegin(), restOfY.rend());
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
