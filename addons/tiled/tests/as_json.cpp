#include "as_json.h"

#include "cli/import/imported.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/trace.h"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <string_view>

namespace lgs::tiled {
namespace {

using Value = nlohmann::ordered_json;

/// Writes elements as JSON, after Tiled's documentation of its format.
class JsonWriter {
 public:
  Value file(pugi::xml_node root) {
    const std::string name = root.name();
    Value value = name == "map" ? map(root) : name == "tileset" ? tileset(root) : objectTemplate(root);
    value["type"] = name;
    return value;
  }

  bool isFaithful = true;  ///< false: the XML says something for which JSON has no words

 private:
  static bool isText(std::string_view key) {
    static const std::set<std::string_view> kTexts{"name",     "class",           "type",           "source",
                                                   "template", "objectalignment", "tilerendersize", "orientation"};
    return kTexts.contains(key);
  }

  Value number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    while (*end == ' ') ++end;
    if (text.empty() || *end != '\0' || !std::isfinite(value)) isFaithful = false;
    if (value == std::floor(value) && std::fabs(value) < 1e15) return static_cast<std::int64_t>(value);
    return value;
  }

  Value attributes(pugi::xml_node node) {
    Value result = Value::object();
    for (const auto attribute : node.attributes()) {
      const std::string key = attribute.name(), text = attribute.value();
      if (key == "infinite" || key == "visible") {
        result[key] = attribute.as_bool();
      } else {
        result[key] = isText(key) ? Value(text) : number(text);
      }
    }
    if (node.child("properties")) result["properties"] = properties(node.child("properties"));
    return result;
  }

  static Value properties(pugi::xml_node list) {
    Value result = Value::array();
    for (const auto property : list.children("property")) {
      const auto attribute = property.attribute("value");
      const std::string text = attribute ? attribute.value() : property.text().get();
      Value value = text;
      if (text == "true" || text == "false") value = text == "true";
      if (!text.empty() && text.size() < 9 && text.find_first_not_of("123456789") == std::string::npos)
        value = std::stoi(text);
      result.push_back({{"name", property.attribute("name").value()}, {"type", "string"}, {"value", value}});
    }
    return result;
  }

  Value map(pugi::xml_node node) {
    Value result = attributes(node);
    for (const auto set : node.children("tileset")) result["tilesets"].push_back(tileset(set));
    result["layers"] = layers(node);
    return result;
  }

  Value layers(pugi::xml_node node) {
    Value result = Value::array();
    for (const auto child : node.children()) {
      const std::string kind = child.name();
      if (kind == "layer") {
        result.push_back(tileLayer(child));
      } else if (kind == "objectgroup") {
        result.push_back(objectGroup(child));
      } else if (kind == "imagelayer" || kind == "group") {
        result.push_back(attributes(child));
        result.back()["type"] = kind;
        if (kind == "group") result.back()["layers"] = layers(child);
      }
    }
    return result;
  }

  Value tileLayer(pugi::xml_node node) {
    Value result = attributes(node);
    result["type"] = "tilelayer";
    const auto data = node.child("data");
    const std::string encoding = data.attribute("encoding").value();
    if (encoding == "base64") {
      result["encoding"] = encoding;
      result["compression"] = data.attribute("compression").value();
    }
    if (!data.child("chunk")) {
      result["data"] = numbers(data, encoding);
      return result;
    }
    for (const auto chunk : data.children("chunk")) {
      result["chunks"].push_back(attributes(chunk));
      result["chunks"].back()["data"] = numbers(chunk, encoding);
    }
    return result;
  }

  Value numbers(pugi::xml_node node, const std::string& encoding) {
    const std::string text = node.text().get();
    if (encoding == "base64") return text;
    Value result = Value::array();
    for (const auto tile : node.children("tile")) result.push_back(number(tile.attribute("gid").as_string("0")));
    for (std::size_t at = 0; encoding == "csv" && at < text.size();) {
      const std::size_t comma = std::min(text.find(',', at), text.size());
      const std::string one = text.substr(at, comma - at);
      if (one.find_first_not_of(" \n") != std::string::npos) result.push_back(number(one));
      at = comma + 1;
    }
    return result;
  }

  Value objectGroup(pugi::xml_node node) {
    Value result = attributes(node);
    result["type"] = "objectgroup";
    result["objects"] = Value::array();
    for (const auto child : node.children("object")) result["objects"].push_back(object(child));
    return result;
  }

  Value object(pugi::xml_node node) {
    Value result = attributes(node);
    for (const char* shape : {"ellipse", "capsule", "point"}) {
      if (node.child(shape)) result[shape] = true;
    }
    if (node.child("text")) result["text"] = {{"text", node.child("text").text().get()}};
    for (const char* shape : {"polygon", "polyline"}) {
      if (node.child(shape)) result[shape] = points(node.child(shape).attribute("points").value());
    }
    return result;
  }

  Value points(const std::string& text) {
    Value result = Value::array();
    for (std::size_t at = 0; (at = text.find_first_not_of(" \n", at)) != std::string::npos;) {
      const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
      const std::string one = text.substr(at, end - at);
      const std::size_t comma = std::min(one.find(','), one.size() - 1);
      result.push_back({{"x", number(one.substr(0, comma))}, {"y", number(one.substr(comma + 1))}});
      at = end;
    }
    return result;
  }

  void image(pugi::xml_node node, Value& into) {
    const auto image = node.child("image");
    if (!image) return;
    into["image"] = image.attribute("source").as_string("x.png");
    if (*into["image"].get_ref<const std::string&>().c_str() == '\0') isFaithful = false;
    for (const char* side : {"width", "height"}) {
      if (image.attribute(side)) into[std::string("image") + side] = number(image.attribute(side).value());
    }
  }

  Value tileset(pugi::xml_node node) {
    Value result = attributes(node);
    image(node, result);
    if (node.child("tileoffset")) result["tileoffset"] = attributes(node.child("tileoffset"));
    for (const auto child : node.children("tile")) {
      Value tile = attributes(child);
      image(child, tile);
      const auto group = child.child("objectgroup");
      if (group) tile["objectgroup"] = objectGroup(group);
      if (group.next_sibling("objectgroup")) isFaithful = false;
      result["tiles"].push_back(tile);
    }
    return result;
  }

  Value objectTemplate(pugi::xml_node node) {
    Value result = Value::object();
    if (node.child("tileset")) result["tileset"] = tileset(node.child("tileset"));
    if (node.child("object")) result["object"] = object(node.child("object"));
    return result;
  }
};

}  // namespace

std::optional<std::string> asJson(const std::string& xml) {
  pugi::xml_document document;
  if (!document.load_buffer(xml.data(), xml.size())) return std::nullopt;
  JsonWriter writer;
  const Value value = writer.file(document.document_element());
  return writer.isFaithful ? std::optional(value.dump()) : std::nullopt;
}

std::optional<std::map<std::string, std::string>> asJson(const std::map<std::string, std::string>& files,
                                                         const std::function<bool(const std::string&)>& chosen) {
  std::map<std::string, std::string> result = files;
  for (auto& [name, text] : result) {
    if (!chosen(name)) continue;
    const auto json = asJson(text);
    if (!json) return std::nullopt;
    text = *json;
  }
  return result;
}

void expectAlike(const ImportedMap& a, const ImportedMap& b) {
  EXPECT_EQ(oracle::printTrace(cli::traceOf(a)), oracle::printTrace(cli::traceOf(b)));
  EXPECT_EQ(toText(a.report), toText(b.report));
  EXPECT_EQ(a.blocks, b.blocks);
  ASSERT_EQ(a.placements.size(), b.placements.size());
  for (std::size_t k = 0; k < a.placements.size(); ++k) {
    const MapPolygon &p = a.placements[k], &q = b.placements[k];
    EXPECT_EQ(std::tuple(p.tile, p.object, p.layer), std::tuple(q.tile, q.object, q.layer)) << "placement " << k;
  }
}

}  // namespace lgs::tiled
