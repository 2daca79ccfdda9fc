#include "json.h"

#include "ldtk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::size_t kMaxJsonDepth = 512;

/// Receives the parts of a document one by one. (The parser that makes the values itself can not say where an error is,
/// other than by an exception.)
class JsonBuilder {
 public:
  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(Json::number_integer_t value) { return put(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return put(value); }
  bool number_float(Json::number_float_t value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }  // only in other formats than text
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool key(std::string& name) {
    key_ = std::move(name);
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& exception) {
    end = position;
    const std::string_view all = exception.what();  // "[json.exception.parse_error.101] parse error at …: what"
    const auto colon = all.find(": ");
    what = all.substr(colon == std::string_view::npos ? all.find("] ") + 2 : colon + 2);
    what = what.substr(0, what.find("; last read: "));  // a piece of the file, which need not be the map's
    return false;
  }

  Json root;
  std::string what;
  std::size_t end = 0;  ///< how many bytes were read when it failed
  bool isTooDeep = false;

 private:
  bool put(Json value) {
    add(std::move(value));
    return true;
  }

  Json* add(Json value) {
    if (open_.empty()) return &(root = std::move(value));
    Json& parent = *open_.back();
    if (parent.is_object()) return &(parent[key_] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }

  bool open(Json value) {
    isTooDeep = open_.size() == kMaxJsonDepth;
    if (!isTooDeep) open_.push_back(add(std::move(value)));
    return !isTooDeep;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<Json*> open_;  // an array does not grow while one of its elements is open
  std::string key_;
};

const Json kNoJson;

}  // namespace

tl::expected<Json, JsonFault> parseJson(std::string_view text) {
  JsonBuilder builder;
  if (Json::sax_parse(text.begin(), text.end(), &builder)) return std::move(builder.root);
  if (builder.isTooDeep) {
    return tl::unexpected(
        JsonFault{0, "has arrays and objects in each other, more than " + std::to_string(kMaxJsonDepth) + " deep"});
  }
  const std::string_view read = text.substr(0, builder.end);
  const auto lines = std::count(read.begin(), read.end(), '\n') - (read.ends_with('\n') ? 1 : 0);
  return tl::unexpected(
      JsonFault{static_cast<std::size_t>(lines) + 1, "is not well-formed JSON: " + std::move(builder.what)});
}

bool JsonPlace::is(const char* key) const {
  const Json& flag = *(*this)[key].value;
  return flag.is_boolean() && flag.get<bool>();
}

JsonPlace JsonPlace::operator[](const char* key) const {
  JsonPlace result{&kNoJson, (path.empty() ? "" : path + "/") + key};
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

std::optional<std::string> scalarText(const Json& value, const char* yes, const char* no) {
  if (value.is_string()) return value.get_ref<const std::string&>();
  if (value.is_boolean()) return value.get<bool>() ? yes : no;
  if (value.is_number_unsigned()) return std::to_string(value.get<std::uint64_t>());
  if (value.is_number_integer()) return std::to_string(value.get<std::int64_t>());
  if (value.is_number_float()) return numberText(value.get<double>());
  return std::nullopt;
}

void JsonReading::fail(const JsonPlace& at, std::string what) const {
  if (!failed()) error_ = ImportError{file_, 0, at.path, std::move(what)};
}

std::vector<JsonPlace> JsonReading::elements(const JsonPlace& array) const {
  std::vector<JsonPlace> result;
  if (array.isMissing()) return result;
  if (!array.value->is_array()) {
    fail(array, "should be an array");
    return result;
  }
  for (const Json& value : *array.value) result.push_back({&value, array.path + "/" + std::to_string(result.size())});
  return result;
}

std::vector<JsonPlace> JsonReading::objects(const JsonPlace& array) const {
  std::vector<JsonPlace> result = elements(array);
  for (const JsonPlace& element : result) {
    if (!element.value->is_object()) fail(element, "should be an object");
  }
  return failed() ? std::vector<JsonPlace>{} : result;
}

double JsonReading::number(const JsonPlace& at, std::optional<double> fallback) const {
  if (at.value->is_number()) return at.value->get<double>();
  if (!at.isMissing() || !fallback) fail(at, at.isMissing() ? "is missing" : "should be a number");
  return fallback.value_or(0);
}

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

void setNumbers(pugi::xml_node node, std::initializer_list<std::pair<const char*, double>> numbers) {
  for (const auto& [name, value] : numbers) setAttribute(node, name, numberText(value));
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
