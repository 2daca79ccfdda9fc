// The files of an import, each read once: so that the same map can be imported several times.
#pragma once

#include "import_one.h"

namespace lgs::tiled {

class Opened {
 public:
  /// Reads the map, and what it names. A problem is kept.
  Opened(const std::string& path, const Options& options, const FileReader& reader, const FolderLister& lister);
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  /// The first problem, of reading or of an import.
  const std::optional<ImportError>& error() const { return error_; }

  /// Forgets the problem of an import, so that there can be another one.
  void forgive() { error_.reset(); }

  /// One pass with these options. What it takes of the budget, the tiles and the placements is gone for the next.
  tl::expected<ImportedMap, ImportError> import(const Options& options, Budget& budget, std::size_t& tiles,
                                                std::size_t& placements);

  const std::vector<std::unique_ptr<MapSource>>& maps() const { return maps_; }
  Budget& budget() { return budget_; }

 private:
  tl::expected<std::string, std::string> read(const std::string& name);
  void openWorld(const FolderLister& lister);
  std::unique_ptr<const XmlFile> openMapOf(const WorldMap& entry);

  std::string path_;
  const Options& options_;
  const FileReader& reader_;
  FileReader guarded_;
  Budget budget_;
  std::optional<ImportError> error_;
  std::vector<std::string> notes_;
  std::optional<std::pair<pugi::xml_node, std::string>> missing_;  // the first map of a world that cannot be read
  std::unique_ptr<const XmlFile> world_;                           // null for a map by itself
  std::vector<std::unique_ptr<MapSource>> maps_;
};

}  // namespace lgs::tiled
