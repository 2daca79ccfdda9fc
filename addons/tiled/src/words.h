// What names say: whether something is solid. Names are those of layers, classes, objects and properties.
#pragma once

#include "xml.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

namespace lgs::tiled {

/// What a name says, the weakest first.
enum class Says : std::uint8_t {
  nothing,
  ground,     ///< it is what bodies stand on or run against: ground, wall, floor, platform …
  collision,  ///< it is there for collision: collision, solid, blocked, obstacle …
};

/// What a word for ground means.
enum class Ground : std::uint8_t {
  part,   ///< a platform, a block: it may be a thing that moves
  wall,   ///< it stands in the way: wall, fence, border …
  floor,  ///< one stands on it; or, with walls beside it, walks on it, seen from above: ground, floor, terrain …
};

struct Saying {
  Says says = Says::nothing;
  std::string_view word = {};  ///< the one that says so, in lower case
  Ground ground = Ground::part;

  bool isWall() const { return says == Says::ground && ground == Ground::wall; }
  bool isFloor() const { return says == Says::ground && ground == Ground::floor; }
  bool isPart() const { return ground == Ground::part; }
};

/// Names are taken apart into words at capitals, digits and signs. What stands around an "and" is judged by itself.
/// docs/maps.md, "What is taken without options", has the rest.
Saying saying(std::string_view name);

/// The same for the name of a property, which may be about what is solid without saying that it is: "collidesWith",
/// "groundSpeed".
Saying sayingOfProperty(std::string_view name);

/// What a name says that something is for.
struct Uses {
  bool isOther = false;       ///< it has a word for another use than ground
  bool isPassable = false;    ///< deadly, or lets bodies through: spikes, triggers, ladders and the like
  bool isFluid = false;       ///< water and the like: it lets bodies through, or stops those that walk
  bool isPassage = false;     ///< about where bodies pass: "walkable". Then a value that says no is a wall
  bool isMain = false;        ///< a layer called "tiles", "main" or the like
  bool isForeground = false;  ///< beside nothing but a background it is the level
  bool isOnlySeen = false;    ///< of a layer: it lies behind or above the others
};
Uses usesOf(std::string_view name);

using Properties = std::map<std::string, std::string>;

/// The custom properties of a map, layer, tile or object; of several with one name the last.
Properties propertiesOf(pugi::xml_node node);

/// What a tile, shape or object is called, and what else it says of itself.
struct Called {
  std::string className = {}, name = {};
  Properties properties = {};
};
Called calledOf(pugi::xml_node node);

/// "1 tile", "2 tiles"
inline std::string counted(std::uint64_t n, const std::string& what) { return concat(n, " ", what, n == 1 ? "" : "s"); }

template <class List, class Value>
bool has(const List& list, const Value& value) {
  return std::find(std::begin(list), std::end(list), value) != std::end(list);
}
inline bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) { return has(names, name); }

/// "A, B, C and 4 more"
std::string listed(const std::vector<std::string>& names, std::size_t most = 8);

/// Upper case letters of ASCII become lower case.
std::string lower(std::string_view text);

/// Whether a value says yes. An empty one does, as games ask whether there is one.
bool saysYes(std::string_view value);

/// The name in a rule, "NAME" or "NAME=VALUE".
std::string propertyIn(const std::string& rule);

/// The first of some rules, "NAME" or "NAME=VALUE", that the properties fit; null if they fit none.
const std::string* firstFit(const std::vector<std::string>& rules, const Properties& properties);

/// Whether a property says that something is not solid: "solid=false", "NoCollide=1". Then this is a rule for it;
/// otherwise "".
std::string noIn(const std::string& property, const std::string& value);

/// The strongest that is said by the name of an element, its class, and of an object layer by the properties that say yes
/// (that of a tile layer is a rule for its tiles), else by its group. The reason in words goes into `why`.
Saying sayingOf(pugi::xml_node node, std::string* why = nullptr);

}  // namespace lgs::tiled
