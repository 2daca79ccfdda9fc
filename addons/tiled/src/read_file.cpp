// What there is of the disk in the importer.
#include "words.h"

#include <lgs/tiled/import.h>

#ifndef _WIN32
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#endif
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace lgs::tiled {

namespace fs = std::filesystem;

namespace {

constexpr const char* kNone = "there is no such file, or no permission to read it";
constexpr const char* kNoFile = "it is no regular file";
constexpr const char* kFolder = "it is a folder";

tl::unexpected<std::string> because(const char* why) { return tl::unexpected<std::string>(why); }

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

#ifdef _WIN32

tl::expected<OpenFile, std::string> openRegular(const fs::path& path) {
  std::error_code failed;
  const auto status = fs::status(path, failed);
  if (fs::is_directory(status)) return because(kFolder);
  if (fs::exists(status) && !fs::is_regular_file(status)) return because(kNoFile);
  OpenFile result(::_wfopen(path.c_str(), L"rb"), std::fclose);
  if (!result) return because(kNone);
  return result;
}

#else

/// Opens a path folder by folder, and follows no link: so nobody can put one in between.
tl::expected<OpenFile, std::string> openRegular(const fs::path& path) {
  constexpr int kFlags = O_RDONLY | O_CLOEXEC | O_NOFOLLOW;
  const fs::path steps = path.relative_path();
  int folder = ::open("/", kFlags | O_DIRECTORY);
  for (const fs::path& step : steps.parent_path()) {
    const int next = ::openat(folder, step.c_str(), kFlags | O_DIRECTORY);
    ::close(folder);
    folder = next;
  }
  const int file = ::openat(folder, steps.empty() ? "." : steps.filename().c_str(), kFlags | O_NONBLOCK | O_NOCTTY);
  const bool isSocket = file < 0 && errno == ENXIO;
  ::close(folder);
  if (file < 0) return because(isSocket ? kNoFile : kNone);
  struct stat status {};
  OpenFile result(::fdopen(file, "rb"), std::fclose);
  if (!result || ::fstat(file, &status) != 0) return because(kNone);
  if (S_ISDIR(status.st_mode)) return because(kFolder);
  if (!S_ISREG(status.st_mode)) return because(kNoFile);
  return result;
}

#endif

/// Reads a regular file, whose path had no symbolic links in it a moment ago. It opens nothing that could block.
tl::expected<std::string, std::string> readRegularFile(const fs::path& path) {
  const auto file = openRegular(path);
  if (!file) return tl::unexpected(file.error());
  std::error_code failed;
  const std::uintmax_t size = fs::file_size(path, failed);
  if (failed) return because(kNone);
  if (size > std::uintmax_t{1} << 30) return because("it is larger than 1 GiB");
  std::string text(static_cast<std::size_t>(size), '\0');
  if (std::fread(text.data(), 1, text.size(), file->get()) != text.size()) return because("reading stopped half-way");
  return text;
}

/// The names of all that lies in a folder.
std::vector<std::string> namesIn(const fs::path& folder, std::error_code& failed) {
  std::vector<std::string> names;
  for (fs::directory_iterator at(folder, failed); !failed && at != fs::directory_iterator(); at.increment(failed))
    names.push_back(at->path().filename().string());
  return names;
}

/// Whether a folder is the root of a project: of a game, or of its maps.
bool isProject(const fs::path& folder) {
  std::error_code ignored;
  const std::vector<std::string> names = namesIn(folder, ignored);
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return isOneOf(name, {".git", "package.json", "project.godot", "Cargo.toml", "build.gradle", "pom.xml",
                          "pyproject.toml", "go.mod"}) ||
           isOneOf(fs::path(name).extension().string(), {".tiled-project", ".ldtk", ".sln", ".csproj"});
  });
}

/// What lies in folders, by its name in lower case. Each is listed once, as a map may name many files that are missing.
using Listed = std::map<fs::path, std::multimap<std::string, std::string>>;

/// The file below a folder whose path, as it really lies, differs from this one by case alone; or nothing.
std::optional<std::string> otherCase(const fs::path& folder, const fs::path& path, Listed& listed) {
  fs::path found = folder;
  for (const fs::path& step : path.lexically_relative(folder)) {
    const auto [all, isNew] = listed.try_emplace(found);
    std::error_code ignored;
    if (isNew)
      for (const std::string& name : namesIn(found, ignored)) all->second.emplace(lower(name), name);
    const auto [from, to] = all->second.equal_range(lower(step.string()));
    if (from == to) return std::nullopt;
    const auto same = std::find_if(from, to, [&](const auto& one) { return one.second == step.string(); });
    found /= (same == to ? from : same)->second;
  }
  return found.generic_string();
}

}  // namespace

tl::expected<std::string, std::string> readFile(const std::string& path) {
  std::error_code failed;
  const fs::path real = fs::canonical(path, failed);
  if (failed) return because(kNone);
  return readRegularFile(real);
}

FileReader readerBelow(const std::string& folder) {
  return [folder](const std::string& path) -> tl::expected<std::string, std::string> {
    if (!liesBelow(folder, path)) return because("it is not below the folder");
    std::error_code failed;
    const fs::path root = fs::canonical(folder.empty() ? "." : folder, failed);
    const fs::path real = failed ? fs::path() : fs::canonical(path, failed);
    if (failed) return because(kNone);
    // Nothing is said of what lies elsewhere, not even whether it is there.
    const bool isBelow = liesBelow(root.generic_string(), real.generic_string());
    return isBelow ? readRegularFile(real) : because("it is a symbolic link out of the folder");
  };
}

tl::expected<std::vector<std::string>, std::string> listFolder(const std::string& path) {
  std::error_code failed, ignored;  // what can not be looked at is no file
  std::vector<std::string> names = namesIn(path, failed);
  if (failed) return tl::unexpected(failed.message());
  std::erase_if(names, [&](const std::string& name) { return !fs::is_regular_file(fs::path(path) / name, ignored); });
  return names;
}

std::string projectFolder(const std::string& map) {
  constexpr int kMostUp = 2;  // of a map that is in no project
  std::error_code failed;
  fs::path folder = folderOf(map).empty() ? "." : folderOf(map), result = folder, real = fs::canonical(folder, failed);
  const char* const home = std::getenv("HOME");
  const fs::path top = home && *home != '\0' ? fs::weakly_canonical(home, failed) : fs::path();
  for (int up = 0; !real.empty(); ++up) {
    if (up <= kMostUp) result = folder;
    if (real == top) break;  // what lies in the home folder itself marks no project
    if (isProject(real)) {
      result = folder;
      break;
    }
    if (real.parent_path() == real.root_path()) break;
    real = real.parent_path();
    folder /= "..";
    if (fs::canonical(withoutSlash(folder), failed) != real) break;  // a link leads here: its neighbours are strangers
  }
  return withoutSlash(result);
}

tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options) {
  Options trusting = options;
  if (trusting.filesIn.empty() && !options.filesAnywhere) trusting.filesIn = projectFolder(path);
  const FileReader below = readerBelow(trusting.filesIn);
  std::vector<std::string> notes;
  Listed listed;
  const FileReader reader = [&](const std::string& name) -> tl::expected<std::string, std::string> {
    if (name == path || options.filesAnywhere) return readFile(name);
    auto text = below(name);
    if (text || !text.error().starts_with(kNoSuchFile)) return text;
    std::error_code failed;
    const fs::path folder = fs::canonical(trusting.filesIn, failed),
                   file = fs::weakly_canonical(fs::absolute(name), failed);
    const std::optional<std::string> other = failed ? std::nullopt : otherCase(folder, file, listed);
    if (!other || *other == file.generic_string()) return text;
    notes.push_back(name + " is read from " + *other + ", which differs by upper and lower case");
    return readerBelow(folder.generic_string())(*other);
  };
  auto map = importMap(path, trusting, reader, listFolder);
  if (map) map->report.notes.insert(map->report.notes.end(), notes.begin(), notes.end());
  return map;
}

}  // namespace lgs::tiled
