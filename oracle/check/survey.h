// A report on a whole engine: all findings of a run by kind, with the smallest trace and the picture of each.
#pragma once

#include "oracle/check/report.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

namespace lgs::oracle {

class Survey {
 public:
  /// `options` names the engine; if it has not even started, there is none. Traces, pictures, pages and the report
  /// itself go to the folder as they are found, so that a run that is interrupted has told what it knew. `again` is the
  /// command that does all of it again.
  Survey(CheckOptions options, std::string folder, std::string again, std::chrono::milliseconds shrinkFor)
      : options_(std::move(options)), folder_(std::move(folder)), again_(std::move(again)), shrinkFor_(shrinkFor) {}

  /// Takes a mismatch that checkTrace() has found. The first ones of a kind are shrunk; the smallest is kept. After
  /// some hangs the engine is given up on sooner.
  void add(const Mismatch& found, const Trace& trace, const CheckStats& stats);

  /// Takes what an engine did at its greeting, or at the end of its input. No trace is to blame.
  void add(const Failure& failure);

  bool isEmpty() const { return kinds_.empty(); }

  /// Writes report.md and report.html, which say the same. Whether they could be written.
  bool write(const CheckStats& stats) const;

 private:
  struct Entry {
    std::uint64_t count = 0;
    Trace trace;       // the smallest
    std::string text;  // what is wrong with it
  };

  void shrink(const std::string& kind, Entry& entry, const Mismatch& found, const Trace& trace);
  void keep(const std::string& kind, Entry& entry, const Trace& trace, const Views& views);
  std::string facts(const CheckStats& stats) const;

  CheckOptions options_;
  std::string folder_;
  std::string again_;
  std::chrono::milliseconds shrinkFor_;
  std::map<std::string, Entry> kinds_;
};

}  // namespace lgs::oracle
