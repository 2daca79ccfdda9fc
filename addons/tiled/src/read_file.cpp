// What there is of the disk in the importer.
#include "below.h"
#include "disk_file.h"

#include <lgs/tiled/import.h>

#include <filesystem>

namespace lgs::tiled {

namespace fs = std::filesystem;

tl::expected<std::string, std::string> readFile(const std::string& path) {
  std::error_code failed;
  const fs::path real = fs::canonical(path, failed);
  if (failed) return tl::unexpected<std::string>("there is no such file, or no permission to read it");
  return readRegularFile(real);
}

FileReader readerBelow(const std::string& folder) {
  return [folder](const std::string& path) -> tl::expected<std::string, std::string> {
    if (!liesBelow(folder, path)) return tl::unexpected<std::string>("it is not below the folder");
    std::error_code failed;
    const fs::path root = fs::canonical(folder.empty() ? "." : folder, failed);
    const fs::path real = failed ? fs::path() : fs::canonical(path, failed);
    if (failed) return tl::unexpected<std::string>("there is no such file, or no permission to read it");
    // Nothing is said of what lies elsewhere, not even whether it is there.
    if (!liesBelow(root.generic_string(), real.generic_string())) {
      return tl::unexpected<std::string>("it is a symbolic link out of the map's folder");
    }
    return readRegularFile(real);
  };
}

tl::expected<std::vector<std::string>, std::string> listFolder(const std::string& path) {
  std::vector<std::string> names;
  std::error_code failed;
  fs::directory_iterator at(path, failed);
  while (!failed && at != fs::directory_iterator()) {
    std::error_code ignored;  // what can not be looked at is no file
    if (at->is_regular_file(ignored)) names.push_back(at->path().filename().string());
    at.increment(failed);
  }
  if (failed) return tl::unexpected(failed.message());
  return names;
}

tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options) {
  const FileReader below = readerBelow(folderOf(path));
  const FileReader reader = [&](const std::string& name) {
    return name == path || options.filesAnywhere ? readFile(name) : below(name);
  };
  return importMap(path, options, reader, listFolder);
}

}  // namespace lgs::tiled
