#include "cli/check_survey.h"

#include "oracle/check/finding.h"
#include "oracle/check/levels.h"
#include "oracle/check/results.h"
#include "oracle/check/shell.h"
#include "oracle/generate/generator.h"
#include "oracle/reference/words.h"
#include "oracle/trace/file.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <limits>
#include <tuple>
#include <utility>

namespace lgs::cli {

using namespace oracle;

namespace {

namespace fs = std::filesystem;

std::string again(const CheckArguments& arguments) {
  const auto& [world, survey] = std::tie(arguments.world, arguments.survey);
  std::string text =
      !arguments.suites.empty()
          ? suitesAgain(arguments)
          : fmt::format("{} --cells {}x{} --case-edits {}{} --seed {}", commandAgain(arguments, world.brushes),
                        world.width, world.height, world.edits, lengthOf(arguments), arguments.seed);
  if (arguments.onlyCase) text += fmt::format(" --case {}", *arguments.onlyCase);
  text += fmt::format(" --oracle {} --report {}", arguments.oracleName(), shellPath(survey.report));
  if (!survey.known.empty()) text += " --known " + shellPath(survey.known);
  if (!survey.replay.empty()) text += " --replay " + shellPath(survey.replay);
  return survey.laws.empty() ? text : text + " --laws " + shellWord(survey.laws);
}

}  // namespace

void addSurveyOptions(CLI::App& command, const std::shared_ptr<CheckArguments>& arguments) {
  SurveyArguments& to = arguments->survey;
  const auto add = [&](const char* name, std::string& text, const char* what, const char* kind) {
    return command.add_option(name, text, what)->option_text(kind)->excludes("--map")->each([&to](const std::string&) {
      to.isGiven = true;
    });
  };
  add("--report", to.report,
      "With an engine: go on after a mismatch, and write a report of\n"
      "all kinds with their smallest traces to this folder",
      "DIR");
  CLI::Option* const known =
      add("--known", to.known,
          "Mismatches that are known: they are no fault, and one that is\ngone is. With --fix the file is written anew",
          "FILE");
  command.add_flag("--fix", to.fix, "Take out of --known what is gone, and put in what is new")->needs(known);
  add("--replay", to.replay, "Play the traces of this folder first, and keep there what fails", "DIR");
  add("--json", to.json, "Write what there is as JSON", "FILE");
  add("--junit", to.junit, "Write what there is as a suite of JUnit", "FILE");
  command
      .add_option_function<std::string>(
          "--laws",
          [arguments](const std::string& words) {
            const auto laws = parseLaws(words);
            if (!laws) throw CLI::ValidationError("--laws", laws.error());
            arguments->options.recommended = *laws;
            arguments->survey.laws = words;
            arguments->survey.isGiven = true;
          },
          "What is a recommendation, reported and no fault: ghosts=should,\nblocks=, islands=, history= or "
          "minimality=should")
      ->option_text("'WORD ...'")
      ->excludes("--map");
}

Status trySurveyFiles(const SurveyArguments& arguments) {
  std::error_code ignored;  // the trial will say what is wrong
  for (const std::string& folder : {arguments.report, arguments.replay}) {
    if (folder.empty()) continue;
    fs::create_directories(folder, ignored);
    if (const Status bad = tryOutputs({(fs::path(folder) / "report.md").string()}); bad != Status::fine) return bad;
  }
  const Status status = tryOutputs({arguments.json, arguments.junit, arguments.fix ? arguments.known : ""});
  for (const std::string& results :
       {arguments.json, arguments.junit})  // those of an earlier run say nothing of this one
    if (status == Status::fine && !results.empty() && results != "-") fs::remove(results, ignored);
  return status;
}

SurveyRun::SurveyRun(const CheckArguments& arguments, const CheckOptions& options)
    : arguments_(arguments), options_(options) {}

Status SurveyRun::readKnown() {
  const std::string& file = arguments_.survey.known;
  if (file.empty() || (arguments_.survey.fix && !fs::exists(file))) return Status::fine;
  const auto text = readFile(file);
  if (!text) return complain(message(text.error(), file));
  auto known = parseKnown(*text);
  if (!known) return complain(file + ":" + known.error());
  known_ = std::move(*known);
  return Status::fine;
}

SurveyRun::Played SurveyRun::play(const Trace& trace, const std::string& where, CheckStats& stats) {
  if (const std::string why = whyNot(trace, options_.engine->can()); !why.empty())
    return tl::unexpected(complain(fmt::format("{}: the engine can not have it: {}", where, why)));
  CheckOptions options = options_;
  options.advise = [&](const Mismatch& found) { advise(found); };
  auto found = checkTrace(trace, options, stats);
  if (!found) return tl::unexpected(complain(message(found.error(), where)));
  return std::move(*found);
}

Status SurveyRun::begin(CheckOptions& options, CheckStats& stats) {
  options.advise = [this](const Mismatch& found) { advise(found); };
  return playFirst(stats);
}

Status SurveyRun::playFirst(CheckStats& stats) {
  if (const Status bad = readKnown(); bad != Status::fine) return bad;
  const auto& [known, replay] = std::tie(arguments_.survey.known, arguments_.survey.replay);
  constexpr std::uint64_t kFew = 3, kToTellApart = 10, kAll = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t shrunk = known.empty() ? kFew : arguments_.survey.fix ? kAll : kToTellApart;
  survey_.emplace(options_, SurveyOptions{arguments_.survey.report, again(arguments_), shrinkTime(arguments_), shrunk,
                                          known_, arguments_.site});
  for (const KnownMismatch& one : known_) {
    const auto found = play(one.trace, known, stats);
    if (!found) return found.error();
    const auto isIt = [&](const Mismatch& m) { return kindOfFinding(m, *options_.engine) == one.kind; };
    const bool isThere = (*found && isIt(**found)) || std::ranges::any_of(advised_, isIt);
    if (!isThere) gone_.push_back(one);
    isThere ? advised_.clear() : add(*found, one.trace, stats);
  }
  for (const std::string& file : replay.empty() ? std::vector<std::string>() : tracesIn(replay)) {
    const auto trace = readTrace(file);
    if (!trace) return complain(message(trace.error(), file));
    const auto found = play(*trace, file, stats);
    if (!found) return found.error();
    add(*found, *trace, stats);
    kept_.insert(identityOf({"", *trace}));
  }
  survey_->lookAnew();  // what failed before does not stand in the way of what is new
  return Status::fine;
}

void SurveyRun::add(const std::optional<Mismatch>& found, const Trace& trace, const CheckStats& stats) {
  for (const Mismatch& advice : std::exchange(advised_, {})) survey_->add(advice, trace, stats);
  if (found) survey_->add(*found, trace, stats);
}

Status SurveyRun::keepFaults() {
  Status status = Status::fine;
  for (const auto& [kind, trace] : survey_->faults()) {
    if (trace.calls.empty() || !kept_.insert(identityOf({"", trace})).second) continue;
    const std::string text = printTrace(trace, kind);
    const std::string base = freePlace((fs::path(arguments_.survey.replay) / Survey::fileOf(kind)).string(), text);
    status = worst(status, write(base + ".trace", text));
  }
  return status;
}

// What has no trace can not be known.
Status SurveyRun::fix() const {
  std::set<std::string> gone;
  for (const KnownMismatch& one : gone_) gone.insert(identityOf(one));
  std::vector<KnownMismatch> now = known_;
  std::erase_if(now, [&](const KnownMismatch& one) { return gone.contains(identityOf(one)); });
  Status status = Status::fine;
  for (const KnownMismatch& one : survey_->faults())
    one.trace.calls.empty() ? static_cast<void>(status = Status::mismatch) : now.push_back(one);
  const Status written = write(arguments_.survey.known, printKnown(now));
  fmt::print("fixed      {}: {} gone, {} in all (several may be of one bug)\n", arguments_.survey.known, gone_.size(),
             counted(now.size(), "trace"));
  return worst(status, written);
}

void SurveyRun::print() const {
  using State = Survey::State;
  for (const auto& [kind, entry] : survey_->kinds()) {
    const auto of = [&findings = entry.findings](State state) {
      return std::ranges::count(findings, state, &Survey::Finding::state);
    };
    fmt::print("{}, {}; smallest traces that differ: {} of a fault, {} known, {} of advice\n", kind,
               counted(entry.count, "time"), of(State::fault), of(State::known), of(State::advice));
    if (entry.onlyCounted() != 0) fmt::print("  {} of them were only counted, not shrunk\n", entry.onlyCounted());
    const auto fault = std::ranges::find(entry.findings, State::fault, &Survey::Finding::state);
    if (fault != entry.findings.end()) fmt::print("\n{}\n{}\n", printTrace(fault->trace), fault->text);
  }
  for (const auto& [kind, trace] : gone_)
    fmt::print("gone, and still in {} (--fix takes it out): {}\n\n{}\n", arguments_.survey.known, kind,
               printTrace(trace));
}

Status SurveyRun::finish(const Totals& totals, const Scene& last) {
  if (const auto failure = options_.engine->finish()) {
    tell(*failure, stdout);
    survey_->add(*failure);
  }
  if (!survey_->write(totals.stats)) return Status::badInput;
  const Results results{options_.engine->name(), *survey_, totals.stats, totals.seconds(), gone_};
  Status status = Status::fine;
  const auto& [report, known, fixes, replay, json, junit, laws, isGiven] = arguments_.survey;
  print();
  if (!json.empty()) status = worst(status, write(json, asJson(results)));
  if (!junit.empty()) status = worst(status, write(junit, asJUnit(results)));
  if (!replay.empty()) status = worst(status, keepFaults());
  if (const std::size_t there = known_.size() - gone_.size(); there != 0)
    fmt::print("known      {} of {} are still there\n", there, counted(known_.size(), "trace"));
  fmt::print(
      "{}\nreport     {}/report.md, report.html\n",
      results.areFine() ? hasFound() ? "no mismatch that is not known" : "no mismatch" : "MISMATCHES of some kinds",
      arguments_.survey.report);
  if (results.areFine()) status = worst(status, drawLast(arguments_, last));
  if (fixes) return worst(status, fix());
  return worst(status, results.areFine() ? Status::fine : Status::mismatch);
}

}  // namespace lgs::cli
