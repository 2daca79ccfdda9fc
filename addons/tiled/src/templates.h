// Object templates: files (TX) that hold one object each, which others fill up.
#pragma once

#include "xml.h"

#include <map>
#include <memory>

namespace lgs::tiled {

struct Template {
  Template(const XmlFile& by, const std::string& named, const FileReader& reader)
      : file(by, named, reader, "template", error) {}

  std::optional<ImportError> error;  ///< why it or its tileset can not be read; this does not spoil the map
  XmlFile file;
};

/// The templates of an import, each read once.
class Templates {
 public:
  explicit Templates(const FileReader& reader) : reader_(reader) {}

  /// The one that a file names.
  Template& of(const XmlFile& file, const std::string& named) {
    std::unique_ptr<Template>& known = templates_[file.pathTo(named)];
    if (!known) known = std::make_unique<Template>(file, named, reader_);
    return *known;
  }

 private:
  const FileReader& reader_;
  std::map<std::string, std::unique_ptr<Template>> templates_;  // by path
};

}  // namespace lgs::tiled
