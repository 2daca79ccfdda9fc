#include "disk_file.h"

#ifdef _WIN32
#include <fstream>
#else
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#endif

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

}  // namespace lgs::tiled
