// Custom properties, and what elements say of themselves.
#pragma once

#include "words.h"
#include "xml.h"

#include <map>

namespace lgs::tiled {

using Properties = std::map<std::string, std::string>;

/// The custom properties of a map, layer, tile or object.
Properties propertiesOf(pugi::xml_node node);

/// Upper case letters of ASCII become lower case.
std::string lower(std::string_view text);

/// Whether a value says yes: it is neither "false" nor "0". An empty one says yes, as games ask whether there is one.
bool saysYes(std::string_view value);

/// The name in a rule, "NAME" or "NAME=VALUE".
std::string propertyIn(const std::string& rule);

/// The first of some rules, "NAME" or "NAME=VALUE", that the properties fit; null if they fit none.
const std::string* firstFit(const std::vector<std::string>& rules, const Properties& properties);

/// Whether a property says that something is not solid: "solid=false". Then this is a rule for it; otherwise "".
std::string noIn(const std::string& property, const std::string& value);

/// The strongest that is said by the name of an element and its class, and of an object layer by the properties that
/// say yes; of equals the first. (A property of a tile layer is a rule for its tiles.) The reason in words goes into
/// `why`.
Saying sayingOf(pugi::xml_node node, std::string* why = nullptr);

/// Whether an element says that it is one-way: its name, its class, or a property that says yes has "one-way",
/// "platform" or "jump-through" in it, in any of the usual spellings.
bool saysOneWay(pugi::xml_node node);

}  // namespace lgs::tiled
