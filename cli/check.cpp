#include "cli/command.h"
#include "cli/progress.h"
#include "oracle/check/isolated.h"
#include "oracle/check/report.h"
#include "oracle/draw/counted.h"
#include "oracle/draw/draw.h"
#include "oracle/generate/features.h"
#include "oracle/generate/generator.h"
#include "oracle/generate/random.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <charconv>
#include <chrono>
#include <filesystem>

namespace lgs::oracle {
namespace {

using Clock = std::chrono::steady_clock;

struct CheckArguments {
  GeneratorOptions world{4, 4, 100};
  std::size_t edits = 20'000;
  std::uint64_t seed = 1;
  std::optional<std::size_t> onlyCase;
  std::string map;
  std::string out = "out";
  std::string svg;
  double shrinkSeconds = 20;
  CheckOptions options;

  std::string oracle() const { return options.naive && options.cgal ? "both" : options.naive ? "naive" : "cgal"; }
};

struct Totals {
  CheckStats stats;
  std::size_t built = 0;  // of the edits: those that make up a map
  Distribution cases;
};

void printSummary(const CheckArguments& arguments, const Totals& totals, double seconds) {
  const CheckStats& s = totals.stats;
  fmt::print("no mismatch\n");
  const std::uint64_t edits = s.edits - totals.built;
  if (totals.built > 0) fmt::print("built by   {}\n", counted(totals.built, "edit"));
  fmt::print("edits      {}, {} of them refused as they must be\n", edits, s.refused);
  fmt::print("commits    {}\n", s.commits);
  fmt::print("compared   {} times with CGAL, {} with the naive reference; {} times the whole world\n", s.cgal, s.naive,
             s.whole);
  fmt::print("segments   {} compared\n", s.segments);
  fmt::print("doors      {}\n", doorsInWords(s));
  fmt::print("time       {:.1f} s, {:.0f} edits/s\n", seconds, static_cast<double>(edits) / seconds);
  if (!arguments.map.empty()) return;
  fmt::print("cases      {}; of these had\n{}", totals.cases.cases, table(totals.cases));
}

Status drawEnd(const CheckArguments& arguments, const Scene& scene) {
  if (arguments.svg.empty()) return Status::fine;
  // Built anew: history does not matter.
  Player player(scene.preserve);
  for (const ScenePolygon& polygon : scene.polygons) {
    const std::string name = fmt::format("{}", player.scene().polygons.size());
    if (const auto done = player.apply(Edit::add(name, polygon)); !done) return complain(done.error().text);
  }
  player.commit();
  DrawOptions options;
  options.title = arguments.map.empty()
                      ? fmt::format("lgs check, seed {}", arguments.seed)
                      : fmt::format("{}, dug and refilled by {}", arguments.map, counted(arguments.edits, "edit"));
  const Status written = write(arguments.svg, drawWorld(scene, outlineOf(player.world()), options));
  if (written == Status::fine && arguments.svg != "-") fmt::print("picture    {}\n", arguments.svg);
  return written;
}

ReportOptions reportOptions(const CheckArguments& arguments, std::string name, std::string reproduce) {
  return {arguments.out, std::move(name), std::move(reproduce),
          std::chrono::milliseconds(static_cast<std::int64_t>(arguments.shrinkSeconds * 1'000)), thisProgram("lgs")};
}

// Runs a check in a process of its own. If the engine brings that down, reports the trace that it was playing.
struct Failure {
  Trace trace;
  std::string name;       // of its files
  std::string reproduce;  // the command that finds it again
};
Status isolated(const CheckArguments& arguments, const CheckOptions& options, const std::function<Status()>& check,
                const std::function<Failure()>& played) {
  const Shared<Status> status;
  const auto crash = crashOf([&] { *status = flushed(check()); });
  if (!crash) return *status;
  const Failure failure = played();
  reportCrash(*crash, failure.trace, options, reportOptions(arguments, failure.name, failure.reproduce));
  return Status::mismatch;
}

Status dig(const CheckArguments& arguments, const Trace& start, const Failure& digging) {
  Player player(start.preserve);
  if (const auto done = play(start, player); !done) return complain(message(done.error(), arguments.map));
  fmt::print("{}: built by {}, {} in {}; then dug and refilled by {}\n", arguments.map,
             counted(editCount(start), "edit"), counted(player.world().stats().polygons, "polygon"),
             counted(player.world().stats().cells, "cell"), counted(arguments.edits, "edit"));
  std::fflush(stdout);

  Clock::time_point begin = Clock::now();
  CheckOptions options = arguments.options;
  Totals totals;
  totals.built = editCount(start);
  Scene last;
  {
    Progress progress;
    options.afterCommit = [&](const Scene& scene) {
      stillAlive();
      if (totals.stats.edits <= totals.built) {
        begin = Clock::now();  // only digging is timed
        return true;
      }
      if (progress.isDue()) {
        progress.show(fmt::format("{} of {}, {}, no mismatch", totals.stats.edits - totals.built,
                                  counted(arguments.edits, "edit"), counted(totals.stats.commits, "commit")));
      }
      if (!arguments.svg.empty()) last = scene;
      return true;
    };
    const auto result = checkTrace(digging.trace, options, totals.stats);
    if (!result) return complain(message(result.error(), arguments.map));
    if (*result) {
      reportMismatch(**result, digging.trace, options, reportOptions(arguments, digging.name, digging.reproduce));
      return Status::mismatch;
    }
  }
  printSummary(arguments, totals, std::chrono::duration<double>(Clock::now() - begin).count());
  return drawEnd(arguments, last);
}

Status checkMap(const CheckArguments& arguments) {
  const auto start = readWorld(arguments.map);
  if (!start) return complain(start.error());
  const Failure digging{digIn(*start, arguments.edits, arguments.seed), fmt::format("mismatch-map-{}", arguments.seed),
                        fmt::format("{} check --map {} --edits {} --seed {} --oracle {} --whole-every {}",
                                    thisProgram("lgs"), shellPath(arguments.map), arguments.edits, arguments.seed,
                                    arguments.oracle(), arguments.options.wholeEvery)};
  return isolated(
      arguments, arguments.options, [&] { return dig(arguments, *start, digging); }, [&] { return digging; });
}

// A mismatch after hours must not be lost for want of a folder. Where there is none yet, it is made for the trial only.
Status tryFiles(const CheckArguments& arguments) {
  namespace fs = std::filesystem;
  const fs::path out = arguments.out;
  fs::path made;  // the first folder of the path that is not there
  for (const fs::path& part : out) {
    made /= part;
    if (!fs::exists(made)) break;
  }
  const bool isNew = !fs::exists(made);
  std::error_code ignored;  // the trial will say what is wrong
  fs::create_directories(out, ignored);
  const Status status = tryOutputs({(out / "mismatch.trace").string(), arguments.svg});
  for (fs::path at = out; isNew && fs::remove(at, ignored) && at != made;) at = at.parent_path();
  return status;
}

// Cases are independent of each other, so that any one can be run again by itself.
std::uint64_t caseSeed(std::uint64_t seed, std::size_t number) { return Random(Random(seed).next() + number).next(); }

// One case of many; cut short where it is the last one.
struct Case {
  std::size_t number = 0;
  std::size_t edits = 0;
};

Failure failureOf(const CheckArguments& arguments, const Case& at) {
  GeneratorOptions world = arguments.world;
  world.edits = at.edits;
  return {caseOf(at.number, world, caseSeed(arguments.seed, at.number)),
          fmt::format("mismatch-{}-{}", arguments.seed, at.number),
          fmt::format("{} check --cells {}x{} --case-edits {} --seed {} --case {} --oracle {}", thisProgram("lgs"),
                      world.width, world.height, world.edits, arguments.seed, at.number, arguments.oracle())};
}

Status playCases(const CheckArguments& arguments, CheckOptions options, Case& at) {
  const Clock::time_point begin = Clock::now();
  Totals totals;
  Scene last;
  Progress progress;
  for (at.number = arguments.onlyCase.value_or(0); totals.stats.edits < arguments.edits; ++at.number) {
    at.edits = arguments.world.edits;
    if (!arguments.onlyCase)
      at.edits = std::min<std::size_t>(editsOf(at.number, at.edits), arguments.edits - totals.stats.edits);
    stillAlive();
    const Failure played = failureOf(arguments, at);
    Features features{};
    std::size_t commits = 0;
    options.afterCommit = [&](const Scene& scene) {
      constexpr std::size_t kSample = 8;  // looking for features at each commit would cost as much as the check
      if (commits++ % kSample == 0) note(scene, features);
      if (!arguments.svg.empty()) last = scene;
      stillAlive();
      return true;
    };
    const std::uint64_t refused = totals.stats.refused;
    const auto result = checkTrace(played.trace, options, totals.stats);
    if (!result) return complain(message(result.error(), fmt::format("case {}", at.number)));
    if (*result) {
      reportMismatch(**result, played.trace, options, reportOptions(arguments, played.name, played.reproduce));
      return Status::mismatch;
    }
    features[static_cast<std::size_t>(Feature::refusal)] = totals.stats.refused != refused;
    totals.cases.add(features);
    if (progress.isDue()) {
      const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
      progress.show(fmt::format("{} of {} edits, {} cases, {:.0f} edits/s, no mismatch", totals.stats.edits,
                                arguments.edits, totals.cases.cases,
                                static_cast<double>(totals.stats.edits) / seconds));
    }
    if (arguments.onlyCase) break;
  }
  printSummary(arguments, totals, std::chrono::duration<double>(Clock::now() - begin).count());
  return drawEnd(arguments, last);
}

Status checkRandom(const CheckArguments& arguments) {
  CheckOptions options = arguments.options;
  options.skipRefused = true;
  options.wholeEvery = 1;
  const Shared<Case> at;
  return isolated(
      arguments, options, [&] { return playCases(arguments, options, *at); },
      [&] { return failureOf(arguments, *at); });
}

// "12x8"
void readSize(const std::string& text, GeneratorOptions& options) {
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

}  // namespace

void addCheck(CLI::App& app, Run& chosen) {
  const auto arguments = std::make_shared<CheckArguments>();
  arguments->options.wholeEvery = 100;
  CLI::App& command =
      *app.add_subcommand("check", "Random edit sequences against the oracle, in degenerate worlds or a map");
  CLI::Option* const cells =
      command
          .add_option_function<std::string>(
              "--cells", [arguments](const std::string& text) { readSize(text, arguments->world); },
              "Size of the random worlds; default 4x4")
          ->option_text("WxH");
  addWholeNumber(
      command, "--edits", [arguments](std::uint64_t n) { arguments->edits = n; }, {1, 1'000'000'000},
      "How many edits, over all cases; default 20000")
      ->option_text("N");
  addWholeNumber(
      command, "--seed", [arguments](std::uint64_t n) { arguments->seed = n; }, {},
      "The same seed gives the same edits everywhere; default 1")
      ->option_text("S");
  addOracleOption(command, arguments->options);
  CLI::Option* const onlyCase = addWholeNumber(
                                    command, "--case", [arguments](std::uint64_t n) { arguments->onlyCase = n; }, {},
                                    "Run only the case of this number, named by a mismatch")
                                    ->option_text("K");
  CLI::Option* const caseEdits =
      addWholeNumber(
          command, "--case-edits", [arguments](std::uint64_t n) { arguments->world.edits = n; }, {1, 10'000'000},
          "Edits of one case, then a new world begins; default 100")
          ->option_text("N");
  CLI::Option* const map = command
                               .add_option("--map", arguments->map,
                                           "Dig in this world instead of random ones: a trace, or a\nTiled map (.tmx)")
                               ->option_text("FILE")
                               ->excludes(cells)
                               ->excludes(onlyCase)
                               ->excludes(caseEdits);
  addWholeNumber(
      command, "--whole-every", [arguments](std::uint64_t n) { arguments->options.wholeEvery = n; }, {},
      "With --map: compare the whole world after every K-th commit\n"
      "and at the end; 0: at the end only. Default 100")
      ->needs(map)
      ->option_text("K");
  command.add_option("--out", arguments->out, "Folder for a mismatch's trace and picture; default out")
      ->option_text("DIR");
  command.add_option("--shrink", arguments->shrinkSeconds, "Seconds to spend on shrinking a mismatch; default 20")
      ->check(CLI::Range(0.0, 86'400.0))
      ->option_text("SECONDS");
  command.add_option("--svg", arguments->svg, "Draw the last world to this file, if there is no mismatch")
      ->option_text("FILE");
  command.footer(
      "WHAT IS CHECKED. Each edit is accepted or refused as the rules say, and a refused one changes\n"
      "nothing. After each commit segments, ghosts and blocks equal those of the naive reference and of\n"
      "CGAL's union, the canonical loops are equal, links are consistent, and the change list, applied to\n"
      "a copy of the old output, gives the new one. At the end of a case a fresh world with the same\n"
      "polygons, added in another order, has the same outline.\n\n"
      "Random worlds are compared as a whole after every commit. CGAL has no say where the preserve\n"
      "relation is no partition of the blocks, and under a partition none about links at vertices where\n"
      "materials meet. The naive reference always has.\n\n"
      "In a map (--map) the references are given the polygons within two cells of the commit's edits, and\n"
      "every segment within one cell of the edits must be the same as theirs, ghosts and block included:\n"
      "by the laws no polygon further away has a say in these. The change list is compared for the whole\n"
      "world at each commit, so a segment that changes further away is noticed too.\n\n"
      "A mismatch is shrunk to a minimal trace, printed, saved and drawn, with the line that finds it\n"
      "again; exit status 1. So is a trace at which the engine crashes, or hangs for a minute.\n\n"
      "Examples: lgs check --cells 5x5 --edits 200000 --seed 7\n"
      "          lgs check --map level.tmx --edits 5000 --svg dug.svg");
  command.callback([arguments, &chosen] {
    chosen = [arguments] {
      if (const Status bad = tryFiles(*arguments); bad != Status::fine) return bad;
      return arguments->map.empty() ? checkRandom(*arguments) : checkMap(*arguments);
    };
  });
}

}  // namespace lgs::oracle
