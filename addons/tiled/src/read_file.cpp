// What there is of the disk in the importer.
#include "below.h"
#include "disk_file.h"
#include "properties.h"

#include <lgs/tiled/import.h>

#include <algorithm>
#include <array>
#include <cstdlib>
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
      return tl::unexpected<std::string>("it is a symbolic link out of the folder");
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

namespace {

/// Whether a folder is the root of a project: of a game, or of its maps.
bool isProject(const fs::path& folder) {
  constexpr std::array<std::string_view, 8> kNames{".git",         "package.json", "project.godot",  "Cargo.toml",
                                                   "build.gradle", "pom.xml",      "pyproject.toml", "go.mod"};
  constexpr std::array<std::string_view, 4> kExtensions{".tiled-project", ".ldtk", ".sln", ".csproj"};
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed); !failed && at != fs::directory_iterator(); at.increment(failed)) {
    const fs::path& path = at->path();
    if (std::find(kNames.begin(), kNames.end(), path.filename().string()) != kNames.end()) return true;
    if (std::find(kExtensions.begin(), kExtensions.end(), path.extension().string()) != kExtensions.end()) return true;
  }
  return false;
}

/// The file below a folder whose path differs from this one by upper and lower case alone, both as they really lie; or
/// nothing.
std::optional<std::string> otherCase(const fs::path& folder, const fs::path& path) {
  fs::path found = folder;
  for (const fs::path& step : path.lexically_relative(folder)) {
    std::error_code failed;
    std::string best;
    for (fs::directory_iterator at(found, failed); !failed && at != fs::directory_iterator(); at.increment(failed)) {
      const std::string name = at->path().filename().string();
      if (name == step.string() || (best != step.string() && lower(name) == lower(step.string()))) best = name;
    }
    if (best.empty()) return std::nullopt;
    found /= best;
  }
  return found.generic_string();
}

}  // namespace

std::string projectFolder(const std::string& map) {
  constexpr int kMostUp = 2;  // of a map that is in no project
  std::error_code failed;
  fs::path folder = folderOf(map).empty() ? "." : folderOf(map), result = folder;
  const fs::path first = fs::canonical(folder, failed);
  const char* const home = std::getenv("HOME");
  const fs::path top = home && *home != '\0' ? fs::weakly_canonical(home, failed) : fs::path();
  fs::path real = first;
  for (int up = 0; !real.empty(); ++up) {
    if (up <= kMostUp) result = folder;
    if (isProject(real)) {
      result = folder;
      break;
    }
    if (real == top || real.parent_path() == real.root_path()) break;
    real = real.parent_path();
    folder /= "..";
  }
  return withoutSlash(result);
}

tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options) {
  Options trusting = options;
  if (trusting.filesIn.empty() && !options.filesAnywhere) trusting.filesIn = projectFolder(path);
  const FileReader below = readerBelow(trusting.filesIn);
  std::vector<std::string> notes;
  const FileReader reader = [&](const std::string& name) -> tl::expected<std::string, std::string> {
    if (name == path || options.filesAnywhere) return readFile(name);
    auto text = below(name);
    if (text || !text.error().starts_with(kNoSuchFile)) return text;
    std::error_code failed;
    const fs::path folder = fs::canonical(trusting.filesIn, failed),
                   file = fs::weakly_canonical(fs::absolute(name), failed);
    const std::optional<std::string> other = failed ? std::nullopt : otherCase(folder, file);
    if (!other || *other == file.generic_string()) return text;
    notes.push_back(name + " is read from " + *other + ", which differs by upper and lower case");
    return readerBelow(folder.generic_string())(*other);
  };
  auto map = importMap(path, trusting, reader, listFolder);
  if (map) map->report.notes.insert(map->report.notes.end(), notes.begin(), notes.end());
  return map;
}

}  // namespace lgs::tiled
