// What kind of file it is decides how it is imported.
#include "below.h"
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
  Budget budget(options);
  const FileReader guarded = [&](const std::string& name) -> tl::expected<std::string, std::string> {
    if (!options.filesAnywhere && name != path && !liesBelow(folderOf(path), name)) {
      return tl::unexpected<std::string>(
          "it is not below the map's folder. If the map can be trusted, files may lie anywhere: "
          "Options::filesAnywhere");
    }
    auto text = reader(name);
    if (text && !budget.read(text->size())) {
      return tl::unexpected<std::string>("the files of the map are larger together than the limit (Options::maxBytes)");
    }
    return text;
  };
  std::optional<ImportError> error;
  const XmlFile file(path, guarded, "map", error, {true, options.filesAnywhere});
  if (error) return tl::unexpected(std::move(*error));
  std::vector<std::string> notes;
  Options settled = options;
  if (file.root().attribute(kLdtkAttribute)) settleLdtk(file, settled, notes);
  if (error) return tl::unexpected(std::move(*error));
  ImportJob job{std::move(settled), budget, guarded, lister};
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
