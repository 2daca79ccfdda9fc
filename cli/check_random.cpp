#include "cli/check_run.h"
#include "cli/progress.h"
#include "oracle/check/isolated.h"
#include "oracle/check/shell.h"
#include "oracle/check/survey.h"
#include "oracle/generate/random.h"

#include <fmt/format.h>
#include <algorithm>

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

Checked caseOf(const CheckArguments& arguments, const Case& at) {
  GeneratorOptions world = arguments.world;
  world.edits = at.edits;
  return {caseOf(at.number, world, caseSeed(arguments.seed, at.number)),
          fmt::format("mismatch-{}-{}", arguments.seed, at.number),
          fmt::format("{} --cells {}x{} --case-edits {} --seed {} --case {} --oracle {}", commandAgain(arguments),
                      world.width, world.height, world.edits, arguments.seed, at.number, arguments.oracleName())};
}

Status finishSurvey(const CheckArguments& arguments, const Survey& survey, const Totals& totals) {
  const std::string again =
      fmt::format("{} --cells {}x{} --case-edits {} --edits {} --seed {} --oracle {} --report {}",
                  commandAgain(arguments), arguments.world.width, arguments.world.height, arguments.world.edits,
                  arguments.edits, arguments.seed, arguments.oracleName(), shellPath(arguments.report));
  if (!survey.write(totals.stats, again)) return Status::badInput;
  fmt::print("{}\nreport     {}/report.md, report.html\n",
             survey.isEmpty() ? "no mismatch" : "MISMATCHES of some kinds", arguments.report);
  return survey.isEmpty() ? Status::fine : Status::mismatch;
}

Status playCases(const CheckArguments& arguments, CheckOptions options, Case& at) {
  Totals totals;
  Scene last;
  Progress progress;
  std::optional<Survey> survey;
  if (!arguments.report.empty()) survey.emplace(options, arguments.report, shrinkTime(arguments));
  for (at.number = arguments.onlyCase.value_or(0); totals.stats.edits < arguments.edits; ++at.number) {
    at.edits = arguments.world.edits;
    if (!arguments.onlyCase)
      at.edits = std::min<std::size_t>(editsOf(at.number, arguments.world), arguments.edits - totals.stats.edits);
    stillAlive();
    const Checked checked = caseOf(arguments, at);
    Features features{};
    std::size_t commits = 0;
    options.afterCommit = [&](const Scene& scene) {
      constexpr std::size_t kSample = 8;  // looking for features after each commit would take as long as the check
      if (commits++ % kSample == 0) note(scene, features);
      if (!arguments.svg.empty()) last = scene;
      stillAlive();
      return true;
    };
    const std::uint64_t refused = totals.stats.refused;
    const auto mismatch = checkTrace(checked.trace, options, totals.stats);
    if (!mismatch) return complain(message(mismatch.error(), fmt::format("case {}", at.number)));
    if (*mismatch && survey) {
      survey->add(**mismatch, checked.trace);
      if (arguments.onlyCase) break;
      continue;
    }
    if (*mismatch) {
      progress.wipe();
      reportMismatch(**mismatch, checked.trace, options, reportOptions(arguments, checked));
      return Status::mismatch;
    }
    features[static_cast<std::size_t>(Feature::refusal)] = totals.stats.refused != refused;
    totals.cases.add(features);
    if (progress.isDue()) {
      progress.show(fmt::format("{} of {} edits, {} cases, {:.0f} edits/s, no mismatch", totals.stats.edits,
                                arguments.edits, totals.cases.cases,
                                static_cast<double>(totals.stats.edits) / totals.seconds()));
    }
    if (arguments.onlyCase) break;
  }
  progress.wipe();
  if (survey) return finishSurvey(arguments, *survey, totals);
  return finish(arguments, totals, last);
}

}  // namespace

Status checkRandom(const CheckArguments& arguments) {
  CheckOptions options = arguments.options;
  options.skipRefused = true;
  options.wholeEvery = 1;
  const Shared<Case> at;
  return isolated(
      arguments, options, [&] { return playCases(arguments, options, *at); }, [&] { return caseOf(arguments, *at); });
}

}  // namespace lgs::cli
