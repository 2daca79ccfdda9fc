#include "cli/check_run.h"
#include "cli/check_survey.h"
#include "oracle/check/isolated.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

namespace lgs::cli {

using namespace oracle;

namespace {

namespace fs = std::filesystem;

// The first folder of a path that does not exist; nothing if all do.
std::optional<fs::path> firstMissing(const fs::path& folder) {
  fs::path path;
  for (const fs::path& part : folder) {
    path /= part;
    if (!fs::exists(path)) return path;
  }
  return std::nullopt;
}

// A mismatch after hours must not be lost because its files can not be written. Folders are made for the trial only.
Status tryFiles(const CheckArguments& arguments) {
  const fs::path out = (fs::path(arguments.out) / "").parent_path();  // without a slash at the end
  const auto made = firstMissing(out);
  std::error_code ignored;  // the trial will say what is wrong
  fs::create_directories(out, ignored);
  const Status status = tryOutputs({(out / "mismatch.trace").string()});
  for (fs::path at = out; made && fs::remove(at, ignored) && at != *made;) at = at.parent_path();
  return status == Status::fine ? tryOutputs({arguments.svg}) : status;
}

// Reads "12x8".
void readSize(const std::string& text, oracle::GeneratorOptions& options) {
  constexpr std::int32_t kMost = 256;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = separated ? std::from_chars(width.ptr + 1, end, options.height) : width;
  const auto good = [](std::int32_t n) { return 1 <= n && n <= kMost; };
  if (!separated || height.ec != std::errc() || height.ptr != end || !good(options.width) || !good(options.height)) {
    throw CLI::ValidationError("--cells", fmt::format("'{}' is not WxH with sizes of 1 to {}", text, kMost));
  }
}

void addEditOptions(CLI::App& command, const std::shared_ptr<CheckArguments>& arguments) {
  CLI::Option* const edits = addWholeNumber(
                                 command, "--edits", [arguments](std::uint64_t n) { arguments->edits = n; },
                                 {1, 1'000'000'000}, "How many edits, in all cases together; default 20000")
                                 ->option_text("N");
  addReal(
      command, "--time", [arguments](double seconds) { arguments->seconds = seconds; }, {0, 1e6},
      "How long it runs, instead; the last case is made to its end")
      ->option_text("SECONDS")
      ->excludes(edits);
  addWholeNumber(
      command, "--seed", [arguments](std::uint64_t n) { arguments->seed = n; }, {},
      "The same seed gives the same edits everywhere; default 1")
      ->option_text("S");
  addOracleOption(command, arguments->options);
}

void addWorldOptions(CLI::App& command, const std::shared_ptr<CheckArguments>& arguments) {
  CLI::Option* const cells = command
                                 .add_option_function<std::string>(
                                     "--cells", [arguments](const std::string& t) { readSize(t, arguments->world); },
                                     "The size of the random worlds; default 4x4")
                                 ->option_text("WxH");
  CLI::Option* const caseEdits =
      addWholeNumber(
          command, "--case-edits", [arguments](std::uint64_t n) { arguments->world.edits = n; }, {1, 10'000'000},
          "How many edits a case has; the next case begins with an empty\nworld; default 100")
          ->option_text("N");
  CLI::Option* const onlyCase = addWholeNumber(
                                    command, "--case", [arguments](std::uint64_t n) { arguments->onlyCase = n; }, {},
                                    "Run only the case with this number")
                                    ->option_text("K");
  CLI::Option* const brushes = command.add_flag("--brushes", arguments->world.brushes,
                                                "Paint and carve in all cases, not in a quarter of them: each\n"
                                                "stroke is measured against CGAL's exact result. An engine of\n"
                                                "cells gets what they do as adds and removes");
  CLI::Option* const views = command.add_flag("--views", arguments->options.views,
                                              "Follow all cases, not a quarter of them, with views of loops,\n"
                                              "islands, pieces and hashes: these are compared with a full\n"
                                              "recompute after every commit");
  CLI::Option* const map =
      command
          .add_option("--map", arguments->map,
                      "Dig in this world instead of random ones: a trace, or a\nmap (.tmx, .tmj, .json, .world, .ldtk)")
          ->option_text("FILE")
          ->excludes(cells)
          ->excludes(onlyCase)
          ->excludes(brushes)
          ->excludes(views)
          ->excludes(caseEdits)
          ->excludes("--time");
  command
      .add_option(
          "--suite", arguments->suites,
          "Play suites of others instead of random worlds: texts of\nClipper2, JSON of iOverlay, GeoJSON, WKT, XML "
          "of GEOS and JTS;\nor folders of these. --case K plays one case of them")
      ->option_text("FILE...")
      ->excludes(cells)
      ->excludes(brushes)
      ->excludes(views)
      ->excludes(caseEdits)
      ->excludes(map)
      ->excludes("--time");
  addWholeNumber(
      command, "--whole-every", [arguments](std::uint64_t n) { arguments->options.wholeEvery = n; }, {},
      "With --map: compare the whole world after every K-th commit,\n"
      "and at the end; 0 is at the end only; default 100")
      ->needs(map)
      ->option_text("K");
}

void addOutputOptions(CLI::App& command, CheckArguments& arguments) {
  command.add_option("--out", arguments.out, "Folder for the trace, picture and page of a mismatch; default out")
      ->option_text("DIR");
  addReal(
      command, "--shrink", [&arguments](double seconds) { arguments.shrinkSeconds = seconds; }, {0, 86'400},
      "Seconds to spend on shrinking a mismatch; default 20")
      ->option_text("SECONDS");
  command
      .add_option("--site", arguments.site,
                  "Where a copy of the sandbox is served (web/README.md): print a link\n"
                  "that opens a mismatch's trace there, to step through and check")
      ->option_text("ADDRESS");
  command.add_option("--svg", arguments.svg, "Draw the last world to this file, if there is no mismatch")
      ->option_text("FILE");
}

Status check(const CheckArguments& arguments) {
  if (!arguments.suites.empty()) return checkSuites(arguments);
  return arguments.map.empty() ? checkRandom(arguments) : checkMap(arguments);
}

Status checkWith(CheckArguments arguments, Engine& engine) {
  introduce(engine, stdout);
  if (engine.can().regions && !engine.can().ghosts && !arguments.options.cgal)
    return complain(
        "lgs check: of an engine of regions the naive reference compares ghosts alone, and this one declares none");
  arguments.options.engine = &engine;
  arguments.world.can = engine.can();
  arguments.world.crowds = false;
  arguments.world.isOfCalls = arguments.world.brushes && !engine.can().regions;  // and it gets what they do
  return check(arguments);
}

// The engine answers in a process of its own.
Status checkApart(const CheckArguments& arguments) {
  const auto engine = startEngine(arguments.engine);
  if (!engine) return Status::badInput;
  return finishEngine(*engine, checkWith(arguments, *engine), stdout);
}

// A shared object is called in the process that compares, which is quickest. If it crashes or hangs there, or if that
// is slow, all is done once more with the engine in a process of its own: what it did can be told and shrunk there.
Status checkQuickly(const CheckArguments& arguments) {
  const Shared<Status> status;
  const auto patience = static_cast<unsigned>(std::ceil(std::max(1.0, arguments.engine.patience())));
  const auto how = crashOf([&] { *status = flushed(checkWith(arguments, *arguments.engine.loaded)); },
                           {.seconds = patience, .asleep = patience + 1});
  if (!how) return *status;
  fmt::print("\nthe engine {}: once more, with the engine in a process of its own\n", *how);
  const Status apart = checkApart(arguments);
  if (apart != Status::fine || how->starts_with("hung")) return apart;
  return tell({Failure::Kind::crash, *how + ", but not in a process of its own"}, stdout);
}

Status run(const CheckArguments& arguments) {
  if (const Status bad = tryFiles(arguments); bad != Status::fine) return bad;
  if (const Status bad = trySurveyFiles(arguments.survey); bad != Status::fine) return bad;
  if (!arguments.engine.isGiven()) return check(arguments);
  return arguments.engine.loaded && !arguments.survey.isGiven ? checkQuickly(arguments) : checkApart(arguments);
}

constexpr const char* kCheckHelp =
    "WHAT IS CHECKED. Every edit must be accepted or refused as the rules say, and a refused edit must\n"
    "change nothing. After every commit\n"
    "  - segments, ghosts and blocks must be those of the naive reference and of CGAL's union;\n"
    "  - the loops must be the same in canonical form, and the links consistent;\n"
    "  - the change list, applied to a copy of the old output, must give the new one.\n"
    "At the end of a case, a fresh world with the same polygons, added in another order, must have the same\n"
    "outline. Of this library's engine all calls are tried, also those that undo, redo, save, load and unload;\n"
    "and a world in which nothing was undone or refused must be the same to the last id.\n\n"
    "CGAL can not judge everything. It needs a preserve relation that partitions the blocks, and then it does\n"
    "not know the links at vertices where the parts meet. The naive reference judges everything.\n\n"
    "Random worlds are compared as a whole after every commit. In a map (--map) a commit is compared near its\n"
    "edits: the references get the polygons within two cells of them, and every segment within one cell must\n"
    "be as theirs. By the laws no polygon further away matters there. The change list is always compared\n"
    "for the whole world, so a segment that changes further away is noticed too.\n\n"
    "A mismatch is shrunk to a minimal trace, printed, saved and drawn (a picture, and a page that steps\n"
    "through it in a browser), with the command that finds it again; the exit status is 1. The same is\n"
    "done if the engine crashes, or hangs for a minute.\n\n";

constexpr const char* kCheckExamples =
    "\n\nExamples: lgs check --cells 5x5 --edits 200000 --seed 7\n"
    "          lgs check --map level.tmx --edits 5000 --svg dug.svg\n"
    "          lgs check --engine 'python3 my_engine.py' --edits 2000";

}  // namespace

void addCheck(CLI::App& app, Action& chosen) {
  const auto arguments = std::make_shared<CheckArguments>();
  arguments->options.wholeEvery = 100;
  CLI::App& command =
      *app.add_subcommand("check", "Make random edits, in random worlds or in a map, and compare with the references");
  addEditOptions(command, arguments);
  addWorldOptions(command, arguments);
  addOutputOptions(command, *arguments);
  addEngineOptions(command, arguments->engine);
  addSurveyOptions(command, arguments);
  command.footer(std::string(kCheckHelp) + kEngineHelp + kCheckExamples);
  command.callback([arguments, &chosen] {
    arguments->engine.prepare();
    if (arguments->survey.isGiven && arguments->survey.report.empty()) arguments->survey.report = arguments->out;
    if (arguments->options.views && arguments->engine.isGiven())
      throw CLI::ExcludesError("--views", "--engine and --engine-so");
    if (arguments->survey.isGiven && !arguments->engine.isGiven()) throw CLI::RequiredError("--engine or --engine-so");
    chosen = [arguments] { return run(*arguments); };
  });
}

}  // namespace lgs::cli
