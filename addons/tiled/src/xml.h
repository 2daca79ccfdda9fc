// A file with its name and lines, and its attributes as numbers. A JSON file becomes the elements that XML would have.
// The first problem is kept; after it, all functions return defaults. So code that reads a file need not look at
// failed() after each attribute.
#pragma once

#include <lgs/tiled/import.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace lgs::tiled {

/// A piece of a file as a message quotes it: short, and without control characters.
std::string inQuotes(std::string_view piece);

/// Without the blanks around it.
std::string_view trimmed(std::string_view text);

/// The parts of a text between separators.
std::vector<std::string_view> split(std::string_view text, std::string_view separators);

/// Texts and numbers, one after the other.
template <class... Parts>
std::string concat(const Parts&... parts) {
  std::string all;
  const auto add = [&](const auto& part) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>) {
      all += std::to_string(part);
    } else {
      all += part;
    }
  };
  (add(parts), ...);
  return all;
}

/// Adds a text to a list in words, unless it is empty.
inline void join(std::string& list, std::string_view text, const char* between = "; ") {
  if (!text.empty()) list += concat(list.empty() ? "" : between, text);
}

/// A number, which may have blanks around it and a plus; nothing for anything else. A real is finite.
std::optional<std::int64_t> parseInteger(std::string_view text);
std::optional<double> parseReal(std::string_view text);

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A number in the fewest digits that mean the same.
std::string numberText(double value);

/// The path of a file that another one names by a path from its own folder, in either kind of slashes.
std::string pathBeside(const std::string& file, std::string named);

/// The folder of a file; "" if its path has none. These go by paths as they are written: links do not matter.
std::string folderOf(const std::string& file);

/// Whether a path leads to something below a folder: neither by "..", nor to another root or drive.
bool liesBelow(const std::string& folder, const std::string& path);

/// The path of a folder, normal and without a slash at its end.
std::string withoutSlash(const std::filesystem::path& folder);

/// The nearest folder that holds both files.
std::string folderOfBoth(const std::string& file, const std::string& other);

/// How a reason begins why a file is not read: its path, as it is written, leads out of the folder.
inline constexpr std::string_view kNotInFolder = "it is not in the folder ";

/// Attributes of elements that were made of JSON, which no key of Tiled's has.
inline constexpr const char* kPathAttribute = "json:path";        ///< the path to what it was made of
inline constexpr const char* kPlaceAttribute = "lgs:place";       ///< a group, such as a level: no part of names
inline constexpr const char* kWorldAttribute = "lgs:world";       ///< the root: the one world that is listed
inline constexpr const char* kThingsAttribute = "lgs:things";     ///< an object layer, of which "platform" says nothing
inline constexpr const char* kDrawnAttribute = "lgs:drawn";       ///< a layer or tileset whose tiles are only drawn
inline constexpr const char* kRemarkAttribute = "lgs:remark";     ///< a layer: what the report says of it
inline constexpr const char* kLdtkAttribute = "ldtk:version";     ///< the root
inline constexpr const char* kLdtkGridAttribute = "__gridSize";   ///< the root or a layer: the side of a cell, pixels
inline constexpr const char* kLdtkWidthAttribute = "ldtk:width";  ///< a world, which is the root if it is alone:
inline constexpr const char* kLdtkHeightAttribute = "ldtk:height";  ///< from its first level to the last one
inline constexpr const char* kLdtkDepthsAttribute = "ldtk:depths";  ///< a world: levels have several depths

class XmlFile {
 public:
  /// Reads and parses a map; it may be a world. If it is trusted, errors may quote the files that it names. All files of
  /// an import share `error`, which must outlive them, as the reader must.
  XmlFile(std::string name, const FileReader& reader, std::optional<ImportError>& error, bool isTrusted);

  /// The same of a file that another one names, whose root element must be `rootName`. Unless files may lie anywhere, it
  /// is read only if the name is not absolute and has an extension of its kind.
  XmlFile(const XmlFile& by, const std::string& named, const char* rootName, std::optional<ImportError>& error);

  const std::string& name() const { return name_; }
  const FileReader& reader() const { return reader_; }
  bool mayQuote() const { return mayQuote_; }  ///< errors may quote what stands in it
  pugi::xml_node root() const { return document_.document_element(); }
  bool failed() const { return error_.has_value(); }
  std::optional<ImportError>& error() const { return error_; }
  bool isMissing() const { return isMissing_; }  ///< the reader says that there is no such file
  bool isRefused() const { return isRefused_; }  ///< nobody looked, as its name leads where the map may not read

  /// Why there is no text of a file that another one names, which is to blame for that: the error goes into the text. ""
  /// if it was read, whatever there is in it.
  std::string takeReason(const char* kind) const;

  /// The line of a node, from 1; 0 if it has none, or comes from JSON.
  int line(pugi::xml_node node) const;

  /// The path of a file that this one names.
  std::string pathTo(std::string named) const { return pathBeside(name_, std::move(named)); }

  /// A text of the file as an error may quote it: after `before` and in quotes; or "".
  std::string quoted(const char* before, std::string_view text) const;

  /// Keeps this error, if it is the first. `option` is the field of Options that decides.
  void fail(pugi::xml_node node, std::string what, std::string option = {}) const;

  /// The value of an attribute that is a whole number from min to max. If the attribute is missing: the fallback, or an
  /// error if there is none.
  std::int64_t integer(pugi::xml_node node, const char* attribute, std::optional<std::int64_t> fallback,
                       std::int64_t min, std::int64_t max) const;

  /// The value of an attribute that is a finite number; 0 if the attribute is missing.
  double real(pugi::xml_node node, const char* attribute) const;

  /// The value of an attribute that is a list of pairs, such as "0,0 12.5,-3".
  std::vector<DoublePoint> points(pugi::xml_node node, const char* attribute) const;

 private:
  void read(const char* rootName, const std::string& refusal);
  void parse();
  void expectRoot(std::string_view rootName) const;
  int lineAt(std::ptrdiff_t offset) const;

  std::string name_;
  bool isTrusted_, mayQuote_ = true;
  bool wasRead_ = false, isMissing_ = false, isRefused_ = false;
  std::string text_;
  pugi::xml_document document_;
  const FileReader& reader_;
  std::optional<ImportError>& error_;
};

/// The class of a tile or object. Tiled 1.9 writes it as "class", all other versions as "type".
std::string classOf(pugi::xml_node node);

}  // namespace lgs::tiled
