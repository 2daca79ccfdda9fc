// What the two kinds of runs of `lgs check` share: their arguments, their ends, and what is said of them.
#pragma once

#include "cli/engine.h"
#include "cli/inputs.h"
#include "oracle/check/report.h"
#include "oracle/check/survey.h"
#include "oracle/generate/features.h"
#include "oracle/generate/generator.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lgs::cli {

/// What belongs to a run that goes on after a mismatch. If none of it is given, the first mismatch ends the run.
struct SurveyArguments {
  std::string report;  ///< folder of a report on the whole engine; by default that of CheckArguments::out
  std::string known;   ///< file of what is known
  bool fix = false;    ///< write that file anew
  std::string replay;  ///< folder of what failed before
  std::string json, junit;
  std::string laws;  ///< which are a recommendation
  bool isGiven = false;
};

struct CheckArguments {
  oracle::GeneratorOptions world{.width = 4, .height = 4, .edits = 100, .isOfCalls = true};
  std::size_t edits = 20'000;
  std::uint64_t seed = 1;
  std::optional<std::size_t> onlyCase;
  std::string map;
  std::vector<std::string> suites;  ///< files and folders of suites that others wrote
  std::string out = "out";
  std::string svg;
  std::string site;               ///< where a copy of the sandbox is served
  std::optional<double> seconds;  ///< how long it runs, instead of `edits`
  SurveyArguments survey;
  double shrinkSeconds = 20;
  oracle::CheckOptions options;
  EngineArguments engine;

  std::string oracleName() const { return options.naive && options.cgal ? "both" : options.naive ? "naive" : "cgal"; }
};

/// Checks random worlds, one case after the other.
Status checkRandom(const CheckArguments& arguments);

/// Digs in a given world.
Status checkMap(const CheckArguments& arguments);

/// Plays suites that others wrote, one case after the other.
Status checkSuites(const CheckArguments& arguments);

/// The command that plays the suites again, but for its further options.
std::string suitesAgain(const CheckArguments& arguments);

/// How the command begins that does such a check again, from any folder: "lgs check".
std::string commandAgain(const CheckArguments& arguments, bool brushes = false, bool views = false);

/// A trace to check.
struct Checked {
  oracle::Trace trace;
  std::string name;          ///< of the files that are written if it fails
  std::string reproduce;     ///< the command that checks it again
  bool areFollowed = false;  ///< its edits, by views
};

/// How long a mismatch may be shrunk.
std::chrono::milliseconds shrinkTime(const CheckArguments& arguments);

/// How random worlds are checked.
oracle::CheckOptions caseOptions(const CheckArguments& arguments);

/// " --edits 20000", or " --time 60".
std::string lengthOf(const CheckArguments& arguments);

/// How to report a mismatch in this trace.
oracle::ReportOptions reportOptions(const CheckArguments& arguments, const Checked& checked);

/// Runs a check of this library's engine in a process of its own. If it crashes or hangs there, reports the trace that
/// was being played: `playing` returns it.
Status isolated(const CheckArguments& arguments, const oracle::CheckOptions& options,
                const std::function<Status()>& check, const std::function<Checked()>& playing);

/// The clock of a run, and what it counts.
struct Totals {
  oracle::CheckStats stats;
  std::size_t built = 0;  ///< how many of the edits make up the map
  oracle::Distribution cases;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();

  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); }
};

/// Ends a run without a mismatch: prints a summary and draws the last world, if that was asked for.
Status finish(const CheckArguments& arguments, const Totals& totals, const oracle::Scene& last);

/// Draws it alone.
Status drawLast(const CheckArguments& arguments, const oracle::Scene& last);

}  // namespace lgs::cli
