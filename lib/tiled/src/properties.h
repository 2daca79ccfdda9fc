// Custom properties, and which names say that something is solid.
#pragma once

#include "xml.h"

#include <map>

namespace lgs::tiled {

using Properties = std::map<std::string, std::string>;

/// The custom properties of a map, layer, tile or object.
Properties propertiesOf(pugi::xml_node node);

/// Upper case letters of ASCII become lower case.
std::string lower(std::string_view text);

/// Whether a value says yes: it is not empty, and neither "false" nor "0".
bool saysYes(std::string_view value);

/// The name in a rule, "NAME" or "NAME=VALUE".
std::string propertyIn(const std::string& rule);

/// The first of some rules, "NAME" or "NAME=VALUE", that the properties fit; null if they fit none.
const std::string* firstFit(const std::vector<std::string>& rules, const Properties& properties);

/// The word in a name that says that something is solid, such as "wall" in "InnerWalls"; empty if there is none. The
/// "ground" in "Background" and "Foreground" does not count.
std::string_view solidWord(std::string_view name);

/// What says that an element is solid: its name, its class, or a property that says yes. In words; empty if nothing
/// does.
std::string whySolid(pugi::xml_node node);

/// Whether an element says that it is one-way: its name, its class, or a property that says yes has "one-way",
/// "platform" or "jump-through" in it, in any of the usual spellings.
bool saysOneWay(pugi::xml_node node);

/// Whether a property of this name is probably meant for collision. This takes more names than solidWord().
bool looksLikeCollision(std::string_view name);

}  // namespace lgs::tiled
