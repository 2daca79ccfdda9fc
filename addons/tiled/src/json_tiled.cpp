// Tiled's JSON says the same as TMX and TSX: values are attributes, objects and lists are elements. Only layers, tiles
// of old files, properties, points and the numbers of tiles are written in another way.
#include "json.h"

#include <algorithm>
#include <array>

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

struct Child {
  const char* key;
  const char* element;
  bool isList;
};
constexpr std::array kChildren{Child{"tilesets", "tileset", true},
                               Child{"tileset", "tileset", false},
                               Child{"tileoffset", "tileoffset", false},
                               Child{"objectgroup", "objectgroup", false},
                               Child{"objects", "object", true},
                               Child{"object", "object", false},
                               Child{"text", "text", false},
                               Child{"maps", "map", true},
                               Child{"patterns", "pattern", true}};

class TiledJson {
 public:
  explicit TiledJson(const JsonReading& reading) : reading_(reading) {}

  /// Gives an element what an object has.
  void read(const JsonPlace& from, pugi::xml_node to) const {
    const std::string_view element = to.name();
    const bool isLayer = element == "layer" || element == "chunk";
    for (const auto& [key, value] : from.value->items()) {
      if (isNumeric(key) && !canBeNumber(value)) reading_.fail(from[key.c_str()], "should be a number");
      const bool isFlag = isOneOf(key, {"ellipse", "capsule", "point"});
      if (isFlag && from.is(key.c_str())) to.append_child(key.c_str());
      if (isFlag || isOneOf(key, {"image", "imagewidth", "imageheight"})) continue;
      if (key == "type" && element != "object" && element != "tile") continue;  // the kind, and no class
      if (isLayer && isOneOf(key, {"data", "encoding", "compression"})) continue;
      if (const auto text = scalarText(value)) setAttribute(to, key.c_str(), *text);
    }
    properties(from["properties"], to);
    image(from, to);
    for (const Child& child : kChildren) {
      const JsonPlace place = from[child.key];
      if (child.isList) {
        for (const JsonPlace& one : reading_.objects(place)) read(one, addElement(to, child.element, one));
      } else if (place.value->is_object()) {
        read(place, addElement(to, child.element, place));
      }
    }
    for (const char* shape : {"polygon", "polyline"}) points(from[shape], shape, to);
    if (element == "tileset") tiles(from, to);
    if (element == "layer") numbers(from, to);
    for (const JsonPlace& layer : reading_.objects(from["layers"])) {
      const std::string type = layer.text("type");
      if (isOneOf(type, {"tilelayer", "objectgroup", "imagelayer", "group"})) {
        read(layer, addElement(to, type == "tilelayer" ? "layer" : type.c_str(), layer));
      } else {
        reading_.fail(layer["type"], "should be tilelayer, objectgroup, imagelayer or group");
      }
    }
  }

 private:
  /// A list of properties; before Tiled 1.2 an object.
  void properties(const JsonPlace& list, pugi::xml_node to) const {
    if (list.value->is_object()) {
      for (const auto& [name, value] : list.value->items()) addProperty(to, name, value);
      return;
    }
    for (const JsonPlace& property : reading_.objects(list)) {
      addProperty(to, property.text("name"), *property["value"].value);
    }
  }

  static void image(const JsonPlace& from, pugi::xml_node to) {
    if (from.text("image").empty()) return;
    const pugi::xml_node node = addElement(to, "image", from);
    for (const auto& [key, name] : {std::pair("imagewidth", "width"), std::pair("imageheight", "height")}) {
      if (const auto size = scalarText(*from[key].value)) setAttribute(node, name, *size);
    }
  }

  void points(const JsonPlace& from, const char* shape, pugi::xml_node to) const {
    if (from.isMissing()) return;
    std::string points;
    for (const JsonPlace& point : reading_.objects(from)) {
      points += (points.empty() ? "" : " ") + numberText(reading_.number(point["x"])) + "," +
                numberText(reading_.number(point["y"]));
    }
    setAttribute(addElement(to, shape, from), "points", points);
  }

  /// A list. Before Tiled 1.2 it was an object with their numbers as keys, and their properties another one.
  void tiles(const JsonPlace& from, pugi::xml_node to) const {
    const JsonPlace list = from["tiles"], ofTiles = from["tileproperties"];
    if (!list.value->is_object() && ofTiles.isMissing()) {
      for (const JsonPlace& tile : reading_.objects(list)) read(tile, addElement(to, "tile", tile));
      return;
    }
    std::map<std::string, pugi::xml_node> byId;
    const auto each = [&](const JsonPlace& all, auto&& use) {
      if (!all.isMissing() && !all.value->is_object()) return reading_.fail(all, "should be an object");
      for (const auto& [id, value] : all.value->items()) {
        const JsonPlace place{&value, all.path + "/" + id};
        pugi::xml_node& node = byId[id];
        if (!node) setAttribute(node = addElement(to, "tile", place), "id", id);
        if (!value.is_object()) return reading_.fail(place, "should be an object");
        use(place, node);
      }
    };
    each(list, [&](const JsonPlace& tile, pugi::xml_node node) { read(tile, node); });
    each(ofTiles, [&](const JsonPlace& all, pugi::xml_node node) { properties(all, node); });
  }

  /// The tile numbers of a layer.
  void numbers(const JsonPlace& from, pugi::xml_node to) const {
    const JsonPlace all = from["data"], chunks = from["chunks"];
    if (all.isMissing() && chunks.isMissing()) return;
    const bool isPacked = from.text("encoding") == "base64";
    const pugi::xml_node data = addElement(to, "data", all.isMissing() ? chunks : all);
    setAttribute(data, "encoding", isPacked ? "base64" : "csv");
    setAttribute(data, "compression", from.text("compression"));
    for (const JsonPlace& chunk : reading_.objects(chunks)) {
      const pugi::xml_node node = addElement(data, "chunk", chunk);
      read(chunk, node);
      write(chunk["data"], isPacked, node);
    }
    if (all.isMissing()) return;
    if (from["startx"].isMissing() && from["starty"].isMissing()) return write(all, isPacked, data);
    const pugi::xml_node whole = addElement(data, "chunk", from);  // an infinite map that was saved without chunks
    for (const auto& [key, name] :
         {std::pair("startx", "x"), {"starty", "y"}, {"width", "width"}, {"height", "height"}})
      setAttribute(whole, name, scalarText(*from[key].value).value_or("0"));
    write(all, isPacked, whole);
  }

  /// They are packed, or separated by commas.
  void write(const JsonPlace& from, bool isPacked, pugi::xml_node to) const {
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
      list += number.is_number() ? *scalarText(number) : "?";
    }
    to.text() = list.c_str();
  }

  const JsonReading& reading_;
};

}  // namespace

void readTiledJson(const JsonReading& reading, const JsonPlace& root, const char* kind, pugi::xml_document& document) {
  TiledJson(reading).read(root, addElement(document.root(), kind, root));
}

}  // namespace lgs::tiled
