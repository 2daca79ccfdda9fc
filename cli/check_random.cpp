#include "cli/check_run.h"
#include "cli/check_survey.h"
#include "cli/progress.h"
#include "oracle/calls/random.h"
#include "oracle/check/isolated.h"
#include "oracle/check/shell.h"
#include "oracle/check/survey.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>

namespace lgs::cli {

using namespace oracle;

namespace {

// Each case has a seed of its own, so that any one can be run again by itself.
std::uint64_t caseSeed(std::uint64_t seed, std::size_t number) { return Random(Random(seed).next() + number).next(); }

// One case of many. The last one may have fewer edits than the others.
struct Case {
  std::size_t number = 0;
  std::size_t edits = 0;
};

// To measure strokes and to recompute views takes longer than all else. So a quarter of the cases of this library's
// engine has strokes and another has views, unless all are asked to. In half of these chunks come and go.
GeneratorOptions worldOf(const CheckArguments& arguments, const Case& at) {
  GeneratorOptions world = arguments.world;
  world.edits = at.edits;
  world.brushes |= world.isOfCalls && at.number % 4 == 1;
  world.streams = world.isOfCalls && !arguments.engine.isGiven() && at.number % 8 == 2;
  return world;
}

Checked caseOf(const CheckArguments& arguments, const Case& at) {
  const GeneratorOptions world = worldOf(arguments, at);
  const bool isOfOthers = arguments.engine.isGiven();
  const bool areFollowed = arguments.options.views || (world.isOfCalls && !isOfOthers && at.number % 4 == 2);
  Trace trace = caseOf(at.number, world, caseSeed(arguments.seed, at.number));
  return {isOfOthers && world.isOfCalls ? inPlainEdits(trace) : std::move(trace),
          fmt::format("mismatch-{}-{}", arguments.seed, at.number),
          fmt::format("{} --cells {}x{} --case-edits {} --seed {} --case {} --oracle {}",
                      commandAgain(arguments, world.brushes, areFollowed), world.width, world.height, world.edits,
                      arguments.seed, at.number, arguments.oracleName()),
          areFollowed};
}

void show(Progress& progress, const CheckArguments& arguments, const Totals& totals, bool isWrong) {
  if (!progress.isDue()) return;
  progress.show(fmt::format("{} edits of{}, {} cases, {:.0f} edits/s, {}", totals.stats.edits, lengthOf(arguments),
                            totals.cases.cases, static_cast<double>(totals.stats.edits) / totals.seconds(),
                            isWrong ? "mismatches" : "no mismatch"));
}

Status playCases(const CheckArguments& arguments, CheckOptions options, Case& at) {
  Totals totals;
  Scene last;
  Progress progress;
  std::optional<SurveyRun> survey;
  if (arguments.survey.isGiven) {
    survey.emplace(arguments, options);
    if (const Status bad = survey->begin(options, totals.stats); bad != Status::fine) return bad;
  }
  const std::uint64_t before = totals.stats.edits;
  std::uint64_t lost = 0;  // edits that were not made, because the engine gave no answer to some before them
  const auto left = [&]() -> std::uint64_t {  // to the end of a case, however little time is left
    constexpr auto kMany = std::numeric_limits<std::uint64_t>::max();
    return arguments.seconds ? kMany : arguments.edits - std::min(arguments.edits, totals.stats.edits - before + lost);
  };
  const auto isOver = [&] { return arguments.seconds ? totals.seconds() >= *arguments.seconds : left() == 0; };
  for (at.number = arguments.onlyCase.value_or(0);; ++at.number) {
    at.edits = arguments.world.edits;
    if (!arguments.onlyCase) at.edits = std::min<std::size_t>(editsOf(at.number, worldOf(arguments, at)), left());
    stillAlive();
    const Checked checked = caseOf(arguments, at);
    if (arguments.world.brushes && arguments.engine.isGiven())
      if (const std::string why = whyNot(checked.trace, arguments.world.can); !why.empty())
        return complain("lgs check: with --brushes there is what the engine can not have: " + why);
    options.views = checked.areFollowed;
    Features features{};
    std::size_t commits = 0;
    options.afterCommit = [&](const Model& standing) {
      constexpr std::size_t kSample = 8;  // looking for features after each commit would take as long as the check
      if (commits++ % kSample == 0) note(standing.scene(checked.trace.preserve), features);
      if (!arguments.svg.empty() && !arguments.world.can.regions) last = standing.scene(checked.trace.preserve);
      stillAlive();
      return true;
    };
    const std::uint64_t edits = totals.stats.edits, refused = totals.stats.refused;
    const auto mismatch = checkTrace(checked.trace, options, totals.stats);
    if (!mismatch) return complain(message(mismatch.error(), fmt::format("case {}", at.number)));
    if (survey) survey->add(*mismatch, checked.trace, totals.stats);
    if (*mismatch && survey) {
      lost += (*mismatch)->isNoAnswer() ? at.edits - (totals.stats.edits - edits) : 0;
    } else if (*mismatch) {
      progress.wipe();
      reportMismatch(**mismatch, checked.trace, options, reportOptions(arguments, checked));
      return Status::mismatch;
    }
    if (!arguments.svg.empty() && arguments.world.can.regions) last = sceneOf(checked.trace);
    features[static_cast<std::size_t>(Feature::refusal)] = totals.stats.refused != refused;
    totals.cases.add(features);
    show(progress, arguments, totals, survey && survey->hasFound());
    if (arguments.onlyCase || isOver()) break;
  }
  progress.wipe();
  return survey ? survey->finish(totals, last) : finish(arguments, totals, last);
}

}  // namespace

Status checkRandom(const CheckArguments& arguments) {
  const CheckOptions options = caseOptions(arguments);
  const Shared<Case> at;
  return isolated(
      arguments, options, [&] { return playCases(arguments, options, *at); }, [&] { return caseOf(arguments, *at); });
}

}  // namespace lgs::cli
