// Tiled's JSON: it says the same as TMX and TSX in other words.
#include "json_elements.h"

#include <algorithm>

namespace lgs::tiled {
namespace {

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether what reads maps takes the value of this key for a number.
bool isNumeric(std::string_view key) {
  return isOneOf(
      key, {"x",           "y",      "width",  "height",      "rotation",    "offsetx",    "offsety",   "parallaxx",
            "parallaxy",   "id",     "gid",    "firstgid",    "tilewidth",   "tileheight", "tilecount", "imagewidth",
            "imageheight", "startx", "starty", "multiplierX", "multiplierY", "offsetX",    "offsetY"});
}

/// Other values would count as if they were missing, or as 1. A text is read later.
bool canBeNumber(const Json& value) { return value.is_null() || value.is_number() || value.is_string(); }

/// Goes through a document. For each function `from` is an object, and `to` the element that is made of it.
class TiledJson {
 public:
  explicit TiledJson(const JsonReading& reading) : reading_(reading) {}

  void map(const JsonPlace& from, pugi::xml_node to) {
    attributes(from, to, {"type"});
    properties(from, to);
    tilesets(from, to);
    layers(from, to);
  }

  void tileset(const JsonPlace& from, pugi::xml_node to) {
    attributes(from, to, {"type", "image", "imagewidth", "imageheight"});
    image(from, to);
    child(from, to, "tileoffset");
    if (!from["tileproperties"].isMissing() || from["tiles"].value->is_object()) return oldTiles(from, to);
    for (const JsonPlace& tile : reading_.objects(from["tiles"])) {
      const pugi::xml_node node = addElement(to, "tile", tile);
      attributes(tile, node, {"image", "imagewidth", "imageheight"});
      tileContent(tile, node);
    }
  }

  void objectTemplate(const JsonPlace& from, pugi::xml_node to) {
    for (const char* part : {"tileset", "object"}) {
      const JsonPlace place = from[part];
      if (!place.value->is_object()) continue;
      const pugi::xml_node node = addElement(to, part, place);
      *part == 't' ? tileset(place, node) : object(place, node);
    }
  }

  void world(const JsonPlace& from, pugi::xml_node to) {
    for (const JsonPlace& part : reading_.objects(from["maps"])) attributes(part, addElement(to, "map", part), {});
    for (const JsonPlace& part : reading_.objects(from["patterns"])) {
      attributes(part, addElement(to, "pattern", part), {});
    }
  }

 private:
  /// All scalars, as attributes of the same name.
  void attributes(const JsonPlace& from, pugi::xml_node to, std::initializer_list<std::string_view> butNot) const {
    for (const auto& [key, value] : from.value->items()) {
      if (isNumeric(key) && !canBeNumber(value)) reading_.fail(from[key.c_str()], "should be a number");
      if (isOneOf(key, butNot)) continue;
      if (const auto text = scalarText(value, "1", "0")) setAttribute(to, key.c_str(), *text);
    }
  }

  /// A list of properties; before Tiled 1.2 an object.
  void properties(const JsonPlace& from, pugi::xml_node to) const {
    const JsonPlace list = from["properties"];
    if (list.value->is_object()) {
      for (const auto& [name, value] : list.value->items()) addProperty(to, name, value);
      return;
    }
    for (const JsonPlace& property : reading_.objects(list)) {
      addProperty(to, property.text("name"), *property["value"].value);
    }
  }

  void child(const JsonPlace& from, pugi::xml_node to, const char* key) const {
    const JsonPlace place = from[key];
    if (place.value->is_object()) attributes(place, addElement(to, key, place), {});
  }

  static void image(const JsonPlace& from, pugi::xml_node to) {
    if (from.text("image").empty()) return;
    const pugi::xml_node node = addElement(to, "image", from);
    for (const auto& [key, name] : {std::pair("imagewidth", "width"), std::pair("imageheight", "height")}) {
      if (const auto size = scalarText(*from[key].value, "1", "0")) setAttribute(node, name, *size);
    }
  }

  void tilesets(const JsonPlace& from, pugi::xml_node to) {
    for (const JsonPlace& set : reading_.objects(from["tilesets"])) tileset(set, addElement(to, "tileset", set));
  }

  /// What is in a tile but its number.
  void tileContent(const JsonPlace& from, pugi::xml_node to) {
    image(from, to);
    properties(from, to);
    const JsonPlace group = from["objectgroup"];
    if (group.value->is_object()) objectGroup(group, addElement(to, "objectgroup", group));
  }

  /// Before Tiled 1.2 tiles were not a list but an object with their numbers as keys, and their properties another one.
  void oldTiles(const JsonPlace& from, pugi::xml_node to) {
    std::map<std::string, pugi::xml_node> byId;
    const auto each = [&](const JsonPlace& list, auto&& use) {
      if (!list.isMissing() && !list.value->is_object()) return reading_.fail(list, "should be an object");
      for (const auto& [id, value] : list.value->items()) {
        const JsonPlace place{&value, list.path + "/" + id};
        pugi::xml_node& node = byId[id];
        if (!node) setAttribute(node = addElement(to, "tile", place), "id", id);
        if (!value.is_object()) return reading_.fail(place, "should be an object");
        use(place, node);
      }
    };
    each(from["tiles"], [&](const JsonPlace& tile, pugi::xml_node node) {
      attributes(tile, node, {"id", "image", "imagewidth", "imageheight"});
      tileContent(tile, node);
    });
    each(from["tileproperties"], [](const JsonPlace& all, pugi::xml_node node) {
      for (const auto& [name, value] : all.value->items()) addProperty(node, name, value);
    });
  }

  void layers(const JsonPlace& from, pugi::xml_node to) {
    for (const JsonPlace& layer : reading_.objects(from["layers"])) {
      const std::string type = layer.text("type");
      if (type == "tilelayer") {
        tileLayer(layer, addElement(to, "layer", layer));
      } else if (type == "objectgroup") {
        objectGroup(layer, addElement(to, "objectgroup", layer));
      } else if (type == "imagelayer") {
        attributes(layer, addElement(to, "imagelayer", layer), {"type", "image"});
      } else if (type == "group") {
        const pugi::xml_node group = addElement(to, "group", layer);
        attributes(layer, group, {"type"});
        properties(layer, group);
        layers(layer, group);
      } else {
        reading_.fail(layer["type"], "should be tilelayer, objectgroup, imagelayer or group");
      }
    }
  }

  void tileLayer(const JsonPlace& from, pugi::xml_node to) {
    attributes(from, to, {"type", "data", "encoding", "compression"});
    properties(from, to);
    const JsonPlace numbers = from["data"], chunks = from["chunks"];
    if (numbers.isMissing() && chunks.isMissing()) return;
    const bool isPacked = from.text("encoding") == "base64";
    const pugi::xml_node data = addElement(to, "data", numbers.isMissing() ? chunks : numbers);
    setAttribute(data, "encoding", isPacked ? "base64" : "csv");
    setAttribute(data, "compression", from.text("compression"));
    for (const JsonPlace& chunk : reading_.objects(chunks)) {
      const pugi::xml_node node = addElement(data, "chunk", chunk);
      attributes(chunk, node, {"data"});
      tiles(chunk["data"], isPacked, node);
    }
    if (numbers.isMissing()) return;
    if (from["startx"].isMissing() && from["starty"].isMissing()) return tiles(numbers, isPacked, data);
    const pugi::xml_node whole = addElement(data, "chunk", from);  // an infinite map that was saved without chunks
    for (const auto& [key, name] :
         {std::pair("startx", "x"), {"starty", "y"}, {"width", "width"}, {"height", "height"}})
      setAttribute(whole, name, scalarText(*from[key].value, "1", "0").value_or("0"));
    tiles(numbers, isPacked, whole);
  }

  /// Tile numbers as text: packed, or separated by commas.
  void tiles(const JsonPlace& from, bool isPacked, pugi::xml_node to) const {
    if (isPacked && from.value->is_string()) {
      to.text() = from.value->get_ref<const std::string&>().c_str();
      return;
    }
    if (isPacked || !from.value->is_array()) {
      return reading_.fail(from, isPacked
                                     ? "should be a text, as its encoding is base64"
                                     : "should be an array of tile numbers (a text needs \"encoding\": \"base64\")");
    }
    std::string list;
    for (const Json& number : *from.value) {
      if (!list.empty()) list += ',';
      list += number.is_number() ? *scalarText(number, "", "") : "?";
    }
    to.text() = list.c_str();
  }

  void objectGroup(const JsonPlace& from, pugi::xml_node to) {
    attributes(from, to, {"type"});
    properties(from, to);
    for (const JsonPlace& each : reading_.objects(from["objects"])) object(each, addElement(to, "object", each));
  }

  void object(const JsonPlace& from, pugi::xml_node to) const {
    attributes(from, to, {"ellipse", "capsule", "point"});
    properties(from, to);
    for (const char* flag : {"ellipse", "capsule", "point"}) {
      if (from.is(flag)) to.append_child(flag);
    }
    if (from["text"].value->is_object()) to.append_child("text");
    for (const char* shape : {"polygon", "polyline"}) {
      if (from[shape].isMissing()) continue;
      const pugi::xml_node node = addElement(to, shape, from[shape]);
      std::string points;
      for (const JsonPlace& point : reading_.objects(from[shape])) {
        points += (points.empty() ? "" : " ") + numberText(reading_.number(point["x"])) + "," +
                  numberText(reading_.number(point["y"]));
      }
      setAttribute(node, "points", points);
    }
  }

  const JsonReading& reading_;
};

}  // namespace

void readTiledJson(const JsonReading& reading, const JsonPlace& root, const char* kind, pugi::xml_document& document) {
  const pugi::xml_node node = addElement(document.root(), kind, root);
  TiledJson reader(reading);
  const std::string_view name = kind;
  if (name == "map") reader.map(root, node);
  if (name == "tileset") reader.tileset(root, node);
  if (name == "template") reader.objectTemplate(root, node);
  if (name == "world") reader.world(root, node);
}

}  // namespace lgs::tiled
