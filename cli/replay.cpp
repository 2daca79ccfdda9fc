#include "cli/command.h"
#include "oracle/check/report.h"
#include "oracle/reference/words.h"
#include "oracle/draw/draw.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/file.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <cstdio>

namespace lgs::oracle {
namespace {

struct ReplayArguments {
  std::string trace;
  bool check = false;
  CheckOptions checkOptions;
  std::string dump;
  std::string svg;
};

Status run(const ReplayArguments& arguments) {
  if (const Status bad = tryOutputs({arguments.dump, arguments.svg}); bad != Status::fine) return bad;
  const auto trace = readTrace(arguments.trace);
  if (!trace) return complain(message(trace.error(), arguments.trace));
  // The summary makes way for a dump or a picture on the standard output.
  std::FILE* const out = arguments.dump == "-" || arguments.svg == "-" ? stderr : stdout;

  std::optional<Mismatch> mismatch;
  if (arguments.check) {
    CheckStats stats;
    auto result = checkTrace(*trace, arguments.checkOptions, stats);
    if (!result) return complain(message(result.error(), arguments.trace));
    mismatch = std::move(*result);
    if (mismatch) {
      fmt::print(out, "MISMATCH {}: {}", arguments.trace, describe(*mismatch, *trace));
    } else {
      fmt::print(out, "checked {}, {} with CGAL, {} with the naive reference: no mismatch\n",
                 counted(stats.commits, "commit"), counted(stats.cgal, "time"), stats.naive);
    }
  }
  Status status = mismatch ? Status::mismatch : Status::fine;
  const bool drawsMismatch = mismatch && !arguments.svg.empty();
  if (drawsMismatch) status = worst(status, write(arguments.svg, draw(*mismatch)));
  if (mismatch && arguments.dump.empty()) return status;

  Player player(trace->preserve);
  if (const auto done = play(*trace, player); !done) return complain(message(done.error(), arguments.trace));
  const Outline outline = outlineOf(player.world());
  fmt::print(out, "{}: {} in {}, {}, {}\n", counted(editCount(*trace), "edit"),
             counted(player.world().stats().polygons, "polygon"), counted(player.world().stats().cells, "cell"),
             counted(outline.size(), "segment"), counted(player.world().loops().size(), "loop"));
  if (!arguments.dump.empty()) status = worst(status, write(arguments.dump, dump(outline)));
  if (!arguments.svg.empty() && !drawsMismatch) {
    DrawOptions options;
    options.title = arguments.trace;
    status = worst(status, write(arguments.svg, drawWorld(player.scene(), outline, options)));
  }
  return status;
}

}  // namespace

void addReplay(CLI::App& app, Run& chosen) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App& command = *app.add_subcommand("replay", "Play a trace; dump, draw or check what comes out");
  command.add_option("TRACE", arguments->trace, "A file in the trace format")->required();
  CLI::Option* const check =
      command.add_flag("--check", arguments->check,
                       "Compare with the oracle after every commit; on a mismatch say\nwhat differs, and where");
  addOracleOption(command, arguments->checkOptions)->needs(check);
  command.add_option("--dump", arguments->dump, "Write the segments after the last commit; - is stdout")
      ->option_text("FILE");
  command.add_option("--svg", arguments->svg, "Draw the world, or the mismatch; - is stdout")->option_text("FILE");
  command.footer(
      "A trace is a list of edits:\n"
      "  lgs-trace 1\n"
      "  add floor 0 0 7  0 0  1 0  1 0.5  0 0.5    # name, cell i j, block, then x y in cells\n"
      "  add ramp  1 0 7  0 0  1 0  0 0.5\n"
      "  commit\n"
      "  remove floor\n"
      "The end of the file commits what is pending.\n\n"
      "A line of a dump: segment <start> <end> <ghost1> <ghost2> <block>, in lattice units of 1/65536 cell.\n\n"
      "Example: lgs replay world.trace --check --dump - --svg world.svg");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace lgs::oracle
