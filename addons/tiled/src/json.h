// JSON values with the paths that lead to them, for messages: "layers/2/objects/0".
#pragma once

#include "xml.h"

#include <nlohmann/json.hpp>

namespace lgs::tiled {

/// A type of its own, by the last argument. Other code in the same program may have compiled nlohmann::json with
/// exceptions, and the linker would mix the two.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, double,
                                  std::allocator, nlohmann::adl_serializer, std::vector<char>>;

/// Parses a text. Arrays and objects may be nested 512 deep, so that what goes through them may recurse. `mayQuote`:
/// what is wrong may be quoted. The error has no file.
tl::expected<Json, ImportError> parseJson(std::string_view text, bool mayQuote);

/// A value in a document. Its functions take any kind of value, since nlohmann's own may end the program if the kind is
/// another one than they expect.
struct JsonPlace {
  const Json* value;
  std::string path;
  const XmlFile* file;

  bool failed() const { return file->failed(); }
  void fail(std::string what) const;

  bool isMissing() const { return value->is_null(); }
  bool is(const char* key) const;  ///< it has this key, with the value true

  /// The value of a key; null if there is none.
  JsonPlace operator[](const char* key) const;

  /// The text of a key; "" if it has none.
  std::string text(const char* key) const;

  /// The elements of an array. None if it is missing; if it is anything else, that is an error.
  std::vector<JsonPlace> elements() const;

  /// The same, where each must be an object.
  std::vector<JsonPlace> objects() const;

  /// A number; an error if it is anything else, or missing and there is no fallback.
  double number(std::optional<double> fallback = std::nullopt) const;
};

/// A scalar as XML writes it: numbers in the fewest digits that mean the same. Nothing for null, arrays and objects.
std::optional<std::string> scalarText(const Json& value);

/// A new element that was made of a value.
pugi::xml_node addElement(pugi::xml_node parent, const char* name, const JsonPlace& from);

/// An attribute that there is already gets another value.
void setAttribute(pugi::xml_node node, const char* name, const std::string& value);
void setNumbers(pugi::xml_node node, std::initializer_list<std::pair<const char*, double>> numbers);

/// A <property> in the element's <properties>. An array or object as value is left out, as it has no text in XML
/// either.
void addProperty(pugi::xml_node node, const std::string& name, const Json& value);

/// Makes a Tiled map, tileset, template or world, or an LDtk project, of the text of a file.
void readJson(const XmlFile& file, std::string_view text, pugi::xml_document& document);

/// The same for a JSON value of Tiled's; `kind` is "map", "tileset", "template" or "world".
void readTiledJson(const JsonPlace& root, const char* kind, pugi::xml_document& document);

/// What tells a file: the beginning of a text, the name of an XML root, or a key of a JSON object.
enum class Sign : std::uint8_t { text, xml, json };

/// The message about a file of another kind, such as a Godot scene, if it has one of the signs; or "".
std::string foreign(Sign kind, const std::function<bool(std::string_view sign)>& has);

/// The same of a kind in words.
std::string isForeign(std::string_view what);

}  // namespace lgs::tiled
