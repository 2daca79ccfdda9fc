// One XML file with its name and lines, and typed access to attributes. The first thing found wrong is kept and
// everything after it yields defaults, so readers run straight through and look at failed() where it matters.
#pragma once

#include <lgs/tiled/import.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lgs::tiled {

class XmlFile {
 public:
  /// Reads and parses; `error` outlives the file and is shared by the files of one import. `rootName` is what the root
  /// element must be.
  XmlFile(std::string name, const FileReader& reader, const char* rootName, std::optional<ImportError>& error);

  const std::string& name() const { return name_; }
  pugi::xml_node root() const { return document_.document_element(); }
  bool failed() const { return error_.has_value(); }
  int line(pugi::xml_node node) const;

  /// Keeps the error, if it is the first.
  void fail(pugi::xml_node node, std::string what) const;

  /// A whole number from min to max. Without `fallback` the attribute must be there.
  std::int64_t integer(pugi::xml_node node, const char* attribute, std::optional<std::int64_t> fallback,
                       std::int64_t min, std::int64_t max) const;

  /// A finite number; 0 where the attribute is missing.
  double real(pugi::xml_node node, const char* attribute) const;

  /// The pairs of a list like "0,0 12.5,-3".
  std::vector<DoublePoint> points(pugi::xml_node node, const char* attribute) const;

 private:
  void parse(const FileReader& reader, const char* rootName);

  std::string name_;
  std::string text_;
  std::vector<std::size_t> lineStarts_;
  pugi::xml_document document_;
  std::optional<ImportError>& error_;
};

/// The class of a tile or object: "type" before Tiled 1.9 and from 1.10 on, "class" in 1.9.
std::string classOf(pugi::xml_node node);

}  // namespace lgs::tiled
