// What kind of file it is decides how it is imported.
#include "import_one.h"
#include "ldtk.h"

#include <utility>

namespace lgs::tiled {

std::optional<Block> ImportedMap::block(const std::string& name) const {
  const auto found = blocks.find(name);
  return found == blocks.end() ? std::nullopt : std::optional(found->second);
}

tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options,
                                                 const FileReader& reader, const FolderLister& lister) {
  std::optional<ImportError> error;
  const XmlFile file(path, reader, "map", error);
  if (error) return tl::unexpected(std::move(*error));
  std::vector<std::string> notes;
  Options settled = options;
  if (file.root().attribute(kLdtkAttribute)) settleLdtk(file, settled, notes);
  if (error) return tl::unexpected(std::move(*error));
  ImportJob job{std::move(settled), reader, lister};
  const bool isWorld = std::string_view(file.root().name()) == "world";
  auto map = isWorld ? importWorld(file, job, error) : importOne(file, job, {}, error);
  if (!map) return map;
  job.names.checkAll(file);
  if (error) return tl::unexpected(std::move(*error));
  map->report.notes.insert(map->report.notes.begin(), notes.begin(), notes.end());
  for (std::string& note : job.asked.notes()) map->report.notes.push_back(std::move(note));
  return map;
}

}  // namespace lgs::tiled
