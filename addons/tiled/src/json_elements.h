// JSON as the elements and attributes that XML would have: so what reads maps knows only one kind of document.
#pragma once

#include "json.h"

#include <pugixml.hpp>

namespace lgs::tiled {

/// The attribute with the path to what an element was made of. No key of Tiled's has a colon.
inline constexpr const char* kPathAttribute = "json:path";

/// A new element that was made of a value.
pugi::xml_node addElement(pugi::xml_node parent, const char* name, const JsonPlace& from);

void setAttribute(pugi::xml_node node, const char* name, const std::string& value);

/// A <property> in the element's <properties>. An array or object as value is left out, as it has no text in XML
/// either.
void addProperty(pugi::xml_node node, const std::string& name, const Json& value);

/// Makes a Tiled map, tileset, template or world, or an LDtk project, of the text of a JSON file. `reader` reads the
/// files of LDtk's levels. The first problem goes into `error`.
void readJson(const std::string& file, std::string_view text, const FileReader& reader, pugi::xml_document& document,
              std::optional<ImportError>& error);

/// The same for a JSON value of Tiled's; `kind` is "map", "tileset", "template" or "world".
void readTiledJson(const JsonReading& reading, const JsonPlace& root, const char* kind, pugi::xml_document& document);

}  // namespace lgs::tiled
