// What there is of the disk in the importer.
#include "below.h"
#include "words.h"

#include <lgs/tiled/import.h>

#ifdef _WIN32
#include <fstream>
#else
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#endif
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

namespace lgs::tiled {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;

tl::unexpected<std::string> because(const char* why) { return tl::unexpected<std::string>(why); }

constexpr const char* kNone = "there is no such file, or no permission to read it";
constexpr const char* kNoFile = "it is no regular file";
constexpr const char* kFolder = "it is a folder";
constexpr const char* kTooLarge = "it is larger than 1 GiB";
constexpr const char* kHalfWay = "reading stopped half-way";

}  // namespace

#ifdef _WIN32

tl::expected<std::string, std::string> readRegularFile(const std::filesystem::path& path) {
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (std::filesystem::is_directory(status)) return because(kFolder);
  if (failed || !std::filesystem::exists(status)) return because(kNone);
  if (!std::filesystem::is_regular_file(status)) return because(kNoFile);
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  std::ifstream in(path, std::ios::binary);
  if (failed || !in) return because(kNone);
  if (size > kMostBytes) return because(kTooLarge);
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!in.read(text.data(), static_cast<std::streamsize>(size))) return because(kHalfWay);
  return text;
}

#else

namespace {

/// A descriptor that is closed at the end.
class Open {
 public:
  explicit Open(int file) : file_(file) {}
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;
  ~Open() {
    if (file_ >= 0) ::close(file_);
  }
  int get() const { return file_; }
  void reset(int file) {
    if (file_ >= 0) ::close(file_);
    file_ = file;
  }

 private:
  int file_;
};

/// Opens a path folder by folder, and follows no link: so nobody can put one in between.
int openStepByStep(const std::filesystem::path& path) {
  constexpr int kFlags = O_RDONLY | O_CLOEXEC | O_NOFOLLOW;
  Open folder(::open("/", kFlags | O_DIRECTORY));
  const std::filesystem::path steps = path.relative_path();
  for (const std::filesystem::path& step : steps.parent_path()) {
    folder.reset(::openat(folder.get(), step.c_str(), kFlags | O_DIRECTORY));
  }
  if (steps.empty()) return ::open("/", kFlags | O_DIRECTORY);
  return ::openat(folder.get(), steps.filename().c_str(), kFlags | O_NONBLOCK | O_NOCTTY);
}

}  // namespace

tl::expected<std::string, std::string> readRegularFile(const std::filesystem::path& path) {
  const Open file(openStepByStep(path));
  struct stat status {};
  if (file.get() < 0) return because(errno == ENXIO ? kNoFile : kNone);  // ENXIO: a socket
  if (::fstat(file.get(), &status) != 0) return because(kNone);
  if (S_ISDIR(status.st_mode)) return because(kFolder);
  if (!S_ISREG(status.st_mode)) return because(kNoFile);
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > kMostBytes) return because(kTooLarge);
  std::string text(static_cast<std::size_t>(size), '\0');
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t now = ::read(file.get(), text.data() + done, text.size() - done);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) return because(kHalfWay);
    done += static_cast<std::size_t>(now);
  }
  return text;
}

#endif

namespace fs = std::filesystem;

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
