#include "json.h"

#include "ldtk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr int kMaxJsonDepth = 512;

/// Reads a text without making values: says what is wrong with it and where. (The parser that makes them says that by an
/// exception alone; and with a callback, which could count how deep it is, it looks at all elements of an array for each.)
class Checker : public nlohmann::detail::json_sax_acceptor<Json> {
 public:
  Checker(std::string_view text, bool mayQuote) : text_(text), mayQuote_(mayQuote) {}

  bool start_object(std::size_t) { return open(); }
  bool start_array(std::size_t) { return open(); }
  bool end_object() { return depth_-- > 0; }
  bool end_array() { return depth_-- > 0; }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& exception) {
    const std::string_view read = text_.substr(0, position);
    fault.line = static_cast<int>(1 + std::count(read.begin(), read.end(), '\n') - read.ends_with('\n'));
    std::string_view what = exception.what();  // "[json.exception.parse_error.101] parse error at …: what"
    const auto colon = what.find(": ");
    what = what.substr(colon == std::string_view::npos ? what.find("] ") + 2 : colon + 2);
    what = what.substr(0, what.find("; last read: "));  // a piece of the file
    if (!mayQuote_) what = what.substr(0, what.find(" parsing '"));
    fault.what = concat("is not well-formed JSON: ", what);
    return false;
  }

  ImportError fault;

 private:
  bool open() {
    if (depth_ == kMaxJsonDepth)
      fault.what = concat("has arrays and objects in each other, more than ", depth_, " deep");
    return depth_++ < kMaxJsonDepth;
  }

  std::string_view text_;
  bool mayQuote_;
  int depth_ = 0;
};

const Json kNoJson;

constexpr auto kKnown = std::to_array<std::tuple<Sign, std::string_view, std::string_view>>({
    {Sign::text, "[gd_scene", "a Godot scene"},
    {Sign::text, "[gd_resource", "a Godot resource"},
    {Sign::text, "\x89PNG", "a PNG image, and no map"},
    {Sign::text, "\xFF\xD8\xFF", "a JPEG image, and no map"},
    {Sign::text, "GIF8", "a GIF image, and no map"},
    {Sign::text, "RIFF", "an image or a sound, and no map"},
    {Sign::text, "PK\x03\x04", "a ZIP archive: unpack it"},
    {Sign::text, "\x1F\x8B", "packed by gzip: unpack it"},
    {Sign::text, "%YAML", "a file of Unity or another program that writes YAML"},
    {Sign::text, "version https://git-lfs", "a pointer of Git LFS: fetch the file itself with 'git lfs pull'"},
    {Sign::text, "return {", "a Lua export: save the map as TMX or JSON"},
    {Sign::text, "(function(name,data)", "a JavaScript export: save the map as TMX or JSON"},
    {Sign::text, "lgs-trace", "a trace of lgs, and no map"},
    {Sign::text, "lgssnap", "a saved world of lgs, and no map"},
    {Sign::xml, "html", "a web page: download the file itself"},
    {Sign::xml, "svg", "an SVG image, and no map"},
    {Sign::xml, "ogmo", "an Ogmo project"},
    {Sign::xml, "OgmoProject", "an Ogmo project"},
    {Sign::xml, "level", "a level of Ogmo or another editor"},
    {Sign::xml, "objecttypes", "a list of Tiled's object types"},
    {Sign::json, "layerInstances", "one level of an LDtk project: import the project (.ldtk) that names it"},
    {Sign::json, "ogmoVersion", "an Ogmo project or level"},
    {Sign::json, "automappingRulesFile", "a Tiled project, which only lists folders: import its maps"},
    {Sign::json, "expandedProjectPaths", "a Tiled session: import a map"},
    {Sign::json, "frames", "an atlas of sprites, and no map"},
});

/// "map", "tileset", "template" or "world"; "" for what is none of Tiled's. Before Tiled 1.0 files did not say it.
const char* tiledKind(const JsonPlace& root) {
  const std::string type = root.text("type");
  for (const char* kind : {"map", "tileset", "template", "world"})
    if (type == kind) return kind;
  if (!type.empty()) return "";
  const auto has = [&](const char* key) { return !root[key].isMissing(); };
  if (has("layers") && has("tilewidth")) return "map";
  if (has("maps") || has("patterns")) return "world";
  return has("object") ? "template" : has("tilewidth") ? "tileset" : "";
}

}  // namespace

tl::expected<Json, ImportError> parseJson(std::string_view text, bool mayQuote) {
  Checker checker(text, mayQuote);
  if (!Json::sax_parse(text.begin(), text.end(), &checker)) return tl::unexpected(std::move(checker.fault));
  return Json::parse(text.begin(), text.end(), nullptr, false);
}

bool JsonPlace::is(const char* key) const { return *(*this)[key].value == Json(true); }

JsonPlace JsonPlace::operator[](const char* key) const {
  JsonPlace result{&kNoJson, concat(path, path.empty() ? "" : "/", key), file};
  if (!value->is_object()) return result;
  const auto found = value->find(key);
  if (found != value->end()) result.value = &*found;
  return result;
}

std::string JsonPlace::text(const char* key) const {
  const Json& found = *(*this)[key].value;
  return found.is_string() ? found.get_ref<const std::string&>() : "";
}

std::string numberText(double value) {
  constexpr double kWholeUpTo = 0x1p53;
  if (std::trunc(value) == value && std::abs(value) <= kWholeUpTo) return std::to_string(std::llround(value));
  return Json(value).dump();  // the digits that give the same number again
}

std::optional<std::string> scalarText(const Json& value) {
  if (value.is_string()) return value.get_ref<const std::string&>();
  if (value.is_number_float()) return numberText(value.get<double>());
  return value.is_boolean() || value.is_number() ? std::optional(value.dump()) : std::nullopt;
}

void JsonPlace::fail(std::string what) const {
  if (!failed()) file->error() = ImportError{file->name(), 0, path, std::move(what)};
}

std::vector<JsonPlace> JsonPlace::elements() const {
  std::vector<JsonPlace> result;
  if (!isMissing() && !value->is_array()) fail("should be an array");
  if (!value->is_array()) return result;
  for (const Json& one : *value) result.push_back({&one, concat(path, "/", result.size()), file});
  return result;
}

std::vector<JsonPlace> JsonPlace::objects() const {
  std::vector<JsonPlace> result = elements();
  for (const JsonPlace& element : result) {
    if (!element.value->is_object()) element.fail("should be an object");
  }
  return failed() ? std::vector<JsonPlace>{} : result;
}

double JsonPlace::number(std::optional<double> fallback) const {
  if (value->is_number()) return value->get<double>();
  if (!isMissing() || !fallback) fail(isMissing() ? "is missing" : "should be a number");
  return fallback.value_or(0);
}

pugi::xml_node addElement(pugi::xml_node parent, const char* name, const JsonPlace& from) {
  pugi::xml_node node = parent.append_child(name);
  setAttribute(node, kPathAttribute, from.path);
  return node;
}

void setAttribute(pugi::xml_node node, const char* name, const std::string& value) {
  auto attribute = node.attribute(name);
  if (!attribute) attribute = node.append_attribute(name);
  attribute = value.c_str();
}

void setNumbers(pugi::xml_node node, std::initializer_list<std::pair<const char*, double>> numbers) {
  for (const auto& [name, value] : numbers) setAttribute(node, name, numberText(value));
}

void addProperty(pugi::xml_node node, const std::string& name, const Json& value) {
  pugi::xml_node list = node.child("properties");
  if (!list) list = node.append_child("properties");
  pugi::xml_node property = list.append_child("property");
  setAttribute(property, "name", name);
  if (const auto text = scalarText(value)) setAttribute(property, "value", *text);
}

std::string foreign(Sign kind, const std::function<bool(std::string_view sign)>& has) {
  for (const auto& [of, sign, what] : kKnown)
    if (of == kind && has(sign)) return isForeign(what);
  return {};
}

std::string isForeign(std::string_view what) {
  return concat("is ", what, ". What is read: maps of Tiled (TMX or JSON), worlds of Tiled and projects of LDtk");
}

void readJson(const XmlFile& file, std::string_view text, pugi::xml_document& document) {
  auto json = parseJson(text, file.mayQuote());
  if (!json) {
    json.error().file = file.name();
    file.error() = std::move(json.error());
    return;
  }
  const JsonPlace root{&*json, "", &file};
  if (isLdtkProject(root)) return readLdtk(root, document);
  const std::string other = foreign(Sign::json, [&](auto key) { return json->is_object() && json->contains(key); });
  if (!other.empty()) return root.fail(other);
  const char* const kind = tiledKind(root);
  if (*kind == '\0') {
    return root.fail("is JSON, but neither of Tiled (a map, tileset, template or world) nor an LDtk project");
  }
  readTiledJson(root, kind, document);
}

}  // namespace lgs::tiled
