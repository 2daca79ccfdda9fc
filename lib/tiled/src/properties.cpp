#include "properties.h"

#include <algorithm>
#include <array>

namespace lgs::tiled {
namespace {

/// "One-Way", "one_way" and "oneWay" are alike.
bool isOneWayWord(std::string_view name) {
  std::string text = lower(name);
  std::erase_if(text, [](char c) { return c == '-' || c == '_' || c == ' '; });
  constexpr std::array<std::string_view, 4> kWords{"oneway", "platform", "jumpthrough", "jumpthru"};
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

}  // namespace

Properties propertiesOf(pugi::xml_node node) {
  Properties result;
  for (const auto property : node.child("properties").children("property")) {
    const auto value = property.attribute("value");  // a text of several lines stands in the element instead
    result[property.attribute("name").value()] = value ? value.value() : property.text().get();
  }
  return result;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

bool saysYes(std::string_view value) { return !value.empty() && value != "false" && value != "0"; }

std::string propertyIn(const std::string& rule) { return rule.substr(0, rule.find('=')); }

const std::string* firstFit(const std::vector<std::string>& rules, const Properties& properties) {
  for (const std::string& rule : rules) {
    const std::size_t equals = rule.find('=');
    const auto found = properties.find(propertyIn(rule));
    if (found == properties.end()) continue;
    if (equals == std::string::npos ? saysYes(found->second) : found->second == rule.substr(equals + 1)) return &rule;
  }
  return nullptr;
}

std::string_view solidWord(std::string_view name) {
  constexpr std::array<std::string_view, 7> kWords{"collision", "collider", "solid",  "wall",
                                                   "ground",    "terrain",  "blocked"};
  const std::string text = lower(name);
  for (const std::string_view word : kWords) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      const std::string_view before = std::string_view(text).substr(0, at);
      if (word != "ground" || !(before.ends_with("back") || before.ends_with("fore"))) return word;
    }
  }
  return {};
}

std::string whySolid(pugi::xml_node node) {
  const auto said = [](const char* what, std::string_view word) {
    return std::string("its ") + what + " says '" + std::string(word) + "'";
  };
  if (const auto word = solidWord(node.attribute("name").value()); !word.empty()) return said("name", word);
  if (const auto word = solidWord(classOf(node)); !word.empty()) return said("class", word);
  for (const auto& [name, value] : propertiesOf(node)) {
    if (!solidWord(name).empty() && saysYes(value)) return "its property '" + name + "' says so";
  }
  return {};
}

bool saysOneWay(pugi::xml_node node) {
  if (isOneWayWord(node.attribute("name").value()) || isOneWayWord(classOf(node))) return true;
  const Properties properties = propertiesOf(node);
  return std::any_of(properties.begin(), properties.end(),
                     [](const auto& p) { return isOneWayWord(p.first) && saysYes(p.second); });
}

bool looksLikeCollision(std::string_view name) {
  constexpr std::array<std::string_view, 5> kParts{"collid", "collis", "block", "obstacle", "impass"};
  const std::string text = lower(name);
  const auto isIn = [&](std::string_view part) { return text.find(part) != std::string::npos; };
  return !solidWord(name).empty() || std::any_of(kParts.begin(), kParts.end(), isIn);
}

}  // namespace lgs::tiled
