// Files that are no maps, or maps of other programs: what they are, for messages.
#pragma once

#include "json.h"

#include <string>
#include <string_view>

namespace lgs::tiled {

/// What a file is that is neither XML nor JSON, such as "a Godot scene"; "" if it is not known.
std::string foreignText(std::string_view text);

/// What a file is by the name of its XML root; "" if it is not known.
std::string foreignXml(std::string_view rootName);

/// What a JSON file is that is neither Tiled's nor an LDtk project; "" if it is not known.
std::string foreignJson(const Json& root);

/// The message about such a file.
std::string isForeign(const std::string& what);

}  // namespace lgs::tiled
