#include "cli/check_run.h"
#include "cli/check_survey.h"
#include "cli/progress.h"
#include "oracle/check/isolated.h"
#include "oracle/check/shell.h"
#include "oracle/reference/words.h"
#include "oracle/suites/strokes.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::cli {

using namespace oracle;

namespace {

struct Playable {
  std::string name;
  std::size_t number = 0;  // in the suites, as --case counts
  Trace trace;
};

struct Suites {
  Suite read;
  std::vector<Playable> cases;
  std::size_t rounded = 0, evenOdd = 0;
  std::vector<std::size_t> ends;  // for each file or folder that was named, where the cases of the next one begin
};

tl::expected<Suites, std::string> readSuites(const CheckArguments& arguments) {
  Suites suites;
  for (const std::string& path : arguments.suites) {
    auto read = readSuite(path);
    if (!read) return tl::unexpected(read.error());
    suites.read.files += read->files;
    for (SuiteCase& of : read->cases) suites.read.cases.push_back(std::move(of));
    for (const auto& [what, times] : read->leftOut) suites.read.leftOut[what] += times;
    suites.ends.push_back(suites.read.cases.size());
  }
  for (std::size_t k = 0; k < suites.read.cases.size(); ++k) {
    if (arguments.onlyCase && *arguments.onlyCase != k) continue;
    auto strokes = strokesOf(suites.read.cases[k]);
    const std::string why = !strokes                     ? strokes.error()
                            : arguments.engine.isGiven() ? whyNot(strokes->trace, arguments.world.can)
                                                         : "";
    if (!why.empty()) {
      const std::size_t reason = why.starts_with("edit ") ? why.find(": ") + 2 : 0;  // whichever edit it is of
      ++suites.read.leftOut[strokes ? "case that the engine can not have: " + why.substr(reason) : why];
      continue;
    }
    suites.rounded += strokes->isRounded ? 1 : 0;
    suites.evenOdd += strokes->isEvenOdd ? 1 : 0;
    suites.cases.push_back({suites.read.cases[k].name, k, std::move(strokes->trace)});
  }
  return suites;
}

void tell(const Suites& suites) {
  fmt::print("suite      {}, {}\n", counted(suites.read.files, "file"), counted(suites.read.cases.size(), "case"));
  fmt::print("played     {}, {} of them rounded to the lattice, {} by the even-odd rule instead of another\n",
             counted(suites.cases.size(), "case"), suites.rounded, suites.evenOdd);
  for (const auto& [what, times] : suites.read.leftOut) fmt::print("left out   {} times: {}\n", times, what);
  std::fflush(stdout);
}

// The first that was named and has no case that can be played: a job that names it means to play it.
const std::string* unplayed(const CheckArguments& arguments, const Suites& suites) {
  auto at = suites.cases.begin();
  for (std::size_t k = 0; k < suites.ends.size(); ++k) {
    const auto end =
        std::find_if(at, suites.cases.end(), [&](const Playable& p) { return p.number >= suites.ends[k]; });
    if (at == end) return &arguments.suites[k];
    at = end;
  }
  return nullptr;
}

Checked checkedOf(const CheckArguments& arguments, const Playable& playable) {
  return {playable.trace, fmt::format("mismatch-suite-{}", playable.number),
          fmt::format("{} --case {} --oracle {}", suitesAgain(arguments), playable.number, arguments.oracleName())};
}

Status play(const CheckArguments& arguments, const Suites& suites, std::size_t& at) {
  CheckOptions options = caseOptions(arguments);
  options.afterCommit = [](const Model&) {
    stillAlive();
    return true;
  };
  Totals totals;
  Progress progress;
  std::optional<SurveyRun> survey;
  if (arguments.survey.isGiven) {
    survey.emplace(arguments, options);
    if (const Status bad = survey->begin(options, totals.stats); bad != Status::fine) return bad;
  }
  for (at = 0; at < suites.cases.size(); ++at) {
    const Playable& playable = suites.cases[at];
    const Checked checked = checkedOf(arguments, playable);
    stillAlive();
    const auto mismatch = checkTrace(checked.trace, options, totals.stats);
    if (!mismatch) return complain(message(mismatch.error(), playable.name));
    if (survey) {
      survey->add(*mismatch, checked.trace, totals.stats);
    } else if (*mismatch) {
      progress.wipe();
      fmt::print("case       {}\n", playable.name);
      reportMismatch(**mismatch, checked.trace, options, reportOptions(arguments, checked));
      return Status::mismatch;
    }
    if (progress.isDue()) progress.show(fmt::format("{} of {}", at + 1, counted(suites.cases.size(), "case")));
  }
  progress.wipe();
  const Scene last = sceneOf(suites.cases.back().trace);
  return survey ? survey->finish(totals, last) : finish(arguments, totals, last);
}

}  // namespace

std::string suitesAgain(const CheckArguments& arguments) {
  std::string text = commandAgain(arguments) + " --suite";
  for (const std::string& path : arguments.suites) text += " " + shellPath(path);
  return text;
}

Status checkSuites(const CheckArguments& arguments) {
  if (arguments.engine.isGiven() && !arguments.world.can.regions)
    return complain("lgs check: --suite has strokes alone, and the engine does not say 'regions' in its greeting");
  const auto suites = readSuites(arguments);
  if (!suites) return complain(suites.error());
  tell(*suites);
  if (suites->cases.empty()) return complain("lgs check: no case of the suites can be played");
  const std::string* const none = arguments.onlyCase ? nullptr : unplayed(arguments, *suites);
  if (none != nullptr) return complain(fmt::format("lgs check: no case of {} can be played", *none));
  const Shared<std::size_t> at;
  return isolated(
      arguments, caseOptions(arguments), [&] { return play(arguments, *suites, *at); },
      [&] { return checkedOf(arguments, suites->cases[*at]); });
}

}  // namespace lgs::cli
