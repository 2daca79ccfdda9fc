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

bool saysYes(std::string_view value) { return value != "false" && value != "0"; }

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

std::string noIn(const std::string& property, const std::string& value) {
  const bool isNo =
      !saysYes(value) && property.find('=') == std::string::npos && sayingOfProperty(property).says == Says::collision;
  return isNo ? property + "=" + value : "";
}

Saying sayingOf(pugi::xml_node node, std::string* why) {
  Saying strongest;
  const auto hear = [&](const Saying& what, const std::string& reason) {
    if (what.says <= strongest.says) return;
    strongest = what;
    if (why) *why = reason;
  };
  const auto quoted = [](const Saying& what) { return " says '" + std::string(what.word) + "'"; };
  const Saying name = saying(node.attribute("name").value()), type = saying(classOf(node));
  hear(name, "its name" + quoted(name));
  hear(type, "its class" + quoted(type));
  const Properties properties = std::string_view(node.name()) == "layer" ? Properties{} : propertiesOf(node);
  for (const auto& [property, value] : properties) {
    if (saysYes(value)) hear(sayingOfProperty(property), "its property '" + property + "' says so");
  }
  return strongest;
}

bool saysOneWay(pugi::xml_node node) {
  if (isOneWayWord(node.attribute("name").value()) || isOneWayWord(classOf(node))) return true;
  const Properties properties = propertiesOf(node);
  return std::any_of(properties.begin(), properties.end(),
                     [](const auto& p) { return isOneWayWord(p.first) && saysYes(p.second); });
}

}  // namespace lgs::tiled
