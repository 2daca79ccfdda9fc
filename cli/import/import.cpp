#include "cli/command.h"
#include "cli/import/error.h"
#include "cli/import/imported.h"
#include "cli/import/options.h"
#include "cli/import/picture.h"
#include "cli/import/survey.h"
#include "lib/text/words.h"
#include "oracle/draw/draw.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <filesystem>

namespace lgs::cli {
namespace {

struct ImportArguments {
  std::string map;
  std::vector<std::string> survey;
  std::string trace = "-";
  std::string report;
  std::string svg;
  bool allowEmpty = false;
  bool strict = false;
  tiled::Options options;
  std::string hintArguments;  ///< those of them that go into hints: " --layer Ground"
};

/// The picture of a map; beside it the next best reading, if there is one.
tl::expected<std::string, std::string> pictureOf(const ImportArguments& arguments, const tiled::ImportedMap& map) {
  const std::string title = std::filesystem::path(arguments.map).filename().string();
  if (!map.report.suggestions.empty()) {
    const tiled::Suggestion& next = map.report.suggestions.front();
    const auto other = tiled::importMap(arguments.map, next.options);
    if (other) return drawReadings(title, map, *other, argumentsOf(next));
  }
  const oracle::Trace trace = traceOf(map);
  oracle::Player player(trace.preserve);
  if (const auto done = play(trace, player); !done) return tl::unexpected(message(done.error(), map.report.file));
  oracle::DrawOptions options;
  options.title = title;
  return drawWorld(player.scene(), oracle::outlineOf(player.world()), options);
}

Status run(const ImportArguments& arguments) {
  if (!arguments.survey.empty()) return survey(arguments.survey, arguments.options);
  const Status bad = tryOutputs({arguments.trace, arguments.report, arguments.svg});
  if (bad != Status::fine) return bad;
  const auto map = tiled::importMap(arguments.map, arguments.options);
  if (!map) return complain(complaint(map.error(), arguments.map));
  const bool isEmpty = map->placements.empty() && !arguments.allowEmpty;
  Status status = isEmpty ? Status::badInput : write(arguments.trace, printTrace(traceOf(*map)));
  const std::string command = "lgs import " + text::shellWord(arguments.map) + arguments.hintArguments;
  const std::string report = withCommands(tiled::toText(map->report, command), arguments.map);
  const std::string summary = summaryOf(report);
  std::FILE* const out = arguments.trace == "-" || isEmpty ? stderr : stdout;
  fmt::print(out, "{}", arguments.report.empty() ? report : summary);
  if (!arguments.report.empty()) status = worst(status, write(arguments.report, report));
  if (isEmpty) return complain("(--allow-empty accepts an empty map)");
  if (arguments.strict && !map->report.partial.empty() && status == Status::fine) status = Status::inPart;
  if (arguments.svg.empty()) return status;
  const auto picture = pictureOf(arguments, *map);
  return worst(status, picture ? write(arguments.svg, *picture) : complain(picture.error()));
}

}  // namespace

void addImport(CLI::App& app, Action& chosen) {
  const auto arguments = std::make_shared<ImportArguments>();
  CLI::App& command = *app.add_subcommand("import", "Turn the collision shapes of a Tiled or LDtk map into a trace");
  command
      .add_option("MAP", arguments->map,
                  "A Tiled map (.tmx, .tmj, .json) or world (.world), or an LDtk\nproject (.ldtk). The files that it "
                  "names are found by their paths")
      ->option_text("(required)");
  command
      .add_option(
          "--survey", arguments->survey,
          "Instead of one map: try all in these folders and below them, and\nprint a table of what comes out of each")
      ->option_text("FOLDER...");
  command.add_option("-o,--output", arguments->trace, "Where the trace goes; default stdout")->option_text("TRACE");
  command
      .add_option("--report", arguments->report,
                  "Where the report goes: what was snapped, carried or\n"
                  "left out; default stdout, or stderr if the trace is on stdout")
      ->option_text("FILE");
  command
      .add_option(
          "--svg", arguments->svg,
          "Draw the imported world to this file; and beside it what the\nmap may mean instead, where that differs")
      ->option_text("FILE");
  command.add_flag("--strict", arguments->strict,
                   "The exit status is 3 if something that says that it is solid was\n"
                   "not taken, or if what a map or you name is not there");
  command.add_flag("--allow-empty", arguments->allowEmpty,
                   "Accept a map from which nothing comes out; otherwise there is\nno trace, and the exit status is 2");
  addImportOptions(command, arguments->options);
  command.footer(
      "Without --solid, --solid-if, --objects, --no-objects and --tiles the map decides what is solid, by the "
      "strongest evidence in it: the report says what was taken and why, and what was not (docs/maps.md).\n\n"
      "The tile in column c and row r of the map becomes cell (c, -1 - r): y is up, and the map's top edge is y = "
      "0.\n\n"
      "Example: lgs import level.tmx -o level.trace --block class --number water=7 --svg level.svg");
  command.callback([arguments, &command, &chosen] {
    if (arguments->map.empty() && arguments->survey.empty()) throw CLI::RequiredError("MAP");
    arguments->hintArguments = importArguments(command, kNotInHints);
    chosen = [arguments] { return run(*arguments); };
  });
}

}  // namespace lgs::cli
