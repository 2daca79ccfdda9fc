#include "bench/published/departures.h"
#include "cli/command.h"
#include "cli/progress.h"
#include "oracle/check/failure.h"
#include "oracle/check/shrink.h"
#include "oracle/draw/draw.h"
#include "oracle/generate/generator.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/words.h"
#include "oracle/trace/file.h"
#include "oracle/trace/model.h"

#include <fmt/format.h>
#include <filesystem>

namespace lgs::cli {

using namespace oracle;
using bench::Departure;
using bench::PublishedRun;

namespace {

struct PublishedArguments {
  std::string trace;
  std::string svg;
  std::string find;
  std::uint64_t seed = 1;
};

/// What the algorithm's output is drawn beside: the output of the laws, or its own output for the same polygons without
/// their past. The second shows stale ghosts.
enum class Beside : bool { laws, freshStart };

std::string drawRun(const PublishedRun& run, Beside beside, std::string title) {
  MismatchOptions options;
  options.title = std::move(title);
  const bool laws = beside == Beside::laws;
  options.expectedName = laws ? "the laws" : "published, afresh";
  options.actualName = laws ? "the published algorithm" : "after the edits";
  return drawMismatch(run.scene, laws ? run.expected : run.afresh, run.published, options);
}

Status compareTrace(const PublishedArguments& arguments) {
  if (const Status bad = tryOutputs({arguments.svg}); bad != Status::fine) return bad;
  const auto trace = readWorld(arguments.trace);
  if (!trace) return complain(trace.error());
  const auto run = bench::runPublished(*trace);
  if (!run) return complain(message(run.error(), arguments.trace));
  std::FILE* const out = arguments.svg == "-" ? stderr : stdout;
  const auto differences = compare(run->expected, run->published);
  fmt::print(out, "{}: {}\n", arguments.trace,
             differences.empty() ? "the published algorithm agrees with the laws" : "the published algorithm departs:");
  for (const Departure departure : bench::kDepartures)
    if (shows(*run, departure)) fmt::print(out, "{}: {}\n", nameOf(departure), describe(departure));
  fmt::print(out, "{}", describe(differences));
  if (const auto past = compare(run->afresh, run->published); !past.empty())
    fmt::print(out, "from what it puts out for the same polygons without their past:\n{}", describe(past));
  Status status = differences.empty() ? Status::fine : Status::mismatch;
  if (!arguments.svg.empty())
    status = worst(status, write(arguments.svg, drawRun(*run, Beside::laws, arguments.trace)));
  return status;
}

constexpr std::uint64_t kCases = 20'000;

// The first random case that departs in this way, made as small as possible.
std::optional<Trace> find(Departure departure, std::uint64_t seed) {
  Progress progress;
  const auto departs = [&](const Trace& t) {
    const auto run = bench::runPublished(t);
    return run && shows(*run, departure);
  };
  for (std::uint64_t number = 0; number < kCases; ++number) {
    if (progress.isDue()) progress.show(fmt::format("{}: case {} of {}", nameOf(departure), number, kCases));
    const Trace trace = withoutRefused(randomCase({3, 3, 24}, seed * kCases + number));
    if (departs(trace)) return shrink(trace, departs, std::chrono::seconds(10));
  }
  return std::nullopt;
}

// Finds a trace of one departure, saves and draws it. If none is found, the trace in the folder is drawn.
Status findOne(Departure departure, const PublishedArguments& arguments) {
  const std::string file = (std::filesystem::path(arguments.find) / nameOf(departure)).string();
  Status status = Status::fine;
  auto trace = find(departure, arguments.seed);
  if (trace) {
    status = write(file + ".trace", printTrace(*trace, describe(departure)));
    fmt::print("{:15} {}\n", nameOf(departure), counted(editCount(*trace), "edit"));
  } else {
    const auto kept = readTrace(file + ".trace");
    fmt::print("{:15} in none of {} random cases; {}\n", nameOf(departure), kCases,
               kept ? "the trace in the folder is drawn" : "no trace in the folder to draw");
    if (!kept) return status;
    trace = *kept;
  }
  const auto run = bench::runPublished(*trace);
  if (!run) return complain(message(run.error(), file + ".trace"));
  const Beside beside = departure == Departure::staleGhosts ? Beside::freshStart : Beside::laws;
  return worst(status, write(file + ".svg", drawRun(*run, beside, describe(departure))));
}

Status findAll(const PublishedArguments& arguments) {
  std::error_code ignored;  // writing the first file will say what is wrong
  std::filesystem::create_directories(arguments.find, ignored);
  Status status = Status::fine;
  for (const Departure departure : bench::kDepartures) status = worst(status, findOne(departure, arguments));
  return status;
}

}  // namespace

void addPublished(CLI::App& app, Action& chosen) {
  const auto arguments = std::make_shared<PublishedArguments>();
  CLI::App& command = *app.add_subcommand("published", "Show where the published algorithm departs from the laws");
  auto* const trace = command.add_option("TRACE", arguments->trace, "Compare at the end of this trace")
                          ->option_text("(this or --find)");
  command.add_option("--svg", arguments->svg, "Draw both outlines, and what differs; - is stdout")
      ->option_text("FILE")
      ->needs(trace);
  auto* const find = command
                         .add_option("--find", arguments->find,
                                     "Search random cases for each known departure, and write the\n"
                                     "smallest trace of each, with its picture, to this folder. Where\n"
                                     "no case departs, the trace that is in the folder is drawn")
                         ->option_text("FOLDER")
                         ->excludes(trace);
  addWholeNumber(
      command, "--seed", [arguments](std::uint64_t seed) { arguments->seed = seed; }, {},
      "The seed of the search; default 1")
      ->option_text("S")
      ->needs(find);
  command.footer(
      "The published algorithm is the one that this project's engine comes from. docs/departures.md says more of it,\n"
      "and shows each departure with a picture.\n\n"
      "Example: lgs published docs/departures/uncut-single.trace --svg departure.svg");
  command.callback([arguments, &chosen] {
    if (arguments->trace.empty() && arguments->find.empty()) throw CLI::RequiredError("TRACE or --find");
    chosen = [arguments] { return arguments->find.empty() ? compareTrace(*arguments) : findAll(*arguments); };
  });
}

}  // namespace lgs::cli
