// What there is of the disk in the importer.
#include <lgs/tiled/import.h>

#include <filesystem>
#include <fstream>

namespace lgs::tiled {

tl::expected<std::string, std::string> readFile(const std::string& path) {
  constexpr std::streamoff kMost = std::streamoff{1} << 30;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return tl::unexpected<std::string>("it is a folder");
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = in ? static_cast<std::streamoff>(in.tellg()) : -1;
  if (size < 0) return tl::unexpected<std::string>("there is no such file, or no permission to read it");
  if (size > kMost) return tl::unexpected<std::string>("it is larger than 1 GiB");
  in.seekg(0);
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!in.read(text.data(), static_cast<std::streamsize>(size)))
    return tl::unexpected<std::string>("reading stopped half-way");
  return text;
}

tl::expected<std::vector<std::string>, std::string> listFolder(const std::string& path) {
  std::vector<std::string> names;
  std::error_code failed;
  std::filesystem::directory_iterator at(path, failed);
  while (!failed && at != std::filesystem::directory_iterator()) {
    std::error_code ignored;  // what can not be looked at is no file
    if (at->is_regular_file(ignored)) names.push_back(at->path().filename().string());
    at.increment(failed);
  }
  if (failed) return tl::unexpected(failed.message());
  return names;
}

tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options) {
  return importMap(path, options, readFile, listFolder);
}

}  // namespace lgs::tiled
