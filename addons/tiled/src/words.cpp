#include "words.h"

#include "asked_names.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace lgs::tiled {
namespace {

/// A longer word stands before a shorter one that is in it, as reports name the first that fits. Those of kLong letters
/// are known with a letter wrong as well: "Obsticles", "Plataformas".
constexpr std::size_t kLong = 8;
constexpr auto kCollision = std::to_array<std::string_view>(
    {"collision", "collider", "collidable", "collides",   "collide", "collid",   "collis",
     "colid",     "colis",    "kollis",     "hitbox",     "solid",   "blocked",  "blocking",
     "blocker",   "obstacle", "obstac",     "impassable", "barrier", "boundary", "boundaries"});
constexpr auto kWalls = std::to_array<std::string_view>({"wall", "border", "fence", "static", "parede", "muro"});
constexpr auto kFloors = std::to_array<std::string_view>({"ground", "floor", "terrain", "surface", "world", "gnd",
                                                          "suelo", "boden", "terreno", "geom", "slope", "pendiente"});
constexpr auto kParts = std::to_array<std::string_view>({"platform", "block", "brick", "pipe", "bloque", "bloco"});

/// Words that are too short to be looked for in others.
constexpr auto kWholeWalls = std::to_array<std::string_view>({"mur", "murs"});
constexpr auto kWholeFloors = std::to_array<std::string_view>({"sol", "ramp", "ramps"});

struct Words {
  Saying are;
  std::span<const std::string_view> words;
  bool areWhole = false;
};
constexpr auto kWords = std::to_array<Words>({{{Says::collision}, kCollision},
                                              {{Says::ground, {}, Ground::wall}, kWalls},
                                              {{Says::ground, {}, Ground::wall}, kWholeWalls, true},
                                              {{Says::ground, {}, Ground::floor}, kFloors},
                                              {{Says::ground, {}, Ground::floor}, kWholeFloors, true},
                                              {{Says::ground, {}, Ground::part}, kParts}});

/// Words that turn the one after them into its opposite, or that are written together with it.
constexpr auto kNot = std::to_array<std::string_view>({"anti", "no", "non", "not", "un", "without"});

/// What lets bodies pass; what does not is solid: "non_traversable", "unwalkable".
constexpr auto kPassed = std::to_array<std::string_view>({"passab", "traversab", "walkab"});

/// Words for another use, as they are. They are also looked for before and after a word that is written together.
constexpr auto kOther = std::to_array<std::string_view>(
    {"art",    "back",  "background", "behind", "below",      "bg",    "cam", "camera", "con",   "fake",
     "far",    "fg",    "fire",       "fore",   "foreground", "front", "fx",  "item",   "items", "light",
     "lights", "mid",   "middle",     "moving", "npc",        "npcs",  "old", "paper",  "pass",  "passable",
     "path",   "paths", "play",       "player", "sprite",     "sur",   "win", "with"});

/// The same for words that begin so.
constexpr auto kOtherBegins = std::to_array<std::string_view>({
    "ambient", "check",  "cloud",  "coin",     "collect", "decal",   "deco",   "detail", "door",
    "effect",  "enem",   "entit",  "entr",     "event",   "exit",    "finish", "flag",   "fond",
    "goal",    "hinter", "ignor",  "liquid",   "navig",   "overlay", "portal", "shadow", "sky",
    "spawn",   "start",  "switch", "teleport", "toxic",   "visual",  "walkab", "warp",   "water",
});

/// What lies behind or above the layer that one walks in, and is only seen; the second for words that begin so.
constexpr auto kSeen = std::to_array<std::string_view>({"back", "bg", "far", "fg", "fore", "front", "over", "sky"});
constexpr auto kSeenBegins = std::to_array<std::string_view>({"above", "background", "behind", "below", "foreground"});

/// What is deadly, or lets bodies through, in whatever layer it is; and values of cells that are no ground.
constexpr auto kPassableBegins =
    std::to_array<std::string_view>({"damag", "dead", "death", "echel", "escad", "escaler", "hazard", "hurt", "kill",
                                     "ladder", "leiter", "lethal", "rope", "sensor", "spike", "trigger", "vine"});
constexpr auto kFluidBegins =
    std::to_array<std::string_view>({"acid", "empty", "hole", "lava", "pit", "void", "water"});

/// What a property can be that is about collision, and does not say that there is any.
constexpr auto kOfProperties = std::to_array<std::string_view>(
    {"category", "col",  "color",  "colour", "filter", "friction", "group", "height", "id", "index", "mask",
     "message",  "name", "script", "sound",  "speed",  "type",     "width", "world",  "x",  "y"});

/// Whether a word begins with one of a list.
template <class List>
bool begins(const List& list, std::string_view word) {
  return std::any_of(list.begin(), list.end(), [&](std::string_view begin) { return word.starts_with(begin); });
}

bool isOther(std::string_view word) {
  return has(kOther, word) || begins(kOtherBegins, word) || begins(kPassableBegins, word) || begins(kFluidBegins, word);
}

/// Whether a word begins with another one, but for a letter.
bool nearlyBegins(std::string_view text, std::string_view word) {
  for (std::size_t length = word.size() - 1; length <= std::min(word.size() + 1, text.size()); ++length) {
    if (areSimilar(text.substr(0, length), word)) return true;
  }
  return false;
}

/// Words in lower case; an empty one stands where the name has an "and".
std::vector<std::string> wordsIn(std::string_view name) {
  const auto isUpper = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto isLower = [](char c) { return (c >= 'a' && c <= 'z') || (static_cast<unsigned char>(c) & 0x80) != 0; };
  std::vector<std::string> words;
  std::string word;
  const auto end = [&] {
    if (!word.empty()) words.push_back(word == "and" ? "" : lower(word));
    word.clear();
  };
  for (std::size_t k = 0; k < name.size(); ++k) {
    const char c = name[k];
    const bool isLetter = isUpper(c) || isLower(c);
    const bool begins = isUpper(c) && k > 0 && (isLower(name[k - 1]) || (k + 1 < name.size() && isLower(name[k + 1])));
    if (!isLetter || begins) end();
    if (isLetter) word += c;
    if (c == '&' || c == '+' || c == '/' || c == ',') words.emplace_back();
  }
  end();
  return words;
}

/// What one word says, with what is written together with it.
Saying sayingOf(std::string_view text) {
  for (const std::string_view no : kNot)
    if (text.starts_with(no) && begins(kPassed, text.substr(no.size()))) return {Says::collision, "not passable"};
  const auto fits = [&](std::string_view word, bool isWhole) {
    const std::size_t at = text.find(word);
    return isWhole ? text == word
                   : at != std::string_view::npos && !isOther(text.substr(0, at)) && !has(kNot, text.substr(0, at)) &&
                         !isOther(text.substr(at + word.size()));
  };
  const auto isNear = [&](std::string_view word, bool) { return word.size() >= kLong && nearlyBegins(text, word); };
  const auto find = [](const auto& isIt) {
    for (const auto& [are, words, areWhole] : kWords)
      for (const std::string_view word : words)
        if (isIt(word, areWhole)) return Saying{are.says, word, are.ground};
    return Saying{};
  };
  const Saying found = find(fits);
  return found.says == Says::nothing ? find(isNear) : found;
}

template <class IsOther>
Saying sayingOf(const std::vector<std::string>& words, const IsOther& isOtherUse) {
  if (words.size() == 1 && (words.front() == "col" || words.front() == "coll")) return {Says::collision, "col"};
  Saying best, part;
  bool isOtherPart = false;
  const auto endPart = [&] {
    if (!isOtherPart && part.says > best.says) best = part;
    part = {};
    isOtherPart = false;
  };
  bool isNot = false;
  for (const std::string& word : words) {
    if (word.empty()) endPart();
    const bool isBarred = isNot && begins(kPassed, word);
    const Saying one = isBarred ? Saying{Says::collision, "not passable"} : sayingOf(word);
    if (one.says > part.says) part = one;
    isOtherPart = isOtherPart || (!isBarred && (isOtherUse(word) || (isNot && one.says != Says::nothing)));
    isNot = has(kNot, word);
  }
  endPart();
  return best;
}

}  // namespace

Saying saying(std::string_view name) {
  const auto isFore = [](std::string_view word) { return isOneOf(word, {"foreground", "fg"}); };
  const std::vector<std::string> words = wordsIn(name);
  const bool isSeen = std::any_of(words.begin(), words.end(), isFore);
  const Saying said =
      sayingOf(words, [&](std::string_view word) { return word != "player" && !isFore(word) && isOther(word); });
  return isSeen && said.says == Says::ground && !said.isFloor() ? Saying{} : said;
}

Saying sayingOfProperty(std::string_view name) {
  return sayingOf(wordsIn(name), [](std::string_view word) { return isOther(word) || has(kOfProperties, word); });
}

Uses usesOf(std::string_view name) {
  Uses uses;
  const std::vector<std::string> words = wordsIn(name);
  for (const std::string& word : words) {
    uses.isOther |= isOther(word);
    uses.isPassable |= begins(kPassableBegins, word);
    uses.isGoneThrough |= uses.isPassable || begins(kFluidBegins, word) || isOneOf(word, {"background", "bg"});
    uses.isPassage |= begins(kPassed, word);
    uses.isMain |= words.size() == 1 && isOneOf(word, {"level", "main", "map", "tile", "tiles"});
    uses.isForeground |= isOneOf(word, {"foreground", "fg"});
    uses.isOnlySeen |= has(kSeen, word) || begins(kSeenBegins, word);
  }
  uses.isPassage = uses.isPassage && saying(name).says == Says::nothing;
  return uses;
}

Properties propertiesOf(pugi::xml_node node) {
  Properties result;
  for (const auto property : node.child("properties").children("property")) {
    const auto value = property.attribute("value");  // a text of several lines stands in the element instead
    result[property.attribute("name").value()] = value ? value.value() : property.text().get();
  }
  return result;
}

std::string listed(const std::vector<std::string>& names, std::size_t most) {
  std::string result;
  for (std::size_t k = 0; k < std::min(most, names.size()); ++k) result += (k == 0 ? "" : ", ") + names[k];
  if (names.size() > most) result += " and " + std::to_string(names.size() - most) + " more";
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
  if (property.find('=') != std::string::npos) return "";
  const bool isOpposite = std::any_of(kNot.begin(), kNot.end(), [&](std::string_view no) {
    const auto words =
        lower(property).starts_with(no) ? wordsIn(property.substr(no.size())) : std::vector<std::string>{};
    return !words.empty() && sayingOf(words.front()).says == Says::collision;
  });
  const bool isNo = saysYes(value) ? isOpposite : sayingOfProperty(property).says == Says::collision;
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
  const Uses uses = usesOf(node.attribute("name").value());
  const bool isForOthers = uses.isOther || uses.isOnlySeen;  // than its group is
  const auto group = node.parent();
  if (strongest.says == Says::nothing && !isForOthers && std::string_view(group.name()) == "group" &&
      !group.attribute(kPlaceAttribute))
    strongest = sayingOf(group, why);
  const bool isPart = strongest.says == Says::ground && strongest.isPart();
  return isPart && node.attribute(kThingsAttribute) ? Saying{} : strongest;
}

}  // namespace lgs::tiled
