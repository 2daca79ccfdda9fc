#include "bench/published/departures.h"

#include "cli/command.h"
#include "cli/progress.h"
#include "oracle/check/shrink.h"
#include "oracle/reference/words.h"
#include "oracle/draw/draw.h"
#include "oracle/generate/generator.h"
#include "oracle/reference/compare.h"
#include "oracle/trace/file.h"
#include "oracle/trace/model.h"

#include <fmt/format.h>
#include <filesystem>

namespace lgs::oracle {
namespace {

struct PublishedArguments {
  std::string trace;
  std::string svg;
  std::string find;
  std::uint64_t seed = 1;
};

/// What the published algorithm puts out, beside the laws, or beside what it puts out for the same polygons without
/// their past: that is where a stale ghost shows.
enum class Beside : bool { laws, freshStart };

std::string drawing(const PublishedRun& run, Beside beside, std::string title) {
  MismatchOptions options;
  options.title = std::move(title);
  const bool laws = beside == Beside::laws;
  options.expectedName = laws ? "the laws" : "published, afresh";
  options.actualName = laws ? "the published algorithm" : "after the edits";
  return drawMismatch(run.scene, laws ? run.expected : run.afresh, run.published, options);
}

Status compareTrace(const PublishedArguments& arguments) {
  if (const Status bad = tryOutputs({arguments.svg}); bad != Status::fine) return bad;
  const auto trace = readTrace(arguments.trace);
  if (!trace) return complain(message(trace.error(), arguments.trace));
  const auto run = runPublished(*trace);
  if (!run) return complain(message(run.error(), arguments.trace));
  std::FILE* const out = arguments.svg == "-" ? stderr : stdout;
  const auto differences = compare(run->expected, run->published);
  fmt::print(out, "{}: {}\n", arguments.trace,
             differences.empty() ? "the published algorithm agrees with the laws" : "the published algorithm departs:");
  for (const Departure departure : kDepartures)
    if (shows(*run, departure)) fmt::print(out, "{}: {}\n", nameOf(departure), describe(departure));
  fmt::print(out, "{}", describe(differences));
  if (const auto past = compare(run->afresh, run->published); !past.empty())
    fmt::print(out, "from what it puts out for the same polygons without their past:\n{}", describe(past));
  Status status = differences.empty() ? Status::fine : Status::mismatch;
  if (!arguments.svg.empty())
    status = worst(status, write(arguments.svg, drawing(*run, Beside::laws, arguments.trace)));
  return status;
}

constexpr std::uint64_t kCases = 20'000;

// The first random case that departs in this way, made as small as it gets.
std::optional<Trace> find(Departure departure, std::uint64_t seed) {
  Progress progress;
  const auto departs = [&](const Trace& t) {
    const auto run = runPublished(t);
    return run && shows(*run, departure);
  };
  for (std::uint64_t number = 0; number < kCases; ++number) {
    if (progress.isDue()) progress.show(fmt::format("{}: case {} of {}", nameOf(departure), number, kCases));
    const Trace trace = withoutRefused(randomCase({3, 3, 24}, seed * kCases + number));
    if (departs(trace)) return shrink(trace, departs, std::chrono::seconds(10));
  }
  return std::nullopt;
}

Status findAll(const PublishedArguments& arguments) {
  std::error_code ignored;  // the first file will say what is wrong
  std::filesystem::create_directories(arguments.find, ignored);
  Status status = Status::fine;
  for (const Departure departure : kDepartures) {
    const std::string file = (std::filesystem::path(arguments.find) / nameOf(departure)).string();
    auto trace = find(departure, arguments.seed);
    if (trace) {
      std::string text = printTrace(*trace);
      text.insert(text.find('\n') + 1, fmt::format("# {}\n", describe(departure)));
      status = worst(status, write(file + ".trace", text));
      fmt::print("{:15} {}\n", nameOf(departure), counted(editCount(*trace), "edit"));
    } else {
      const auto kept = readTrace(file + ".trace");
      fmt::print("{:15} in none of {} random cases; {}\n", nameOf(departure), kCases,
                 kept ? "the trace in the folder is drawn" : "no trace in the folder to draw");
      if (kept) trace = *kept;
    }
    if (!trace) continue;
    const auto run = runPublished(*trace);
    if (!run) return complain(message(run.error(), file + ".trace"));
    const Beside beside = departure == Departure::staleGhosts ? Beside::freshStart : Beside::laws;
    status = worst(status, write(file + ".svg", drawing(*run, beside, describe(departure))));
  }
  return status;
}

}  // namespace

void addPublished(CLI::App& app, Run& chosen) {
  const auto arguments = std::make_shared<PublishedArguments>();
  CLI::App& command = *app.add_subcommand("published", "See where the published algorithm departs from the laws");
  auto* const trace = command.add_option("TRACE", arguments->trace, "Compare at the end of this trace");
  command.add_option("--svg", arguments->svg, "Draw both, and what differs; - is stdout")
      ->option_text("FILE")
      ->needs(trace);
  auto* const find =
      command
          .add_option("--find", arguments->find,
                      "Search random cases for each known departure; write the smallest\ntrace of each, "
                      "and its picture, to a folder; one that is not\nfound is drawn from the trace there")
          ->option_text("FOLDER")
          ->excludes(trace);
  addWholeNumber(
      command, "--seed", [arguments](std::uint64_t seed) { arguments->seed = seed; }, {}, "Of the search")
      ->needs(find);
  command.footer(
      "What it is, and each departure with its picture: docs/departures.md.\n\n"
      "Example: lgs published docs/departures/uncut-single.trace --svg departure.svg");
  command.callback([arguments, &chosen] {
    if (arguments->trace.empty() && arguments->find.empty()) throw CLI::RequiredError("TRACE or --find");
    chosen = [arguments] { return arguments->find.empty() ? compareTrace(*arguments) : findAll(*arguments); };
  });
}

}  // namespace lgs::oracle
