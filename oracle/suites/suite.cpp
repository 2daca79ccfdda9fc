#include "oracle/suites/suite.h"

#include "oracle/trace/file.h"
#include "oracle/trace/trace.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <numeric>

namespace lgs::oracle {
namespace {

namespace fs = std::filesystem;

constexpr std::array kResults{"union", "intersection", "difference", "xor", "all"};

bool hasResultName(const fs::path& file) { return std::ranges::find(kResults, file.stem().string()) != kResults.end(); }

// Of an args.geojson: those whose results lie beside it.
std::vector<Operation> operationsBeside(const fs::path& file) {
  std::vector<Operation> operations;
  if (file.stem() != "args") return operations;
  std::error_code ignored;
  for (const char* const name : kResults) {
    if (!fs::exists(fs::path(file).replace_filename(name).replace_extension(file.extension()), ignored)) continue;
    for (const Operation operation : operationOf(name).operations)
      if (std::ranges::find(operations, operation) == operations.end()) operations.push_back(operation);
  }
  return operations;
}

Read readFileOf(const fs::path& path, Suite& suite) {
  const std::string file = path.string();
  constexpr std::uintmax_t kMost = std::uintmax_t{64} << 20;
  std::error_code ignored;  // reading it will say what is wrong
  if (fs::file_size(path, ignored) > kMost && !ignored) return tl::unexpected(file + ": it has more than 64 MiB");
  const auto bytes = readFile(file);
  if (!bytes) return tl::unexpected(message(bytes.error(), file));
  std::string_view text = *bytes;
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const char begin = first == std::string_view::npos ? ' ' : text[first];
  const std::size_t seen = suite.seen();
  const Read done = begin == '<'                   ? readXml(file, text, suite)
                    : begin == '{' || begin == '[' ? readJson(file, text, operationsBeside(path), suite)
                    : text.find("CLIPTYPE") != std::string_view::npos ? readClipper(file, text, suite)
                                                                      : readWkt(file, text, suite);
  if (!done) return tl::unexpected(file + ":" + done.error());
  if (suite.seen() == seen)
    return tl::unexpected(file +
                          ": there is no case in it. Suites are texts of Clipper2, JSON of iOverlay, GeoJSON, WKT, "
                          "or XML of GEOS and JTS");
  ++suite.files;
  return {};
}

bool isOfSuites(const fs::path& file) {
  constexpr std::array kEndings{".txt", ".json", ".geojson", ".wkt", ".xml"};
  return std::ranges::find(kEndings, file.extension().string()) != kEndings.end();
}

}  // namespace

std::size_t Suite::seen() const {
  return std::accumulate(leftOut.begin(), leftOut.end(), cases.size(),
                         [](std::size_t sum, const auto& entry) { return sum + entry.second; });
}

void Suite::add(const std::string& place, const std::vector<Operation>& operations,
                const std::vector<Operand>& operands) {
  for (const Operation operation : operations)
    cases.push_back(
        {fmt::format("{}: {}", place, kOperations[static_cast<std::size_t>(operation)]), operation, operands});
}

NamedOperation operationOf(std::string_view name) {
  std::string word(name);
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto begins = [&](std::string_view with) { return word.starts_with(with); };
  using enum Operation;
  if (begins("union") || word == "unaryunion") return {{unite}};
  if (begins("intersection") || word == "intersect") return {{intersect}};
  if (word == "diff_ba" || word == "inversedifference") return {{subtract}, true};
  if (begins("diff") || begins("subtract")) return {{subtract}};
  if (begins("xor") || begins("symdiff") || begins("symmetricdiff")) return {{exclude}};
  if (word == "all" || word == "overlayareatest") return {kAllOperations};
  return {};
}

tl::expected<Suite, std::string> readSuite(const std::string& path) {
  Suite suite;
  std::error_code ignored;  // reading it will say what is wrong
  if (!fs::is_directory(path, ignored)) {
    const Read done = readFileOf(path, suite);
    return done ? tl::expected<Suite, std::string>(std::move(suite)) : tl::unexpected(done.error());
  }
  std::vector<fs::path> files;
  std::error_code unread;
  for (auto at = fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied, unread);
       at != fs::recursive_directory_iterator(); at.increment(unread)) {
    if (!at->is_regular_file(ignored)) continue;
    const bool isResult =
        hasResultName(at->path()) && fs::exists(fs::path(at->path()).replace_filename("args.geojson"), ignored);
    if (isOfSuites(at->path()) && !isResult) files.push_back(at->path());
    if (!isOfSuites(at->path())) ++suite.leftOut["file whose name does not end in txt, json, geojson, wkt or xml"];
  }
  if (unread) ++suite.leftOut["folder that can not be read to its end: " + unread.message()];
  std::ranges::sort(files);
  for (const fs::path& file : files)
    if (const Read done = readFileOf(file, suite); !done) ++suite.leftOut[done.error()];
  if (suite.files == 0) return tl::unexpected(path + ": there is no suite in this folder");
  return suite;
}

}  // namespace lgs::oracle
