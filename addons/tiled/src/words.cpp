#include "words.h"

#include "asked_names.h"

#include <algorithm>
#include <array>
#include <vector>

namespace lgs::tiled {
namespace {

/// Lists have blanks between their words. A "*" stands for any end of a word.
using Words = std::string_view;

/// What is said by words that stand anywhere in another one, "=" before those that are too short for that. A longer word
/// stands before a shorter one that is in it, as reports name the first that fits. Those of kLong letters are known with
/// a letter wrong as well: "Obsticles", "Plataformas".
constexpr std::size_t kLong = 8;
constexpr auto kSays = std::to_array<std::pair<Saying, Words>>(
    {{{Says::collision},
      "collision collider collidable collides collide collid collis colid colis kollis hitbox solid blocked blocking "
      "blocker obstacle obstac impassable barrier boundary boundaries"},
     {{Says::ground, {}, Ground::wall}, "wall border fence static parede muro =mur =murs"},
     {{Says::ground, {}, Ground::floor},
      "ground floor terrain surface world gnd suelo boden terreno geom slope pendiente =sol =ramp =ramps"},
     {{Says::ground, {}, Ground::part}, "platform block brick pipe bloque bloco"}});

/// Words that turn the one after them into its opposite, or that are written together with it.
constexpr Words kNot = "anti no non not un without";

/// What lets bodies pass; what does not is solid: "non_traversable", "unwalkable".
constexpr Words kPassed = "passab* traversab* walkab*";

/// Words for another use. They are also looked for before and after a word that is written together.
constexpr Words kOther =
    "ambient* art back background behind below bg cam camera check* cloud* coin* collect* con decal* deco* detail* "
    "door* effect* end enem* entit* entr* event* exit* fake far fg finish* fire flag* fond* fore foreground front fx "
    "goal* hinter* ignor* item items light lights liquid* mid middle moving navig* npc npcs old overlay* paper pass "
    "passable path paths play player portal* shadow* sky* spawn* sprite start* sur switch* teleport* toxic* visual* "
    "walkab* warp* water* win with";

/// What lies behind or above the layer that one walks in, and is only seen.
constexpr Words kSeen = "above* back background* behind* below* bg far fg fore foreground* front over sky";
constexpr Words kForeground = "foreground fg";

/// What is deadly, or lets bodies through, in whatever layer it is; and values of cells that are no ground.
constexpr Words kPassable =
    "damag* dead* death* echel* escad* escaler* hazard* hurt* kill* ladder* leiter* lethal* rope* sensor* spike* "
    "trigger* vine*";
constexpr Words kFluid = "acid* empty* hole* lava* pit* void* water*";

/// What a property can be that is about collision, and does not say that there is any.
constexpr Words kOfProperties =
    "category col color colour filter friction group height id index mask message name script sound speed type width "
    "world x y";

/// The first word of a list that fits; or "".
template <class Fits>
std::string_view firstOf(Words list, const Fits& fits) {
  while (!list.empty()) {
    const std::string_view word = list.substr(0, list.find(' '));
    if (fits(word)) return word;
    list.remove_prefix(std::min(list.size(), word.size() + 1));
  }
  return {};
}

bool isIn(Words list, std::string_view word) {
  const std::string_view found = firstOf(list, [&](std::string_view one) {
    return one.ends_with('*') ? word.starts_with(one.substr(0, one.size() - 1)) : word == one;
  });
  return !found.empty();
}

bool isOther(std::string_view word) { return isIn(kOther, word) || isIn(kPassable, word) || isIn(kFluid, word); }

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

constexpr Saying kImpassable{Says::collision, "not passable"};

/// What one word says, with what is written together with it.
Saying sayingOf(std::string_view text) {
  const auto isBarred = [&](std::string_view no) {
    return text.starts_with(no) && isIn(kPassed, text.substr(no.size()));
  };
  if (!firstOf(kNot, isBarred).empty()) return kImpassable;
  const auto fits = [&](std::string_view word) {
    if (word.starts_with('=')) return text == word.substr(1);
    const std::size_t at = text.find(word);
    if (at == std::string_view::npos) return false;
    const std::string_view before = text.substr(0, at), after = text.substr(at + word.size());
    return !isOther(before) && !isIn(kNot, before) && !isOther(after);
  };
  const auto isNear = [&](std::string_view word) { return word.size() >= kLong && nearlyBegins(text, word); };
  const auto find = [](const auto& isIt) {
    for (const auto& [are, words] : kSays)
      if (const auto word = firstOf(words, isIt); !word.empty())
        return Saying{are.says, word.substr(word.starts_with('=') ? 1 : 0), are.ground};
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
    const bool isBarred = isNot && isIn(kPassed, word);
    const Saying one = isBarred ? kImpassable : sayingOf(word);
    if (one.says > part.says) part = one;
    isOtherPart = isOtherPart || (!isBarred && (isOtherUse(word) || (isNot && one.says != Says::nothing)));
    isNot = isIn(kNot, word);
  }
  endPart();
  return best;
}

/// Whether a name says that there is no collision: "NoCollide", "non_collidables".
bool isOpposite(std::string_view name) {
  const std::string_view no = firstOf(kNot, [&](std::string_view one) {
    const auto words = wordsIn(lower(name.substr(0, one.size())) == one ? name.substr(one.size()) : "");
    return !words.empty() && sayingOf(words.front()).says == Says::collision;
  });
  return !no.empty();
}

}  // namespace

Saying saying(std::string_view name) {
  const auto isFore = [](std::string_view word) { return isIn(kForeground, word); };
  const std::vector<std::string> words = wordsIn(name);
  const bool isSeen = std::any_of(words.begin(), words.end(), isFore);
  const Saying said =
      sayingOf(words, [&](std::string_view word) { return word != "player" && !isFore(word) && isOther(word); });
  return isSeen && said.says == Says::ground && !said.isFloor() ? Saying{} : said;
}

Saying sayingOfProperty(std::string_view name) {
  return sayingOf(wordsIn(name), [](std::string_view word) { return isOther(word) || isIn(kOfProperties, word); });
}

Uses usesOf(std::string_view name) {
  Uses uses;
  const std::vector<std::string> words = wordsIn(name);
  uses.isOther = isOpposite(name);
  for (const std::string& word : words) {
    uses.isOther |= isOther(word);
    uses.isPassable |= isIn(kPassable, word);
    uses.isFluid |= isIn(kFluid, word);
    uses.isPassage |= isIn(kPassed, word);
    uses.isMain |= words.size() == 1 && isIn("level main map tile tiles", word);
    uses.isForeground |= isIn(kForeground, word);
    uses.isOnlySeen |= isIn(kSeen, word);
  }
  uses.isPassage = uses.isPassage && saying(name).says == Says::nothing;
  return uses;
}

Properties propertiesOf(pugi::xml_node node) {
  Properties result;
  for (const auto list : node.children("properties")) {
    for (const auto property : list.children("property")) {
      const auto value = property.attribute("value");  // a text of several lines stands in the element instead
      result[property.attribute("name").value()] = value ? value.value() : property.text().get();
    }
  }
  return result;
}

Called calledOf(pugi::xml_node node) { return {classOf(node), node.attribute("name").value(), propertiesOf(node)}; }

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
  const bool isNo = saysYes(value) ? isOpposite(property) : sayingOfProperty(property).says == Says::collision;
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
