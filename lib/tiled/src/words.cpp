#include "words.h"

#include "properties.h"

#include <algorithm>
#include <array>
#include <vector>

namespace lgs::tiled {
namespace {

constexpr auto kCollision = std::to_array<std::string_view>(
    {"collision", "collider", "collidable", "collides", "collide", "collid", "collis", "colis", "hitbox", "solid",
     "blocked", "blocking", "blocker", "obstacle", "impassable", "barrier", "boundary", "boundaries"});
constexpr auto kGround = std::to_array<std::string_view>({"ground", "wall", "floor", "terrain", "platform", "plateform",
                                                          "plataform", "plattform", "block", "brick", "pipe"});

/// Words for another use, as they are. They are also looked for before and after a word that is written together.
constexpr auto kOther = std::to_array<std::string_view>(
    {"anti",     "art",    "back",  "background", "behind", "below",  "bg",     "cam",   "camera",     "con",
     "dead",     "deadly", "death", "fake",       "far",    "fg",     "fire",   "fore",  "foreground", "front",
     "fx",       "hazard", "hurt",  "item",       "items",  "kill",   "killer", "light", "lights",     "mid",
     "middle",   "moving", "no",    "non",        "not",    "npc",    "npcs",   "old",   "paper",      "pass",
     "passable", "path",   "paths", "play",       "player", "sprite", "sur",    "un",    "with",       "without"});

/// The same for words that begin so.
constexpr auto kOtherBegins = std::to_array<std::string_view>(
    {"ambient", "coin",    "damag",  "decal", "deco",    "detail", "effect", "enem",   "event",
     "ignor",   "overlay", "shadow", "spawn", "trigger", "visual", "water",  "ladder", "rope",
     "spike",   "lava",    "sky",    "cloud", "acid",    "liquid", "toxic"});

/// What lies behind or above the layer that one walks in, and is only seen.
constexpr auto kSeen = std::to_array<std::string_view>({"above", "back", "background", "behind", "below", "bg", "far",
                                                        "fg", "fore", "foreground", "front", "over", "sky"});

/// Values of cells that are no ground to stand on, in whatever layer they are.
constexpr auto kThroughBegins = std::to_array<std::string_view>({"acid", "ladder", "lava", "rope", "spike", "vine"});

/// What a property can be that is about collision, and does not say that there is any.
constexpr auto kOfProperties =
    std::to_array<std::string_view>({"category", "color", "colour", "filter", "friction", "group", "height", "id",
                                     "index", "mask", "message", "name", "script", "sound", "speed", "type"});

template <class List>
bool has(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool isOther(std::string_view word) {
  return has(kOther, word) || std::any_of(kOtherBegins.begin(), kOtherBegins.end(),
                                          [&](std::string_view begin) { return word.starts_with(begin); });
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
  const auto fits = [&](std::string_view word) {
    const std::size_t at = text.find(word);
    return at != std::string_view::npos && !isOther(text.substr(0, at)) && !isOther(text.substr(at + word.size()));
  };
  for (const std::string_view word : kCollision) {
    if (fits(word)) return {Says::collision, word};
  }
  for (const std::string_view word : kGround) {
    if (fits(word)) return {Says::ground, word};
  }
  return {};
}

template <class IsOther>
Saying sayingOf(const std::vector<std::string>& words, const IsOther& isOtherUse) {
  Saying best, part;
  bool isOtherPart = false;
  const auto endPart = [&] {
    if (!isOtherPart && part.says > best.says) best = part;
    part = {};
    isOtherPart = false;
  };
  for (const std::string& word : words) {
    if (word.empty()) endPart();
    const Saying one = sayingOf(word);
    if (one.says > part.says) part = one;
    isOtherPart = isOtherPart || isOtherUse(word);
  }
  endPart();
  return best;
}

}  // namespace

Saying saying(std::string_view name) { return sayingOf(wordsIn(name), isOther); }

Saying sayingOfProperty(std::string_view name) {
  return sayingOf(wordsIn(name), [](std::string_view word) { return isOther(word) || has(kOfProperties, word); });
}

bool isGoneThrough(std::string_view name) {
  const std::vector<std::string> words = wordsIn(name);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return std::any_of(kThroughBegins.begin(), kThroughBegins.end(),
                       [&](std::string_view begin) { return word.starts_with(begin); });
  });
}

bool isMainName(std::string_view name) {
  constexpr auto kMain = std::to_array<std::string_view>({"level", "main", "map", "tile", "tiles", "world"});
  const std::vector<std::string> words = wordsIn(name);
  return words.size() == 1 && has(kMain, words.front());
}

bool isOnlySeen(std::string_view name) {
  const std::vector<std::string> words = wordsIn(name);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) { return has(kSeen, word); });
}

bool isForOtherUse(std::string_view name) {
  const std::vector<std::string> words = wordsIn(name);
  return std::any_of(words.begin(), words.end(), isOther);
}

}  // namespace lgs::tiled
