#include "cli/inputs.h"

#include "lib/text/words.h"
#include "oracle/trace/file.h"
#include "oracle/trace/saved.h"

#include <fmt/format.h>
#include <lgs/world.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <span>

namespace lgs::cli {
namespace {

// Whether a file is a map: by its name, or else as it begins like XML or JSON.
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

tl::expected<oracle::Trace, std::string> readSaved(const std::string& path) {
  const auto bytes = oracle::readFile(path);
  if (!bytes) return tl::unexpected(message(bytes.error(), path));
  const auto world = World::load(std::as_bytes(std::span(*bytes)));
  if (!world) return tl::unexpected(path + ": " + message(world.error()));
  return oracle::traceOf(*world);
}

// What `lgs import MAP` writes. What it has to say of the map it says by itself, on the standard error.
tl::expected<oracle::Trace, std::string> readMap(const std::string& path) {
  const auto import = programBeside("import");
  if (!import) return tl::unexpected(path + " is a map, and " + import.error());
  const std::string command = text::shellWord(*import) + " " + text::shellWord(path) + " --report /dev/null";
  std::FILE* const output = popen(command.c_str(), "r");
  if (output == nullptr) return tl::unexpected(path + ": " + *import + " can not be started");
  std::string trace;
  std::array<char, 65'536> piece;
  for (std::size_t n = 1; n > 0;) trace.append(piece.data(), n = std::fread(piece.data(), 1, piece.size(), output));
  if (pclose(output) != 0) {
    return tl::unexpected(path + ": not imported. `lgs import` has options for maps, and writes a trace to go on with");
  }
  return oracle::parseTrace(trace).trace;
}

}  // namespace

tl::expected<oracle::Trace, std::string> readWorld(const std::string& path) {
  if (isMap(path)) return readMap(path);
  if (path.ends_with(".lgs")) return readSaved(path);
  auto trace = oracle::readTrace(path);
  if (!trace) return tl::unexpected(message(trace.error(), path));
  return std::move(*trace);
}

std::vector<std::string> tracesIn(const std::string& folder) {
  std::vector<std::string> traces;
  std::error_code ignored;  // reading one will say what is wrong
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".trace") traces.push_back(entry.path().string());
  std::ranges::sort(traces);
  return traces;
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
