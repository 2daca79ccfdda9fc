#include "json_elements.h"

#include "foreign.h"
#include "ldtk.h"

namespace lgs::tiled {
namespace {

/// "map", "tileset", "template" or "world"; "" for what is none of Tiled's. Before Tiled 1.0 files did not say it.
const char* tiledKind(const JsonPlace& root) {
  const std::string type = root.text("type");
  for (const char* kind : {"map", "tileset", "template", "world"}) {
    if (type == kind) return kind;
  }
  if (!type.empty()) return "";
  const auto has = [&](const char* key) { return !root[key].isMissing(); };
  if (has("layers") && has("tilewidth")) return "map";
  if (has("maps") || has("patterns")) return "world";
  return has("object") ? "template" : has("tilewidth") ? "tileset" : "";
}

}  // namespace

pugi::xml_node addElement(pugi::xml_node parent, const char* name, const JsonPlace& from) {
  pugi::xml_node node = parent.append_child(name);
  setAttribute(node, kPathAttribute, from.path);
  return node;
}

void setAttribute(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name) = value.c_str();
}

void addProperty(pugi::xml_node node, const std::string& name, const Json& value) {
  pugi::xml_node list = node.child("properties");
  if (!list) list = node.append_child("properties");
  pugi::xml_node property = list.append_child("property");
  setAttribute(property, "name", name);
  if (const auto text = scalarText(value, "true", "false")) setAttribute(property, "value", *text);
}

void readJson(const std::string& file, std::string_view text, const FileReader& reader, pugi::xml_document& document,
              std::optional<ImportError>& error) {
  const auto json = parseJson(text);
  if (!json) {
    error = ImportError{file, static_cast<int>(json.error().line), "", json.error().what};
    return;
  }
  const JsonReading reading(file, error);
  const JsonPlace root{&*json, ""};
  if (isLdtkProject(root)) return readLdtk(reading, root, reader, document);
  if (const std::string foreign = foreignJson(*json); !foreign.empty()) return reading.fail(root, isForeign(foreign));
  const char* const kind = tiledKind(root);
  if (*kind == '\0') {
    return reading.fail(root, "is JSON, but neither of Tiled (a map, tileset, template or world) nor an LDtk project");
  }
  readTiledJson(reading, root, kind, document);
}

}  // namespace lgs::tiled
