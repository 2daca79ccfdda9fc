#include "cli/import/survey.h"

#include "cli/import/error.h"
#include "cli/import/options.h"
#include "lib/text/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

namespace lgs::cli {
namespace {

namespace fs = std::filesystem;

/// What comes of a map, the best first.
enum class MapOutcome : std::uint8_t { atOnce, inPart, byCommand, nothing, refused };

constexpr std::array<const char*, 5> kOutcomes{"at once", "in part", "by command", "nothing", "refused"};
constexpr std::array<const char*, 5> kMeanings{"a world at the first try", "a world, with a word on what is missing",
                                               "a world after the first command that is offered",
                                               "nothing in them could be solid", "not read, with the reason"};

struct MapRow {
  MapOutcome outcome{};
  std::uint64_t polygons = 0;
  std::string map;
  std::string what;  ///< what was taken, or the command, or the reason
};

MapRow rowOf(const std::string& path, const tiled::Options& options) {
  const auto map = tiled::importMap(path, options);
  if (!map) return {MapOutcome::refused, 0, path, complaint(map.error(), path)};
  const tiled::Report& report = map->report;
  const double cells = report.infinite ? 0 : static_cast<double>(report.width) * report.height;
  const std::string share =
      cells > 0 ? fmt::format("{:.0f} % of the map: ", 100 * static_cast<double>(report.cells) / cells) : "";
  if (report.polygons > 0 && report.partial.empty())
    return {MapOutcome::atOnce, report.polygons, path, share + report.choice};
  if (report.polygons > 0) return {MapOutcome::inPart, report.polygons, path, share + report.partial};
  if (report.suggestions.empty()) return {MapOutcome::nothing, 0, path, ""};
  const tiled::Suggestion& first = report.suggestions.front();
  return {MapOutcome::byCommand, first.polygons, path, argumentsOf(first)};
}

/// Whether a file may be a map, by its name. Tilesets and templates in JSON have names of maps, too; they are passed
/// over.
bool mayBeMap(const fs::path& path) {
  constexpr std::array kEndings{".tmx", ".tmj", ".json", ".world", ".ldtk"};
  return std::find(kEndings.begin(), kEndings.end(), path.extension().string()) != kEndings.end();
}

bool isNoMap(const fs::path& path, const MapRow& row) {
  return row.outcome == MapOutcome::refused && path.extension() == ".json" &&
         (row.what.find("is JSON, but") != std::string::npos ||
          row.what.find("What is read: maps of Tiled") != std::string::npos ||
          row.what.find("this is not the kind of file expected") != std::string::npos ||
          row.what.find("may be a tileset") != std::string::npos);
}

/// The last words of a complaint, without a command that follows: so that equal reasons can be counted.
std::string reasonIn(const std::string& complaint) {
  const std::string line = complaint.substr(0, complaint.find(": lgs import "));
  const std::size_t colon = line.rfind(": ", line.size() - std::min<std::size_t>(line.size(), 2));
  return colon == std::string::npos ? line : line.substr(colon + 2);
}

Status listMaps(const std::string& folder, std::vector<std::string>& maps) {
  std::error_code fault;
  if (fs::is_regular_file(folder, fault)) {
    maps.push_back(folder);
    return Status::fine;
  }
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, fault);
  for (; !fault && at != fs::recursive_directory_iterator(); at.increment(fault)) {
    if (at->is_regular_file(fault) && mayBeMap(at->path())) maps.push_back(at->path().generic_string());
    fault.clear();  // a file that cannot be looked at is no map
  }
  return fault ? complain(folder + ": " + fault.message()) : Status::fine;
}

void printRows(const std::vector<MapRow>& rows) {
  for (std::size_t k = 0; k < kOutcomes.size(); ++k) {
    const auto outcome = static_cast<MapOutcome>(k);
    for (const MapRow& row : rows) {
      if (row.outcome != outcome) continue;
      fmt::print("{:<10}  {:>8}  {}{}\n", kOutcomes[k], row.polygons, text::withoutControls(row.map),
                 row.what.empty() ? "" : "  |  " + text::withoutControls(row.what));
    }
  }
  fmt::print("\n{} maps\n", rows.size());
  for (std::size_t k = 0; k < kOutcomes.size(); ++k) {
    const auto count = std::count_if(rows.begin(), rows.end(),
                                     [&](const MapRow& row) { return row.outcome == static_cast<MapOutcome>(k); });
    const double share = rows.empty() ? 0 : 100.0 * static_cast<double>(count) / static_cast<double>(rows.size());
    fmt::print("{:>6}  {:>3.0f} %  {:<10}  {}\n", count, share, kOutcomes[k], kMeanings[k]);
  }
  std::map<std::string, int> reasons;
  for (const MapRow& row : rows)
    if (row.outcome == MapOutcome::refused) ++reasons[reasonIn(row.what)];
  for (const auto& [reason, count] : reasons) fmt::print("{:>6}  refused: {}\n", count, text::withoutControls(reason));
}

}  // namespace

Status survey(const std::vector<std::string>& folders, const tiled::Options& options) {
  std::vector<MapRow> rows;
  std::set<std::string> contents;  // equal maps count once
  for (const std::string& folder : folders) {
    std::vector<std::string> maps;
    if (const Status bad = listMaps(folder, maps); bad != Status::fine) return bad;
    std::sort(maps.begin(), maps.end());
    tiled::Options trusting = options;  // whoever names a folder trusts it
    if (options.filesIn.empty() && fs::is_directory(folder)) trusting.filesIn = folder;
    for (const std::string& path : maps) {
      MapRow row = rowOf(path, trusting);
      const auto text = tiled::readFile(path);
      if (!isNoMap(path, row) && (!text || contents.insert(*text).second)) rows.push_back(std::move(row));
    }
  }
  if (rows.empty()) return complain("there is no map in the folder");
  printRows(rows);
  return Status::fine;
}

}  // namespace lgs::cli
