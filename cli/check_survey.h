// A run of `lgs check` that goes on after a mismatch: what is known and what failed before come first; in the end there
// is a report, and what programs of others read.
#pragma once

#include "cli/check_run.h"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::cli {

/// Adds --report, --known, --fix, --replay, --json, --junit and --laws.
void addSurveyOptions(CLI::App& command, const std::shared_ptr<CheckArguments>& arguments);

/// Whether all that such a run will write can be written; or complains.
Status trySurveyFiles(const SurveyArguments& arguments);

class SurveyRun {
 public:
  SurveyRun(const CheckArguments& arguments, const oracle::CheckOptions& options);

  /// Plays what is known, and what failed before. Bad input if that can not be read, or the engine can not have it. From
  /// then on checks with these options advise here.
  Status begin(oracle::CheckOptions& options, oracle::CheckStats& stats);

  /// Takes what a check has found, and what it has advised of.
  void add(const std::optional<oracle::Mismatch>& found, const oracle::Trace& trace, const oracle::CheckStats& stats);

  bool hasFound() const { return !survey_->isEmpty(); }

  /// Ends the engine, writes everything, and says what there is. Draws the last world if all is fine.
  Status finish(const Totals& totals, const oracle::Scene& last);

 private:
  using Played = tl::expected<std::optional<oracle::Mismatch>, Status>;
  void advise(const oracle::Mismatch& found) { advised_.push_back(found); }
  Status playFirst(oracle::CheckStats& stats);
  Status readKnown();
  Played play(const oracle::Trace& trace, const std::string& where, oracle::CheckStats& stats);
  Status fix() const;
  Status keepFaults();
  void print() const;

  const CheckArguments& arguments_;
  oracle::CheckOptions options_;
  std::optional<oracle::Survey> survey_;
  std::vector<oracle::KnownMismatch> known_, gone_;
  std::vector<oracle::Mismatch> advised_;
  std::set<std::string> kept_;  // identities of what failed before
};

}  // namespace lgs::cli
