#include "oracle/trace/file.h"

#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace lgs::oracle {
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

tl::expected<void, TraceError> writeFile(const std::string& path, std::string_view content) {
  const auto write = [&](std::FILE* file) {
    return std::fwrite(content.data(), 1, content.size(), file) == content.size() && std::fflush(file) == 0;
  };
  if (path == "-") {
    if (!write(stdout)) return tl::unexpected(systemError("cannot write"));
    return {};
  }
  const File file(std::fopen(path.c_str(), "wb"));
  if (!file || !write(file.get())) return tl::unexpected(systemError("cannot write the file"));
  return {};
}

tl::expected<void, TraceError> tryToWrite(const std::string& path) {
  namespace fs = std::filesystem;
  if (path == "-") return {};
  std::error_code ignored;
  const fs::file_status before = fs::status(path, ignored);
  // Whoever reads from a pipe would take the trial for the end.
  if (fs::exists(before) && !fs::is_regular_file(before) && !fs::is_directory(before)) return {};
  if (!File(std::fopen(path.c_str(), "ab"))) return tl::unexpected(systemError("cannot write the file"));
  if (!fs::exists(before)) fs::remove(path, ignored);
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
