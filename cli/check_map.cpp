#include "cli/check_run.h"
#include "cli/progress.h"
#include "oracle/check/isolated.h"
#include "oracle/check/shell.h"
#include "oracle/reference/words.h"
#include "oracle/trace/model.h"
#include "oracle/trace/plain_edits.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <cstdio>

namespace lgs::cli {

using namespace oracle;

namespace {

Status dig(const CheckArguments& arguments, const Trace& start, const Checked& digging) {
  Player player(start.preserve);
  const auto done = play(start, player);
  const bool isBad = withoutRefused(start).calls.size() != start.calls.size();  // if not, the check finds what is wrong
  if (!done && isBad) return complain(message(done.error(), arguments.map));
  fmt::print("{}: built by {}, {} in {}; then dug and refilled by {}\n", arguments.map,
             counted(editCount(start), "edit"), counted(player.world().stats().polygons, "polygon"),
             counted(player.world().stats().cells, "cell"), counted(arguments.edits, "edit"));
  std::fflush(stdout);

  CheckOptions options = arguments.options;
  Totals totals;
  totals.built = editCount(start);
  Scene last;
  Progress progress;
  options.afterCommit = [&](const Model& standing) {
    stillAlive();
    if (totals.stats.edits <= totals.built) {
      totals.begin = std::chrono::steady_clock::now();  // only digging is timed
      return true;
    }
    if (progress.isDue()) {
      progress.show(fmt::format("{} of {}, {}, no mismatch", totals.stats.edits - totals.built,
                                counted(arguments.edits, "edit"), counted(totals.stats.commits, "commit")));
    }
    if (!arguments.svg.empty()) last = standing.scene(digging.trace.preserve);
    return true;
  };
  const auto mismatch = checkTrace(digging.trace, options, totals.stats);
  progress.wipe();
  if (!mismatch) return complain(message(mismatch.error(), arguments.map));
  if (*mismatch) {
    reportMismatch(**mismatch, digging.trace, options, reportOptions(arguments, digging));
    return Status::mismatch;
  }
  return finish(arguments, totals, last);
}

}  // namespace

Status checkMap(const CheckArguments& arguments) {
  const auto read = readWorld(arguments.map);
  if (!read) return complain(read.error());
  const Trace start = inPlainEdits(*read);
  const Capabilities& can = arguments.world.can;
  if (const std::string why = whyNot(withoutRefused(start), can); !why.empty())
    return complain(fmt::format("{}: the engine can not have it: {}", arguments.map, why));
  Checked digging{digIn(start, arguments.edits, arguments.seed, can, !arguments.engine.isGiven()),
                  fmt::format("mismatch-map-{}", arguments.seed),
                  fmt::format("{} --map {} --edits {} --seed {} --oracle {} --whole-every {}", commandAgain(arguments),
                              shellPath(arguments.map), arguments.edits, arguments.seed, arguments.oracleName(),
                              arguments.options.wholeEvery)};
  return isolated(
      arguments, arguments.options, [&] { return dig(arguments, start, digging); }, [&] { return digging; });
}

}  // namespace lgs::cli
