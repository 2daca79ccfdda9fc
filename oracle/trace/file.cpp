#include "oracle/trace/file.h"

#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

namespace lgs::oracle {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxFile = std::size_t{1} << 30;

// stdio, not streams: it says why it failed, a directory included.
struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

TraceError systemError(std::string_view what) {
  return {0, fmt::format("{}: {}", what, std::generic_category().message(errno)), {}};
}

}  // namespace

tl::expected<std::string, TraceError> readFile(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) return tl::unexpected(systemError("cannot open the file"));
  std::string content;
  char buffer[65'536];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) {
    content.append(buffer, n);
    if (content.size() > kMaxFile) return tl::unexpected(TraceError{0, "larger than 1 GiB", {}});
  }
  if (std::ferror(file.get())) return tl::unexpected(systemError("cannot read the file"));
  return content;
}

namespace {

bool writeTo(std::FILE* file, std::string_view content) {
  return std::fwrite(content.data(), 1, content.size(), file) == content.size() && std::fflush(file) == 0;
}

/// A new file beside another one, whose name it gets at the end, when all of it is on the disk. Until then the other
/// one is as it was. If that does not come to pass, nothing is left of it.
class Beside {
 public:
  explicit Beside(const fs::path& target)
      : target_(target), name_(target.string() + ".XXXXXX"), file_(::mkstemp(name_.data())) {}
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  ~Beside() {
    if (file_ < 0) return;
    const int why = errno;
    ::close(file_);
    if (!isInPlace_) ::unlink(name_.c_str());
    errno = why;
  }

  bool isOpen() const { return file_ >= 0; }

  bool replace(std::string_view content) {
    const int copy = ::dup(file_);
    File stream(copy < 0 ? nullptr : ::fdopen(copy, "wb"));
    if (!stream || !writeTo(stream.get(), content)) return false;
    if (std::fclose(stream.release()) != 0 || ::fsync(file_) != 0 || ::fchmod(file_, mode()) != 0) return false;
    isInPlace_ = std::rename(name_.c_str(), target_.c_str()) == 0;
    return isInPlace_;
  }

 private:
  /// Who may read and write: as of the file that was there, or as of any new one.
  ::mode_t mode() const {
    struct stat before {};
    if (::stat(target_.c_str(), &before) == 0) return before.st_mode & 07777;
    const ::mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
  }

  fs::path target_;
  std::string name_;
  int file_;
  bool isInPlace_ = false;
};

/// What is written in place, since there is no old content to lose: pipes, devices.
bool isStream(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// Where a path leads: a link stays, and what it points to is replaced.
fs::path targetOf(const std::string& path) {
  std::error_code failed;
  fs::path target = fs::weakly_canonical(path, failed);
  return failed || !fs::is_symlink(path, failed) ? fs::path(path) : target;
}

/// Whether the file may be replaced, as far as its own permissions say.
bool mayReplace(const fs::path& target) {
  std::error_code ignored;
  if (fs::is_directory(target, ignored)) errno = EISDIR;
  return !fs::is_directory(target, ignored) && (!fs::exists(target, ignored) || ::access(target.c_str(), W_OK) == 0);
}

}  // namespace

tl::expected<void, TraceError> writeFile(const std::string& path, std::string_view content) {
  if (path == "-") {
    if (!writeTo(stdout, content)) return tl::unexpected(systemError("cannot write"));
    return {};
  }
  if (isStream(path)) {
    const File file(std::fopen(path.c_str(), "wb"));
    if (!file || !writeTo(file.get(), content)) return tl::unexpected(systemError("cannot write the file"));
    return {};
  }
  const fs::path target = targetOf(path);
  if (!mayReplace(target)) return tl::unexpected(systemError("cannot write the file"));
  Beside file(target);
  if (!file.isOpen() || !file.replace(content)) return tl::unexpected(systemError("cannot write the file"));
  return {};
}

tl::expected<void, TraceError> tryToWrite(const std::string& path) {
  if (path == "-" || isStream(path)) return {};  // whoever reads from a pipe would take the trial for the end
  const fs::path target = targetOf(path);
  if (!mayReplace(target) || !Beside(target).isOpen()) return tl::unexpected(systemError("cannot write the file"));
  return {};
}

tl::expected<Trace, TraceError> readTrace(const std::string& path) {
  const auto text = readFile(path);
  if (!text) return tl::unexpected(text.error());
  ParsedTrace parsed = parseTrace(*text);
  if (!parsed.error) return std::move(parsed.trace);
  Player player(parsed.trace.preserve);
  if (const auto done = play(parsed.trace, player); !done) return tl::unexpected(done.error());
  return tl::unexpected(*parsed.error);
}

}  // namespace lgs::oracle
