// A report on a whole engine: all findings of a run by kind, with the smallest trace and the picture of each.
#pragma once

#include "oracle/check/known.h"
#include "oracle/check/report.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace lgs::oracle {

struct SurveyOptions {
  std::string folder;                     ///< for traces, pictures, pages and the report itself
  std::string again;                      ///< the command that does all of it again
  std::chrono::milliseconds shrinkFor{};  ///< each
  std::uint64_t shrunk = 3;               ///< so many of a kind that are not known are; later ones are only counted
  std::vector<KnownMismatch> known = {};  ///< what is known is no fault
  std::string site = {};                  ///< where a copy of the sandbox is served, if anywhere
};

class Survey {
 public:
  /// `options` names the engine; if it has not even started, there is none. Files are written as mismatches are found,
  /// so that a run that is interrupted has told what it knew.
  Survey(CheckOptions options, SurveyOptions how);

  enum class State : std::uint8_t { fault, known, advice };
  struct Finding {
    Trace trace;       ///< as small as can be; empty, if none is to blame
    std::string text;  ///< what is wrong with it
    State state{};
  };
  struct Entry {
    std::uint64_t count = 0;
    std::uint64_t looked = 0;              ///< for so many of these the smallest trace was looked for
    std::uint64_t faults = 0, advice = 0;  ///< how many of those count for SurveyOptions::shrunk
    std::vector<Finding> findings;         ///< no two are alike; the smallest comes first

    std::uint64_t onlyCounted() const { return count - looked; }
  };

  /// Takes a mismatch that checkTrace() has found, or has advised of. The first ones of a kind are shrunk. After some
  /// hangs the engine is given up on sooner.
  void add(const Mismatch& found, const Trace& trace, const CheckStats& stats);

  /// Takes what an engine did at its greeting, or at the end of its input. No trace is to blame.
  void add(const Failure& failure);

  /// The first ones of a kind are shrunk anew.
  void lookAnew();

  const std::map<std::string, Entry>& kinds() const { return kinds_; }  ///< of findings
  bool isEmpty() const { return kinds_.empty(); }
  std::vector<KnownMismatch> faults() const;  ///< what is neither known nor advice

  /// The name of a kind's files, without their folder and ending.
  static std::string fileOf(std::string kind);

  /// Writes report.md and report.html, which say the same. Whether they could be written.
  bool write(const CheckStats& stats) const;

 private:
  State shrink(const std::string& kind, Entry& entry, const Mismatch& found, const Trace& trace);
  void keep(const std::string& kind, const Trace& trace, const Views& views) const;
  std::string facts(const CheckStats& stats) const;

  CheckOptions options_;
  SurveyOptions how_;
  std::set<std::string> known_, met_;  // identities
  std::map<std::string, Entry> kinds_;
};

}  // namespace lgs::oracle
