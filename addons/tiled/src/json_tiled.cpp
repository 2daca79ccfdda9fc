// Tiled's JSON says the same as TMX and TSX: values are attributes, objects and lists are elements. Only layers, tiles
// of old files, properties, points and the numbers of tiles are written in another way.
#include "json.h"
#include "words.h"

namespace lgs::tiled {
namespace {

/// A value as an attribute has it; nothing for null. Whoever takes a list for a number says that it is none.
std::optional<std::string> attributeText(const Json& value) {
  const auto text = scalarText(value);
  return text || value.is_null() ? text : "…";
}

/// Gives an element what an object has.
void readElement(const JsonPlace& from, pugi::xml_node to);

/// A list of properties; before Tiled 1.2 an object.
void addProperties(const JsonPlace& list, pugi::xml_node to) {
  if (list.value->is_object()) {
    for (const auto& [name, value] : list.value->items()) addProperty(to, name, value);
    return;
  }
  for (const JsonPlace& property : list.objects()) {
    addProperty(to, property.text("name"), *property["value"].value);
  }
}

void addImage(const JsonPlace& from, pugi::xml_node to) {
  if (from.text("image").empty()) return;
  const pugi::xml_node node = addElement(to, "image", from);
  for (const auto& [key, name] : {std::pair("imagewidth", "width"), std::pair("imageheight", "height")}) {
    if (const auto size = attributeText(*from[key].value)) setAttribute(node, name, *size);
  }
}

void addPoints(const JsonPlace& from, const char* shape, pugi::xml_node to) {
  if (from.isMissing()) return;
  std::string points;
  for (const JsonPlace& point : from.objects()) {
    points += (points.empty() ? "" : " ") + numberText(point["x"].number()) + "," + numberText(point["y"].number());
  }
  setAttribute(addElement(to, shape, from), "points", points);
}

/// A list. Before Tiled 1.2 it was an object with their numbers as keys, and their properties another one.
void addTiles(const JsonPlace& from, pugi::xml_node to) {
  const JsonPlace list = from["tiles"], ofTiles = from["tileproperties"];
  if (!list.value->is_object() && ofTiles.isMissing()) {
    for (const JsonPlace& tile : list.objects()) readElement(tile, addElement(to, "tile", tile));
    return;
  }
  std::map<std::string, pugi::xml_node> byId;
  const auto each = [&](const JsonPlace& all, auto&& use) {
    if (!all.isMissing() && !all.value->is_object()) return all.fail("should be an object");
    for (const auto& [id, value] : all.value->items()) {
      const JsonPlace place{&value, concat(all.path, "/", all.file->mayQuote() ? id : "…"), all.file};
      pugi::xml_node& node = byId[id];
      if (!node) setAttribute(node = addElement(to, "tile", place), "id", id);
      if (!value.is_object()) return place.fail("should be an object");
      use(place, node);
    }
  };
  each(list, [&](const JsonPlace& tile, pugi::xml_node node) { readElement(tile, node); });
  each(ofTiles, [&](const JsonPlace& all, pugi::xml_node node) { addProperties(all, node); });
}

/// Writes tile numbers: packed, or separated by commas.
void writeNumbers(const JsonPlace& from, bool isPacked, pugi::xml_node to) {
  if (isPacked && from.value->is_string()) {
    to.text() = from.value->get_ref<const std::string&>().c_str();
    return;
  }
  if (isPacked || !from.value->is_array()) {
    return from.fail(isPacked ? "should be a text, as its encoding is base64"
                              : "should be an array of tile numbers (a text needs \"encoding\": \"base64\")");
  }
  std::string list;
  for (const Json& number : *from.value) {
    if (!list.empty()) list += ',';
    list += number.is_number() ? *scalarText(number) : "?";
  }
  to.text() = list.c_str();
}

/// The tile numbers of a layer.
void addNumbers(const JsonPlace& from, pugi::xml_node to) {
  const JsonPlace all = from["data"], chunks = from["chunks"];
  if (all.isMissing() && chunks.isMissing()) return;
  const bool isPacked = from.text("encoding") == "base64";
  const pugi::xml_node data = addElement(to, "data", all.isMissing() ? chunks : all);
  setAttribute(data, "encoding", isPacked ? "base64" : "csv");
  setAttribute(data, "compression", from.text("compression"));
  for (const JsonPlace& chunk : chunks.objects()) {
    const pugi::xml_node node = addElement(data, "chunk", chunk);
    readElement(chunk, node);
    writeNumbers(chunk["data"], isPacked, node);
  }
  if (all.isMissing()) return;
  if (from["startx"].isMissing() && from["starty"].isMissing()) return writeNumbers(all, isPacked, data);
  const pugi::xml_node whole = addElement(data, "chunk", from);  // an infinite map that was saved without chunks
  for (const auto& [key, name] : {std::pair("startx", "x"), {"starty", "y"}, {"width", "width"}, {"height", "height"}})
    setAttribute(whole, name, attributeText(*from[key].value).value_or("0"));
  writeNumbers(all, isPacked, whole);
}

void readElement(const JsonPlace& from, pugi::xml_node to) {
  const std::string_view element = to.name();
  const bool isLayer = element == "layer" || element == "chunk";
  for (const auto& [key, value] : from.value->items()) {
    const bool isFlag = isOneOf(key, {"ellipse", "capsule", "point"});
    if (isFlag && from.is(key.c_str())) to.append_child(key.c_str());
    if (isFlag || isOneOf(key, {"image", "imagewidth", "imageheight"})) continue;
    if (key == "type" && element != "object" && element != "tile") continue;  // the kind, and no class
    if (isLayer && isOneOf(key, {"data", "encoding", "compression"})) continue;
    if (const auto text = attributeText(value)) setAttribute(to, key.c_str(), *text);
  }
  addProperties(from["properties"], to);
  addImage(from, to);
  for (const std::string key :
       {"tilesets", "tileset", "tileoffset", "objectgroup", "objects", "object", "text", "maps", "patterns"}) {
    const JsonPlace place = from[key.c_str()];
    if (key.ends_with('s')) {  // a list
      const std::string one = key.substr(0, key.size() - 1);
      for (const JsonPlace& each : place.objects()) readElement(each, addElement(to, one.c_str(), each));
    } else if (place.value->is_object()) {
      readElement(place, addElement(to, key.c_str(), place));
    }
  }
  for (const char* shape : {"polygon", "polyline"}) addPoints(from[shape], shape, to);
  if (element == "tileset") addTiles(from, to);
  if (element == "layer") addNumbers(from, to);
  for (const JsonPlace& layer : from["layers"].objects()) {
    const std::string type = layer.text("type");
    if (isOneOf(type, {"tilelayer", "objectgroup", "imagelayer", "group"})) {
      readElement(layer, addElement(to, type == "tilelayer" ? "layer" : type.c_str(), layer));
    } else {
      layer["type"].fail("should be tilelayer, objectgroup, imagelayer or group");
    }
  }
}

}  // namespace

void readTiledJson(const JsonPlace& root, const char* kind, pugi::xml_document& document) {
  readElement(root, addElement(document.root(), kind, root));
}

}  // namespace lgs::tiled
