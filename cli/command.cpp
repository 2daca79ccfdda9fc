#include "cli/command.h"

#include "cli/import_error.h"
#include "cli/imported.h"
#include "oracle/trace/file.h"

#include <fmt/format.h>
#include <lgs/debug.h>
#include <lgs/world.h>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <span>
#include <system_error>

namespace lgs::cli {

Status complain(std::string_view text) {
  fmt::print(stderr, "{}\n", text);
  return Status::badInput;
}

Status write(const std::string& path, std::string_view content) {
  const auto done = oracle::writeFile(path, content);
  return done ? Status::fine : complain(message(done.error(), path == "-" ? "standard output" : path));
}

Status flushed(Status status) {
  errno = 0;
  const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!lost || status == Status::badInput) return status;  // bad input has had its complaint
  const std::string why = errno == 0 ? "" : ": " + std::generic_category().message(errno);
  const Status bad = complain("standard output: cannot write" + why);
  return status == Status::fine ? bad : status;
}

Status tryOutputs(std::initializer_list<std::string> paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1) {
    return complain("only one output can go to the standard output; name a file for the others");
  }
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    if (const auto done = oracle::tryToWrite(path); !done) return complain(message(done.error(), path));
  }
  return Status::fine;
}

namespace {

// The polygons of a saved world, as edits that make them.
tl::expected<oracle::Trace, std::string> readSaved(const std::string& path) {
  const auto bytes = oracle::readFile(path);
  if (!bytes) return tl::unexpected(message(bytes.error(), path));
  const auto world = World::load(std::as_bytes(std::span(*bytes)));
  if (!world) return tl::unexpected(path + ": " + message(world.error()));
  return oracle::parseTrace(writeTrace(*world)).trace;
}

}  // namespace

bool isMap(const std::string& path) {
  constexpr std::array kEndings{".tmx", ".tmj", ".json", ".world", ".ldtk"};
  if (std::any_of(kEndings.begin(), kEndings.end(), [&](const char* ending) { return path.ends_with(ending); }))
    return true;
  std::ifstream file(path, std::ios::binary);
  std::string begin(64, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (begin.starts_with(kByteOrderMark)) begin.erase(0, kByteOrderMark.size());
  const std::size_t first = begin.find_first_not_of(" \t\r\n");
  return first != std::string::npos && (begin[first] == '<' || begin[first] == '{');
}

tl::expected<oracle::Trace, std::string> readWorld(const std::string& path) {
  if (isMap(path)) {
    const auto map = tiled::importMap(path);
    if (!map) return tl::unexpected(complaint(map.error(), path, "lgs import "));
    return traceOf(*map);
  }
  if (path.ends_with(".lgs")) return readSaved(path);
  auto trace = oracle::readTrace(path);
  if (!trace) return tl::unexpected(message(trace.error(), path));
  return std::move(*trace);
}

CLI::Option* addWholeNumber(CLI::App& command, const std::string& name, std::function<void(std::uint64_t)> set,
                            WholeRange range, const std::string& description) {
  const auto read = [name, set = std::move(set), range](const std::string& text) {
    std::uint64_t number = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (status != std::errc() || end != text.data() + text.size() || number < range.min || number > range.max) {
      throw CLI::ValidationError(name,
                                 fmt::format("'{}' is not a whole number from {} to {}", text, range.min, range.max));
    }
    set(number);
  };
  return command.add_option_function<std::string>(name, read, description);
}

double readReal(const std::string& name, const std::string& text, RealRange range) {
  double number = 0;
  const auto [end, status] =
      std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::general);
  const bool isNumber = status == std::errc() && end == text.data() + text.size();
  if (!isNumber || !(number >= range.min && number <= range.max)) {  // false for nan
    throw CLI::ValidationError(name, fmt::format("'{}' is not a number from {} to {}", text, range.min, range.max));
  }
  return number;
}

CLI::Option* addReal(CLI::App& command, const std::string& name, std::function<void(double)> set, RealRange range,
                     const std::string& description) {
  const auto read = [name, set = std::move(set), range](const std::string& text) { set(readReal(name, text, range)); };
  return command.add_option_function<std::string>(name, read, description);
}

CLI::Option* addOracleOption(CLI::App& command, oracle::CheckOptions& options) {
  return command
      .add_option_function<std::string>(
          "--oracle",
          [&options](const std::string& which) {
            options.naive = which != "cgal";
            options.cgal = which != "naive";
          },
          "Which references compare: CGAL's exact union of all polygons;\n"
          "the naive one, which follows the laws word by word; or both\n"
          "(the default)")
      ->check(CLI::IsMember({"cgal", "naive", "both"}))
      ->option_text("cgal|naive|both");
}

}  // namespace lgs::cli
